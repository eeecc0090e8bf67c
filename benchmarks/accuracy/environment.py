"""The real rclpy to run under: an environment of `scripts/ros_environment`, with interface packages built for it."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from tests_ros.environments import Environment

from .oracle.processes import PLAIN, Python


def real_python(environment: Environment, prefixes: list[Path]) -> Python:
    """What runs under a distribution's rclpy are executed with.

    The middleware looks for nobody: each run is alone in its workspace, as under the stand-in.
    """
    variables = environment.variables(prefixes, 0, Path(tempfile.gettempdir()))
    variables |= PLAIN | {"ROS_DISTRO": environment.distro, "ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"}
    return Python(str(environment.python), tuple(variables.items()), real=True)


def built(environment: Environment, checkout: Path, skipped: list[str]) -> list[Path]:
    """The interface packages of a checkout that can be built; why the others cannot be is added to `skipped`."""
    prefixes = []
    for manifest in sorted(checkout.rglob("package.xml")):
        try:
            prefixes += environment.interfaces(manifest.parent)
        except (RuntimeError, OSError, subprocess.TimeoutExpired) as error:
            skipped.append(f"{manifest.parent.relative_to(checkout)}: {str(error).splitlines()[-1][:200]}")
    return prefixes


def environment_of(distro: str) -> Environment:
    """The environment of a distribution; ends the program where there is none."""
    environment = Environment(distro)
    if not environment.ready():
        sys.exit(f"no environment for {distro}: run `python scripts/ros_environment {distro}`")
    return environment
