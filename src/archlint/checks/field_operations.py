"""What MSG003 says of code that takes what a field of a message holds for something else."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.python_code.field_operations import FieldOperation, field_operations

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import System

_IS = {"int": "an int", "float": "a float", "bool": "a bool", "string": "a string"}
_OTHERS = {"string": "a string", "number": "a number", "list": "a list"}


def operations_on_fields(system: System) -> Iterator[Finding]:
    """The findings about such code."""
    yield from map(_finding, field_operations(system))


def _finding(row: FieldOperation) -> Finding:
    use = row.use
    of = f"{use.type}.{use.section_name}" if use.section_name else use.type
    return finding(
        "MSG003",
        row.place,
        f"'{use.name}' of {of} is {_what(row)}, {_outcome(row)}",
        help=_cure(row),
        node=None if use.node is None else use.node.name.text,
        identity=(use.type, use.section_name, use.name, row.deed, row.by),
        group=(row.place.file, of, use.name, row.deed, row.other, row.by),
    )


def _what(row: FieldOperation) -> str:
    if row.kind == "array":
        return f"an array of {row.type_name}"
    return _IS.get(row.kind) or f"a {row.type_name}"


def _outcome(row: FieldOperation) -> str:
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
    return f"and {row.by}() of it raises TypeError"


def _cure(row: FieldOperation) -> str:
    match row.kind, row.deed:
        case "message", _:
            return "use one of its fields"
        case "array", "compares" | "adds" if row.other != "number":
            return "convert it first: list(…)"
        case "array", _:
            return "use one of its items, or the min() or max() of them"
        case _, "adds" if row.other == "string":
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
