"""The run of one program: an abstract interpretation, and what it has found of ROS."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from archlint import model
from archlint.finding import Place
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.machine import Phase

if TYPE_CHECKING:
    from archlint.interpreter.activation import Activation
    from archlint.interpreter.heap import Store
    from archlint.interpreter.identity import Key
    from archlint.interpreter.library import Library
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.interpreter.values import ClassValue, EachValue, Value
    from archlint.libraries.values import MessageValue
    from archlint.ros.interfaces import InterfaceTable


@dataclass(eq=False)
class Pending:
    """A callback that is still to be run, with what it is called with."""

    callback: model.Callback
    value: Value
    arguments: tuple[Value, ...]
    lineage: tuple[int, ...] = ()
    """The functions (their facts, by identity) of the callbacks that led to it, the first one first."""


@dataclass(frozen=True)
class Root:
    """How code gets at something: by a variable of a module, or by an attribute of one of its classes."""

    module: Module
    name: str
    owner: str | None = None


@dataclass(frozen=True)
class Escape:
    """Where something got out of sight, and how."""

    place: Place
    reason: str


@dataclass(frozen=True)
class Shared:
    """Values that were put where all functions of a module can get at them."""

    root: Root
    values: tuple[Value, ...]
    place: Place


class Run(Interpreter):
    """The state of the run of one program.  ``library`` makes what knows the libraries that it imports."""

    def __init__(
        self,
        library: Callable[[Run], Library],
        index: ModuleIndex,
        store: Store,
        program: model.Program,
        context: model.Callback,
        interfaces: InterfaceTable | None = None,
        overrides: model.Overrides | None = None,
    ) -> None:
        super().__init__(index, store)
        self.library = library(self)
        self.program = program
        self.refused = program.refused
        self.context = context
        self.interfaces = interfaces
        self.overrides = overrides or model.Overrides()
        self.blueprints: dict[int, model.Blueprint] = {}
        self.nodes: dict[str, model.Blueprint] = {}
        self.distro: str | None = None
        """The distribution that the workspace is for, where that was said."""
        self.argv: Value | None = None
        """The list ``sys.argv``, where the command line is known."""
        self.coroutines: set[int] = set()
        """The calls, by the id of their facts, whose coroutines another call starts."""
        self.escaped: dict[int, Escape] = {}
        """Objects that code has which is not followed, by key."""
        self.shared: list[Shared] = []
        """Nodes, or what may hold some, that were put where all functions of a module can get at them."""
        self.escaping_classes: dict[int, ClassValue] = {}
        """Node classes that the entry point gives to code that is not here."""
        self.roots = 0
        """How many callbacks and methods have run."""
        self.lineage: tuple[int, ...] = ()
        """The functions of the callback that runs now and of those that led to it."""
        self.pending: list[Pending] = []
        self.started: list[Pending] = []
        """Callbacks that ran, in their order."""
        self.met_again: set[int] | None = None
        """Where callbacks run that have run before: the nodes that they made then and have met again."""
        self.news: dict[str, set[int]] = {}
        """The attributes, and of which objects (by key), in which callbacks left what another may act on."""
        self.tried: list[Pending] = []
        """The methods that nothing calls, as they were run."""
        self.at_spin: Callable[[Run], None] | None = None
        """Runs what is pending when main spins: callbacks see the state of then, not what main does at the end."""
        self.registered: dict[tuple[Any, ...], set[Key]] = {}
        """Which callbacks were handed over where, and with what each time."""
        self.fields: dict[tuple[int, str], MessageValue | EachValue] = {}
        """Messages that fields of messages hold, where nothing was assigned to them."""
        self.made_in: dict[int, Activation] = {}
        """Which call of a function made a message, by its key."""
        self.inside: dict[int, int] = {}
        """Which message a message is a field of, by their keys."""
        self.passed_to: dict[int, Place] = {}
        """The functions that fields of their parameters are used in, by the same id."""
        self.delivered: dict[int, model.Creation] = {}
        """Which subscription, server or client calls its callback with a message, by its key."""
        self.field_uses: set[tuple[Any, ...]] = set()
        self.creations: dict[tuple[Any, ...], model.Creation] = {}
        self.told_apart: dict[Key, Key] = {}
        """Which callbacks the first of the creations at one place, with one name, was given."""
        self.calls: dict[tuple[Any, ...], model.ApiCall] = {}
        self.short_lived: dict[Activation, list[model.Blueprint]] = {}
        """The nodes that nothing but the variables of a running function hold."""

    @property
    def phase(self) -> Phase:
        return _PHASES.get(self.context.role, Phase.LATER)

    def give_up(self) -> None:
        self.program.exhausted = True

    @contextmanager
    def importing(self, module: Module) -> Iterator[None]:
        kept = self.context
        self.context = model.Callback("module", module.name, Place(module.path, 1, 1, 1, 1), None)
        try:
            yield
        finally:
            self.context = kept

    def note_open_test(self, key: str, test: Value) -> None:
        """Nothing decides the test of a branch; a launch notes why."""

    def note_asked_file(self, path: str) -> None:
        """The code asks whether a file is there; a launch notes which."""

    def chain(self) -> tuple[model.Frame, ...]:
        """The calls that lead from the start of this root to what runs now."""
        frames = []
        for caller, callee in zip(self.activations, self.activations[1:], strict=False):
            if callee.call_place is not None:
                frames.append(model.Frame(caller.qualified, callee.qualified, callee.call_place, caller.body))
        return tuple(frames)


_PHASES = {"module": Phase.IMPORT, "init": Phase.START, "main": Phase.START}
"""By the role of what runs."""

__all__ = ["Escape", "Pending", "Root", "Run", "Shared"]
