"""What code does with the fields of messages that Python refuses for what they hold, or that always has one result.

Source: rosidl_generator_py makes an ``int``, ``float``, ``bool`` or ``str`` of a primitive field, an ``array.array`` of
an array of numbers without a fixed size (of a fixed one an array of numpy, which is left out here), and an object
without operators of a message.
"""

from __future__ import annotations

import array
from collections.abc import Iterator
from typing import TYPE_CHECKING, Literal

from archlint.analysis.kept import kept_for_each_file, once
from archlint.place import Place
from archlint.python_code.class_chains import targets_of
from archlint.python_code.tried_code import OF_A_WRONG_KIND, tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.interface_values import INTEGER_RANGES
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

if TYPE_CHECKING:
    from archlint.model import FieldUse
    from archlint.syntax.interfaces import FieldType
    from archlint.systems.model import System

_Kind = Literal["int", "float", "bool", "string", "array", "message"]
Deed = Literal[
    "adds", "compares", "orders", "calculates", "takes out of", "goes through", "unpacks", "looks into", "runs", "calls"
]
"""``runs`` is ``msg.data()``, ``calls`` is ``len(msg.data)``."""
_Other = Literal["string", "number", "list", ""]
_Spot = tuple[str, int, int, int, int]
"""A file, and the span in it."""
_Row = tuple[Deed, _Other, str, facts.Span, facts.Span]
"""What is done, with what beside the field, by which operator or function; the spans of the field and of it all."""
_DeedTo = tuple[Deed, _Other, str, facts.Expr, facts.Span]
"""The same with the expression that it is done to."""
_ORDER = frozenset({"<", "<=", ">", ">="})
_EQUAL = frozenset({"==", "!=", "in", "not in"})
_ARITHMETIC = frozenset({"+", "-", "/", "//", "**", "*"})
_TIMES = frozenset({"builtin_interfaces/msg/Time", "builtin_interfaces/msg/Duration"})
"""What API001 judges, with the times of rclpy."""
_NUMBERS: frozenset[_Kind] = frozenset({"int", "float", "bool"})
_LOOPS = frozenset({"enumerate", "list", "max", "min", "set", "sorted", "sum", "tuple"})
_FUNCTIONS = frozenset({"len", "range", "abs", "round", "float", "int"}) | _LOOPS
_TYPES: dict[_Kind, tuple[type, ...]] = {
    "int": (int,),
    "float": (float,),
    "bool": (bool,),
    "string": (str,),
    "array": (array.array,),
}
_HAVE = {kind: frozenset(name for type_ in types for name in dir(type_)) for kind, types in _TYPES.items()}
LEVELS = frozenset({"error", "fatal", "info", "warn", "warning"})
"""Of a logger of ROS, which takes a text; not ``debug``, at which nobody looks by default."""
_OF_OBJECTS = frozenset({"unpacks", "looks into", "runs"})


@dataclass(frozen=True)
class FieldOperation:
    """``'speed: ' + msg.data``; one that ``fails`` raises an error, the others have one result, whatever comes."""

    place: Place
    use: FieldUse
    kind: _Kind
    type_name: str
    """Of a message, or of the items of an array."""
    deed: Deed
    other: _Other
    by: str
    """The operator or the function."""
    attribute: str = ""
    """The attribute of ``self`` that holds the field, where it is not read right there."""

    @property
    def fails(self) -> bool:
        return self.deed != "compares"


def field_operations(system: System) -> Iterator[FieldOperation]:
    """Each such piece of code, where only messages with such a field come to it."""
    workspace = system.workspace
    if workspace is None:
        return
    uses = fields_read(system)
    for file in sorted({file for file, *_ in uses}):
        for deed, other, by, field, whole in _rows(workspace, file) or ():
            use, kind = uses.get((file, *field), (None, None))
            held = None if kind is None else held_in(kind)
            if use is not None and kind is not None and held is not None and goes_wrong(held, deed, other, by):
                yield FieldOperation(Place(file, *whole), use, held, kind.name, deed, other, by)


@once
def fields_read(system: System) -> dict[_Spot, tuple[FieldUse, FieldType]]:
    """What reads fields, by its place, where it is of one type whoever comes there."""
    table = None if system.workspace is None else system.workspace.interfaces
    uses: dict[_Spot, tuple[FieldUse, FieldType] | None] = {}
    for use in (use for program in system.programs for use in program.field_uses):
        kind = None if table is None else table.field_type(use.type, use.section_name, use.name)
        place = use.place
        key = (place.file, place.line, place.column, place.end_line, place.end_column)
        judged = use.access == "read" and use.exists and not system.roles.is_test(place.file)
        row = (use, kind) if judged and kind is not None else None
        before = uses.get(key, row)
        uses[key] = row if row is not None and before is not None and before[1] == row[1] else None
    return {key: row for key, row in uses.items() if row is not None}


def held_in(kind: FieldType) -> _Kind | None:
    """What Python finds in a field; None where that depends, or is not judged here."""
    numeric = kind.name in ("float32", "float64", *INTEGER_RANGES) and kind.name not in ("byte", "char")
    if kind.array:
        return "array" if numeric and kind.array != "fixed" and kind.name != "uint8" else None
    if not kind.is_primitive:
        return None if kind.name in _TIMES else "message"
    if numeric:
        return "float" if kind.name.startswith("float") else "int"
    return "bool" if kind.name == "bool" else "string" if kind.name in ("string", "wstring") else None


def goes_wrong(held: _Kind, deed: Deed, other: _Other, by: str) -> bool:
    """Whether Python refuses to do that with what is held, or always has one result."""
    match deed:
        case "adds":
            return held != "string" if other == "string" else other == "list" or held not in _NUMBERS
        case "calculates":
            return held == "message" if by == "*" else held not in _NUMBERS
        case "compares" | "orders":
            if held == "array":
                return (other == "list") == (deed == "compares")
            if held == "message":
                return deed == "orders" or other in ("string", "number")
            return other == "list" or (other == "number") == (held == "string")
        case "takes out of" | "goes through" | "unpacks":
            return held in _NUMBERS or held == "message"
        case "looks into":  # MSG001 asks which fields a message has
            return held != "message" and by not in _HAVE[held]
        case "runs":
            return True
    if by == "len" or by in _LOOPS:
        return held in _NUMBERS or held == "message"
    if by.startswith("math.") or by in ("abs", "round"):
        return held in ("string", "message", "array")
    if by == "json.loads" or by in LEVELS:
        return held != "string"
    return held not in ("int", "bool") if by == "range" else held in ("message", "array")


# ---------------------------------------------------------------------------------------- what code does with fields


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    """What a file does with attributes that may be fields."""
    rows: list[_Row] = []
    given = {target.dotted for target in targets_of(code.body)}
    for function in everything_in(code.body, facts.Function):
        asked = _asked_for_their_class(function)
        for deed, other, by, field, whole in deeds_in(function):
            attribute = _attribute_behind(function, field)
            if deed in _OF_OBJECTS and attribute is not None and attribute.dotted in given:
                continue  # what another function makes of the field may stand it
            if attribute is not None and attribute.dotted not in asked:
                rows.append((deed, other, by, attribute.span, whole))
    return rows


def deeds_in(function: facts.Function) -> Iterator[_DeedTo]:
    """What a function does with what may be a field or a message, but for what it asks for its class, and where it
    expects that to fail.  A comparison does not fail."""
    asked = _asked_for_their_class(function)
    expecting = tried_for(function.body, OF_A_WRONG_KIND)
    for part in parts_of(function.body):
        for row in _deeds_of(part):
            deed, _, _, value, _ = row
            if value.dotted not in asked and (deed == "compares" or Itself(part) not in expecting):
                yield row


def _deeds_of(part: facts.Base) -> Iterator[_DeedTo]:
    """What a part does with a field or a message, if it is one: with what beside it, by what, and the spans."""
    match part:
        case facts.Binary(op="+", left=left, right=right, span=span):
            for field, other in ((left, right), (right, left)):
                if is_text(other):
                    yield "adds", "string", "+", field, span
                elif _is_number(other):
                    yield "adds", "number", "+", field, span
                elif _is_list(other):
                    yield "adds", "list", "+", field, span
        case facts.Binary(op=op, left=left, right=right, span=span) if op in _ARITHMETIC:
            for field, other in ((left, right), (right, left)):
                if _is_number(other):
                    yield "calculates", "number", op, field, span
        case facts.Compare(left=left, ops=[operator], comparators=[right], span=span) if operator in _ORDER | _EQUAL:
            deed: Deed = "orders" if operator in _ORDER else "compares"
            pairs = ((left, right),) if operator in ("in", "not in") else ((left, right), (right, left))
            for field, other in pairs:
                if (what := _compared_with(other, operator)) is not None:
                    yield deed, what, operator, field, span
        case facts.Subscript(value=facts.Attribute() | facts.Name() as field, span=span):
            yield "takes out of", "", "[]", field, span
        case facts.For(iterable=facts.Attribute() | facts.Name() as field, is_async=False):
            yield "goes through", "", "for", field, field.span
        case facts.Generator(iterable=facts.Attribute() | facts.Name() as field):
            yield "goes through", "", "for", field, field.span
        case facts.Assign(targets=[facts.Sequence()], value=facts.Attribute() | facts.Name() as field, span=span):
            yield "unpacks", "", "=", field, span
        case facts.Attribute(value=facts.Attribute() | facts.Name() as field, attr=name, span=span):
            yield "looks into", "", name, field, span
        case facts.Call(func=function, args=given, span=span):
            if isinstance(function, (facts.Attribute, facts.Name)):
                yield "runs", "", "()", function, span
            match given:
                case [facts.Argument(value=field, keyword=None, star="")] if by := _function_of_values(function):
                    yield "calls", "", by, field, span


def _function_of_values(function: facts.Expr) -> str:
    """The name of a function, if it is one that takes no message; empty for any other."""
    match function:
        case facts.Attribute(attr=level, value=facts.Call(func=logger)) if level in LEVELS:
            return level if logger.dotted.endswith(".get_logger") else ""
    name = function.dotted
    return name if name in _FUNCTIONS or name == "json.loads" or name.startswith("math.") else ""


def is_text(part: facts.Base) -> bool:
    """Whether an expression is a text for certain, if it can be evaluated."""
    match part:
        case facts.Literal(value=str()) | facts.FormatString():
            return True
        case facts.Binary(op="+", left=left, right=right):
            return is_text(left) or is_text(right)
        case facts.Binary(op="%", left=left):
            return is_text(left)
        case facts.Call(func=facts.Name(id="str")):
            return True
    return False


def _is_number(part: facts.Base) -> bool:
    match part:
        case facts.Literal(value=int() | float() as value):
            return not isinstance(value, bool)
        case facts.Unary(op="-" | "+", operand=operand):
            return _is_number(operand)
    return False


def _is_list(part: facts.Base) -> bool:
    match part:
        case facts.Sequence(kind="list") | facts.Comprehension(kind="list"):
            return True
        case facts.Call(func=facts.Name(id="list")):
            return True
    return False


def _compared_with(part: facts.Base, operator: str) -> _Other | None:
    """What is on the other side of a comparison, or in the list there."""
    match part:
        case facts.Sequence(kind="list" | "tuple" | "set", elements=elements):
            if operator not in ("in", "not in"):
                return "list" if part.kind == "list" else None
            kinds = {_compared_with(element, "==") for element in elements}
            return kinds.pop() if len(kinds) == 1 else None
        case _ if operator in ("in", "not in"):
            return None
        case facts.Literal(value=str()):
            return "string"
        case _ if _is_number(part):
            return "number"
    return None


def _attribute_behind(function: facts.Function, field: facts.Expr) -> facts.Attribute | None:
    """The attribute that an expression is, or that the one assignment to a variable gives it."""
    match field:
        case facts.Attribute():
            return None if field.dotted and field.dotted in _assigned(function) else field
        case facts.Name(id=name):
            return _read_into(function).get(name)
    return None


@once_for
def _assigned(function: facts.Function) -> frozenset[str]:
    """The attributes that a function sets: they may hold anything then."""
    statements = everything_in(function.body, facts.Statement)
    return frozenset(target.dotted for statement in statements for target in statement.assigned if target.dotted)


@once_for
def _read_into(function: facts.Function) -> dict[str, facts.Attribute]:
    """The variables of a function that get an attribute and nothing else."""
    bound = list(names_bound(function))
    attributes: dict[str, facts.Attribute] = {}
    for statement in parts_of(function.body, facts.Assign):
        match statement:
            case facts.Assign(targets=[facts.Name(id=name)], value=facts.Attribute() as value):
                if bound.count(name) == 1 and value.dotted not in _assigned(function):
                    attributes[name] = value
    return attributes


@once_for
def _asked_for_their_class(function: facts.Function) -> frozenset[str]:
    """What a function asks for its class: ``isinstance(msg.data, str)``, ``type(msg.data)``, ``hasattr(…)``."""
    return frozenset(
        call.args[0].value.dotted
        for call in everything_in(function.body, facts.Call)
        if call.func.variable in ("isinstance", "type", "hasattr") and call.args
    )


__all__ = [
    "LEVELS",
    "FieldOperation",
    "deeds_in",
    "field_operations",
    "fields_read",
    "goes_wrong",
    "held_in",
    "is_text",
]
