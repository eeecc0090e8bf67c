"""What code logs that is certainly no text, though no literal: a ``Time``, a message, a parameter's number, a list.

Source: ``rclpy_logging_rcutils_log`` of rclpy takes a text, as :mod:`~archlint.python_code.logger_calls` has it; tried
with rclpy of jazzy, which refuses each of these.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.api_signatures import distros
from archlint.model import Misuse, RefusedCall
from archlint.place import Place
from archlint.python_code import rclpy_objects
from archlint.python_code.class_chains import ClassInFile, classes_of, methods_of
from archlint.python_code.declared_kinds import kind_with_parameters
from archlint.python_code.logger_calls import LEVELS, LOGGER, Loggers, has_own_loggers
from archlint.python_code.message_variables import imported_messages, makes_message, variables_of_messages
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.parameters_as_values import gives_parameters
from archlint.python_code.plain_kinds import Kind, Values, kind_of, kind_of_all, values_in, values_of_self
from archlint.python_code.rclpy_objects import objects_of
from archlint.python_code.text_sums import is_its_own
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import System

_OF_NODES = frozenset({rclpy_objects.Kind.PARAMETER, rclpy_objects.Kind.VALUE})


@dataclass(frozen=True)
class _Row:
    span: facts.Span
    method: str
    kind: str
    instead: str
    cls: int | None
    """The class in a method of which it is, by its position in the file."""
    attribute: str = ""
    """The attribute of ``self`` that is logged."""
    of_node: bool = False
    """Whether it is so only if ``self`` is a node of rclpy's."""


def logged_values(system: System) -> Iterator[RefusedCall]:
    """Every such call in the files that use rclpy; none where the workspace has loggers of its own."""
    workspace = system.workspace
    if workspace is None or has_own_loggers(workspace):
        return
    for path in workspace.python_files(mentioning="get_logger"):
        code = workspace.facts_at(path)
        for row in (_rows(workspace, path) or ()) if code is not None else ():
            cls = None if row.cls is None or code is None else classes_of(code)[row.cls]
            if row.attribute and (row.cls is None or not is_its_own(workspace, path, row.cls, row.attribute)):
                continue
            if row.of_node and (cls is None or not gives_parameters(system, ClassInFile(path, cls))):
                continue
            yield RefusedCall(
                Place(path, *row.span),
                f"{LOGGER}.{row.method}",
                Misuse.KIND,
                ("message",),
                takes=1,
                given=row.kind,
                wanted="a text",
                signature=(row.instead,),
                distros=distros(),
            )


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    loggers = Loggers(code)
    if not loggers.uses_rclpy:
        return []
    rows: list[_Row] = []
    in_methods: set[Itself[facts.Base]] = set()
    for number, cls in enumerate(classes_of(code)):
        attributes = values_of_self(cls)
        for function in methods_of(cls):
            in_methods.add(Itself(function))
            rows += _in(code, loggers, function, number, attributes)
    for function in everything_in(code.body, facts.Function):
        if Itself[facts.Base](function) not in in_methods:
            rows += _in(code, loggers, function, None, {})
    return rows


def _in(
    code: facts.Facts, loggers: Loggers, function: facts.Function, number: int | None, attributes: Values
) -> Iterator[_Row]:
    calls = [call for call in parts_of(function.body, facts.Call) if call.func.attribute in LEVELS]
    calls = [call for call in calls if loggers.is_of_logger(call.func) and not loggers.is_tried(call)]
    if not calls:
        return
    cls = None if number is None else classes_of(code)[number]
    variables, messages = values_in(function), imported_messages(code)
    own_messages = variables_of_messages(function, messages) if messages else set()
    for call in calls:
        match call.args:
            case [facts.Argument(value=value, keyword=None, star=""), *others] if loggers.refusal(call) is None:
                if any(argument.star for argument in others):
                    continue
            case _:
                continue
        own = of_self(value)
        held = attributes.get(own, ()) if own is not None else variables.get(value.variable, ()) or [value]
        row = partial(_Row, call.span, call.func.attribute, instead=f"str({value.dotted or '…'})", cls=number)
        of_rclpy = objects_of(code).scope(function).kind(value)
        if of_rclpy is not None:
            yield row(kind=str(of_rclpy), of_node=of_rclpy in _OF_NODES)
        elif makes_message(value, messages) or value.variable in own_messages:
            yield row(kind="a message")
        elif (of_parameter := kind_with_parameters(code, cls, held)) is not None:
            yield row(kind=_words(of_parameter), attribute=own or "", of_node=True)
        elif own is not None and (kind := kind_of_all(held, {})) not in (None, Kind.NONE):
            yield row(kind=_words(kind), attribute=own)
        elif own is None and (kind := kind_of(value, variables)) not in (None, Kind.NONE):
            yield row(kind=_words(kind))


def _words(kind: Kind | None) -> str:
    return str(Kind.NUMBER if kind is Kind.NUMERIC else kind)


__all__ = ["logged_values"]
