"""The symbolic run: state, statements, and the joining of undecided branches.

Expressions are evaluated in :mod:`archlint.interpreter.expressions`, calls in :mod:`archlint.interpreter.calls`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from archlint import model
from archlint.faults import Faults
from archlint.finding import Place
from archlint.interpreter.heap import Layer, Store
from archlint.interpreter.refusals import Refused
from archlint.interpreter.values import (
    ClassValue,
    EachValue,
    FunctionValue,
    Instance,
    Known,
    MessageValue,
    ModuleValue,
    Scope,
    Unknown,
    Value,
)
from archlint.syntax import facts
from archlint.syntax.control_flow import comes_round

if TYPE_CHECKING:
    from archlint.interpreter import identity, repeats
    from archlint.interpreter.modules import Module, ModuleIndex
    from archlint.ros.interfaces import InterfaceTable

DEPTH = 48
"""How many calls deep a run follows."""
STEPS = 8_000
"""How many statements one callback may run."""
PROGRAM_STEPS = 80_000
"""How many statements all of a program may run, its entry point first; from then on each root has few."""
TEST_STEPS = 8_000
"""The same for test code: its nodes are shown, but what it calls in the library is not its own."""
FEW_STEPS = 400
"""What a root may run in any case, so that no callback goes unseen."""
EXTRA_STEPS = 80_000
"""What all roots of a program may run in this way, once its own statements are spent: each of them may start more."""
ROOTS = 4_000
"""How many callbacks and methods of a program run: a fleet of nodes has some hundreds."""
SELF_STARTS = 2
"""How often a function runs as a callback that it started itself.  A callback that makes a node of its own class
gives each node a callback of its own; the third does what the second did."""
WORK_OF_A_STEP = 500
"""How many slots and items that branches leave may be joined for the price of a statement."""
UNROLL = 512
"""How many items of a known collection a loop is unrolled over."""
COMPREHENDED = 8_000
"""How many items all comprehensions of a program go through one by one: tables of numbers are no names."""

Status = str | None
"""How a block ended: None (fell through), ``return``, ``break``, ``continue``, ``raise``."""


@dataclass(eq=False)
class Activation:
    """One running function (or module, or class body)."""

    qualified: str
    module: Module
    scope: Scope
    body: list[facts.Stmt]
    depth: int
    """Depth of the store when it began."""
    function: FunctionValue | None = None
    self_value: Value | None = None
    call_place: Place | None = None
    statement: facts.Stmt | None = None
    loops: list[facts.While | facts.For] = field(default_factory=list)
    left: set[int] = field(default_factory=set)
    """Loops (by identity) that an undecided ``break`` may have left."""
    tries: int = 0
    """How many ``try`` blocks of the function are around what runs now."""
    forgiving: int = 0
    """How many of them may be there for an attribute that is missing."""
    returns: list[tuple[Value, Layer | None]] = field(default_factory=list)
    yields: list[Value] = field(default_factory=list)
    scopes: list[int] = field(default_factory=list)
    """Scopes that end with it: its own, and those of its comprehensions."""
    arms: int = 0
    """How many undecided branches it was called in."""
    settled: int = -1
    """How many undecided branches there were when the statement that runs began: no more are left to chance in it."""
    closed_over: bool = False
    """Whether a function defined inside may outlive it."""
    short_lived: list[model.Blueprint] = field(default_factory=list)
    """The nodes that nothing but its variables hold."""

    def forget(self, layers: list[Layer]) -> None:
        """Drop the variables of a function that has ended, unless an inner function still needs them."""
        if self.closed_over:
            return
        for layer in layers:
            for at in [at for at in layer if at[0] in self.scopes]:
                del layer[at]

    def place(self, span: facts.Span) -> Place:
        return Place(self.module.path, *span)


@dataclass(eq=False)
class Pending:
    """A callback that is still to be run, with what it is called with."""

    callback: model.Callback
    value: Value
    arguments: tuple[Value, ...]
    lineage: tuple[int, ...] = ()
    """The functions (their facts, by identity) of the callbacks that led to it, the first one first."""


class Run:
    """The state of the symbolic run of one program."""

    def __init__(
        self,
        index: ModuleIndex,
        store: Store,
        program: model.Program,
        context: model.Callback,
        interfaces: InterfaceTable | None = None,
        overrides: model.Overrides | None = None,
    ) -> None:
        self.index = index
        self.store = store
        self.program = program
        self.context = context
        self.interfaces = interfaces
        self.overrides = overrides or model.Overrides()
        self.faults = Faults()
        """Where archlint itself failed; a linker or loader gives all of its runs one."""
        self.activations: list[Activation] = []
        self.arms: list[tuple[str, int]] = []
        self.steps = 0
        self.allowed_steps = PROGRAM_STEPS
        self.left = PROGRAM_STEPS
        """What is left of the program's statements."""
        self.granted = PROGRAM_STEPS
        """What it had of them at first."""
        self.late = False
        """Whether the other programs of the workspace have spent what all may run together."""
        self.items_left = COMPREHENDED
        """How many more items its comprehensions go through."""
        self.blueprints: dict[int, model.Blueprint] = {}
        self.nodes: dict[str, model.Blueprint] = {}
        self.instances: dict[int, Instance] = {}
        self.distro: str | None = None
        """The distribution that the workspace is for, where that was said."""
        self.argv: Value | None = None
        """The list ``sys.argv``, where the command line is known."""
        self.coroutines: set[int] = set()
        """The calls, by the id of their facts, whose coroutines another call starts."""
        self.opened: set[int] = set()
        """Objects whose empty collections no longer count as empty, by key."""
        self.escaped: dict[int, escapes.Escape] = {}
        """Objects that code has which is not followed, by key."""
        self.shared: list[escapes.Shared] = []
        """Nodes, or what may hold some, that were put where all functions of a module can get at them."""
        self.handed_out: dict[int, ClassValue] = {}
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
        self.registered: dict[tuple[Any, ...], set[identity.Key]] = {}
        """Which callbacks were handed over where, and with what each time."""
        self.fields: dict[tuple[int, str], MessageValue | EachValue] = {}
        """Messages that fields of messages hold, where nothing was assigned to them."""
        self.made_in: dict[int, Activation] = {}
        """Which call of a function made a message, by its key."""
        self.inside: dict[int, int] = {}
        """Which message a message is a field of, by their keys."""
        self.callers: dict[int, set[Place | None]] = {}
        """Where each function (by the id of its facts) is called; None for code that is not here."""
        self.passed_to: dict[int, Place] = {}
        """The functions that fields of their parameters are used in, by the same id."""
        self.delivered: dict[int, model.Creation] = {}
        """Which subscription, server or client calls its callback with a message, by its key."""
        self.field_uses: set[tuple[Any, ...]] = set()
        self.creations: dict[tuple[Any, ...], model.Creation] = {}
        self.told_apart: dict[identity.Key, identity.Key] = {}
        """Which callbacks the first of the creations at one place, with one name, was given."""
        self.calls: dict[tuple[Any, ...], model.ApiCall] = {}
        self.repeats: dict[identity.Key, repeats.Repeated] = {}
        self.runs: dict[int, int] = {}
        self.executed: set[tuple[int, int]] = set()
        """Functions that ran, as ``(instance key or 0, id of the function's facts)``."""
        self.comes_round: dict[tuple[int, int], bool] = {}
        """Whether a loop may go round again after a statement in it, by their ids."""
        self.ran: set[int] = set()
        """Functions that ran on anything."""

    # ------------------------------------------------------------------------------------------- places

    @property
    def activation(self) -> Activation:
        return self.activations[-1]

    def place(self, span: facts.Span) -> Place:
        return Place(self.activation.module.path, *span)

    def chain(self) -> tuple[model.Frame, ...]:
        """The calls that lead from the start of this root to what runs now."""
        frames = []
        for caller, callee in zip(self.activations, self.activations[1:], strict=False):
            if callee.call_place is not None:
                frames.append(model.Frame(caller.qualified, callee.qualified, callee.call_place, caller.body))
        return tuple(frames)

    def rounds(self) -> tuple[Place, ...]:
        """The loops that go round what runs now, those of the callers first."""
        return tuple(one.place(loop.span) for one in self.activations for loop in self.loops_of(one))

    def loops_of(self, activation: Activation) -> list[facts.While | facts.For]:
        """The loops of a function that go round its present statement: what is always followed by ``break`` or
        ``return`` runs once."""
        statement = activation.statement
        if not activation.loops or statement is None:
            return activation.loops
        found = []
        for loop in activation.loops:
            key = id(loop), id(statement)
            if key not in self.comes_round:
                self.comes_round[key] = comes_round(loop, statement)
            if self.comes_round[key]:
                found.append(loop)
        return found

    # ----------------------------------------------------------------------------------------- variables

    def new_scope(
        self,
        parent: Scope | None,
        module: Module,
        kind: str,
        qualified: str,
        bound: frozenset[str] | None = None,
        outer: frozenset[str] = frozenset(),
    ) -> Scope:
        return Scope(self.store.new_key(), parent, module, kind, qualified, bound, outer)

    def lookup(self, name: str) -> Value | None:
        """What a name means here; None where it is no variable of any scope (then it may be a builtin)."""
        scope: Scope | None = self.activation.scope
        first = True
        while scope is not None:
            if (first or scope.kind != "class") and (scope.bound is None or name in scope.bound):
                value = self.store.get(scope.key, name)
                if isinstance(value, Value):
                    return value
                if scope.bound is not None and name not in scope.outer and scope.kind == "function":
                    return Unknown(f"'{name}' is not assigned on this path")
            first = False
            scope = scope.parent
        return None

    def assign_name(self, name: str, value: Value) -> None:
        scope = self.activation.scope
        if name in scope.outer:
            target = scope.parent
            while target is not None and (
                target.kind == "class" or (target.bound is not None and name not in target.bound)
            ):
                target = target.parent
            scope = target or scope
        if isinstance(value, Instance):
            nodes.note_replaced(self, value, self.store.get(scope.key, name))
        self.store.set(scope.key, name, value)
        if scope.kind == "module":
            escapes.named(self, scope.module, name, value)

    # -------------------------------------------------------------------------------------------- modules

    def import_module(self, module: Module) -> ModuleValue:
        """Run a module's body once for all programs, and return it."""
        if module.state == "new":
            module.state = "running"
            module.scope = Scope(self.store.new_key(), None, module, "module", module.name)
            kept = self.activations, self.arms, self.context
            context = model.Callback("module", module.name, Place(module.path, 1, 1, 1, 1), None)
            self.activations, self.arms, self.context = [], [], context
            bounds = self.steps, self.allowed_steps
            if self.late:  # what is run for all programs is not cut short for the sake of the others
                self.steps, self.allowed_steps = 0, STEPS
            try:
                with self.store.at_base():
                    self.store.set(module.scope.key, "__name__", Known(module.name))
                    self.store.set(module.scope.key, "__file__", self.path_of(module))
                    self.activations.append(
                        Activation(module.name, module, module.scope, module.facts.body, self.store.depth)
                    )
                    self.execute(module.facts.body)
            except Exception as error:  # of what statements do not keep to themselves: code that is nested too deep
                self.note_fault(f"following the module {module.name}", error, context.place)
            finally:
                self.activations, self.arms, self.context = kept
                if self.late:
                    self.steps, self.allowed_steps = bounds
                module.state = "done"
            escapes.share(self, module)
        return ModuleValue(module)

    def path_of(self, module: Module) -> Value:
        """What a module knows as ``__file__``."""
        return Unknown("the path of the installed file")

    def module_attribute(self, module: Module, name: str) -> Value | None:
        """``module.name``: a variable, or a submodule."""
        self.import_module(module)
        assert module.scope is not None
        value = self.store.get(module.scope.key, name)
        if isinstance(value, Value):
            return value
        if module.is_package:
            below = self.index.find(module, name, level=1)
            if below is not None and below is not module:
                return self.import_module(below)
        return expressions.star_imported(self, module.star_externals, name)

    # ----------------------------------------------------------------------------------------- statements

    def execute(self, block: list[facts.Stmt]) -> Status:
        activation = self.activation
        if self.store.work >= WORK_OF_A_STEP:
            # Joining large lists again and again takes longer than the statements that make it happen.
            self.steps += self.store.work // WORK_OF_A_STEP
            self.store.work = 0
        depth, arms = self.store.depth, len(self.arms)
        for statement in block:
            self.steps += 1
            if self.steps > self.allowed_steps:
                self.program.exhausted = True
                return "raise"
            activation.statement = statement
            activation.settled = arms
            try:
                status = statements.STATEMENTS[statement.__class__](self, statement)
            except Refused:
                return "raise"
            except (RecursionError, MemoryError):
                raise  # not for the innermost statement, which was only the last straw
            except Exception as error:
                status = self._step_over(statement, error, activation, depth, arms)
            if status is not None:
                return status
        return None

    def _step_over(
        self, statement: facts.Stmt, error: Exception, activation: Activation, depth: int, arms: int
    ) -> Status:
        """Go on behind a statement that archlint failed at, with the state as far as it got."""
        span = (1, 1, 1, 1) if isinstance(statement, facts.Global) else statement.span
        self.note_fault("following this statement", error, activation.place(span))
        del self.activations[self.activations.index(activation) + 1 :]
        del self.arms[arms:]
        if self.store.depth > depth:
            self.store.merge([self.store.cut(depth)])
        return None

    def note_fault(self, what: str, error: Exception, place: Place) -> None:
        """Note a failure of archlint's own: the program is followed only in part."""
        self.faults.note(what, error, place)
        self.program.exhausted = True

    def note_open_test(self, key: str, test: Value) -> None:
        """Nothing decides the test of a branch; a launch notes why."""

    def note_asked_file(self, path: str) -> None:
        """The code asks whether a file is there; a launch notes which."""

    def branch(self, key: str, arm: int, block: list[facts.Stmt]) -> tuple[Status, Layer]:
        """Run a block as one arm of an undecided branch; its writes are returned, not applied."""
        with self.arm(key, arm) as taken:
            status = self.execute(block)
        return status, taken[0]

    @contextmanager
    def arm(self, key: str, arm: int) -> Iterator[list[Layer]]:
        """What runs inside belongs to one arm of a branch; the list then holds what it wrote."""
        depth = self.store.depth
        self.store.push()
        self.arms.append((key, arm))
        taken: list[Layer] = []
        try:
            yield taken
        finally:
            self.arms.pop()
            taken.append(self.store.cut(depth))

    def join(self, results: list[tuple[Status, Layer]]) -> Status:
        """Go on after alternative blocks: with the joined state of those that do not leave the function."""
        live = [layer for status, layer in results if status not in ("return", "raise")]
        if live:
            self.store.merge(live)
            ended = {status for status, _ in results if status not in ("return", "raise")}
            if len(ended) > 1 and "break" in ended and self.activation.loops:
                self.activation.left.add(id(self.activation.loops[-1]))
            return ended.pop() if len(ended) == 1 else None
        statuses = [status for status, _ in results]
        return "return" if "return" in statuses else statuses[0]

    def key_of(self, span: facts.Span) -> str:
        return f"{self.activation.module.path}:{span[0]}:{span[1]}"

    # ---------------------------------------------------------- implemented by the neighbouring modules

    def evaluate(self, expression: facts.Expr) -> Value:
        return expressions.evaluate(self, expression)

    def call(
        self,
        function: Value,
        args: list[Value],
        keywords: dict[str, Value],
        expression: facts.Call | None = None,
        open_arguments: bool = False,
    ) -> Value:
        return calls.call(self, function, args, keywords, expression, open_arguments)


# The three modules are one machine in three rooms: statements here need expressions and calls there.
from archlint.interpreter import calls, expressions, statements
from archlint.libraries.rclpy import escapes, nodes

__all__ = ["Activation", "Pending", "Run"]
