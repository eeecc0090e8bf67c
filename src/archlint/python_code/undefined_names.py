"""Names that Python code reads and that nothing binds: a NameError when the line runs.

Scopes are Python's own.  What is bound anywhere in a scope counts as bound, whichever line comes first, and a file in
which anything may be bound (a star import of a module that is not known, ``exec``) is left alone.
"""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.launch.files import GENERATE
from archlint.place import Place
from archlint.python_code.evaluated_hints import evaluates_hints, hints_of
from archlint.python_code.left_blanks import is_left_blank, lines_looked_at
from archlint.python_code.offered_names import bound_in, makers_of_names, own_names, starred
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.flow_facts import covers, is_unreachable
from archlint.syntax.parts import everything_in, once_for, parts_of
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_OF_MODULES = frozenset(
    {"__annotations__", "__builtins__", "__debug__", "__dict__", "__doc__", "__file__", "__loader__", "__name__"}
    | {"__package__", "__path__", "__spec__"}
)
_OF_CLASSES = frozenset({"__class__", "__module__", "__qualname__"})
_NEWER = frozenset({"BaseExceptionGroup", "EncodingWarning", "ExceptionGroup", "PythonFinalizationError", "aiter"})
"""Built-in names that not every Python has with which archlint runs."""
_OF_PYTHON_2 = frozenset(
    {"basestring", "cmp", "execfile", "file", "long", "raw_input", "reduce", "reload", "unichr", "unicode", "xrange"}
)
_ALWAYS = frozenset(dir(builtins)) | _OF_MODULES | _OF_CLASSES | _NEWER | {"WindowsError", "_"}
_CHECKS_VERSION = frozenset({"PY2", "PY3", "six", "version_info"})
_ROS_1 = frozenset({"rospy", "roslib"})
_KINDS = frozenset({"python", "launch_python", "setup_py"})
_OF_NOTEBOOKS = frozenset({"display", "get_ipython"})
"""What IPython adds to the built-in names.  Source: ``init_builtins`` in IPython/core/interactiveshell.py."""
_HAVE_IPYTHON = ("colab", "ipython", "jupyter", "kaggle", "notebook")
_SPHINX = "/conf.py"
"""The file for which Sphinx defines names of its own."""


@dataclass(frozen=True)
class Undefined:
    """A name that is read, and who has one of that name: the class of the method, or nobody."""

    place: Place
    name: str
    known: frozenset[str]
    """All names that the code there can read."""
    of_self: bool
    """Whether the class of the method has an attribute or a method of the name."""
    added: bool = False
    """Whether it is a local variable, since the function changes it with ``+=``, and nothing gives it a value."""
    without_self: str = ""
    """The method that it is read in, where that has no parameter at all and the class has one of the name."""
    called: bool = False
    caught: bool = False
    """Whether an ``except`` has it for a class, and gives what it catches no name: ``except e:``."""


def undefined_names(workspace: WorkspaceIndex) -> Iterator[Undefined]:
    """Every such read in the files that were asked for: the first of each name in each function."""
    told = _told_of_launch_files(workspace)
    for file, file_facts in (*workspace.code.judged(), *_setup_files(workspace)):
        if file.kind not in _KINDS or file.relative.endswith(_SPHINX) or workspace.roles.is_test(file.relative):
            continue
        known_at = _unbound(workspace, file.relative) or _Unbound()
        unbound = known_at.reads
        if file.kind == "launch_python" and file.relative not in _programs_called_like_launch_files(workspace):
            if file_facts.problems:
                continue  # Python refuses all of it
            if not any(function.name == GENERATE for function in statements_of(file_facts.body, facts.Function)):
                continue  # nothing launches it: any text may be called like a launch file, and linked from anywhere
            idle = _idle_functions(file_facts)
            unbound = [r for r in unbound if (file.relative, r.name) not in told]
            unbound = [r for r in unbound if not any(covers(function, r.span) for function in idle)]
        if any(r.in_hint for r in unbound) and not evaluates_hints(workspace, file.relative, file_facts):
            unbound = [r for r in unbound if not r.in_hint]
        if unbound:
            looked_at = lines_looked_at(workspace, file.relative)
            unbound = [r for r in unbound if r.span[0] not in looked_at]
        brought = starred(workspace, file.relative, file_facts) if unbound else None
        if brought is None:
            continue
        names = {r.name for r in unbound if is_left_blank(workspace, file.relative, r.name, r.span[0])}
        for read in (read for read in unbound if read.name not in names):
            if (read.added or not brought.has(read.name)) and not _is_blank(read.name):
                known = known_at.names_at(read)
                known = known | brought.names if brought.names else known  # a copy for each read is a square
                place, span = Place(file.relative, *read.span), read.span
                of_self = read.of_self and span not in _first_values(file_facts)
                called = span in _called(file_facts)
                caught = span in _caught(file_facts)
                yield Undefined(place, read.name, known, of_self, read.added, read.without_self, called, caught)


def _setup_files(workspace: WorkspaceIndex) -> Iterator[tuple[SourceFile, facts.Facts]]:
    """Each setup.py that colcon runs: that of a package of CMake is never read."""
    for file, file_facts in workspace.code.setup_files:
        package = workspace.packages.get(file.package or "")
        if package is not None and package.build_type == "ament_python":
            yield file, file_facts


def _is_blank(name: str) -> bool:
    """Whether a name is a gap that an exercise leaves for others to fill in, ``____``."""
    return len(name) > 1 and not name.strip("_")


@once
def _programs_called_like_launch_files(workspace: WorkspaceIndex) -> frozenset[str]:
    """The modules of console scripts with the name of a launch file, ``follow_launch.py``, that describe no launch."""
    programs = (e for installs in workspace.installs.values() for e in installs.executables.values())
    modules = {(each.package, each.module) for each in programs if each.module}
    named = {path for package, module in modules for path in workspace.code.files_named(package, module)}
    codes = {path: workspace.facts_at(path) for path in named}
    return frozenset(path for path, code in codes.items() if code is not None and GENERATE not in own_names(code))


@once_for
def _called(code: facts.Facts) -> frozenset[facts.Span]:
    """Where the names stand that a file calls."""
    functions = (call.func for call in everything_in(code.body, facts.Call))
    return frozenset(function.span for function in functions if isinstance(function, facts.Name))


@once_for
def _caught(code: facts.Facts) -> frozenset[facts.Span]:
    """Where the names stand, none like that of a class, that handlers ask for and that give what they catch no name."""
    handlers = (handler for handler in everything_in(code.body, facts.Handler) if handler.name is None)
    types = (handler.type for handler in handlers)
    return frozenset(each.span for each in types if isinstance(each, facts.Name) and each.id.islower())


@once_for
def _first_values(code: facts.Facts) -> frozenset[facts.Span]:
    """Where a name stands of which an attribute of the same name gets its value, if it gets none otherwise, or the name
    is called: ``self.db = db('map.db')`` does not mean itself."""
    rows: dict[str, list[tuple[facts.Span, ...]]] = {}
    for statement in everything_in(code.body):
        for target in statement.assigned:
            match target:
                case facts.Attribute(value=facts.Name(id="self"), attr=attr):
                    read = [part.span for part in everything_in(statement.children(), facts.Name) if part.id == attr]
                    rows.setdefault(attr, []).append(tuple(read))
    of_classes = {name for cls in everything_in(code.body, facts.Class) for name in bound_in(cls.body)}
    only = [reads for attr, reads in rows.items() if all(reads) and attr not in of_classes]
    spans = {span for reads in only for read in reads for span in read}
    return frozenset(spans | {span for reads in rows.values() for read in reads for span in read} & _called(code))


def statements_of_module(workspace: WorkspaceIndex, file: str) -> frozenset[facts.Span]:
    """The plain statements that run one after the other when a file is loaded: at the first that fails it is over."""
    code = workspace.facts_at(file)
    return frozenset() if code is None else _plain_statements(code)


@once_for
def _plain_statements(code: facts.Facts) -> frozenset[facts.Span]:
    plain = (facts.Assign, facts.Annotated, facts.Augmented, facts.Expression)
    return frozenset(statement.span for statement in code.body if isinstance(statement, plain))


def names_bound_in(workspace: WorkspaceIndex, file: str) -> frozenset[str]:
    """The names that any line of a file binds."""
    code = workspace.facts_at(file)
    parts = [] if code is None else everything_in(code.body)
    return frozenset(name for part in parts for name in bound_by(part))


def _told_of_launch_files(workspace: WorkspaceIndex) -> frozenset[tuple[str, str]]:
    """The names, each with its file, that keep a launch file from being read at all, of which LCH008 speaks."""
    lost = (each for launched in workspace.launched for each in launched.undefined.items())
    return frozenset((place.file, name) for place, name in lost)


def _idle_functions(code: facts.Facts) -> list[facts.Function]:
    """The functions of a launch file that neither launch nor any line of the file calls or passes on."""
    named = {name.id for name in everything_in(code.body, facts.Name)} | {GENERATE}
    return [function for function in statements_of(code.body, facts.Function) if function.name not in named]


# ------------------------------------------------------------------------------------------------------ scopes


@dataclass(frozen=True)
class _Read:
    """A read of a name that no scope around it binds."""

    name: str
    span: facts.Span
    of_self: bool
    added: bool = False
    without_self: str = ""
    in_hint: bool = False


_Known = tuple[_Read, frozenset[str]]
"""Such a read, and all names that the code there can read."""


@dataclass(frozen=True)
class _Scope:
    """The names that code can read, and those of the class that a method is of; ``without_self`` is the name of a
    method that has no parameter."""

    names: frozenset[str]
    members: frozenset[str] = frozenset()
    without_self: str = ""
    body: Sequence[facts.Stmt] = ()
    """The statements of the function that the code is in."""
    in_hint: bool = False
    """Whether the code is the annotations of a function."""

    def within(self, names: frozenset[str]) -> _Scope:
        return replace(self, names=self.names | names)

    def read(self, name: facts.Name, *, added: bool = False) -> _Known:
        is_member = name.id in self.members or (name.id == "self" and bool(self.without_self))
        of_self = is_member and "self" in self.names
        without_self = self.without_self if is_member and not of_self else ""
        return _Read(name.id, name.span, of_self, added, without_self, self.in_hint), self.names


@dataclass(frozen=True)
class _Unbound:
    """The reads of a file that no scope binds.  ``names`` are those that can be read there, ``known`` says for each
    read which of these: many share them."""

    reads: list[_Read] = field(default_factory=list)
    names: list[frozenset[str]] = field(default_factory=list)
    known: list[int] = field(default_factory=list)

    def names_at(self, read: _Read) -> frozenset[str]:
        return self.names[self.known[self.reads.index(read)]]


@kept_for_each_file
def _unbound(code: facts.Facts) -> _Unbound:
    """The first read of each such name in each function of a file."""
    rows = _unbound_with_names(code)
    names = list(dict.fromkeys(names for _, names in rows))
    numbers = {known: number for number, known in enumerate(names)}
    return _Unbound([read for read, _ in rows], names, [numbers[known] for _, known in rows])


def _unbound_with_names(code: facts.Facts) -> list[_Known]:
    asked = _asked_for(code)
    if not _ROS_1.isdisjoint(_modules_of(code)) or asked is None:
        return []
    always = _ALWAYS if _CHECKS_VERSION.isdisjoint(code.names) else _ALWAYS | _OF_PYTHON_2
    scope = _Scope(always | own_names(code) | asked)
    return [*_reads(code.body, scope)]


def _asked_for(code: facts.Facts) -> frozenset[str] | None:
    """The names of which code asks whether there are such, ``"name" in globals()``; None where it may bind any name."""
    makers = makers_of_names(code)
    if not makers:
        return frozenset()
    asked = [name for part in everything_in(code.body, facts.Compare) if (name := _asked_in(part)) is not None]
    asks = all(use.variable in ("globals", "locals") for use in makers)
    return frozenset(asked) if asks and len(asked) == len(makers) else None


def _asked_in(part: facts.Compare) -> str | None:
    match part:
        case facts.Compare(
            facts.Literal(str(name)), ["in" | "not in"], [facts.Call(facts.Name("globals" | "locals"), [])]
        ):
            return name
    return None


def _modules_of(code: facts.Facts) -> set[str]:
    tops = {part.module.partition(".")[0] for part in everything_in(code.body, facts.Import)}
    return tops | {part.module.partition(".")[0] for part in everything_in(code.body, facts.ImportFrom)}


def _reads(body: Sequence[facts.Base], scope: _Scope) -> Iterator[_Known]:
    """The first read of each name that code reads and that is not in its scope, in the order of the source."""
    seen: set[str] = set()
    stack = list(reversed(body))
    while stack:
        part = stack.pop()
        match part:
            case facts.Function() | facts.Lambda() | facts.Class():
                stack += reversed(_evaluated_outside(part))
                yield from _reads(hints_of(part), replace(scope, in_hint=True))
                yield from _reads_inside(part, scope)
            case facts.Comprehension(generators=generators):
                targets = [name.id for each in generators for name in everything_in(each.target, facts.Name)]
                yield from _reads(part.children(), scope.within(frozenset(targets)))
            case facts.Try() if any(_catches(handler) for handler in part.handlers):
                stack += reversed([*part.handlers, *part.orelse, *part.final])
            case facts.If(test=test, orelse=orelse) if _is_of_windows(test):
                stack += reversed([test, *orelse])
            case facts.If(test=test, body=inside, orelse=orelse) if _is_of_notebooks(test):
                stack += reversed([test, *orelse])
                yield from _reads(inside, scope.within(_OF_NOTEBOOKS))
            case facts.Annotated(target=target, value=value):
                stack += [fact for fact in (value, target) if fact is not None]
            case facts.Name(id=name):
                if name not in scope.names and name not in seen and not is_unreachable(scope.body, part.span):
                    seen.add(name)
                    yield scope.read(part)
            case _:
                stack += reversed(part.children())


def _evaluated_outside(part: facts.Function | facts.Lambda | facts.Class) -> list[facts.Base]:
    """What the code around a function or a class evaluates: decorators, bases and defaults."""
    match part:
        case facts.Class(bases=bases, decorators=decorators):
            return [*decorators, *bases]
        case facts.Function(params=params, decorators=decorators):
            return [*decorators, *(param.default for param in params if param.default is not None)]
        case facts.Lambda(params=params):
            return [param.default for param in params if param.default is not None]


def _reads_inside(part: facts.Function | facts.Lambda | facts.Class, scope: _Scope) -> Iterator[_Known]:
    match part:
        case facts.Class(body=body):
            own = frozenset(bound_in(body))
            members = own | {target.attr for target in _set_on_self(body)}
            for statement in body:
                if isinstance(statement, facts.Function):  # which does not see what the body of the class binds
                    yield from _reads(_evaluated_outside(statement), scope.within(own))
                    yield from _reads(hints_of(statement), replace(scope.within(own), in_hint=True))
                    without_self = "" if statement.params or statement.decorators else statement.name
                    yield from _reads_inside(statement, _Scope(scope.names, members, without_self))
                else:
                    yield from _reads([statement], scope.within(own))
        case facts.Function(params=params, body=body):
            inside = scope.within(frozenset(param.name for param in params))
            yield from _reads(body, replace(inside.within(frozenset(bound_in(body))), body=body))
            yield from _only_added_to(part, inside)
        case facts.Lambda(params=params, body=body):
            yield from _reads([body], scope.within(frozenset((*(param.name for param in params), *bound_in([body])))))


def _only_added_to(function: facts.Function, scope: _Scope) -> Iterator[_Known]:
    """The local variables that a function changes with ``+=`` alone, so that nothing ever gives them a value."""
    params = frozenset(param.name for param in function.params)
    others = {
        name for part in parts_of(function.body) if not isinstance(part, facts.Augmented) for name in bound_by(part)
    }
    seen: set[str] = set()
    for part in parts_of(function.body, facts.Augmented):
        match part.target:
            case facts.Name(id=name) if name not in others | params | seen:
                seen.add(name)
                yield scope.read(part.target, added=True)


def _set_on_self(body: Sequence[facts.Stmt]) -> Iterator[facts.Attribute]:
    for function in statements_of(body, facts.Function):
        for part in everything_in(function.body):
            for target in part.assigned:
                match target:
                    case facts.Attribute(value=facts.Name(id="self")):
                        yield target


def _is_of_windows(test: facts.Expr) -> bool:
    """``os.name == 'nt'``: what runs nowhere else, most likely comes from elsewhere and never runs."""
    match test:
        case facts.Compare(left, ["=="], [right]):
            return (left.dotted, right.text) in {("os.name", "nt"), ("sys.platform", "win32")}
    return False


def _is_of_notebooks(test: facts.Expr) -> bool:
    """``if IN_NOTEBOOK``: whether a test is true only where IPython runs the code."""
    parts = (part for part in everything_in([test]) if isinstance(part, (facts.Name, facts.Attribute)))
    return any(word in part.last_name.lower() for part in parts for word in _HAVE_IPYTHON)


def _catches(handler: facts.Handler) -> bool:
    return handler.type is None or "NameError" in handler.caught


__all__ = ["Undefined", "undefined_names"]
