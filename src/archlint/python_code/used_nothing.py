"""Results of functions that return none, which code uses as if they were something: ``for item in items.sort():``."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.place import Place
from archlint.python_code.own_calls import function_meant, own_calls_of
from archlint.python_code.plain_kinds import Kind, kind_of
from archlint.python_code.tried_code import OF_A_WRONG_KIND, tried_for
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.control_flow import always_raises
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


class Use(StringEnum):
    """What code does with a None."""

    FAILS = "fails"
    LOOKS_INTO = "looks into"
    """It asks for an attribute."""
    TESTS = "tests"
    TESTS_NOT = "tests not"
    KEEPS = "keeps"


_CALCULATE = frozenset({"+", "-", "*", "/", "//", "%", "**"})
_ORDER = frozenset({"<", "<=", ">", ">="})
_TAKE_A_VALUE = frozenset(
    {"len", "sorted", "list", "tuple", "set", "sum", "min", "max", "float", "int", "abs", "enumerate"}
)
_SHUFFLES = frozenset({"random.shuffle", "np.random.shuffle", "numpy.random.shuffle"})
_OF_LISTS = frozenset({"append", "clear", "extend", "insert", "remove", "reverse", "sort"})


@dataclass(frozen=True)
class UsedNothing:
    """Such a use of a call of ``name``, a function of the workspace that is ``defined`` somewhere or one of Python."""

    place: Place
    name: str
    use: Use
    defined: Place | None = None


def uses_of_nothing(workspace: WorkspaceIndex) -> Iterator[UsedNothing]:
    """Every such line in the files that were asked for, but for test code."""
    for path in workspace.python_files():
        for name, use, span in _of_python(workspace, path) or ():
            yield UsedNothing(Place(path, *span), name, use)
        uses = dict(uses_of_results(workspace, path) or ())
        if path in _started_by_entries(workspace):
            uses = _outside_of_guard(workspace, path, uses)
        for call in (own_calls_of(workspace, path) or ()) if uses else ():
            row = uses.get(call.span)
            meant = None if row is None else function_meant(workspace, path, call)
            if row is not None and meant is not None and returns_nothing(meant.code):
                defined = Place(meant.file, *meant.code.name_span)
                yield UsedNothing(Place(path, *row[1]), call.name, row[0], defined)


@once
def _started_by_entries(workspace: WorkspaceIndex) -> frozenset[str]:
    """The modules of console scripts, which call a function and leave out what a module does as the program."""
    executables = [each for installs in workspace.installs.values() for each in installs.executables.values()]
    scripts = {each.script for each in executables}
    modules = ((each.package, each.module) for each in executables if each.module and each.script is None)
    files = (file for package, module in modules for file in workspace.code.files_named(package, module or ""))
    return frozenset(file for file in files if file not in scripts)


def _outside_of_guard(
    workspace: WorkspaceIndex, path: str, uses: dict[facts.Span, tuple[Use, facts.Span]]
) -> dict[facts.Span, tuple[Use, facts.Span]]:
    """The uses but for tests below ``if __name__ == '__main__':``, as of the status that the program ends with."""
    file_facts = workspace.facts_at(path)
    guard, tests = None if file_facts is None else main_guard(file_facts), (Use.TESTS, Use.TESTS_NOT)
    if guard is None:
        return uses
    return {call: row for call, row in uses.items() if row[0] not in tests or not covers(guard, call)}


@once_for
def returns_nothing(code: facts.Function) -> bool:
    """Whether a function returns None wherever it ends, and is more than a place for one to be written."""
    if code.is_async or code.is_generator or code.decorators or code.name == "__init__" or always_raises(code.body):
        return False
    if all(_says_nothing(statement) for statement in code.body):
        return False
    returned = (statement.value for statement in parts_of(code.body, facts.Return))
    return all(value is None or _is_none(value) for value in returned)


def _is_none(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and value.value is None


def _says_nothing(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Jump() | facts.Raise() | facts.Expression(value=facts.Literal() | facts.Opaque()):
            return True
        case facts.Return(value=None):
            return True
    return False


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def uses_of_results(code: facts.Facts) -> list[tuple[facts.Span, tuple[Use, facts.Span]]]:
    """The calls whose results code uses, or those of the one variable that gets them: how, and where."""
    expecting = tried_for(code.body, OF_A_WRONG_KIND)
    rows: list[tuple[facts.Span, tuple[Use, facts.Span]]] = []
    for body in _bodies(code):
        kept = _kept_in(body)
        for part in parts_of(body):
            if Itself(part) in expecting:
                continue
            for value, use, span in _used_by(part):
                match value:
                    case facts.Call(span=called):
                        rows.append((called, (use, span)))
                    case facts.Name(id=name) if name in kept and use in (Use.FAILS, Use.LOOKS_INTO):
                        rows.append((kept[name].span, (use, span)))
    return rows[::-1]  # in a dict the first use of a call wins


def _bodies(code: facts.Facts) -> Iterator[Sequence[facts.Stmt]]:
    yield code.body
    for function in everything_in(code.body, facts.Function):
        yield function.body


def _kept_in(body: Sequence[facts.Stmt]) -> dict[str, facts.Call]:
    """The variables of a function that get the result of one call and nothing else, and are not asked for None."""
    bound = list(names_bound(body))
    asked = {
        name.id for part in everything_in(body) for test in tests_in(part) for name in everything_in([test], facts.Name)
    }
    shared = {name for statement in everything_in(body, facts.Global) for name in statement.names}
    kept: dict[str, facts.Call] = {}
    for statement in parts_of(body, facts.Assign):
        match statement:
            case facts.Assign(targets=[facts.Name(id=name)], value=facts.Call() as call):
                if bound.count(name) == 1 and name not in asked | shared:
                    kept[name] = call
    return kept


def tests_in(part: facts.Base) -> Sequence[facts.Expr]:
    """The expressions for whose truth a piece of code asks."""
    match part:
        case facts.If(test=test) | facts.While(test=test) | facts.Assert(test=test) | facts.Conditional(test=test):
            return [test]
        case facts.Boolean(values=values):
            return values
        case facts.Comprehension(generators=generators):
            return [test for generator in generators for test in generator.conditions]
    return []


def _used_by(part: facts.Base) -> Iterator[tuple[facts.Expr, Use, facts.Span]]:
    """What a piece of code uses the values of."""
    match part:
        case facts.Assign(targets=[facts.Sequence()], value=value, span=span):
            yield value, Use.FAILS, span
        case facts.Subscript(value=value, span=span):
            yield value, Use.FAILS, span
        case facts.Attribute(value=value, attr=attr, span=span) if not attr.startswith("__"):
            yield value, Use.LOOKS_INTO, span
        case facts.For(iterable=facts.Call(span=span) | facts.Name(span=span) as value, is_async=False):
            yield value, Use.FAILS, span
        case facts.Generator(iterable=facts.Call(span=span) | facts.Name(span=span) as value):
            yield value, Use.FAILS, span
        case facts.Binary(op=op, left=left, right=right, span=span) if op in _CALCULATE:
            yield left, Use.FAILS, span
            if not (op == "%" and _is_text(left)):
                yield right, Use.FAILS, span
        case facts.Compare(left=left, ops=[op], comparators=[right], span=span) if op in _ORDER:
            yield left, Use.FAILS, span
            yield right, Use.FAILS, span
        case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=value, star="")], span=span):
            if name in _TAKE_A_VALUE:
                yield value, Use.FAILS, span
        case facts.Call(
            func=facts.Attribute(value=held, attr="publish"), args=[facts.Argument(value=value)], span=span
        ):
            if "pub" in held.last_name.lower():
                yield value, Use.FAILS, span
        case facts.If(test=facts.Call(span=span) as value) | facts.While(test=facts.Call(span=span) as value):
            yield value, Use.TESTS, span
        case facts.If(test=facts.Unary(op="not", operand=facts.Call() as value, span=span)):
            yield value, Use.TESTS_NOT, span


def _is_text(part: facts.Base) -> bool:
    return isinstance(part, facts.FormatString) or (isinstance(part, facts.Literal) and part.text is not None)


@kept_for_each_file
def _of_python(code: facts.Facts) -> list[tuple[str, Use, facts.Span]]:
    """The uses of what ``random.shuffle()`` and the methods that change a list return."""
    rows: list[tuple[str, Use, facts.Span]] = []
    for body in _bodies(code):
        lists = _lists_in(body)
        read = [name.id for name in everything_in(body, facts.Name)]
        for part in parts_of(body):
            for value, use, span in (*_used_by(part), *_kept_by(part, read)):
                if isinstance(value, facts.Call) and _changes_a_list(value, lists):
                    rows.append((value.func.dotted, use, span))
    return rows


def _kept_by(part: facts.Base, read: Sequence[str]) -> Iterator[tuple[facts.Expr, Use, facts.Span]]:
    match part:
        case facts.Assign(targets=[facts.Attribute()], value=value, span=span):
            yield value, Use.KEEPS, span
        case facts.Assign(targets=[facts.Name(id=name)], value=value, span=span) if read.count(name) > 1:
            yield value, Use.KEEPS, span


def _changes_a_list(call: facts.Call, lists: frozenset[str]) -> bool:
    match call.func:
        case facts.Attribute(value=facts.Name(id=name), attr=attr) if name in lists and attr in _OF_LISTS:
            return True
    return call.func.dotted in _SHUFFLES


def _lists_in(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """The variables of a function that hold lists for certain."""
    bound = list(names_bound(body))
    lists: list[str] = []
    for statement in parts_of(body, facts.Assign):
        match statement:
            case facts.Assign(targets=[facts.Name(id=name)], value=value) if kind_of(value, {}) is Kind.LIST:
                lists.append(name)
    return frozenset(name for name in lists if lists.count(name) == bound.count(name))


__all__ = ["Use", "UsedNothing", "returns_nothing", "tests_in", "uses_of_nothing", "uses_of_results"]
