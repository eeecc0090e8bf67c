"""What of a program's code its runs come to, by names: from what a file does as it is loaded, over all that this names,
to what that names in turn.

A function or a method that no such name leads to does not run, whatever is wrong in it.  Names are taken at their
widest: one counts for every function, class and method of that name in the files of the program, a class that asks
itself for attributes by names which are not written out comes to all of its methods, and a program that runs texts to
all of its functions and classes.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_named_by_launch, python_build_files
from archlint.analysis.kept import kept, kept_for_each_file, kept_for_few_files, once
from archlint.analysis.uncalled_methods import is_tried_alone
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs


def is_unreached(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a place is in a function, a method or a class to which no program here comes, though programs load its
    file, or below an ``if False:``.  What a package without programs offers is for others to call."""
    if workspace is None or not place.file.endswith(".py"):
        return False
    if any(covers(statement, place.span) for statement in _switched_off(workspace, place.file)):
        return True
    if workspace.roles.is_test(place.file):
        return False
    blocks = _blocks(workspace, place.file)
    if blocks is None or _is_for_others(workspace, place.file):
        return False
    programs = [start for start in _starts(workspace) if place.file in _files(workspace, start)]
    block = _block_at(blocks, place.line)
    return bool(programs) and not any(_comes_to(workspace, start, place.file, block) for start in programs)


def _is_for_others(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file may be used by code that is not here: its package installs no program of Python, or more than is
    known, or another package here needs it; or it lies in no package, and does not say what it does as a program."""
    name = workspace.package_of(file)
    if name is None:
        return not _has_a_guard(workspace, file)
    installs = workspace.installs.get(name)
    if installs is None or installs.open_executables or not _has_programs(installs):
        return True
    return name in needed_packages(workspace)


def _has_programs(installs: Installs) -> bool:
    return any(each.module or each.script for each in installs.executables.values())


@once
def needed_packages(workspace: WorkspaceIndex) -> frozenset[str]:
    """The packages that others here declare that they need."""
    return frozenset(
        dependency.name
        for package in workspace.packages.values()
        for dependency in package.dependencies
        if dependency.name != package.name
    )


@once
def _starts(workspace: WorkspaceIndex) -> list[str]:
    """The files that may be loaded as programs, or by what loads them by name: installed ones, those that say what they
    do as a program or that the files which build a package name, launch files, tests, and all that lie in no
    package."""
    launch_files = [path for path in workspace.launch_files.all() if path.endswith(".py")]
    paths = {*workspace.code.installed_programs, *launch_files, *workspace.code.files_that_mention("__main__")}
    for file, _ in workspace.code.judged():
        if file.kind == "python" and _may_be_loaded(workspace, file.relative):
            paths.add(file.relative)
    return sorted(paths)


def _may_be_loaded(workspace: WorkspaceIndex, file: str) -> bool:
    name = workspace.package_of(file)
    installs = workspace.installs.get(name or "")
    stem = posixpath.basename(file).removesuffix(".py")
    if installs is None or workspace.roles.is_test(file) or stem in installs.words:
        return True
    built = any(workspace.code.mentions(path, stem) for path in python_build_files(installs))
    return built or is_named_by_launch(workspace, stem)


def _files(workspace: WorkspaceIndex, start: str) -> frozenset[str]:
    """The files that a program loads."""
    return kept(workspace, (_files, start), lambda: workspace.code.reached_from([start]) | {start})


@dataclass(frozen=True)
class _Block:
    """Code of a file that runs as one: a function or the head of a class at its top, a method, what the file does only
    as a program, or (without a name) all of its rest."""

    name: str
    owner: str
    """The class of a method."""
    first: int
    last: int
    names: list[str]
    """What it names, in code and in texts of one word."""
    bases: list[str]
    """Those of a class."""
    is_called: bool
    """Whether it is called by what is not written out: a decorator may note it somewhere, Python calls it by itself."""
    asks_itself: bool
    """Whether it asks ``self`` for attributes by names that are not written out."""
    runs_texts: bool
    """Whether it runs code or finds definitions by texts."""


_AS_PROGRAM = "__main__"
_WORDS = re.compile(r"[\w.:/-]+")
_DESCRIPTORS = frozenset({"abstractmethod", "cached_property", "classmethod", "property", "setter", "staticmethod"})
"""Decorators that call nothing of their own accord."""
_RUNNING_TEXTS = frozenset({"__import__", "__subclasses__", "eval", "exec", "globals", "import_module", "importlib"})
_PLAIN_BASES = frozenset({"ABC", "Enum", "IntEnum", "NamedTuple", "Node", "Protocol", "object"})
"""Bases that call no method of their own accord."""
_OF_NODES = frozenset({"destroy_node"})
"""Methods that ROS calls."""


@kept_for_each_file
def _blocks(code: facts.Facts) -> list[_Block]:
    blocks: list[_Block] = []
    rest: list[facts.Stmt] = []
    guard = main_guard(code)
    for statement in code.body:
        match statement:
            case facts.Function():
                blocks.append(_of_function(statement, ""))
            case facts.Class(body=body):
                methods = [part for part in body if isinstance(part, facts.Function)]
                blocks += [_of_class(statement), *(_of_function(method, statement.name) for method in methods)]
            case facts.If(span=span) if statement is guard:
                blocks.append(_block(_AS_PROGRAM, [statement], span))
            case _ if not _lists_names(statement):
                rest.append(statement)
    return [*blocks, _block("", rest, (0, 0, 0, 0))]


def _lists_names(statement: facts.Stmt) -> bool:
    return isinstance(statement, facts.Assign) and any(target.variable == "__all__" for target in statement.targets)


def _of_function(function: facts.Function, owner: str) -> _Block:
    noted = any(decorator.last_name not in _DESCRIPTORS for decorator in function.decorators)
    by_python = bool(owner) and (function.name.startswith("__") or function.name in _OF_NODES)
    called = noted or by_python or function.name.startswith("test_")
    return _block(function.name, [function], function.span, owner=owner, is_called=called)


def _of_class(cls: facts.Class) -> _Block:
    parts: list[facts.Base] = [*cls.decorators, *(base.value for base in cls.bases)]
    parts += [part for part in cls.body if not isinstance(part, facts.Function)]
    bases = [base.value.last_name or "?" for base in cls.bases]
    called = bool(cls.decorators) or cls.name.startswith("Test")
    return _block(cls.name, parts, cls.span, bases=bases, is_called=called)


def _block(
    name: str,
    parts: Sequence[facts.Base],
    span: facts.Span,
    *,
    owner: str = "",
    bases: Sequence[str] = (),
    is_called: bool = False,
) -> _Block:
    every = [*everything_in(parts)]
    off = {Itself(part) for statement in _never_run(every) for part in everything_in([statement])}
    every = [part for part in every if Itself(part) not in off] if off else every
    texts = (part.value for part in every if isinstance(part, facts.Literal) and isinstance(part.value, str))
    words = {word for text in texts if _WORDS.fullmatch(text) for word in re.split(r"\W+", text)}
    froms = (part for part in every if isinstance(part, facts.ImportFrom))
    renamed = {imported for part in froms for imported, bound in part.names if imported != bound}
    names = {part.last_name for part in every if part.last_name} | words | renamed
    of_texts = not _RUNNING_TEXTS.isdisjoint(names)
    return _Block(name, owner, span[0], span[2], sorted(names), list(bases), is_called, _asks_itself(every), of_texts)


@kept_for_few_files
def _switched_off(code: facts.Facts) -> list[facts.Stmt]:
    """The statements of a file that no run comes to, whatever calls the code around them."""
    return [*_never_run(everything_in(code.body))]


def _never_run(every: Iterable[facts.Base]) -> Iterator[facts.Stmt]:
    """The statements below literal conditions that never hold: ``if False:``, ``while 0:``, the ``else`` of
    ``if True:``."""
    for part in every:
        match part:
            case facts.If(test=facts.Literal(value=bool() | int() as test), body=body, orelse=orelse):
                yield from orelse if test else body
            case facts.While(test=facts.Literal(value=bool() | int() as test), body=body) if not test:
                yield from body


def _asks_itself(every: Iterable[facts.Base]) -> bool:
    return any(
        part.func.last_name == "getmembers"
        or (
            part.func.variable == "getattr"
            and len(part.args) > 1
            and part.args[0].value.variable in ("cls", "self")
            and not isinstance(part.args[1].value, facts.Literal)
        )
        for part in every
        if isinstance(part, facts.Call)
    )


def _block_at(blocks: Collection[_Block], line: int) -> _Block:
    """The innermost block that holds a line."""
    around = [block for block in blocks if block.first <= line <= block.last]
    rest = next(block for block in blocks if not block.name)
    return max(around, key=lambda block: block.first, default=rest)


def _comes_to(workspace: WorkspaceIndex, start: str, file: str, block: _Block) -> bool:
    live = kept(workspace, (_live, start), lambda: _live(workspace, start))
    return (file, block.name, block.first) in live


_Key = tuple[str, str, int]
"""A block: its file, its name and its first line."""


def _live(workspace: WorkspaceIndex, start: str) -> frozenset[_Key]:
    """The blocks that a program comes to."""
    files = sorted(_files(workspace, start))
    rows = [(file, block) for file in files for block in _blocks(workspace, file) or ()]
    return _Walk(rows, _open_classes(rows)).of(_at_start(workspace, start, rows))


def _at_start(
    workspace: WorkspaceIndex, start: str, rows: Iterable[tuple[str, _Block]]
) -> Iterator[tuple[str, _Block]]:
    """What runs as the files of a program are loaded, and what ROS then calls."""
    entries = _entries(workspace)
    tried = is_tried_alone(workspace, start)
    is_program = start in workspace.code.installed_programs or _has_a_guard(workspace, start)
    for file, block in rows:
        # What is no program is loaded by something that is not here, for what it has.
        called = not is_program or block.name in entries or (block.name == _AS_PROGRAM and not tried)
        if not block.owner and (not block.name or block.is_called or (file == start and called)):
            yield file, block


@once
def _entries(workspace: WorkspaceIndex) -> frozenset[str]:
    """The functions with which installed programs and launch files begin."""
    every = (each for installs in workspace.installs.values() for each in installs.executables.values())
    return frozenset({"generate_launch_description", *(each.function or "main" for each in every)})


def _has_a_guard(workspace: WorkspaceIndex, file: str) -> bool:
    return any(block.name == _AS_PROGRAM for block in _blocks(workspace, file) or ())


def _open_classes(rows: Iterable[tuple[str, _Block]]) -> frozenset[str]:
    """The classes with a base that may call their methods of its own accord."""
    bases: dict[str, set[str]] = {}
    for _, block in rows:
        if not block.owner and (block.bases or block.name[:1].isupper()):
            bases.setdefault(block.name, set()).update(block.bases)
    closed: set[str] = set()
    while True:
        more = {name for name, of in bases.items() if name not in closed and of <= closed | _PLAIN_BASES}
        if not more:
            return frozenset(bases.keys() - closed)
        closed |= more


class _Walk:
    """From block to block by names."""

    def __init__(self, rows: Sequence[tuple[str, _Block]], open_classes: Collection[str]) -> None:
        self._open_classes = open_classes
        self._by_name: dict[str, list[tuple[str, _Block]]] = {}
        self._of_class: dict[tuple[str, str], list[tuple[str, _Block]]] = {}
        self._live_classes: set[tuple[str, str]] = set()
        self._at_top = [(file, block) for file, block in rows if not block.owner and block.name != _AS_PROGRAM]
        for file, block in rows:
            if block.name not in ("", _AS_PROGRAM):
                self._by_name.setdefault(block.name, []).append((file, block))
            if block.owner:
                self._of_class.setdefault((file, block.owner), []).append((file, block))

    def of(self, at_start: Iterable[tuple[str, _Block]]) -> frozenset[_Key]:
        """All blocks that these lead to."""
        waiting, live, named = [*at_start], set[_Key](), set[str]()
        while waiting:
            file, block = waiting.pop()
            key = (file, block.name, block.first)
            if key not in live:
                live.add(key)
                waiting += self._led_to(file, block, named)
        return frozenset(live)

    def _led_to(self, file: str, block: _Block, named: set[str]) -> Iterator[tuple[str, _Block]]:
        fresh = [name for name in block.names if name not in named]
        named.update(fresh)
        if not block.owner:
            self._live_classes.add((file, block.name))
        if block.runs_texts:
            yield from self._at_top
        if block.asks_itself:
            yield from self._of_class.get((file, block.owner), ())
        for name in fresh:
            for path, other in self._by_name.get(name, ()):
                if not other.owner or (path, other.owner) in self._live_classes:
                    yield path, other
        for path, method in self._of_class.get((file, block.name), ()) if not block.owner else ():
            if method.is_called or block.name in self._open_classes or method.name in named:
                yield path, method


__all__ = ["is_unreached", "needed_packages"]
