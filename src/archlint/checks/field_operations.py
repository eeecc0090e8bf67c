"""What MSG003 says of code that takes a message, or what a field of it holds, for something else."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Related
from archlint.python_code.field_operations import LEVELS, FieldOperation, field_operations
from archlint.python_code.given_fields import GivenField, given_fields
from archlint.python_code.kept_fields import kept_field_operations
from archlint.python_code.kept_messages import kept_message_operations
from archlint.python_code.made_message_operations import MadeMessageOperation, made_message_operations
from archlint.python_code.message_operations import MessageOperation, message_operations

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import System

_IS = {"int": "an int", "float": "a float", "bool": "a bool", "string": "a string"}
_OTHERS = {"string": "a string", "number": "a number", "list": "a list", "message": "another message"}


def operations_on_fields(system: System) -> Iterator[Finding]:
    """The findings about such code."""
    yield from map(_finding, (*field_operations(system), *kept_field_operations(system)))
    for given in given_fields(system):
        yield from unless_uncalled(system, _of_given(given))
    yield from map(_of_message, (*message_operations(system), *kept_message_operations(system)))
    for row in () if system.workspace is None else made_message_operations(system.workspace):
        yield from unless_uncalled(system, _of_made(row))


def _of_made(row: MadeMessageOperation) -> Finding:
    return finding(
        "MSG003",
        row.place,
        f"'{row.name}' is a message of type {row.type}, {_outcome(row)}",
        help="use one of its fields",
        identity=(row.name, row.deed, row.by),
        group=(row.place.file, row.name, row.type),
    )


def _finding(row: FieldOperation) -> Finding:
    use = row.use
    of = f"{use.type}.{use.section_name}" if use.section_name else use.type
    field = f"'{use.name}' of {of}"
    field = f"'{row.attribute}' is {field}," if row.attribute else f"{field} is"
    return finding(
        "MSG003",
        row.place,
        f"{field} {_what(row)}, {_outcome(row)}",
        help=_cure(row),
        node=None if use.node is None else use.node.name.text,
        related=[Related(use.place, f"'{row.attribute}' gets it here")] if row.attribute else [],
        identity=(use.type, use.section_name, use.name, row.deed, row.by),
        group=(row.place.file, of, use.name, row.deed, row.other, row.by, row.attribute),
    )


def _of_given(row: GivenField) -> Finding:
    use, name = row.operation.use, row.name.rpartition(".")[2]
    of = f"{use.type}.{use.section_name}" if use.section_name else use.type
    return finding(
        "MSG003",
        row.operation.place,
        f"'{use.name}' of {of} is {_what(row.operation)}, which {name}() takes apart: that raises TypeError",
        help=f"give {name}() a list of the fields of the message, or let it use them by their names",
        node=None if use.node is None else use.node.name.text,
        related=[Related(row.done, f"{name}() takes '{row.parameter}' apart here")],
        identity=(use.type, use.section_name, use.name, row.name),
        group=(row.operation.place.file, of, use.name, row.name),
    )


def _of_message(row: MessageOperation) -> Finding:
    of = f"{row.type}.{row.section_name}" if row.section_name else row.type
    creation, node = row.callback.creation, row.callback.node
    since = f" once {row.callback.name} has run" if row.kept else ""
    return finding(
        "MSG003",
        row.place,
        f"'{row.name}' is a message of type {of}{since}, {_outcome(row)}",
        help="keep the field that is meant, or use one of its fields" if row.kept else "use one of its fields",
        related=[] if creation is None else [Related(creation.place, f"{row.callback.name} gets it from here")],
        node=None if node is None else node.name.text,
        identity=(row.callback.name, row.name, row.deed, row.by),
        group=(row.place.file, row.callback.name, row.name, of),
    )


def _what(row: FieldOperation) -> str:
    if row.kind == "array":
        return f"an array of {row.type_name}"
    return _IS.get(row.kind) or f"a {row.type_name}"


def _outcome(row: FieldOperation | MessageOperation | MadeMessageOperation) -> str:
    other = _OTHERS.get(row.other, "")
    match row.deed:
        case "adds":
            return f"and '+' with {other} raises TypeError"
        case "calculates" | "orders":
            return f"and '{row.by}' with {other} raises TypeError"
        case "compares":
            always = row.by in ("!=", "not in")
            return f"which never equals {other}: this is always {always}"
        case "takes out of":
            return "and taking an item of it raises TypeError"
        case "goes through":
            return "and a loop over it raises TypeError"
        case "unpacks":
            return "and unpacking it into several variables raises TypeError"
        case "looks into":
            return f"and has no '{row.by}': this line raises AttributeError"
        case "runs":
            return "and calling it raises TypeError"
    return f"and {row.by}() of it raises TypeError"


_OF_LISTS = frozenset({"clear", "copy", "sort"})
"""What a list has and an ``array.array`` has not."""


def _cure(row: FieldOperation) -> str:
    match row.kind, row.deed:
        case "message", _:
            return "use one of its fields"
        case "array", "compares" | "adds" if row.other != "number":
            return "convert it first: list(…)"
        case "array", "looks into" if row.by in _OF_LISTS:
            return "convert it first: list(…)"
        case "array", "looks into":
            return "use its items, or make an array of numpy of it first"
        case "array", _:
            return "use one of its items, or the min() or max() of them"
        case _, "looks into" | "runs" | "unpacks":
            return "use it as it is"
        case _, "adds" | "calls" if row.other == "string" or row.by in LEVELS:
            return "convert it: str(…), or write an f-string"
        case _, "takes out of" | "goes through":
            return "use it as it is, or send a message whose field is an array"
        case "string", "compares":
            return "compare it with a string, or convert it: int(…)"
        case "bool", "compares" | "orders":
            return "a bool is True or False: use it as it is"
        case _, "compares" | "orders" if row.other == "string":
            return "compare it with a number"
        case _ if row.by == "range":
            return "convert it: int(…)"
    return "convert it: float(…) or int(…)" if row.kind == "string" else "use it as it is"


__all__ = ["operations_on_fields"]
