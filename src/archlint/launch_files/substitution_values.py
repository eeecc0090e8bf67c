"""Substitutions that the code of a launch file uses as if they were the values that launch makes of them later.

Source: a ``Substitution`` of launch is an object without operators.  Python finds it true, unequal to any text, and
makes ``<launch.substitutions.… object at 0x…>`` of it; ``+`` raises a TypeError.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.launch.tables import SUBSTITUTIONS, LaunchClass
from archlint.launch_files.launch_code import names_from_launch
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.bindings import bound_by
from archlint.syntax.flow_facts import holds
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex


class Misuse(StringEnum):
    """What code does with a substitution, or with the text of one."""

    ADDED = "added"
    """``'a' + LaunchConfiguration('x')``."""
    FORMATTED = "formatted"
    """``f'{LaunchConfiguration('x')}'``."""
    CONVERTED = "converted"
    """``str(LaunchConfiguration('x'))``."""
    INDEX = "index"
    """``files[LaunchConfiguration('x')]``."""
    TESTED = "tested"
    """``if LaunchConfiguration('x'):``, ``not LaunchConfiguration('x')``."""
    COMBINED = "combined"
    """``LaunchConfiguration('x') and LaunchConfiguration('y')``."""
    COMPARED = "compared"
    """``LaunchConfiguration('x') == 'true'``."""
    TEXT_TESTED = "text tested"
    """``if LaunchConfiguration('x').perform(context):``, where the text is ``true`` or ``false``."""


@dataclass(frozen=True)
class Misused:
    """One place; ``what`` is the class of the substitution, or the launch argument whose text is tested."""

    kind: Misuse
    what: str
    span: facts.Span
    operator: str = ""
    is_given: bool = False
    """Whether the result is an argument, or an item of what is one: a parameter's value, say."""
    chooses: bool = False
    """Whether it decides between two texts, as in ``'a' if … else 'b'``, or a test between two constants."""
    combined: str = ""
    """The word, ``and`` or ``or``, that makes the result that is given of this one and others."""


def misused_substitutions(system: System) -> Iterator[tuple[str, Misused]]:
    """Every such place in the launch files in Python of a launched system, with its file."""
    if system.launched is None or system.workspace is None:
        return
    for file in system.launched.sources:
        if file.endswith(".py"):
            yield from ((file, misused) for misused in _of_file(system.workspace, file) or ())


def is_chosen_in_vain(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether code at a place tests a substitution, so that it chooses the same each time, whatever was meant."""
    rows = (_of_file(workspace, place.file) if place.file.endswith(".py") else None) or ()
    spans = (misused.span for misused in rows if misused.kind in _TESTS)
    return any(holds(place.span, span) for span in spans)


_TESTS = (Misuse.TESTED, Misuse.COMBINED, Misuse.COMPARED, Misuse.TEXT_TESTED)


@kept_for_each_file
def _of_file(file_facts: facts.Facts) -> list[Misused]:
    code = _Code(file_facts)
    places = {misused.span: misused for misused in _misused(code)} if code.classes else {}
    return sorted(places.values(), key=lambda misused: misused.span)


_CLASSES = frozenset(map(str, SUBSTITUTIONS - {LaunchClass.TEXT_SUBSTITUTION}))
_YES_OR_NO = frozenset({"true", "false"})


class _Code:
    """The names of one launch file that stand for substitutions, and for the texts of launch arguments, whatever
    happens: all that the file assigns to such a name are calls which make one."""

    def __init__(self, file_facts: facts.Facts) -> None:
        self.body = file_facts.body
        self.classes = {bound: name for bound, name in names_from_launch(self.body).items() if name in _CLASSES}

    @cached_property
    def assigned(self) -> dict[str, list[facts.Expr]]:
        """All values of the names that are bound by plain assignments only."""
        values: dict[str, list[facts.Expr]] = {}
        others: set[str] = set()
        for part in everything_in(self.body):
            match part:
                case facts.Assign(targets=[facts.Name(id=name)], value=value):
                    values.setdefault(name, []).append(value)
                case _:
                    others.update(bound_by(part))
        return {name: rows for name, rows in values.items() if name not in others}

    @cached_property
    def yes_or_no(self) -> frozenset[str]:
        """The launch arguments that the file declares with the default ``true`` or ``false``."""
        calls = (call for call in everything_in(self.body, facts.Call) if call.func.last_name == _DECLARE)
        rows = ((_argument(call, 0, "name"), _argument(call, -1, "default_value")) for call in calls)
        return frozenset(name for name, default in rows if name and default and default.lower() in _YES_OR_NO)

    def substitution(self, e: facts.Expr) -> str:
        """The class of the substitution that an expression is for certain; empty for anything else."""
        match e:
            case facts.Name(id=name) if name in self.assigned:
                kinds = {self._made(value) for value in self.assigned[name]}
                return kinds.pop() if len(kinds) == 1 else ""
        return self._made(e)

    def _made(self, e: facts.Expr) -> str:
        match e:
            case facts.Call(func=facts.Name(id=name)):
                return self.classes.get(name, "")
        return ""

    def configuration(self, e: facts.Expr) -> str:
        """The launch argument of the ``LaunchConfiguration`` that an expression is for certain; empty for anything
        else."""
        options = self.assigned.get(e.id, []) if isinstance(e, facts.Name) else [e]
        names = {_configuration(option) for option in options if self._made(option) == _CONFIGURATION}
        return names.pop() if len(names) == len(options) == 1 else ""

    def text_of(self, e: facts.Expr) -> str:
        """The launch argument whose text an expression is for certain; empty for anything else."""
        match e:
            case facts.Name(id=name) if name in self.assigned:
                names = {self._performed(value) for value in self.assigned[name]}
                return names.pop() if len(names) == 1 else ""
        return self._performed(e)

    def _performed(self, e: facts.Expr) -> str:
        match e:
            case facts.Call(func=facts.Attribute(value=asked, attr="perform")):
                return self.configuration(asked)
            case facts.Subscript(value=facts.Attribute(attr="launch_configurations"), index=index):
                return index.text or ""
        return ""


_DECLARE = str(LaunchClass.DECLARE_LAUNCH_ARGUMENT)
_CONFIGURATION = str(LaunchClass.LAUNCH_CONFIGURATION)


def _configuration(e: facts.Expr) -> str:
    return _argument(e, 0, "variable_name") if isinstance(e, facts.Call) else ""


def _argument(call: facts.Call, position: int, keyword: str) -> str:
    """The text that a call is given as an argument."""
    named = [argument.value.text for argument in call.args if argument.keyword == keyword]
    plain = [argument.value.text for argument in call.args[:1] if not argument.keyword and position == 0]
    return next((text for text in (*named, *plain) if text is not None), "")


# ------------------------------------------------------------------------------------------- what is done with them


def _misused(code: _Code) -> Iterator[Misused]:
    printed = {id(part) for argument in _printed(code.body) for part in everything_in(argument.value)}
    combined = {id(operand): op for value in _given(code.body) for operand, op in _operands(value)}
    given = {id(value) for value in _given(code.body)} | combined.keys()
    choosing = {
        id(choice.test)
        for choice in everything_in(code.body, facts.Conditional)
        if choice.body.text is not None and choice.orelse.text is not None
    }
    decided = {id(choice) for choice in _decided_by_condition(code)}
    for part in everything_in(code.body):
        match part:
            case facts.Binary(op="+", left=left, right=right):
                yield from _each(code, Misuse.ADDED, (left, right), part.span)
            case facts.Binary(op="%", left=facts.Literal(value=str()), right=right) if id(part) not in printed:
                yield from _each(code, Misuse.FORMATTED, right.unpacked, part.span)
            case facts.FormatString() if id(part) not in printed:
                values = [field.value for field in part.parts if isinstance(field, facts.Field)]
                yield from _each(code, Misuse.FORMATTED, values, part.span)
            case facts.Call(args=[argument, *others]) if part.func.last_name in _TAKE_VALUES and (
                part.func.last_name != "str" or id(part) not in printed
            ):
                if not others or part.func.last_name not in _OF_PYTHON:
                    hands_on = id(part) in given and part.func.last_name in _OF_PYTHON
                    for misused in _each(code, Misuse.CONVERTED, [argument.value], part.span, part.func.last_name):
                        yield replace(misused, is_given=hands_on)
            case facts.Subscript(index=index, span=span):
                yield from _each(code, Misuse.INDEX, [index], span)
            case facts.Compare(comparators=[facts.Literal(value=None)]):
                pass  # it asks whether there is a substitution
            case facts.Compare(ops=[op], comparators=[right]) if op in ("==", "!=", "in", "not in"):
                sides = [part.left] if "in" in op else [part.left, right]
                for misused in _each(code, Misuse.COMPARED, sides, part.span, op):
                    row = replace(misused, is_given=id(part) in given, chooses=id(part) in choosing)
                    yield replace(row, combined=combined.get(id(part), ""))
            case facts.Boolean(values=values, op=op):
                yield from (m for v in values[:-1] for m in _each(code, Misuse.COMBINED, [v], part.span, op))
            case facts.Unary(op="not", operand=operand):
                yield from _tested(code, operand)
            case facts.Conditional() if id(part) in decided:
                pass  # the action only runs with the outcome that the test has
            case facts.Conditional(test=test, body=facts.Literal(), orelse=facts.Literal()):
                yield from (replace(misused, chooses=True) for misused in _tested(code, test))
            case facts.If(test=test) | facts.While(test=test) | facts.Conditional(test=test):
                yield from _tested(code, test)


_OF_PYTHON = frozenset({"str", "int", "float", "len", "range"})
_TAKE_VALUES = _OF_PYTHON | {"open", "get_package_share_directory", "get_package_share_path", "get_package_prefix"}
"""Functions that need a value at once."""


def _each(
    code: _Code,
    kind: Misuse,
    values: Iterable[facts.Expr],
    span: facts.Span,
    operator: str = "",
) -> Iterator[Misused]:
    classes = [name for name in map(code.substitution, values) if name]
    if classes:
        yield Misused(kind, classes[0], span, operator)


def _tested(code: _Code, test: facts.Expr) -> Iterator[Misused]:
    """The operands of a test that are true whatever their values are."""
    match test:
        case facts.Boolean(values=values):
            for value in values:
                yield from _tested(code, value)
        case facts.Name() | facts.Call() | facts.Subscript():
            yield from _each(code, Misuse.TESTED, [test], test.span)
            name = code.text_of(test)
            if name in code.yes_or_no:
                yield Misused(Misuse.TEXT_TESTED, name, test.span)


def _given(body: list[facts.Stmt]) -> Iterator[facts.Expr]:
    """What is an argument of a call, or an item of a display; a condition is none of these, nor is what a function of
    the file itself is called with, which may ask for its text."""
    own = {function.name for function in everything_in(body, facts.Function)}
    calls = [call for call in everything_in(body, facts.Call) if call.func.dotted in own]
    asked = {id(part) for call in calls for argument in call.args for part in everything_in(argument.value)}
    for value in _handed_on(body):
        if id(value) not in asked:
            yield value


def _operands(e: facts.Expr) -> Iterator[tuple[facts.Expr, str]]:
    """What ``and`` or ``or`` makes a value of, with that word."""
    if isinstance(e, facts.Boolean):
        for operand in e.values:
            yield operand, e.op
            yield from _operands(operand)


def _handed_on(body: list[facts.Stmt]) -> Iterator[facts.Expr]:
    for part in everything_in(body):
        match part:
            case facts.Call(args=arguments):
                yield from (argument.value for argument in arguments if argument.keyword != _CONDITION)
            case facts.Mapping(values=values) | facts.Sequence(elements=values):
                yield from values


def _decided_by_condition(code: _Code) -> Iterator[facts.Conditional]:
    """The choices in the arguments of an action that test what its ``condition=IfCondition(…)`` tests."""
    for call in everything_in(code.body, facts.Call):
        for argument in call.args:
            match argument:
                case facts.Argument(
                    keyword="condition", value=facts.Call(func=facts.Name(id="IfCondition"), args=[tested])
                ) if name := code.configuration(tested.value):
                    for choice in everything_in([each.value for each in call.args], facts.Conditional):
                        if code.configuration(choice.test) == name:
                            yield choice


_CONDITION = "condition"


def _printed(body: list[facts.Stmt]) -> Iterator[facts.Argument]:
    """What code prints or logs: that a substitution is an object is plain to see there, and nothing else is wrong."""
    for call in everything_in(body, facts.Call):
        if call.func.last_name == "print" or _is_of_logger(call.func):
            yield from call.args


_LEVELS = frozenset({"critical", "debug", "error", "exception", "fatal", "info", "log", "warn", "warning"})
_LOGGERS = frozenset({"log", "logger", "logging"})
_MAKE_LOGGERS = frozenset({"getLogger", "get_logger"})


def _is_of_logger(function: facts.Expr) -> bool:
    """Whether a function writes to a log: ``logger.info``, ``logging.warning``, ``get_logger('robot').debug``."""
    match function:
        case facts.Attribute(value=facts.Call(func=function), attr=level):
            return level in _LEVELS and function.last_name in _MAKE_LOGGERS
        case facts.Attribute(value=logger, attr=level):
            return level in _LEVELS and logger.last_name.lower().strip("_").rpartition("_")[2] in _LOGGERS
    return False


__all__ = ["Misuse", "Misused", "is_chosen_in_vain", "misused_substitutions"]
