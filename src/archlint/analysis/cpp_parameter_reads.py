"""By which method C++ takes the value of a parameter: ``get_parameter("speed").as_double()``.

Source: ``rclcpp::Parameter``, whose methods throw a ``ParameterTypeException`` where the parameter has another type;
``get_value<double>()`` does not convert an integer, either.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.ros.parameter_types import ParameterType
    from archlint.systems.model import System

_METHODS: dict[str, ParameterType] = {
    "as_bool": "bool",
    "as_int": "integer",
    "as_double": "double",
    "as_string": "string",
    "as_byte_array": "byte_array",
    "as_bool_array": "bool_array",
    "as_integer_array": "integer_array",
    "as_double_array": "double_array",
    "as_string_array": "string_array",
}
_BY_TYPE = {kind: f"{method}()" for method, kind in _METHODS.items()}
_INTEGERS = r"(?:unsigned )?(?:int|long|long int|short)|(?:std::)?u?int(?:8|16|32|64)_t|(?:std::)?size_t"
_TYPES: tuple[tuple[str, ParameterType], ...] = (
    ("bool", "bool"),
    (_INTEGERS, "integer"),
    ("double|float|(?:std::)?(?:double|float)_t", "double"),
    ("std::string", "string"),
    ("std::vector<(?:int64_t|int|long)>", "integer_array"),
    ("std::vector<double>", "double_array"),
    ("std::vector<std::string>", "string_array"),
    ("std::vector<bool>", "bool_array"),
)
_METHOD = re.compile(r"\s*\.\s*((as_\w+)|get_value\s*<\s*([\w:<> ]+?)\s*>)\s*\(\s*\)")
_VARIABLE = re.compile(r"\b(?:auto|rclcpp::Parameter)\s*&{0,2}\s*(\w+)\s*=\s*(?:(?:this|\w+)\s*->\s*)?\Z")
"""What stands in front of a call whose result a new variable gets."""


@dataclass(frozen=True)
class WrongAccessor:
    """A method that throws for the type of the parameter: what is ``called``, and what is ``right``."""

    place: Place
    called: str
    right: str


def wrong_accessors(system: System, read: Place, kind: ParameterType) -> Iterator[WrongAccessor]:
    """The methods that take the value of the parameter that a call gives, at once or from the one variable of a name,
    and that are for another type."""
    text = None if system.workspace is None else system.workspace.tree.text(read.file)
    if text is None:
        return
    begin, end = _offset(text, read.line, read.column), _offset(text, read.end_line, read.end_column)
    rows = [_METHOD.match(text, end)]
    variable = _VARIABLE.search(text, max(0, begin - _NEAR), begin)
    is_asked = variable is not None and re.search(rf"\b{variable[1]}\s*\.\s*get_type\b", text) is not None
    if variable is not None and not is_asked and len(re.findall(rf"[\w>&]\s+&{{0,2}}{variable[1]}\b", text)) == 1:
        uses = re.finditer(rf"(?<![\w.>]){variable[1]}(?=\s*\.)", text)
        rows += [_METHOD.match(text, use.end()) for use in uses]
    wrong = [row for row in rows if row is not None and _asked_for(row) not in (None, kind)]
    if wrong and not _is_chosen_by_type(text, begin):
        for row in wrong:
            span = *_position(text, row.start(1)), *_position(text, row.end())
            yield WrongAccessor(Place(read.file, *span), f"{row[1]}()", _BY_TYPE[kind])


def keeps_variable(system: System, read: Place) -> bool:
    """Whether a call is a ``get_parameter(name, variable)``, which throws nothing: it returns false and leaves the
    variable as it is where nothing declares the parameter."""
    text = None if system.workspace is None or read.file.endswith(".py") else system.workspace.tree.text(read.file)
    if text is None:
        return False
    written = text[_offset(text, read.line, read.column) : _offset(text, read.end_line, read.end_column)]
    _, _, given = _TEXT.sub("", written).partition("get_parameter")
    return _TWO_ARGUMENTS.fullmatch(given) is not None


_TEXT = re.compile(r'"(?:[^"\\\n]|\\.)*"')
_TWO_ARGUMENTS = re.compile(r"\s*(?:<[^()]*>)?\s*\([^,]*,[^,]*\)", re.DOTALL)


def _is_chosen_by_type(text: str, at: int) -> bool:
    """Whether an ``if`` around a read asks for a type: of ``if constexpr (std::is_same_v<T, int>)`` only the branch for
    the ``T`` of the object is compiled, and which that is the call does not say."""
    return any(_OF_TYPE.search(head) is not None for head in _heads(text, at))


def _heads(text: str, at: int) -> Iterator[str]:
    """How the statement at an offset begins, and what stands in front of each block around it; of an ``else`` also the
    branches before it."""
    depth, end, wanted, is_else = 0, at, True, False
    for index in range(at - 1, max(-1, at - _FAR), -1):
        mark = text[index]
        if mark not in "{};" or (mark == ";" and depth):
            continue
        if not depth and wanted:
            head = text[index + 1 : end]
            yield head
            is_else = head.lstrip().startswith("else")
        if mark == "}":
            wanted = wanted and bool(depth)
            depth += 1
        elif mark == ";":
            wanted, end = wanted and is_else, index
        elif depth:
            depth -= 1
            if not depth:
                wanted, is_else, end = is_else, False, index
        else:
            wanted, is_else, end = True, False, index


_FAR = 10_000
"""How many characters in front of a call may belong to the blocks around it."""
_OF_TYPE = re.compile(r"\bif\s+constexpr\b|\b(?:if|switch)\s*\([^{;]*\b(?:get_type|get_type_name|is_same|typeid)\b")
_NEAR = 200
"""How many characters in front of a call are looked at."""


def _asked_for(called: re.Match[str]) -> ParameterType | None:
    if called[2]:
        return _METHODS.get(called[2])
    return next((kind for pattern, kind in _TYPES if re.fullmatch(pattern, called[3])), None)


def _offset(text: str, line: int, column: int) -> int:
    start = 0
    for _ in range(line - 1):
        start = text.index("\n", start) + 1
    return start + column - 1


def _position(text: str, offset: int) -> tuple[int, int]:
    return text.count("\n", 0, offset) + 1, offset - (text.rfind("\n", 0, offset) + 1) + 1


__all__ = ["WrongAccessor", "keeps_variable", "wrong_accessors"]
