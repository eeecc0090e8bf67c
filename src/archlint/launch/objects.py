"""The objects that launch files make of launch's classes: actions, substitutions, conditions, event handlers …"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Known, Value

if TYPE_CHECKING:
    from archlint.branches import BranchArms
    from archlint.finding import Place
    from archlint.interpreter.machine import Machine

OWN = "launch."
"""What the paths of launch's classes begin with, wherever they are imported from."""

MADE_BY_BASE = "#action"
"""The slot of what ``super().__init__()`` makes of an object whose class derives from one of launch's."""
ENTITIES = "#entities"
"""The slot of the actions in a launch description, which code adds to."""
GIVEN = "#given"
"""The slot of what the constructor of a class that derives from one of launch's is given, by name or position."""
PAIR_PLACE = "#place"
"""The slot of where a pair of texts is written in XML and YAML."""


@dataclass(frozen=True, slots=True, eq=False)
class LaunchObject(Instance):
    """An object of a class that is in launch's tables, with its arguments by the names that its constructor has."""

    places: dict[str, Place] = field(default_factory=dict)
    """Where each argument is written."""
    rest: tuple[Value, ...] = ()
    """Arguments beyond those that have a name."""
    open: bool = False
    """Whether there may be more arguments than are known."""
    branch_arms: BranchArms = frozenset()
    """The branches of the launch file's own code that it is made in."""


def kind_of(value: Value | None) -> str:
    """``Node`` for an object of launch's or launch_ros' ``Node`` …; empty for anything else."""
    if isinstance(value, Instance) and isinstance(value.cls, External) and value.cls.path.startswith(OWN):
        return value.cls.path.removeprefix(OWN)
    return ""


def argument(value: Value | None, name: str) -> Value | None:
    """A constructor argument; None where it was not given, or is None."""
    found = value.arguments.get(name) if isinstance(value, Instance) else None
    return None if isinstance(found, Known) and found.value is None else found


def places_of(value: Value | None) -> dict[str, Place]:
    """Where the arguments of an object are written."""
    return value.places if isinstance(value, LaunchObject) else {}


def made_by_base(machine: Machine, value: Value | None) -> Instance | None:
    """For an object of a workspace's class that derives from one of launch's: what ``super().__init__()`` made."""
    made = machine.store.get(value.key, MADE_BY_BASE) if isinstance(value, Instance) else None
    return made if isinstance(made, Instance) else None


def has_more_arguments(value: Value) -> bool:
    """Whether an object may be given more than is known."""
    return isinstance(value, LaunchObject) and value.open
