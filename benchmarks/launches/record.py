"""Loads launch files with the real launch, and notes what they would start: ``python -m benchmarks.launches.record
CHECKOUT… -o records --python ENV/bin/python --launch CHECKOUT --launch-ros CHECKOUT``.

ENV has rclpy (``scripts/ros_environment jazzy`` makes one from PyPI's wheels), lark and osrf_pycommon; the two
checkouts are of ros2/launch and ros2/launch_ros, on the branch of the same distribution. Each checkout is laid out as
its packages install it (see ``layout``), and each launch file is loaded with its defaults and once for each other
value of an argument that something asks for.

This runs code of the repositories. Each launch file runs in a process of its own, in namespaces without network, with
a file system that is read-only but for a folder in memory, with limits of time and memory, and with everything that
starts processes replaced (``inside/guard``). Without ``unshare`` nothing is run.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from benchmarks.launches import layout

RUNNER = Path(__file__).parent / "inside" / "runner.py"
UNSHARE = ("unshare", "--map-root-user", "--mount", "--net", "--pid", "--fork", "--kill-child", "--ipc")
HOURS = 3


@dataclass(frozen=True)
class Sandbox:
    """What launch files are loaded with: a Python that has rclpy, checkouts of ros2/launch and ros2/launch_ros, and
    folders with further packages."""

    python: Path
    launch: Path
    launch_ros: Path
    libraries: tuple[Path, ...] = ()


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("checkouts", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--python", type=Path, required=True)
    parser.add_argument("--launch", type=Path, required=True)
    parser.add_argument("--launch-ros", type=Path, required=True)
    parser.add_argument(
        "--library", type=Path, action="append", default=[], help="a folder with further Python packages"
    )
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    sandbox = Sandbox(options.python, options.launch, options.launch_ros, tuple(options.library))
    for checkout in options.checkouts:
        rows = record(checkout.resolve(), sandbox)
        (options.output / f"{checkout.name}.json").write_text(json.dumps(rows, indent=1) + "\n")
        runs = [run for row in rows for run in row["runs"]]
        failed = sum(run["error"] is not None for run in runs)
        print(f"{checkout.name}: {len(rows)} launch files, {len(runs)} runs, {failed} of them failed", flush=True)
    return 0


def record(root: Path, sandbox: Sandbox) -> list[dict[str, Any]]:
    with tempfile.TemporaryDirectory(prefix="launches-") as folder:
        install, work = Path(folder, "install"), Path(folder, "work")
        install.mkdir()
        work.mkdir()
        found = layout.packages(root)
        wanted = [{"setup": str(one.folder / "setup.py")} for one in found if one.setup]
        answers = sandboxed(wanted, install, work, sandbox)
        setups = {row["setup"]: row["runs"][0] for row in answers}
        for package in found:
            layout.lay_out(package, setups.get(str(package.folder / "setup.py")), install)
        files = [(path, package) for package in found for path in layout.launch_files(package)]
        places = {str(layout.place_of(package, path, install)): path for path, package in files}
        rows = sandboxed([{"launch": place} for place in places], install, work, sandbox)
        return [{"file": places[row["launch"]].relative_to(root).as_posix(), "runs": row["runs"]} for row in rows]


def sandboxed(jobs: list[dict[str, str]], install: Path, work: Path, sandbox: Sandbox) -> list[dict[str, Any]]:
    """Run jobs where nothing can be written but to ``work``, which is in memory."""
    if not jobs:
        return []
    settings = work.parent / "settings.json"
    made = {"install": str(install), "work": str(work), "launch": str(sandbox.launch.resolve()), "jobs": jobs}
    made["libraries"] = [str(one.resolve()) for one in sandbox.libraries]
    settings.write_text(json.dumps(made))
    launch, ros = sandbox.launch.resolve(), sandbox.launch_ros.resolve()
    path = [launch / "launch", launch / "launch_xml", launch / "launch_yaml", ros / "launch_ros", install / "python"]
    path += [one.resolve() for one in sandbox.libraries]
    environment = {
        "PATH": "/usr/bin:/bin",
        "HOME": str(work),
        "TMPDIR": str(work),
        "ROS_HOME": str(work),
        "ROS_LOG_DIR": str(work / "log"),
        "ROS_DISTRO": "jazzy",
        "ROS_VERSION": "2",
        "USER": "user",
        "AMENT_PREFIX_PATH": str(install),
        "PYTHONPATH": os.pathsep.join(map(str, path)),
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONHASHSEED": "0",
        "LANG": "C.UTF-8",
    }
    script = (
        f"mount --make-rprivate / && mount -t tmpfs -o size=256m tmpfs {shlex.quote(str(work))} && "
        f"mount -o remount,ro,bind / && mount -t proc proc /proc && ulimit -v 4000000 && "
        f"exec {shlex.join([str(sandbox.python.absolute()), '-s', str(RUNNER), str(settings)])}"
    )
    done = subprocess.run(
        [*UNSHARE, "sh", "-c", script],
        env=environment,
        stdout=subprocess.PIPE,
        stdin=subprocess.DEVNULL,
        cwd=work,
        timeout=HOURS * 3600,
        check=False,
        text=True,
    )
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    if len(rows) != len(jobs):
        print(f"only {len(rows)} of {len(jobs)} jobs were done (exit code {done.returncode})", file=sys.stderr)
    return rows


if __name__ == "__main__":
    sys.exit(main())
