"""Run the oracle over checked-out repositories: `python -m benchmarks.accuracy.run CHECKOUTS [-o DIR]`."""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path

from tests_ros.environments import OWN_INTERFACES

from .environment import built, environment_of, real_python
from .oracle.processes import Pool, Python
from .oracle.run import Oracle

EXAMPLES = OWN_INTERFACES / "example_interfaces"


def main() -> None:
    """Write DIR/<repository>.json for each folder below CHECKOUTS (or for CHECKOUTS itself with --one)."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("checkouts", type=Path, help="a folder of repositories")
    parser.add_argument("names", nargs="*", help="only these repositories (default: all)")
    parser.add_argument("-o", "--output", type=Path, default=Path("oracle-results"))
    parser.add_argument("--one", action="store_true", help="CHECKOUTS is itself one repository")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--real", metavar="DISTRO", help="under rclpy itself, of .venv-ros-DISTRO")
    parser.add_argument("--plain", action="store_true", help="programs and classes once, nothing forced")
    parser.add_argument("--unbuilt", action="store_true", help="with --real: build no interfaces of the checkout")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    folders = (
        [options.checkouts] if options.one else sorted(path for path in options.checkouts.iterdir() if path.is_dir())
    )
    for folder in folders:
        if options.names and folder.name not in options.names:
            continue
        started = time.monotonic()
        processes = Pool(_python(options.real, folder, not options.unbuilt))
        result = Oracle(folder, options.jobs, processes).run(plain=options.plain)
        processes.close()
        target = options.output / f"{folder.resolve().name}.json"
        target.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
        ended = sum(run["ended"] for run in result["runs"])
        print(
            f"{folder.name}: {len(result['entities'])} entities, "
            f"{ended}/{len(result['runs'])} runs came to their end, "
            f"{len(result['unreached'])} create calls unreached, {time.monotonic() - started:.0f} s",
            flush=True,
        )


def _python(distro: str | None, checkout: Path, build: bool) -> Python:
    """What to run a checkout with: under the stand-in, or a distribution's rclpy with the checkout's own interfaces."""
    if distro is None:
        return Python()
    environment, not_built = environment_of(distro), list[str]()
    prefixes = [*environment.interfaces(EXAMPLES), *(built(environment, checkout, not_built) if build else ())]
    for reason in not_built:
        print(f"not built: {reason}", flush=True)
    return real_python(environment, prefixes)


if __name__ == "__main__":
    main()
