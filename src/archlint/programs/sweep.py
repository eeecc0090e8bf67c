"""The classes and functions that no program has run: each is run alone, callers before what they call."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence, Set
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.limits import CLASSES
from archlint.interpreter.modules import Module
from archlint.interpreter.objects.classes import allocate
from archlint.interpreter.values import BoundMethod, ClassValue, FunctionValue, Unknown, Value
from archlint.libraries.interest import interesting
from archlint.libraries.rclpy import escapes, node_classes
from archlint.monitor import Monitor
from archlint.programs.ahead import shares
from archlint.programs.followed import Definition, Followed
from archlint.programs.followed_program import FollowedProgram
from archlint.programs.keys import DefinitionKey, ModuleKey, ProgramKey
from archlint.programs.progress import Progress
from archlint.programs.roots import flags_of
from archlint.programs.top_level import definitions, place_of
from archlint.records import dataclass
from archlint.syntax.cpp.known_names import FIELDS
from archlint.syntax.facts import Assign, Attribute, Function, Lambda
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run

Row = tuple[Module, Definition]
Parts = Callable[[int], Sequence[Callable[[], object]]]
"""Some work in parts, as many as there are to be."""
_FEW = 8
"""How many classes or functions one process runs as fast as several would."""


def _by_itself(parts: Parts) -> None:
    """Nobody else runs anything."""


@dataclass
class Sweep:
    """Runs what no program has run so far.

    ``follow`` gives what becomes of a program, ``new_run`` begins the run of one, ``value_of`` gives what a module's
    variable holds, and ``ahead`` has parts of the work done in other processes, of which
    ``is_known`` says what they need not do.
    """

    progress: Progress
    follow: Callable[[ProgramKey, Callable[[], Followed]], Followed]
    new_run: Callable[[str, Module, model.Role], Run]
    value_of: Callable[[Module, str], Value | None]
    monitor: Monitor = field(default_factory=Monitor)
    ahead: Callable[[Parts], object] = _by_itself
    is_known: Callable[[ProgramKey], bool] = lambda key: False

    def run(self, modules: Sequence[Module]) -> None:
        defined = [(module, self._definitions(module)) for module in modules]
        classes = [(module, row) for module, rows in defined for row in rows if row.is_class and row.is_own]
        functions = [(module, row) for module, rows in defined for row in rows if not row.is_class]
        self._run_classes([(module, cls) for module, cls in classes if cls.is_node])
        self._run_rest([(module, cls) for module, cls in classes if not cls.is_node], functions)

    def _definitions(self, module: Module) -> list[Definition]:
        """What a module defines, once it has been imported."""

        def act() -> Followed:
            run = self.new_run(module.name, module, model.Role.MODULE)
            with FollowedProgram(run, module) as root:
                run.import_module(module)
            names = dict.fromkeys(statement.name for statement in definitions(module.facts.body))
            rows = (_definition(run, module, name, self.value_of(module, name)) for name in names)
            return root.result([row for row in rows if row is not None])

        return self.follow(ModuleKey(module.path), act).definitions

    def _run_classes(self, classes: Sequence[Row]) -> None:
        """Node classes that nothing makes: once, with the constructor's defaults, flags either way.  A class that
        others here derive from is covered by them."""
        bases = {base for _, cls in classes for base in cls.bases}
        for last in (False, True):
            self._run_each([row for row in classes if (row[1].place in bases) is last])

    def _run_rest(self, classes: Sequence[Row], functions: Sequence[Row]) -> None:
        candidates = [
            row for row in classes if row[1].is_interesting and row[1].place not in self.progress.instantiated
        ]
        candidates += [row for row in functions if row[1].is_interesting and row[1].place not in self.progress.ran]
        mentioned: dict[str, int] = {}
        for _, definition in candidates:
            for name in definition.names:
                mentioned[name] = mentioned.get(name, 0) + 1
        called = {definition.name for _, definition in candidates if definition.is_class}
        for turn in range(3):
            rows = []
            for row in candidates:
                definition = row[1]
                own = 1 if definition.name in definition.names else 0
                is_used = mentioned.get(definition.name, 0) > own
                of_class = definition.name.partition("::")[0] in called and not definition.is_class
                if turn == (2 if of_class else 1 if is_used else 0):
                    rows.append(row)
            self._run_each(rows)

    def _run_each(self, rows: Sequence[Row]) -> None:
        """Run each that neither a program nor one of those before it has run; several at a time in other processes,
        where some may then run in vain."""
        left = [row for row in rows if not self._has_run(row[1])]
        if sum(not self.is_known(_key(*row)) for row in left) > _FEW:
            self.ahead(lambda count: [partial(self._run_share, left, share) for share in shares(left, count)])
        self._run_share(left, range(len(left)))

    def _run_share(self, rows: Sequence[Row], share: range) -> None:
        for number in share:
            if not self._has_run(rows[number][1]):
                self._run_alone(*rows[number])

    def _has_run(self, definition: Definition) -> bool:
        seen: Set[Place] = self.progress.instantiated if definition.is_class else self.progress.ran
        return definition.place in seen

    def _run_alone(self, module: Module, definition: Definition) -> None:
        def act() -> Followed:
            value = self.value_of(module, definition.variable)
            return self._run_class(module, value) if definition.is_class else self._run_function(module, value)

        self.monitor.following(1)
        self.follow(_key(module, definition), act)

    def _run_class(self, module: Module, cls: Value | None) -> Followed:
        assert isinstance(cls, ClassValue)
        run = self.new_run(cls.qualified, module, model.Role.INIT)
        run.program.executable = False
        with FollowedProgram(run, module, place_of(cls)) as root:
            init, _ = cls.lookup(run, "__init__")
            run.call(cls, CallSite(keywords=flags_of(init)))
        return root.result()

    def _run_function(self, module: Module, function: Value | None) -> Followed:
        assert isinstance(function, FunctionValue)
        run = self.new_run(function.qualified, module, model.Role.METHOD)
        run.program.executable = False
        with FollowedProgram(run, module, place_of(function)) as root:
            given = run.call(self._on_its_object(run, module, function), CallSite(keywords=flags_of(function)))
            escapes.escape(run, [given], f"{function.qualified}() returns it, and nothing here calls that")
        return root.result()

    def _on_its_object(self, run: Run, module: Module, function: FunctionValue) -> Value:
        """A method that C++ defines outside of its class, on an object whose fields others may have set."""
        owner, colons, _ = getattr(function.ir, "name", "").partition("::")
        cls = self.value_of(module, owner) if colons else None
        if not isinstance(cls, ClassValue):
            return function
        instance = allocate(run, cls)
        for name in _fields_of(run, cls):
            run.store.set(instance.key, name, Unknown(f"who sets '{name}' is not known"))
        return BoundMethod(function, instance)


def _key(module: Module, definition: Definition) -> DefinitionKey:
    return DefinitionKey(module.path, definition.variable)


def _fields_of(run: Run, cls: ClassValue) -> Iterator[str]:
    """The fields that objects of a class of C++ have."""
    for base in cls.classes:
        fields = run.store.get(base.key, FIELDS)
        code = fields.ir if isinstance(fields, FunctionValue) else None
        for statement in code.body if isinstance(code, Function) else ():
            match statement:
                case Assign([Attribute(_, name)]):
                    yield name


def _definition(run: Run, module: Module, variable: str, value: Value | None) -> Definition | None:
    """A class or function that a module's variable holds; None for anything else."""
    place = None if value is None else place_of(value)
    if place is None or not isinstance(value, (ClassValue, FunctionValue)):
        return None
    mro = value.mro if isinstance(value, ClassValue) else ()
    if len(mro) > CLASSES:  # the end of it is unknown: too much for each of them to be run
        return None
    is_node = isinstance(value, ClassValue) and node_classes.is_node(value)
    constructor = _constructor_outside(run, value)
    in_cpp = value.scope.module.file.kind == "cpp"
    is_interesting = any(interesting(code, in_cpp=in_cpp) for code in (value.ir, constructor) if code is not None)
    return Definition(
        variable,
        getattr(value.ir, "name", ""),
        value.qualified,
        place,
        isinstance(value, ClassValue),
        value.scope.module is module,
        is_node,
        is_interesting,
        tuple(base for cls in mro[1:] if (base := place_of(cls)) is not None),
        names_in(value.ir) if is_interesting and not is_node else frozenset(),
    )


def _constructor_outside(run: Run, value: ClassValue | FunctionValue) -> Function | Lambda | None:
    """The constructor of a class of C++, which is mostly defined outside of it.  Where it makes nothing, others set
    what the methods use, and each method is followed for itself."""
    if not isinstance(value, ClassValue) or value.scope.module.file.kind != "cpp":
        return None
    constructor = run.store.get(value.key, "__init__")
    return constructor.ir if isinstance(constructor, FunctionValue) else None


__all__ = ["Sweep"]
