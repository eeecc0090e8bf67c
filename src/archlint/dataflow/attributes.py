"""What functions leave in attributes and global variables, and what they read there: so data goes from one callback of
a node to another without any message.

Code is followed through the methods of its class; what other objects do with their own attributes is not.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, once_for_each_file
from archlint.libraries import tables
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, classes_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, targets_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.analysis.source_code import FunctionFacts
    from archlint.systems.model import WorkspaceIndex

Variable = tuple[str, str]
"""``global``, for the global variables of a file, or nothing, for attributes of ``self``; and the name."""

_CHANGES = frozenset(
    {"add", "append", "appendleft", "clear", "extend", "insert", "pop", "popleft", "put", "put_nowait", "remove"}
    | {"set", "setdefault", "update"}
)
"""Methods that change what an attribute holds."""
_TAKES = frozenset({"pop", "popleft", "setdefault"})
"""Those of them that also give something of it."""
_LOGGING = "get_logger"
_FUNCTIONS = (facts.Function, facts.Lambda)
_HANDLES = frozenset(row.path.rpartition(".")[2] for row in tables.ROWS if row.creates)
"""What makes a publisher, a timer …: no data comes through the attribute that holds it."""


@dataclass
class Use:
    """What code leaves in variables, and what it reads."""

    sets: set[Variable] = field(default_factory=set)
    reads: set[Variable] = field(default_factory=set)
    calls: set[str] = field(default_factory=set)
    """The methods of ``self`` that it names: it calls them, or hands them over."""

    def add(self, other: Use) -> None:
        self.sets |= other.sets
        self.reads |= other.reads


def use_of(workspace: WorkspaceIndex, file: str, functions: Iterable[FunctionFacts], cls: ClassInFile | None) -> Use:
    """What functions of a file use, with all methods of the class of their object that they lead to."""
    methods = {} if cls is None else _methods(workspace, cls)
    total = Use()
    seen: set[int] = set()
    left = [(file, function) for function in functions]
    while left:
        path, function = left.pop()
        if id(function) in seen:
            continue
        seen.add(id(function))
        own = _own_use(workspace, path, function)
        total.add(own)
        left += (methods[name] for name in sorted(own.calls) if name in methods)
    return total


def class_around(workspace: WorkspaceIndex, file: str, function: FunctionFacts) -> ClassInFile | None:
    """The class that a method, or what is defined inside one, belongs to."""
    by_function = _classes_by_function(workspace, file)
    cls = None if by_function is None else by_function.get(id(function))
    return None if cls is None else ClassInFile(file, cls)


@once_for_each_file
def _classes_by_function(file_facts: facts.Facts) -> dict[int, facts.Class]:
    """The class of each method, of each function and lambda inside one, by their ``id``; the innermost class."""
    return {
        id(part): cls
        for cls in classes_of(file_facts)
        for part in everything_in(cls.body)
        if isinstance(part, _FUNCTIONS)
    }


def class_at(workspace: WorkspaceIndex, place: Place) -> ClassInFile | None:
    """The class whose name stands at a place."""
    file_facts = workspace.facts_at(place.file)
    classes = () if file_facts is None else classes_of(file_facts)
    return next((ClassInFile(place.file, cls) for cls in classes if cls.name_span == place.span), None)


def root_of(workspace: WorkspaceIndex, cls: ClassInFile) -> Place:
    """The class of the workspace that a class derives from in the end: all classes of one object have it in common."""
    last = chain_of(workspace, cls).own[-1]
    return Place.of(last.file, last.code.name_span)


def _methods(workspace: WorkspaceIndex, cls: ClassInFile) -> Mapping[str, tuple[str, facts.Function]]:
    """The methods of a class and its bases by name, each with its file."""

    def find() -> dict[str, tuple[str, facts.Function]]:
        methods: dict[str, tuple[str, facts.Function]] = {}
        for each in chain_of(workspace, cls).own:
            for statement in each.code.body:
                if isinstance(statement, facts.Function):
                    methods.setdefault(statement.name, (each.file, statement))
        return methods

    key = Place.of(cls.file, cls.code.name_span)
    return kept(workspace, (_methods, key), find)


def _own_use(workspace: WorkspaceIndex, file: str, function: FunctionFacts) -> Use:
    uses = _uses_by_function(workspace, file)
    return Use() if uses is None else uses.get(id(function), Use())


@once_for_each_file
def _uses_by_function(file_facts: facts.Facts) -> dict[int, Use]:
    """What each function of a file uses by itself, by its ``id``."""
    shared = frozenset(
        name for statement in everything_in(file_facts.body, facts.Global) for name in _global_names(statement)
    )
    handles = frozenset(_handles(file_facts))
    uses: dict[int, Use] = {}
    for function, self_name in _functions_with_self(file_facts):
        use = uses[id(function)] = _use(function, self_name, shared)
        for variables in (use.sets, use.reads):
            variables.difference_update([row for row in variables if row[1].partition(".")[0] in handles])
    return uses


def _handles(file_facts: facts.Facts) -> Iterator[str]:
    """The names of attributes and variables that hold an entity of ROS."""
    for assignment in everything_in(file_facts.body, facts.Assign):
        match assignment.value:
            case facts.Call() as call if called_name(call) in _HANDLES:
                yield from (target.last_name for target in assignment.targets)


def _global_names(statement: facts.Global) -> Sequence[str]:
    return statement.names if statement.kind == "global" else ()


def _functions_with_self(file_facts: facts.Facts) -> Iterator[tuple[FunctionFacts, str]]:
    """Each function and lambda of a file with the name that ``self`` has in it; empty where it has none."""
    names: dict[int, str] = {}
    for cls in classes_of(file_facts):
        for method in cls.body:
            if isinstance(method, facts.Function) and method.params:
                own = method.params[0].name
                names.update({id(part): own for part in everything_in(method) if isinstance(part, _FUNCTIONS)})
    for part in everything_in(file_facts.body):
        if isinstance(part, _FUNCTIONS):
            yield part, names.get(id(part), "")


def _use(function: FunctionFacts, self_name: str, shared: frozenset[str]) -> Use:
    use = Use()
    done: set[int] = set()
    """Expressions that stand for no reading of their own."""
    for part in _parts(function):
        for target in (single for assigned in part.assigned for single in targets_in(assigned)):
            variable = _variable(target, self_name, shared)
            if variable is not None:
                use.sets.add(variable)
                done.update(map(id, _path(target)))
        match part:
            case facts.Call(func=facts.Attribute(value=owner, attr=method) as callee):
                _note_call(use, _variable(owner, self_name, shared), callee, method)
                done.update(map(id, _path(callee)))
                if owner.variable == self_name and self_name:
                    use.calls.add(method)
        variable = _variable(part, self_name, shared) if id(part) not in done else None
        if variable is not None:
            use.reads.add(variable)
            use.calls.add(variable[1])  # a property, or a method that is handed over
            done.update(map(id, _path(part)))
    return use


def _note_call(use: Use, owner: Variable | None, callee: facts.Attribute, method: str) -> None:
    """``self.queue.append(…)``, ``self.robot.base.stop()``."""
    if owner is None:
        return
    if method in _CHANGES:
        use.sets.add(owner)
    if method not in _CHANGES or method in _TAKES:
        use.reads.add(owner)


def _parts(function: FunctionFacts) -> Iterator[facts.Base]:
    """All parts of a function but for what it only writes to the log."""
    body: list[facts.Base] = [*function.body] if isinstance(function, facts.Function) else [function.body]
    stack = body[::-1]
    while stack:
        part = stack.pop()
        if _is_log(part):
            continue
        yield part
        stack += part.children()[::-1]


def _is_log(part: facts.Base) -> bool:
    match part:
        case facts.Call(func=facts.Attribute(value=facts.Call(func=callee))):
            return callee.last_name == _LOGGING
    return False


def _path(target: facts.Base) -> Iterator[facts.Base]:
    """``self.a.b[k]``: the expression, and those that it starts with."""
    while True:
        yield target
        match target:
            case facts.Attribute(value=value) | facts.Subscript(value=value):
                target = value
            case _:
                return


def _variable(target: facts.Base, self_name: str, shared: frozenset[str]) -> Variable | None:
    """The attribute of ``self``, or the global variable, that an expression is (a part of): ``a.b`` for
    ``self.a.b.c``, for an object often holds several others."""
    inner = ""
    for part in _path(target):
        match part:
            case facts.Attribute(value=facts.Name(id=name), attr=attr) if self_name and name == self_name:
                return "", f"{attr}.{inner}" if inner else attr
            case facts.Attribute(attr=attr):
                inner = attr
            case facts.Subscript():
                inner = ""
            case facts.Name(id=name) if name in shared:
                return "global", name
    return None


def concerns(is_set: str, is_read: str) -> bool:
    """Whether what sets one attribute changes what is read of another: ``a`` holds ``a.b``."""
    return is_set == is_read or is_read.startswith(f"{is_set}.") or is_set.startswith(f"{is_read}.")


__all__ = ["Use", "Variable", "class_around", "class_at", "concerns", "root_of", "use_of"]
