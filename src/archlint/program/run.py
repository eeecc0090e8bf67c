"""The symbolic run: state, statements, and the joining of undecided branches.

Expressions are evaluated in :mod:`archlint.program.expressions`, calls in :mod:`archlint.program.calls`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from archlint.facts import model as facts
from archlint.finding import Place
from archlint.program import messages, model
from archlint.program.store import Layer, Store
from archlint.program.values import (
    FALSE,
    NONE,
    TRUE,
    ClassValue,
    External,
    FunctionValue,
    Instance,
    Known,
    MessageValue,
    ModuleValue,
    NodeValue,
    Scope,
    Unknown,
    Value,
    alternatives,
    one_of,
)

if TYPE_CHECKING:
    from archlint.program.interface_table import InterfaceTable
    from archlint.program.modules import Module, ModuleIndex

DEPTH = 48
"""How many calls deep a run follows."""
STEPS = 20_000
"""How many statements one callback may run."""
PROGRAM_STEPS = 150_000
"""How many statements all of a program may run, its entry point first; from then on each root has few."""
TEST_STEPS = 8_000
"""The same for test code: its nodes are shown, but what it calls in the library is not its own."""
FEW_STEPS = 600
"""What a root may run in any case, so that no callback goes unseen."""
REPEATS = 3
"""How often one root runs a function with the same arguments."""
RUNS = 150
"""How often one root runs a function with any arguments."""
UNROLL = 512
"""How many items of a known collection a loop is unrolled over."""

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
    tries: int = 0
    returns: list[tuple[Value, Layer | None]] = field(default_factory=list)
    yields: list[Value] = field(default_factory=list)
    scopes: list[int] = field(default_factory=list)
    """Scopes that end with it: its own, and those of its comprehensions."""
    arms: int = 0
    """How many undecided branches it was called in."""
    closed_over: bool = False
    """Whether a function defined inside may outlive it."""

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


class Run:
    """The state of the symbolic run of one program."""

    def __init__(
        self,
        index: ModuleIndex,
        store: Store,
        program: model.Program,
        context: model.Callback,
        interfaces: InterfaceTable | None = None,
        overrides: dict[str, object] | None = None,
    ) -> None:
        self.index = index
        self.store = store
        self.program = program
        self.context = context
        self.interfaces = interfaces
        self.overrides = overrides or {}
        self.activations: list[Activation] = []
        self.arms: list[tuple[str, int]] = []
        self.steps = 0
        self.allowed_steps = PROGRAM_STEPS
        self.left = PROGRAM_STEPS
        """What is left of the program's statements."""
        self.blueprints: dict[int, model.Blueprint] = {}
        self.nodes: dict[str, model.Blueprint] = {}
        self.instances: dict[int, Instance] = {}
        self.pending: list[Pending] = []
        self.started: list[Pending] = []
        """Callbacks that ran, in their order."""
        self.stateful = False
        """Whether a callback left an object in an attribute that another may use."""
        self.at_spin: Callable[[Run], None] | None = None
        """Runs what is pending when main spins: callbacks see the state of then, not what main does at the end."""
        self.registered: set[tuple[Any, ...]] = set()
        self.fields: dict[tuple[int, str], MessageValue] = {}
        """Messages that fields of messages hold, where nothing was assigned to them."""
        self.made_in: dict[int, Activation] = {}
        """Which call of a function made a message, by its key."""
        self.field_uses: set[tuple[Any, ...]] = set()
        self.creations: dict[tuple[Any, ...], model.Creation] = {}
        self.calls: dict[tuple[Any, ...], model.ApiCall] = {}
        self.repeats: dict[tuple[Any, ...], tuple[int, Value]] = {}
        self.runs: dict[int, int] = {}
        self.executed: set[tuple[int, int]] = set()
        """Functions that ran, as ``(instance key or 0, id of the function's facts)``."""
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
                frames.append(model.Frame(caller.qualified, callee.qualified, callee.call_place))
        return tuple(frames)

    def rounds(self) -> tuple[Place, ...]:
        """The loops that go round what runs now, those of the callers first."""
        return tuple(one.place(loop.span) for one in self.activations for loop in one.loops)

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
        self.store.set(scope.key, name, value)

    # -------------------------------------------------------------------------------------------- modules

    def import_module(self, module: Module) -> ModuleValue:
        """Run a module's body once for all programs, and return it."""
        if module.state == "new":
            module.state = "running"
            module.scope = Scope(self.store.new_key(), None, module, "module", module.name)
            kept = self.activations, self.arms, self.context
            context = model.Callback("module", module.name, Place(module.path, 1, 1, 1, 1), None)
            self.activations, self.arms, self.context = [], [], context
            try:
                with self.store.at_base():
                    self.store.set(module.scope.key, "__name__", Known(module.name))
                    self.store.set(module.scope.key, "__file__", Unknown("the path of the installed file"))
                    self.activations.append(
                        Activation(module.name, module, module.scope, module.facts.body, self.store.depth)
                    )
                    self.execute(module.facts.body)
            finally:
                self.activations, self.arms, self.context = kept
                module.state = "done"
        return ModuleValue(module)

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
        for statement in block:
            self.steps += 1
            if self.steps > self.allowed_steps:
                self.program.exhausted = True
                return "raise"
            activation.statement = statement
            status = _STATEMENTS[statement.__class__](self, statement)
            if status is not None:
                return status
        return None

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


# ------------------------------------------------------------------------------------------ the statements


def assign(run: Run, target: facts.Expr, value: Value) -> None:
    """Bind an assignment target."""
    kind = target.__class__
    if kind is facts.Name:
        assert isinstance(target, facts.Name)
        run.assign_name(target.id, value)
    elif kind is facts.Attribute:
        assert isinstance(target, facts.Attribute)
        expressions.set_attribute(run, run.evaluate(target.value), target.attr, value, target)
    elif kind is facts.Subscript:
        assert isinstance(target, facts.Subscript)
        expressions.set_item(run, run.evaluate(target.value), run.evaluate(target.index), value)
    elif kind is facts.Sequence:
        assert isinstance(target, facts.Sequence)
        _unpack(run, target.elements, value)
    elif kind is facts.Starred:
        assert isinstance(target, facts.Starred)
        assign(run, target.value, value)


def _unpack(run: Run, targets: list[facts.Expr], value: Value) -> None:
    if isinstance(value, (Unknown,)):
        for target in targets:
            assign(run, target, value)
        return
    rows = []
    for alternative in alternatives(value):
        items = expressions.iterate(run, alternative)
        rows.append(None if items is None or items.open else list(items.values))
    stars = [i for i, target in enumerate(targets) if isinstance(target, facts.Starred)]
    if any(row is None for row in rows) or stars or any(len(row or ()) != len(targets) for row in rows):
        if len(rows) == 1 and rows[0] is not None and len(stars) == 1 and len(rows[0]) >= len(targets) - 1:
            row, at = rows[0], stars[0]
            after = len(targets) - at - 1
            middle = row[at : len(row) - after]
            for target, item in zip(targets[:at], row[:at], strict=True):
                assign(run, target, item)
            assign(run, targets[at], expressions.new_list(run, middle))
            for target, item in zip(targets[at + 1 :], row[len(row) - after :], strict=True):
                assign(run, target, item)
            return
        for target in targets:
            assign(run, target, Unknown("the items of this value are not known"))
        return
    for i, target in enumerate(targets):
        assign(run, target, one_of(row[i] for row in rows if row is not None))


def _assign(run: Run, s: facts.Assign) -> Status:
    value = run.evaluate(s.value)
    for target in s.targets:
        assign(run, target, value)
    return None


def _annotated(run: Run, s: facts.Annotated) -> Status:
    if s.value is not None:
        assign(run, s.target, run.evaluate(s.value))
    elif run.activation.scope.kind == "class" and isinstance(s.target, facts.Name):
        pass  # a dataclass field without a default; its value comes from the constructor
    return None


def _augmented(run: Run, s: facts.Augmented) -> Status:
    # What counts up at run time has no one value: only a straight run of a function keeps it known.
    before = run.evaluate(s.target)
    operand = run.evaluate(s.value)
    value = expressions.binary(run, s.op, before, operand, s.span)
    counted = isinstance(s.target, facts.Attribute) and run.context.role not in ("init", "main", "module")
    if counted and isinstance(value, Known) and not isinstance(value.value, str):
        value = Unknown("the value changes at run time")
    assign(run, s.target, value)
    return None


def _expression(run: Run, s: facts.Expression) -> Status:
    run.evaluate(s.value)
    if isinstance(s.value, facts.Call) and calls.never_returns(run, s.value):
        return "raise"
    return None


def _return(run: Run, s: facts.Return) -> Status:
    value = NONE if s.value is None else run.evaluate(s.value)
    activation = run.activation
    straight = run.store.depth == activation.depth + 1
    activation.returns.append((value, None if straight else run.store.above(activation.depth)))
    return "return"


def _raise(run: Run, s: facts.Raise) -> Status:
    if s.value is not None:
        run.evaluate(s.value)
    return "raise"


def _if(run: Run, s: facts.If) -> Status:
    test = run.evaluate(s.test)
    truth = expressions.truth(run, test)
    if truth is not None:
        return run.execute(s.body if truth else s.orelse)
    key = run.key_of(s.span)
    results = []
    for arm, block in enumerate((s.body, s.orelse)):
        with run.arm(key, arm) as taken:
            expressions.narrow(run, s.test, arm == 0)
            status = run.execute(block)
        results.append((status, taken[0]))
    return run.join(results)


def _for(run: Run, s: facts.For) -> Status:
    iterable = run.evaluate(s.iterable)
    activation = run.activation
    activation.loops.append(s)
    try:
        items = expressions.iterate(run, iterable)
        if items is None or items.open or len(items.values) > UNROLL:
            return _loop_of_unknown(run, s, iterable, items)
        for item in items.values:
            assign(run, s.target, item)
            status = run.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return run.execute(s.orelse)


def _loop_of_unknown(run: Run, s: facts.For, iterable: Value, items: expressions.Items | None) -> Status:
    key = run.key_of(s.span)
    if items is not None and len(items.values) <= UNROLL:
        for number, item in enumerate(items.values):
            with run.arm(key + f"#{number}", 0) as taken:
                assign(run, s.target, item)
                run.execute(s.body)
            run.store.merge([taken[0], {}])
        if any(isinstance(item, Unknown) for item in items.values):
            return None
    from archlint.program.values import reason

    with run.arm(key, 0) as taken:
        _forget_counters(run, s.body)
        why = reason(iterable)
        if why == "the value is not a constant":
            why = "what the loop runs over is not known"
        assign(run, s.target, expressions.unknown_item(run, iterable, why))
        status = run.execute(s.body)
    run.join([(None if status in ("break", "continue") else status, taken[0]), (None, {})])
    return None


def _while(run: Run, s: facts.While) -> Status:
    activation = run.activation
    activation.loops.append(s)
    try:
        for _ in range(UNROLL):
            truth = expressions.truth(run, run.evaluate(s.test))
            if truth is False:
                break
            constant = isinstance(s.test, facts.Literal)
            if truth is None or constant:
                return _loop_once(run, s, certain=constant)
            status = run.execute(s.body)
            if status == "break":
                return None
            if status in ("return", "raise"):
                return status
    finally:
        activation.loops.pop()
    return run.execute(s.orelse)


def _loop_once(run: Run, s: facts.While, certain: bool) -> Status:
    if certain:
        _forget_counters(run, s.body)
        status = run.execute(s.body)
        return status if status in ("return", "raise") else None
    with run.arm(run.key_of(s.span), 0) as taken:
        expressions.narrow(run, s.test, True)
        _forget_counters(run, s.body)
        status = run.execute(s.body)
    run.join([(None if status in ("break", "continue") else status, taken[0]), (None, {})])
    return None


def _forget_counters(run: Run, block: list[facts.Stmt]) -> None:
    """A loop that is run once stands for many rounds: what it counts up is no longer known."""
    for statement in block:
        if isinstance(statement, facts.Augmented) and isinstance(statement.target, facts.Name):
            run.assign_name(statement.target.id, Unknown("the value changes in a loop"))
        elif isinstance(statement, (facts.If, facts.While, facts.For)):
            _forget_counters(run, statement.body)
            _forget_counters(run, statement.orelse)
        elif isinstance(statement, (facts.With, facts.Try)):
            _forget_counters(run, statement.body)


def _with(run: Run, s: facts.With) -> Status:
    for item in s.items:
        value = calls.enter(run, run.evaluate(item.value))
        if item.target is not None:
            assign(run, item.target, value)
    return run.execute(s.body)


_IMPORT_ERRORS = {"ImportError", "ModuleNotFoundError"}


def _try(run: Run, s: facts.Try) -> Status:
    activation = run.activation
    activation.tries += 1
    try:
        status = run.execute(s.body)
    finally:
        activation.tries -= 1
    if status is None and s.orelse:
        status = run.execute(s.orelse)
    results: list[tuple[Status, Layer]] = [(status, {})]
    key = run.key_of(s.span)
    for arm, handler in enumerate(s.handlers, start=1):
        if status is None and (_cannot_raise(s.body) or _is_import_error(handler.type)):
            continue
        with run.arm(key, arm) as taken:
            if handler.name is not None:
                run.assign_name(handler.name, Unknown("an exception"))
            handled = run.execute(handler.body)
        results.append((handled, taken[0]))
    status = run.join(results) if len(results) > 1 else status
    if s.final:
        final = run.execute(s.final)
        return final or status
    return status


def _cannot_raise(body: list[facts.Stmt]) -> bool:
    """Whether a block only binds constants."""
    return all(
        isinstance(statement, facts.Assign)
        and isinstance(statement.value, facts.Literal)
        and all(isinstance(target, facts.Name) for target in statement.targets)
        for statement in body
    )


def _is_import_error(expression: facts.Expr | None) -> bool:
    if isinstance(expression, facts.Name):
        return expression.id in _IMPORT_ERRORS
    if isinstance(expression, facts.Sequence):
        return bool(expression.elements) and all(_is_import_error(e) for e in expression.elements)
    return False


def _match(run: Run, s: facts.Match) -> Status:
    subject = run.evaluate(s.subject)
    key = run.key_of(s.span)
    results: list[tuple[Status, Layer]] = []
    for arm, case in enumerate(s.cases):
        verdict = expressions.matches(run, case.pattern, subject)
        if verdict is False:
            continue
        with run.arm(key, arm) as taken:
            expressions.bind_pattern(run, case.pattern, subject)
            guard = None if case.guard is None else expressions.truth(run, run.evaluate(case.guard))
            certain = verdict is True and (case.guard is None or guard is True)
            if guard is False:
                continue
            if certain and not results:
                break
            status = run.execute(case.body)
        results.append((status, taken[0]))
        if certain:
            return run.join(results)
    else:
        results.append((None, {}))
        return run.join(results)
    # The first case that can match does match: no branch at all.
    expressions.bind_pattern(run, case.pattern, subject)
    return run.execute(case.body)


def _import(run: Run, s: facts.Import) -> Status:
    importer = run.activation.module
    found = run.index.find(importer, s.module)
    if s.alias is not None:
        run.assign_name(s.alias, External(s.module) if found is None else run.import_module(found))
        return None
    if found is not None:
        run.import_module(found)
    top = s.module.partition(".")[0]
    first = run.index.find(importer, top)
    run.assign_name(top, External(top) if first is None else run.import_module(first))
    return None


def _import_from(run: Run, s: facts.ImportFrom) -> Status:
    importer = run.activation.module
    found = run.index.find(importer, s.module, s.level)
    dotted = run.index.absolute_name(importer, s.module, s.level)
    for name, bound in s.names:
        if name == "*":
            _import_star(run, found, dotted)
            continue
        value: Value | None = None
        if found is not None and found is not importer:
            value = run.module_attribute(found, name)
            if value is None:
                value = (
                    Unknown(f"'{name}' is defined later in an import cycle")
                    if found.state == "running"
                    else Unknown(f"{found.name} has no '{name}'")
                )
        else:
            below = run.index.find(importer, f"{s.module}.{name}" if s.module else name, s.level)
            if below is None:
                messages.note_interface(run, f"{dotted}.{name}", s.span)
            value = External(f"{dotted}.{name}") if below is None else run.import_module(below)
        run.assign_name(bound, value)
    return None


def _import_star(run: Run, found: Module | None, dotted: str) -> None:
    if found is None:
        run.activation.module.star_externals.append(dotted)
        return
    run.import_module(found)
    assert found.scope is not None
    exports = found.facts.exports
    for (key, name), value in list(run.store.layers[0].items()):
        if key == found.scope.key and isinstance(name, str) and isinstance(value, Value):
            public = name in exports if exports is not None else not name.startswith("_")
            if public:
                run.assign_name(name, value)
    run.activation.module.star_externals.extend(found.star_externals)


def _function(run: Run, s: facts.Function) -> Status:
    run.assign_name(s.name, calls.define_function(run, s))
    return None


def _class(run: Run, s: facts.Class) -> Status:
    run.assign_name(s.name, calls.define_class(run, s))
    return None


def _delete(run: Run, s: facts.Delete) -> Status:
    for target in s.targets:
        if isinstance(target, facts.Subscript):
            expressions.delete_item(run, run.evaluate(target.value), run.evaluate(target.index))
    return None


def _assert(run: Run, s: facts.Assert) -> Status:
    run.evaluate(s.test)
    expressions.narrow(run, s.test, True)
    return None


def _jump(run: Run, s: facts.Jump) -> Status:
    return None if s.kind == "pass" else s.kind


def _nothing(run: Run, s: facts.Global) -> Status:
    return None


_STATEMENTS: dict[type, Callable[[Run, Any], Status]] = {
    facts.Assign: _assign,
    facts.Annotated: _annotated,
    facts.Augmented: _augmented,
    facts.Expression: _expression,
    facts.Return: _return,
    facts.Raise: _raise,
    facts.If: _if,
    facts.For: _for,
    facts.While: _while,
    facts.With: _with,
    facts.Try: _try,
    facts.Match: _match,
    facts.Import: _import,
    facts.ImportFrom: _import_from,
    facts.Global: _nothing,
    facts.Delete: _delete,
    facts.Assert: _assert,
    facts.Jump: _jump,
    facts.Function: _function,
    facts.Class: _class,
}

# The three modules are one machine in three rooms: statements here need expressions and calls there.
from archlint.program import calls, expressions  # noqa: E402

__all__ = ["FALSE", "TRUE", "Activation", "ClassValue", "NodeValue", "Pending", "Run", "assign"]
