"""Holds archlint's launches of a folder of repositories against launch itself, in one command: ``python -m
benchmarks.launches FOLDER -o OUTPUT``.

Each repository below FOLDER is recorded (see ``record``) and compared (see ``compare``), two at a time. OUTPUT gets
NAME.json, the record, and NAME.txt, its row and each difference; a repository that has a record is not recorded
again. The table and its sum go to the standard output. What is not there is set up: the environment with rclpy
(``scripts/ros_environment``), and the sources of ros2/launch and ros2/launch_ros below ``--ros``.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections import Counter
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from benchmarks.launches import compare
from benchmarks.launches.expected import DISTRO
from benchmarks.launches.record import Sandbox
from benchmarks.launches.repository import held

ROOT = Path(__file__).resolve().parents[2]
NEEDED = ("lark", "osrf_pycommon")
"""What launch imports beside rclpy's wheels."""


def main() -> int:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.launches", description=(__doc__ or "").partition(":")[0]
    )
    parser.add_argument("folder", type=Path, nargs="+", help="a folder of repositories")
    parser.add_argument("-o", "--output", type=Path, required=True, help="for records and differences")
    parser.add_argument("--one", action="store_true", help="each FOLDER is one repository")
    parser.add_argument("--jobs", type=int, default=2, help="how many repositories at a time")
    parser.add_argument("--python", type=Path, help="the Python of an environment with rclpy, lark and osrf_pycommon")
    parser.add_argument("--ros", type=Path, default=ROOT / "corpus", help="where launch and launch_ros are checked out")
    parser.add_argument("--library", type=Path, action="append", default=[], help="a folder with further packages")
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    sandbox = Sandbox(
        options.python or environment(),
        source(options.ros, "launch"),
        source(options.ros, "launch_ros"),
        tuple(options.library),
    )
    roots = [
        root.resolve() for folder in options.folder for root in ([folder] if options.one else repositories(folder))
    ]
    print(compare.HEAD)
    failures = []
    total: Counter[str] = Counter()
    with ThreadPoolExecutor(options.jobs) as threads:
        for outcome in threads.map(lambda root: held(root, sandbox, options.output.resolve()), roots):
            total += outcome.counts
            if outcome.failure is not None:
                failures.append(f"{outcome.name}: {outcome.failure}")
            elif outcome.counts["files"]:
                print(compare.line(outcome.name.replace("+", "/"), outcome.counts), flush=True)
    print(compare.line("all", total))
    print("".join(f"not compared: {failure}\n" for failure in failures), end="")
    return 1 if failures else 0


def repositories(folder: Path) -> Iterator[Path]:
    yield from (root for root in sorted(folder.iterdir()) if root.is_dir() and not root.name.startswith("."))


# ------------------------------------------------------------------------------------------------ what is needed


def environment() -> Path:
    """The Python of an environment with rclpy and what launch imports, which is made where there is none."""
    run([sys.executable, str(ROOT / "scripts" / "ros_environment"), DISTRO])
    python = ROOT / f".venv-ros-{DISTRO}" / "bin" / "python"
    if not python.exists():
        sys.exit(f"no ROS 2 {DISTRO} on this machine; name another Python with --python")
    modules = f"import {', '.join(NEEDED)}"
    if subprocess.run([python, "-c", modules], stderr=subprocess.DEVNULL, check=False).returncode:
        run([sys.executable, "-m", "pip", "--quiet", "--python", str(python.parents[1]), "install", *NEEDED])
    return python


def source(folder: Path, name: str) -> Path:
    """The checkout of one repository of ROS, which is cloned where it is not there."""
    if not (folder / name).is_dir():
        run(
            [
                "git",
                "clone",
                "--quiet",
                "--depth",
                "1",
                "-b",
                DISTRO,
                f"https://github.com/ros2/{name}",
                str(folder / name),
            ]
        )
    return folder / name


def run(command: Iterable[str]) -> None:
    subprocess.run([*command], stdout=sys.stderr, check=True)


if __name__ == "__main__":
    sys.exit(main())
