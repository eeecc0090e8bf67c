"""What code does with a ``Parameter`` as if it were the value in it: arithmetic, comparisons, conditions, loops.

``get_parameter()`` and ``declare_parameter()`` of a node return an object of ``rclpy.parameter.Parameter``, which has
no operator but ``==``, no length and no items, and counts as true whatever is in it.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_few_files
from archlint.analysis.own_names import is_defined_somewhere
from archlint.libraries.rclpy.names import NODE_CLASSES
from archlint.place import Place
from archlint.python_code.class_chains import Chain, ClassInFile, chain_of, classes_of
from archlint.python_code.rclpy_objects import Kind, Objects, Variables, objects_of
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of
from archlint.syntax.tree import span_of

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


class Outcome(StringEnum):
    """What comes of it."""

    FAILS = "fails"
    """A TypeError."""
    TRUE = "true"
    FALSE = "false"


@dataclass(frozen=True)
class ParameterUse:
    """A place where a Parameter stands for its value; ``by`` is the operator, function or statement."""

    outcome: Outcome
    by: str
    place: Place


@dataclass(frozen=True)
class _Row:
    outcome: Outcome
    by: str
    span: facts.Span
    cls: facts.Class | None
    """The class in whose method it is."""


_GIVE_PARAMETERS = ("get_parameter", "declare_parameter")


def parameter_uses(system: System) -> Iterator[ParameterUse]:
    """Every such use in the files that were asked for, outside of test code and of classes that may be no plain
    nodes."""
    workspace = system.workspace
    if workspace is None:
        return
    for path in workspace.python_files(mentioning="rclpy"):
        rows = [row for row in _of_file(workspace, path) if _is_of_node(workspace, path, row.cls)]
        if rows and not _has_own_parameters(system, path):
            yield from (ParameterUse(row.outcome, row.by, Place(path, *row.span)) for row in rows)


def _has_own_parameters(system: System, file: str) -> bool:
    """Whether code that a file may use defines a method by the name of one that gives parameters."""
    return any(is_defined_somewhere(system, file, name) for name in _GIVE_PARAMETERS)


def gives_parameters(system: System, cls: ClassInFile) -> bool:
    """Whether what ``self`` has by the names of methods that give parameters is certainly rclpy's."""
    workspace = system.workspace
    if workspace is None or _has_own_parameters(system, cls.file):
        return False
    return not NODE_CLASSES.isdisjoint(chain_of(workspace, cls).foreign) and _is_of_node(workspace, cls.file, cls.code)


def _is_of_node(workspace: WorkspaceIndex, file: str, cls: facts.Class | None) -> bool:
    """Whether ``self`` is certainly rclpy's node, if it is anything that has parameters."""
    chain = Chain() if cls is None else chain_of(workspace, ClassInFile(file, cls))
    return chain.complete and NODE_CLASSES.issuperset(set(chain.foreign) - {"object", "abc.ABC"})


@kept_for_few_files
def _of_file(file_facts: facts.Facts) -> list[_Row]:
    code = objects_of(file_facts)
    owners = {
        Itself(function): cls for cls in classes_of(file_facts) for function in everything_in(cls.body, facts.Function)
    }
    return [
        _Row(outcome, by, span, owners.get(Itself(function)))
        for function in everything_in(file_facts.body, facts.Function)
        for outcome, by, span in _uses(code, function)
    ]


_Use = tuple[Outcome, str, facts.Span]
_ORDER = frozenset({"<", "<=", ">", ">="})


def _uses(code: Objects, function: facts.Function) -> Iterator[_Use]:
    scope = code.scope(function)
    for part in parts_of(function.body):
        if Itself(part) in code.tried:
            continue
        for test in _tests(part):
            if scope.kind(test) == Kind.PARAMETER and not code.may_be_none(test):
                yield Outcome.TRUE, "", span_of(test)
        yield from _failing(scope, part)


def _tests(part: facts.Base) -> list[facts.Expr]:
    """The expressions whose truth decides something."""
    match part:
        case facts.If(test=test) | facts.While(test=test) | facts.Conditional(test=test) | facts.Assert(test=test):
            return [test]
        case facts.Unary(op="not", operand=operand):
            return [operand]
        case facts.Boolean(values=values):
            return values[:-1]
    return []


def _failing(scope: Variables, part: facts.Base) -> Iterator[_Use]:
    """What raises a TypeError, and comparisons that never hold."""

    def is_parameter(e: facts.Expr) -> bool:
        return scope.kind(e) == Kind.PARAMETER

    match part:
        case facts.Binary(op=op, left=left, right=right, span=span):
            formats = op == "%" and not is_parameter(left)  # '%s' % parameter
            if (is_parameter(left) or is_parameter(right)) and not formats:
                yield Outcome.FAILS, f"'{op}'", span
        case facts.Compare(ops=[op], left=left, comparators=[right], span=span):
            if op in _ORDER and (is_parameter(left) or is_parameter(right)):
                yield Outcome.FAILS, f"'{op}'", span
            elif op in ("==", "!=") and _is_compared(left, right, is_parameter(left), is_parameter(right)):
                yield Outcome.FALSE if op == "==" else Outcome.TRUE, f"'{op}'", span
            elif op in ("in", "not in") and is_parameter(right):
                yield Outcome.FAILS, f"'{op}'", span
        case facts.Subscript(value=value, span=span) if is_parameter(value):
            yield Outcome.FAILS, "an index", span
        case facts.For(iterable=iterable) | facts.Generator(iterable=iterable) if is_parameter(iterable):
            yield Outcome.FAILS, "a loop", span_of(iterable)
        case facts.Call(func=facts.Name(id="zip"), args=given):
            if any(is_parameter(argument.value) and not argument.star and not argument.keyword for argument in given):
                yield Outcome.FAILS, "zip()", part.span
        case facts.Call(func=facts.Name(id=name), args=[facts.Argument(value=value, keyword=None, star=""), *_]):
            if name in _OF_VALUES and is_parameter(value):
                yield Outcome.FAILS, f"{name}()", part.span


_OF_VALUES = frozenset(
    {"abs", "all", "any", "enumerate", "float", "int", "iter", "len", "list", "open", "range", "reversed", "round"}
)
_OF_VALUES |= {"set", "sorted", "sum", "tuple"}
"""Functions of Python that refuse an object which is no number, text or list."""


def _is_compared(left: facts.Expr, right: facts.Expr, is_left: bool, is_right: bool) -> bool:
    """Whether one side is a Parameter and the other a constant, which is never equal to it."""
    other = right if is_left else left
    return is_left != is_right and isinstance(other, facts.Literal) and other.value is not None


__all__ = ["Outcome", "ParameterUse", "gives_parameters", "parameter_uses"]
