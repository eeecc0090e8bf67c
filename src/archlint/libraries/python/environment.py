"""What the environment of a process of ROS 2 says."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import Known

if TYPE_CHECKING:
    from archlint.libraries.run import Run

ENVIRONMENT = {"ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
"""What the environment of every ROS 2 process says."""


def variable(run: Run, name: object) -> Known | None:
    """What a variable is in any process of ROS 2; ``ROS_DISTRO`` where the configuration says the distribution."""
    text = run.distro if name == "ROS_DISTRO" else ENVIRONMENT.get(str(name))
    return None if text is None else Known(text)


__all__ = ["variable"]
