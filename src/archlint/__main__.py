"""``python -m archlint``."""

import sys

if sys.path and not (sys.flags.isolated or getattr(sys.flags, "safe_path", False)):
    # Python puts the working directory first: its yaml.py or json.py would be run in place of the library.
    del sys.path[0]

from archlint.cli import main

if __name__ == "__main__":
    main()
