"""The objects that launch files make of launch's classes: actions, substitutions, conditions, event handlers …"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.fields import Field
from archlint.interpreter.values import (
    NONE,
    BoundMethod,
    External,
    FunctionValue,
    Instance,
    Items,
    Known,
    Value,
    join_items,
    one_of,
)
from archlint.launch.tables import CLASSES, SUBSTITUTIONS, LaunchClass
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.branches import BranchArms
    from archlint.finding import Place
    from archlint.interpreter.machine import Machine

OWN = "launch."
"""What the paths of launch's classes begin with, wherever they are imported from."""

MADE_BY_BASE: Field[Value] = Field("action", one_of)
"""What ``super().__init__()`` makes of an object whose class derives from one of launch's."""
ENTITIES: Field[Items] = Field("entities", join_items)
"""The actions in a launch description, which code adds to."""
GIVEN: Field[tuple[tuple[str, Value], ...]] = Field("given")
"""What the constructor of a class that derives from one of launch's is given, by name or position."""
PAIR_PLACE: Field[Place] = Field("place of a pair")
"""Where a pair of texts is written in XML and YAML."""


@dataclass(frozen=True, slots=True, eq=False)
class LaunchObject(Instance):
    """An object of a class that is in launch's tables, with its arguments by the names that its constructor has."""

    kind: LaunchClass = field(kw_only=True)
    """Its class."""
    places: dict[str, Place] = field(default_factory=dict)
    """Where each argument is written."""
    rest: tuple[Value, ...] = ()
    """Arguments beyond those that have a name."""
    open: bool = False
    """Whether there may be more arguments than are known."""
    branch_arms: BranchArms = frozenset()
    """The branches of the launch file's own code that it is made in."""
    called_at: Place | None = None
    """The call of the helper that makes it of what it is given; None for one that no such function makes."""

    @property
    def is_substitution(self) -> bool:
        """Whether it stands for a text."""
        return self.kind in SUBSTITUTIONS

    def argument(self, name: str) -> Value | None:
        """A constructor argument; None where it was not given, or is None."""
        return given(self.arguments.get(name))

    def given(self, name: str) -> Value:
        """A constructor argument, ``None`` itself where it was not given."""
        return self.arguments.get(name, NONE)


def launch_object(
    key: int,
    kind: LaunchClass,
    place: Place | None,
    arguments: dict[str, Value],
    *,
    places: dict[str, Place] | None = None,
    rest: tuple[Value, ...] = (),
    open: bool = False,
    branch_arms: BranchArms = frozenset(),
    called_at: Place | None = None,
) -> LaunchObject:
    """An object of a class of launch."""
    cls = External(f"{OWN}{kind}")
    return LaunchObject(cls, key, place, arguments, "", places or {}, rest, open, branch_arms, called_at, kind=kind)


def given(value: Value | None) -> Value | None:
    """What an argument or a default is; None for Python's ``None``, which launch takes for nothing."""
    return None if value == NONE else value


def kind_of(value: Value | None) -> LaunchClass | None:
    """The class of launch that an object is of; None for anything else, and for a class that is in no table."""
    match value:
        case LaunchObject(kind=kind):
            return kind
    return CLASSES.get(class_name(value))


def class_name(value: Value | None) -> str:
    """``Node`` for an object of launch's or launch_ros' ``Node`` …, be it in the tables or not; empty for anything
    else."""
    match value:
        case Instance(cls=External(path=path)) if path.startswith(OWN):
            return path.removeprefix(OWN)
    return ""


def argument(value: Value | None, name: str) -> Value | None:
    """A constructor argument of an object; None where it was not given, or is None."""
    return given(value.arguments.get(name)) if isinstance(value, Instance) else None


def place_of(value: Value | None) -> Place | None:
    """Where an object is made."""
    return value.place if isinstance(value, Instance) else None


def made_by_base(machine: Machine, value: Value | None) -> LaunchObject | None:
    """For an object of a workspace's class that derives from one of launch's: what ``super().__init__()`` made."""
    base_object = machine.store.get(value.key, MADE_BY_BASE) if isinstance(value, Instance) else None
    return base_object if isinstance(base_object, LaunchObject) else None


def own_method(machine: Machine, value: Instance, name: str) -> BoundMethod | None:
    """A method of an object that its class, or one that it derives from in the workspace, defines."""
    match get_attribute(machine, value, name):
        case BoundMethod(function=FunctionValue()) as method:
            return method
    return None


def given_of(machine: Machine, value: Instance) -> tuple[tuple[str, Value], ...] | None:
    """What the constructor of an object was given, by name or position; None where that is not known in full."""
    return machine.store.get(value.key, GIVEN)


def entities_of(machine: Machine, description: Instance) -> Items | None:
    """The actions of a launch description."""
    return machine.store.get(description.key, ENTITIES)


def known_text(value: Value | None) -> str | None:
    """The text that a constant is to launch; None for what is not known in full."""
    return str(value.value) if isinstance(value, Known) else None
