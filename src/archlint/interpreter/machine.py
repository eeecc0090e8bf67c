"""The machine that interprets Python abstractly: its state, its limits, and the joining of undecided branches.

What a kind of statement, expression or call does is in rooms of their own, which know the machine; it knows none of
them (:mod:`archlint.interpreter.interpreter` puts them together) and no library either: it asks its
:class:`~archlint.interpreter.library.Library`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Iterator, Sequence
from contextlib import contextmanager
from enum import Enum
from typing import Literal

from archlint.branches import Branch, BranchArm, CodeBranch
from archlint.faults import Faults
from archlint.finding import Place
from archlint.interpreter.activation import Activation, Repeated
from archlint.interpreter.call_site import NOTHING_GIVEN, CallSite
from archlint.interpreter.caught import Raised
from archlint.interpreter.declared import definition_of, nested_class
from archlint.interpreter.heap import Layer, Store
from archlint.interpreter.implementations import sources_to_run
from archlint.interpreter.library import Library
from archlint.interpreter.limits import COMPREHENDED, IMPORTS, NESTED_CALLS, PROGRAM_STEPS, RUNS, STEPS, WORK_OF_A_STEP
from archlint.interpreter.modules import Module, ModuleIndex, Scope, ScopeKind
from archlint.interpreter.shared_variables import bind
from archlint.interpreter.values import Declared, External, Instance, Known, ModuleValue, Unknown, Value, reason
from archlint.reasons import Uninformative
from archlint.syntax import facts
from archlint.syntax.control_flow import may_run_again

Status = Literal["return", "break", "continue", "raise"] | None
"""How a block ended; None where it fell through."""


class Refused(Exception):
    """Ends the path that runs: the statement raises a TypeError."""


class Phase(Enum):
    """When code of a program runs, which decides how certain its state is."""

    IMPORT = "import"
    """While a module is imported."""
    START = "start"
    """While the program starts: nothing has come from outside."""
    LATER = "later"
    """Whenever something calls it."""


class _Arm:
    """One arm of a branch while it runs.  No ``contextmanager``: there are too many to make a generator for each."""

    def __init__(self, machine: Machine, key: Branch, arm: int) -> None:
        self.machine = machine
        self.branch_arm = key, arm
        self.depth = machine.store.depth
        self.taken: list[Layer] = []

    def __enter__(self) -> list[Layer]:
        self.machine.store.push()
        self.machine.branch_arms.append(self.branch_arm)
        return self.taken

    def __exit__(self, *_: object) -> None:
        self.machine.branch_arms.pop()
        self.taken.append(self.machine.store.cut(self.depth))


class Machine(ABC):
    """The state of one abstract interpretation."""

    library: Library
    allowed_runs = RUNS
    allowed_nesting = NESTED_CALLS
    """How many calls of one function may run at a time where it is certain that each comes to the next."""

    def __init__(self, index: ModuleIndex, store: Store) -> None:
        self.index = index
        self.store = store
        self.faults = Faults()
        """Where archlint itself failed; a linker or loader gives all of its runs one."""
        self.activations: list[Activation] = []
        self.branch_arms: list[BranchArm] = []
        self.unknown_results = 0
        """How many calls, items and tests have been met that are not known."""
        self.steps = 0
        self.allowed_steps = PROGRAM_STEPS
        self.left = PROGRAM_STEPS  # what is left of the program's statements
        self.granted = PROGRAM_STEPS  # what it had of them at first
        self.late = False
        """Whether the other programs of the workspace have spent what all may run together."""
        self.items_left = COMPREHENDED
        """How many more items its comprehensions go through."""
        self.instances: dict[int, Instance] = {}
        self.opened: set[int] = set()
        """Objects whose empty collections no longer count as empty, by key."""
        self.callers: dict[int, set[Place | None]] = {}
        """Where each function (by the id of its facts) is called; None for code that is not here."""
        self.repeats: dict[Hashable, Repeated] = {}
        self.runs: dict[int, int] = {}
        self.by_reference: dict[int, dict[str, Value]] = {}  # see references.py
        self.exhausted = False
        self.refused: set[Place] = set()  # the calls that Python refuses
        self.executed: set[tuple[int, int]] = set()
        """Functions that ran, as ``(instance key or 0, id of the function's facts)``."""
        self.ran: dict[int, tuple[facts.Function | facts.Lambda, str]] = {}
        """Functions that ran on anything, by the id of their facts, with the shown path of their file."""
        self._repeats: dict[tuple[int, int], bool] = {}  # whether a loop may repeat after a statement in it, by ids

    @property
    def phase(self) -> Phase:
        return Phase.START

    def give_up(self) -> None:
        """A bound cuts the interpretation short: the program is followed only in part."""
        self.exhausted = True

    def note_refused(self, place: Place) -> None:
        """Python refuses the call at a place."""
        self.refused.add(place)

    def are_settled(self, parameters: frozenset[str]) -> bool:
        """Whether the values of these parameters are certain while what runs now does."""
        return self.library.are_settled(parameters)

    # ------------------------------------------------------------------------------------------- places

    @property
    def activation(self) -> Activation:
        return self.activations[-1]

    def place(self, span: facts.Span) -> Place:
        return self.activations[-1].module.place(span)

    def enclosing_loops(self) -> tuple[Place, ...]:
        """The loops around what runs now, those of the callers first."""
        return tuple(
            activation.place(loop.span)
            for activation in self.activations
            if activation.loops
            for loop in self.loops_of(activation)
        )

    def loops_of(self, activation: Activation) -> list[facts.While | facts.For]:
        """The loops of a function around its present statement: what is always followed by ``break`` or
        ``return`` runs once."""
        statement = activation.statement
        if not activation.loops or statement is None:
            return activation.loops
        loops = []
        for loop in activation.loops:
            key = id(loop), id(statement)
            if key not in self._repeats:
                self._repeats[key] = may_run_again(loop, statement)
            if self._repeats[key]:
                loops.append(loop)
        return loops

    # ----------------------------------------------------------------------------------------- variables

    def new_scope(
        self,
        parent: Scope | None,
        module: Module,
        kind: ScopeKind,
        qualified: str,
        bound: frozenset[str] | None = None,
        outer: frozenset[str] = frozenset(),
    ) -> Scope:
        return Scope(self.store.new_key(), parent, module, kind, qualified, bound, outer)

    def lookup(self, name: str) -> Value | None:
        """What a name means here; None where it is no variable of any scope (then it may be a builtin)."""
        scope: Scope | None = self.activations[-1].scope
        first = True
        while scope is not None:
            if (first or scope.kind != "class") and (scope.bound is None or name in scope.bound):
                value = self.store.get(scope.key, name)
                if value is not None:
                    return definition_of(self.index, self.store, value) if value.__class__ is Declared else value
                if scope.bound is not None and name not in scope.outer and scope.kind == "function":
                    return Unknown(f"'{name}' is not assigned on this path")
            elif (nested := nested_class(self.store, scope, name)) is not None:
                return nested
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
        self._assign_in(scope, name, value)

    def _assign_in(self, scope: Scope, name: str, value: Value) -> None:
        if isinstance(value, Instance):
            self.library.rebound(value, self.store.get(scope.key, name))
        if scope.kind != "module":
            self.store.set(scope.key, name, value)
            return
        bind(self.index, self.store, scope, name, value, in_function=self.activation.scope is not scope)
        self.library.module_variable(scope.module, name, value)

    def assign_around(self, name: str, value: Value) -> None:
        """Assign to a variable that a scope around the function has, such as the module."""
        scope: Scope | None = self.activation.scope
        while scope is not None and (scope.kind == "class" or self.store.get(scope.key, name) is None):
            scope = scope.parent
        self._assign_in(scope or self.activation.scope, name, value)

    # -------------------------------------------------------------------------------------------- modules

    def import_module(self, module: Module) -> ModuleValue:
        """Run a module's body once for all programs, and return it; one that is imported too deep is not run."""
        if module.state == "new" and self.index.running >= IMPORTS:
            return ModuleValue(module)
        self.index.note_use(module)
        if module.state == "new" and self.index.import_earlier is not None:
            self.index.import_earlier(module)
        if module.state == "new":
            module.state = "running"
            module.scope = Scope(self.store.new_key(), None, module, "module", module.name)
            kept = self.activations, self.branch_arms
            self.activations, self.branch_arms = [], []
            bounds = self.steps, self.allowed_steps
            if self.late:  # what is run for all programs is not cut short for the sake of the others
                self.steps, self.allowed_steps = 0, STEPS
            try:
                with self.importing(module), self.index.first_import(module):
                    self._run_top_level(module)
            finally:
                self.activations, self.branch_arms = kept
                if self.late:
                    self.steps, self.allowed_steps = bounds
                module.state = "done"
            self.library.module_done(module)
            for source in sources_to_run(self.index, module):
                self.import_module(source)
        return ModuleValue(module)

    def _run_top_level(self, module: Module) -> None:
        assert module.scope is not None
        try:
            with self.store.at_base() as older:
                self.index.note_writes(module, older)
                self.store.set(module.scope.key, "__name__", Known(module.name))
                self.store.set(module.scope.key, "__file__", self.path_of(module))
                body = module.facts.body
                self.activations.append(Activation(module.name, module, module.scope, body, self.store.depth))
                self.execute(body)
        except Exception as error:  # of what statements do not keep to themselves: code that is nested too deep
            self.note_fault(f"following the module {module.name}", error, Place(module.path, 1, 1, 1, 1))

    @contextmanager
    def importing(self, module: Module) -> Iterator[None]:
        """While a module's top level runs."""
        yield

    def path_of(self, module: Module) -> Value:
        """What a module knows as ``__file__``."""
        return Unknown("the path of the installed file")

    def module_attribute(self, module: Module, name: str) -> Value | None:
        """``module.name``: a variable, or a submodule."""
        self.import_module(module)
        if module.scope is None:
            return Unknown("more imports inside each other than Python follows")
        if (value := self.store.get(module.scope.key, name)) is not None:
            return definition_of(self.index, self.store, value) if isinstance(value, Declared) else value
        if module.is_package:
            below = self.index.find(module, name, level=1)
            if below is not None and below is not module:
                return self.import_module(below)
        return self.star_imported(module.star_externals, name)

    def star_imported(self, packages: Sequence[str], name: str) -> Value | None:
        """A name that may come from a star import of a foreign package; None where there is no such import.  Where
        several may have it, it is unknown."""
        candidates = self.library.star_sources(packages, name)
        if len(set(candidates)) == 1:
            return External(f"{candidates[0]}.{name}")
        return Unknown(f"'{name}' comes from one of several star imports") if candidates else None

    # ----------------------------------------------------------------------------------------- statements

    def execute(self, block: list[facts.Stmt]) -> Status:
        activation = self.activation
        if self.store.work >= WORK_OF_A_STEP:
            # Joining large lists again and again takes longer than the statements that make it happen.
            self.steps += self.store.work // WORK_OF_A_STEP
            self.store.work = 0
        depth, arms = self.store.depth, len(self.branch_arms)
        for statement in block:
            self.steps += 1
            if self.steps > self.allowed_steps:
                self.give_up()
                return "raise"
            activation.statement = statement
            activation.settled = arms
            try:
                status = self.run_statement(statement)
            except Refused:
                return "raise"
            except (Raised, RecursionError, MemoryError):
                raise  # the last two not for the innermost statement, which was only the last straw
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
        del self.branch_arms[arms:]
        if self.store.depth > depth:
            self.store.merge([self.store.cut(depth)])
        return None

    def note_fault(self, what: str, error: Exception, place: Place) -> None:
        """Note a failure of archlint's own: the program is followed only in part."""
        self.faults.note(what, error, place)
        self.give_up()

    def branch(self, key: Branch, arm: int, block: list[facts.Stmt]) -> tuple[Status, Layer]:
        """Run a block as one arm of an undecided branch; its writes are returned, not applied."""
        with self.arm(key, arm) as taken:
            status = self.execute(block)
        return status, taken[0]

    def arm(self, key: Branch, arm: int) -> _Arm:
        """What runs inside belongs to one arm of a branch; the list then holds what it wrote."""
        return _Arm(self, key, arm)

    def leave_open(self, key: Branch, test: Value) -> str | None:
        """Note a test that nothing decides; the reason, where it says more than that."""
        self.library.undecided(key, test)
        self.unknown_results += 1
        why = reason(test)
        if isinstance(why, Uninformative):
            return None
        self.activation.open_test = self.activation.open_test or why
        return why

    def end_arm(self, key: Branch, arm: int, status: Status) -> None:
        """Note of an arm that it leaves the function, where it does: what follows never runs beside it."""
        activation = self.activation
        if status == "return" or (status == "raise" and not activation.tries):
            activation.ended_arms |= {(key, arm)}

    def ended_arms(self) -> frozenset[BranchArm]:
        """The arms that have left one of the running functions."""
        return frozenset().union(*(activation.ended_arms for activation in self.activations))

    def join(self, results: list[tuple[Status, Layer]], why: str | None = None) -> Status:
        """Go on after alternative blocks: with the joined state of those that do not leave the function.

        ``why`` says why it is not decided which of them runs."""
        live = [layer for status, layer in results if status not in ("return", "raise")]
        if live:
            self.store.merge(live, why)
            ended = {status for status, _ in results if status not in ("return", "raise")}
            if len(ended) > 1 and "break" in ended and self.activation.loops:
                self.activation.left.add(id(self.activation.loops[-1]))
            return ended.pop() if len(ended) == 1 else None
        statuses = [status for status, _ in results]
        return "return" if "return" in statuses else statuses[0]

    def branch_at(self, span: facts.Span, part: int | None = None) -> CodeBranch:
        """The branch that something in the current file decides."""
        return CodeBranch(self.activation.module.path, span[0], span[1], part)

    # ------------------------------------------------------------------------------ what the rooms implement

    @abstractmethod
    def run_statement(self, statement: facts.Stmt) -> Status:
        """Run one statement."""

    @abstractmethod
    def evaluate(self, expression: facts.Expr) -> Value:
        """The value of an expression."""

    @abstractmethod
    def call(self, function: Value, site: CallSite = NOTHING_GIVEN) -> Value:
        """Call a value.  What is not known to be callable evaluates to unknown."""


__all__ = ["Activation", "Machine", "Phase", "Refused"]
