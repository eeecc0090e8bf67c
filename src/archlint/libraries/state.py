"""What the run of a program finds of ROS, by what it is of: nodes, create calls, callbacks, messages, what escapes."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import field
from typing import TYPE_CHECKING, Any

from archlint import model
from archlint.finding import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.branches import BranchArm
    from archlint.interpreter.activation import Activation
    from archlint.interpreter.changing import Changes
    from archlint.interpreter.heap import Slot
    from archlint.interpreter.identity import Key
    from archlint.interpreter.modules import Module
    from archlint.interpreter.values import ClassValue, Value


Lineage = tuple[model.FunctionRef | None, ...]
"""The functions of the callbacks that led to another, the first one first."""


Within = tuple["int | BranchArm", ...]
"""Where a callback runs while another one, or the main program, goes on: the roots around it, and the arms of branches
that each of them is in."""


@dataclass(eq=False)
class Pending:
    """A callback that is still to be run, with what it is called with."""

    callback: model.Callback
    value: Value
    arguments: tuple[Value, ...]
    lineage: Lineage = ()
    began: int = 0
    """Which of the program's roots it was when it last ran, counted from 1."""
    read: Set[Slot] = frozenset()
    """What it read then of the state that it met."""
    within: Within | None = None
    """Where that was; None at the end of the program, when all ways through it are joined."""


@dataclass(frozen=True, slots=True)
class Left:
    """What a callback has left in an attribute of an object that others may act on."""

    after: int
    """How many roots had begun by then: those that begin later meet it, unless they run on another way."""
    within: Within = ()
    by: int = 0
    """Which root left it, where that one has made the object itself and nothing that was there before leads to it."""
    doors: frozenset[Slot] = frozenset()
    """Where something that was there before leads to it, if the callback has made the object: who has read one of these
    may find the object, and has not asked it before."""

    def is_new_to(self, pending: Pending) -> bool:
        """Whether a callback has not met it yet."""
        if pending.began == self.by:
            return False
        joined = pending.within is None or pending.within[: len(self.within)] == self.within
        return pending.began <= self.after or not joined


@dataclass(frozen=True)
class Root:
    """How code gets at something: by a variable of a module, or by an attribute of one of its classes."""

    module: Module
    name: str
    owner: str | None = None


@dataclass(frozen=True)
class Escape:
    """Where something escaped, and how."""

    place: Place
    reason: str


@dataclass(frozen=True)
class Shared:
    """Values that were put where all functions of a module can get at them."""

    root: Root
    values: tuple[Value, ...]
    place: Place


@dataclass
class Nodes:
    """The nodes that a program makes."""

    by_key: dict[str, model.Blueprint] = field(default_factory=dict)
    by_object: dict[int, model.Blueprint] = field(default_factory=dict)
    """Those that are objects of a class of the workspace, by the key of the object."""
    initialised: bool = False
    """Whether the program may have called ``rclpy.init()``."""
    too_early: list[tuple[Place, str]] = field(default_factory=list)
    """Where nodes are made before that, and of which class."""
    without_arguments: set[int] = field(default_factory=set)
    """The contexts, by the keys of their objects, that ``rclpy.init(args=[])`` keeps the command line from."""
    short_lived: dict[Activation, list[tuple[model.Blueprint, str]]] = field(default_factory=dict)
    """Those that nothing but the variables of a running function hold, each with the variable."""
    revisited: set[int] | None = None
    """Where callbacks run that have run before: the nodes that they made then and have met again, by id."""


@dataclass
class Calls:
    """What is noted of calls."""

    creations: dict[tuple[Any, ...], model.Creation] = field(default_factory=dict)
    first_functions: dict[Key, Key] = field(default_factory=dict)
    """Which callbacks the first of the creations at one place, with one name, was given."""
    watched: dict[tuple[Any, ...], model.ApiCall] = field(default_factory=dict)
    """The calls that rules want to see."""
    refused: dict[tuple[Place, str], model.RefusedCall | None] = field(default_factory=dict)
    """The calls of libraries that are refused, by where they are and what they call; None of one that is not always."""
    futures: dict[tuple[Place, str], model.MistakenFuture | None] = field(default_factory=dict)
    """The futures that are taken for what they will hold, by where and what is read of them; None of one that is not
    always."""
    absent_reads: dict[tuple[Place, str], model.AbsentRead | None] = field(default_factory=dict)
    """The attributes that objects of the workspace's classes do not have, by where they are read; None of one that is
    there at times."""
    set_on_futures: set[str] = field(default_factory=set)
    """The attributes that code gives to futures."""


@dataclass(eq=False)
class ChangedAttributes:
    """The attributes of a program's objects that methods of their classes change: a row in each of several lists, since
    there are thousands and all of them are looked at for each method."""

    slots: list[tuple[int, str]] = field(default_factory=list)
    """The key of the object, and the attribute."""
    changes: list[Changes] = field(default_factory=list)
    """What the methods put there."""
    values: list[Value | None] = field(default_factory=list)
    """What it held when a method was last run."""
    options: list[tuple[Value, ...] | None] = field(default_factory=list)
    """What it may hold at any time for that, as :mod:`archlint.programs.any_time` has it."""
    changing: list[tuple[tuple[int, str], tuple[Value, ...]]] = field(default_factory=list)
    """Those that may hold something else then, with what."""
    seen_instances: int = 0
    """How many of the program's objects these are of."""

    def add(self, slot: tuple[int, str], changes: Changes) -> None:
        """One more attribute, of which nothing is known yet."""
        self.slots.append(slot)
        self.changes.append(changes)
        self.values.append(None)
        self.options.append(None)


@dataclass
class Callbacks:
    """The callbacks of a program: registered, running, run."""

    pending: list[Pending] = field(default_factory=list)
    """Handed over, and still to be run."""
    started: list[Pending] = field(default_factory=list)
    """Callbacks that ran, in their order."""
    tried: list[Pending] = field(default_factory=list)
    """The methods that nothing calls, as they were run."""
    count: int = 0
    """How many callbacks and methods have run."""
    within: Within = ()
    """Where those run that begin now, but for the branches that are open."""
    ended: bool = False
    """Whether the main program has ended."""
    lineage: Lineage = ()
    """The functions of the callback that runs now and of those that led to it."""
    registered: dict[tuple[Any, ...], set[Key]] = field(default_factory=dict)
    """Which callbacks were registered where, and with what each time."""
    news: dict[str, dict[int, set[Left]]] = field(default_factory=dict)
    """The attributes, and of which objects (by key), in which callbacks left what another may act on."""
    coroutines: dict[int, model.Role] = field(default_factory=dict)
    """The calls, by the id of their facts, whose coroutines another call starts, and as what."""
    changed_attributes: ChangedAttributes = field(default_factory=ChangedAttributes)
    """What methods change of the program's objects."""


@dataclass
class Messages:
    """The messages of a program, by their keys, and what the code does with their fields."""

    fields: dict[tuple[int, str], Value] = field(default_factory=dict)
    """What fields of messages hold, where nothing was assigned to them."""
    made_in: dict[int, Activation] = field(default_factory=dict)
    """Which call of a function made a message."""
    inside: dict[int, int] = field(default_factory=dict)
    """Which message a message is a field of."""
    delivered: dict[int, model.Creation] = field(default_factory=dict)
    """Which subscription, server or client calls its callback with a message."""
    answered: dict[int, model.Creation] = field(default_factory=dict)
    """Which client a response was sent to."""
    asked_in: dict[Place, Activation] = field(default_factory=dict)
    """Which call of a function has last asked a client of its own object, at that place."""
    passed_to: dict[int, Place] = field(default_factory=dict)
    """The functions, by the id of their facts, that fields of their parameters are used in."""
    uses: set[tuple[Any, ...]] = field(default_factory=set)
    """The uses of fields that are noted."""
    values: dict[tuple[Place, str], model.WrongValue | None] = field(default_factory=dict)
    wrong_arguments: set[tuple[Place, str]] = field(default_factory=set)
    """Those of them that a call of the function around decides, whatever other calls give it."""
    """What fields are given that do not take it, by where and the field; None where it is not always wrong."""


@dataclass
class Escapes:
    """What code has got that is not followed, or may get."""

    objects: dict[int, Escape] = field(default_factory=dict)
    """Objects that code has which is not followed, by key."""
    shared: list[Shared] = field(default_factory=list)
    """Nodes, or what may hold some, that were put where all functions of a module can get at them."""
    classes: dict[int, ClassValue] = field(default_factory=dict)
    """Node classes that the entry point gives to code that is not here, by id."""


__all__ = ["Callbacks", "Calls", "Escape", "Escapes", "Messages", "Nodes", "Pending", "Root", "Shared"]
