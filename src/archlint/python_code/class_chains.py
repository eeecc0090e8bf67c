"""The classes that a class of the workspace derives from, by its text: no run has to come to it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field
from functools import cache, wraps
from itertools import takewhile
from typing import TYPE_CHECKING, TypeVar

from archlint.analysis.kept import HasFiles, kept, kept_as, name_of, result_type
from archlint.libraries.rclpy.names import canonical
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, once_for, targets_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_Result = TypeVar("_Result")
_MOST_BINDINGS = 3
"""How many statements that bind one name are told apart: with more of them its meaning is not known."""
_DEPTH = 8
"""How many files an import is followed through, and how many classes derive from each other."""


@dataclass(frozen=True)
class ClassInFile:
    """A class and the file that it is in."""

    file: str
    code: facts.Class


@dataclass
class Chain:
    """A class with all that it derives from: classes of the workspace, the first one itself, and foreign ones by their
    canonical names.  ``complete`` is false where some base is not known, or something may change the class."""

    own: list[ClassInFile] = field(default_factory=list)
    foreign: list[str] = field(default_factory=list)
    complete: bool = True

    def has(self, other: ClassInFile) -> bool:
        """Whether another class is this one, or one that it derives from."""
        return any(cls.code is other.code for cls in self.own)


@once_for
def classes_of(file_facts: facts.Facts) -> Sequence[facts.Class]:
    """Every class of a file, those inside functions and classes included."""
    return tuple(everything_in(file_facts.body, facts.Class))


def classes_asked_for(workspace: WorkspaceIndex) -> Iterator[ClassInFile]:
    """The classes of the files that were asked for, but for test code."""
    for file, file_facts in workspace.code.judged():
        if not workspace.roles.is_test(file.relative):
            for code in classes_of(file_facts):
                yield ClassInFile(file.relative, code)


@once_for
def _numbers(file_facts: facts.Facts) -> dict[int, int]:
    """The position of each class among :func:`classes_of`, by its id."""
    return {id(code): number for number, code in enumerate(classes_of(file_facts))}


def kept_for_each_class(analysis: Callable[[facts.Class], _Result]) -> Callable[[HasFiles, ClassInFile], _Result]:
    """As :func:`~archlint.analysis.kept.kept_for_each_file`, for an analysis of one class by its text."""
    of_all = kept_as(
        name_of(analysis),
        cache(lambda: list[result_type(analysis)]),  # type: ignore[misc]
        lambda file_facts: [*map(analysis, classes_of(file_facts))],
    )

    @wraps(analysis)
    def of(workspace: HasFiles, cls: ClassInFile) -> _Result:
        file_facts = workspace.facts_at(cls.file)
        number = None if file_facts is None else _numbers(file_facts).get(id(cls.code))
        rows = None if number is None else of_all(workspace, cls.file)
        return analysis(cls.code) if rows is None or number is None else rows[number]

    return of


def chain_of(workspace: WorkspaceIndex, cls: ClassInFile) -> Chain:
    """What a class derives from."""

    def follow() -> Chain:
        chain = Chain()
        _add(workspace, cls, chain, _DEPTH)
        return chain

    return kept(workspace, (chain_of, Itself(cls.code)), follow)


def _add(workspace: WorkspaceIndex, cls: ClassInFile, chain: Chain, depth: int) -> None:
    if chain.has(cls):
        return
    chain.own.append(cls)
    chain.complete &= depth > 0 and not cls.code.decorators
    for base in cls.code.bases if depth > 0 else ():
        if base.keyword is not None or base.star:
            chain.complete = False
            continue
        meant = class_named(workspace, cls.file, base.value.dotted, depth)
        match meant:
            case ClassInFile():
                _add(workspace, meant, chain, depth - 1)
            case str():
                chain.foreign.append(meant)
            case None:
                chain.complete = False


def class_named(workspace: WorkspaceIndex, file: str, name: str, depth: int = _DEPTH) -> ClassInFile | str | None:
    """The class that a dotted name in a file means: one of the workspace, or the canonical name of a foreign one."""
    file_facts = workspace.facts_at(file)
    if file_facts is None or not name or depth <= 0:
        return None
    head, _, rest = name.partition(".")
    bindings = _bindings(file_facts)
    bound = bindings.get(head, bindings.get("*", ()))
    if not bound and name == "object":
        return name
    match bound:
        case [facts.Class() as code] if not rest:
            return ClassInFile(file, code)
        case [facts.ImportFrom() as statement]:
            return _imported(workspace, file, statement, head, rest, depth)
        case [facts.ImportFrom(), facts.ImportFrom() as statement] if _comes_first(file_facts, statement):
            return _imported(workspace, file, statement, head, rest, depth)
        case [facts.Import(module=module, alias=alias), *_] if _is_foreign(workspace, file, module):
            return canonical(f"{module}.{rest}" if alias else name) if rest else None
    return None


def _comes_first(file_facts: facts.Facts, second: facts.ImportFrom) -> bool:
    """Whether an import that replaces an earlier one is outside of any block, and before all functions and classes."""
    before = takewhile(lambda statement: not isinstance(statement, (facts.Class, facts.Function)), file_facts.body)
    return any(statement is second for statement in before)


def _imported(
    workspace: WorkspaceIndex, file: str, statement: facts.ImportFrom, head: str, rest: str, depth: int
) -> ClassInFile | str | None:
    own = next((name for name, bound in statement.names if bound == head), None)
    if own is None:  # a star
        return None
    path = workspace.code.path_of_import(file, statement.module, statement.level)
    if path is None:
        foreign = not statement.level and _is_foreign(workspace, file, statement.module)
        return canonical(".".join(filter(None, (statement.module, own, rest)))) if foreign else None
    module = workspace.code.path_of_import(file, f"{statement.module}.{own}".lstrip("."), statement.level)
    if module is not None:
        return class_named(workspace, module, rest, depth - 1)
    return None if rest else class_named(workspace, path, own, depth - 1)


def _is_foreign(workspace: WorkspaceIndex, file: str, module: str) -> bool:
    """Whether a module, and the package that it is in, are certainly not of the workspace."""
    top = module.partition(".")[0]
    return top not in workspace.code.top_modules and workspace.code.path_of_import(file, top) is None


@once_for
def _bindings(file_facts: facts.Facts) -> dict[str, list[facts.Base]]:
    """The first three statements that bind each name of a file.  A star may bind any of them; those of names
    that nothing else binds have the key ``*``."""
    bindings: dict[str, list[facts.Base]] = {"*": []}
    still_few = {"*"}
    for statement in statements_of(file_facts.body):
        names = _bound_by(statement)
        for name in names - bindings.keys():
            bindings[name] = [*bindings["*"]]
            still_few.add(name)
        for name in still_few & names if "*" not in names else [*still_few]:
            bindings[name].append(statement)
            if len(bindings[name]) >= _MOST_BINDINGS:
                still_few.remove(name)
    return bindings


def _bound_by(statement: facts.Base) -> set[str]:
    match statement:
        case facts.Class(name=own) | facts.Function(name=own):
            return {own}
        case facts.ImportFrom(names=names):
            return {bound for _, bound in names}
        case facts.Import(module=module, alias=alias):
            return {alias or module.partition(".")[0]}
        case facts.Assign(targets=targets):
            return {target.variable for target in targets if target.variable}
    return set()


def files_with(workspace: WorkspaceIndex, name: str) -> list[str]:
    """The Python files in which a name stands, but for launch files of packages."""
    beside = (file.relative for file, _ in workspace.code.judged() if file.package is None)
    loose = [path for path in beside if workspace.code.mentions(path, name)]
    return [*dict.fromkeys((*workspace.code.files_that_mention(name), *loose))]


def derived_from(workspace: WorkspaceIndex, cls: ClassInFile) -> Iterator[ClassInFile]:
    """The classes of the workspace that derive from one."""
    for file in dict.fromkeys((cls.file, *files_with(workspace, cls.code.name))):
        file_facts = workspace.facts_at(file)
        for code in classes_of(file_facts) if file_facts is not None else ():
            other = ClassInFile(file, code)
            if code is not cls.code and chain_of(workspace, other).has(cls):
                yield other


def methods_of(cls: facts.Class) -> Iterator[facts.Function]:
    """The functions of a class body."""
    return (function for function in statements_of(cls.body, facts.Function))


def targets_of(body: Sequence[facts.Stmt] | facts.Stmt) -> Iterator[facts.Base]:
    """Everything that statements assign, those of nested functions too: the parts of tuples one by one."""
    for part in everything_in(body):
        if isinstance(part, facts.WithItem):
            targets = [] if part.target is None else [part.target]
        else:
            targets = [] if isinstance(part, facts.Augmented) else part.assigned
        for target in targets:
            yield from targets_in(target)


__all__ = [
    "Chain",
    "ClassInFile",
    "chain_of",
    "class_named",
    "classes_asked_for",
    "classes_of",
    "derived_from",
    "files_with",
    "kept_for_each_class",
    "methods_of",
    "targets_of",
]
