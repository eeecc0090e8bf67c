"""What a distribution does with a keyword that the constructor of a message does not have.

Sources: the messages that rosidl_generator_py makes.  Those of Humble assert that they know each keyword; Jazzy's and
Kilted's look at keywords only with ``ROS_PYTHON_CHECK_FIELDS=1`` (tried with both), and take no notice of others; from
Lyrical on, a constructor has a parameter for each field, so that Python itself refuses any other.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import named_distros
from archlint.ros.distros import DISTROS

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_IGNORED = ""
_OUTCOMES = {
    "humble": "AssertionError",
    "jazzy": _IGNORED,
    "kilted": _IGNORED,
    "lyrical": "TypeError",
    "rolling": "TypeError",
}


def outcome_of_keyword(workspace: WorkspaceIndex | None, distros: Sequence[str]) -> str:
    """What comes of it, in words, in the distributions that the workspace is meant for."""
    named = [distro for distro in distros or DISTROS if distro in named_distros(workspace)]
    rows: dict[str, list[str]] = {}
    for distro in named or distros or DISTROS:
        rows.setdefault(_OUTCOMES[distro], []).append(distro)
    ignoring = rows.pop(_IGNORED, [])
    if not rows:
        return "the constructor ignores such a keyword, and the field keeps its default"
    if not ignoring and len(rows) == 1:
        return f"such a keyword raises {next(iter(rows))}"
    raised = " and ".join(f"{error} on {' and '.join(where)}" for error, where in rows.items())
    ignored = f", and {' and '.join(ignoring)} {'ignores' if len(ignoring) == 1 else 'ignore'} it" if ignoring else ""
    return f"such a keyword raises {raised}{ignored}"


__all__ = ["outcome_of_keyword"]
