"""Runs jobs of the oracle in forks of one process, which has imported what all of them need.

``python -m benchmarks.accuracy.oracle.server [--real]``; each line of the standard input is the folder of a job, and
the answer, a line too, is ``0`` or how the fork ended.
"""

from __future__ import annotations

import os
import resource
import sys
from pathlib import Path

from . import child, real

_MEMORY = 6 << 30
"""Bytes of address space for one run; middleware and its threads take about one gigabyte of it."""


def main() -> None:
    """Serve until the standard input ends."""
    if "--real" in sys.argv[1:]:
        real.install()
    else:
        child.load_standins(real_rclpy=False)  # once, and not in each fork
    for line in sys.stdin:
        print(_ended(Path(line.rstrip("\n"))), flush=True)


def _ended(folder: Path) -> str:
    fork = os.fork()
    if fork == 0:
        try:
            _serve(folder)
        finally:
            os._exit(1)
    _, status = os.waitpid(fork, 0)
    return str(os.waitstatus_to_exitcode(status))


def _serve(folder: Path) -> None:
    noise = os.open(folder / "noise", os.O_WRONLY | os.O_CREAT)
    quiet = os.open(os.devnull, os.O_RDONLY)
    for old, new in ((quiet, 0), (noise, 1), (noise, 2)):
        os.dup2(old, new)
    resource.setrlimit(resource.RLIMIT_AS, (_MEMORY, _MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    os.chdir(folder)
    os.environ.update(HOME=str(folder), TMPDIR=str(folder), ROS_LOG_DIR=str(folder / "log"))
    sys.argv = ["child", "job.json"]
    child.execute(Path("job.json"))


if __name__ == "__main__":
    main()
