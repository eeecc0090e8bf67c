"""``.msg``, ``.srv`` and ``.action`` files as data.

The grammar is that of ``rosidl_adapter``, the package that reads these files when a workspace is built: one
line a field or a constant, ``#`` starts a comment wherever it stands, ``---`` alone on a line parts the
sections.  What it refuses becomes a problem at that line; the lines that are in order are kept.
"""

from __future__ import annotations

import re
from dataclasses import field
from typing import Final, Literal

import msgspec

from archlint.records import dataclass
from archlint.syntax.facts import Base, FileProblem
from archlint.syntax.interface_values import (
    PRIMITIVE_TYPES,
    ArrayKind,
    InvalidValue,
    Value,
    parse_primitive,
    parse_value,
)
from archlint.syntax.parts import once_for
from archlint.syntax.python import gate

InterfaceKind = Literal["msg", "srv", "action"]
"""What an interface file defines, as the suffix of the file says."""
INTERFACE_KINDS: Final[tuple[InterfaceKind, ...]] = ("msg", "srv", "action")
KIND_OF_SUFFIX: Final[dict[str, InterfaceKind]] = {kind: kind for kind in INTERFACE_KINDS}
SectionName = Literal["message", "request", "response", "goal", "result", "feedback"]
WrapperName = Literal["feedback message", "result response"]
"""What rclpy wraps sections of an action in."""

SECTIONS: Final[dict[InterfaceKind, tuple[SectionName, ...]]] = {
    "msg": ("message",),
    "srv": ("request", "response"),
    "action": ("goal", "result", "feedback"),
}
"""The sections of each kind of interface, in the order in which a file has them."""

_SEPARATOR = "---"
_PACKAGE_NAME = re.compile(r"(?!.*__)(?!.*_\Z)[a-z][a-z0-9_]*\Z")
_FIELD_NAME = _PACKAGE_NAME
_MESSAGE_NAME = re.compile(r"[A-Z][A-Za-z0-9]*\Z")
_AROUND_NAME = re.compile(r"^Sample_|(?:_(?:Request|Response|Goal|Result|Feedback))+$")
"""What ``is_valid_message_name`` of rosidl_adapter takes off before it looks at a name."""
_CONSTANT_NAME = re.compile(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*\Z")
_BOUNDED_STRING = re.compile(r"(w?string)<=([0-9]{1,18})\Z")
_ARRAY = re.compile(r"(.+?)\[(?:(<=)?([0-9]{1,18}))?\]\Z")


class FieldType(Base, frozen=True):
    """The type of a field.

    ``name`` is a primitive type (``float64``), a full name (``geometry_msgs/msg/Point``), or a bare message
    name (``Point``), which is of the package that the file belongs to.  ``array`` is empty, ``fixed``,
    ``bounded`` or ``unbounded``; ``size`` the number of elements, or the most of them, where there is one;
    ``string_bound`` the most characters of a bounded string.
    """

    name: str
    array: ArrayKind = ""
    size: int | None = None
    string_bound: int | None = None

    @property
    def is_primitive(self) -> bool:
        return self.name in PRIMITIVE_TYPES

    def qualified(self, package: str) -> str:
        """``name`` in full, for a file of ``package``."""
        return self.name if self.is_primitive or "/" in self.name else f"{package}/msg/{self.name}"


class InterfaceField(Base, frozen=True):
    name: str
    type: FieldType
    line: int
    default: Value | list[Value] | None = None


class InterfaceConstant(Base, frozen=True):
    name: str
    type: str
    value: Value
    line: int


class Section(Base, frozen=True):
    """One of the messages of an interface; ``name`` is one of :data:`SECTIONS`, or what rclpy wraps one in."""

    name: SectionName | WrapperName
    fields: list[InterfaceField] = msgspec.field(default_factory=list)
    constants: list[InterfaceConstant] = msgspec.field(default_factory=list)

    def field(self, name: str) -> InterfaceField | None:
        """The field of that name, or None."""
        return _by_name(self).get(name)


@once_for
def _by_name(section: Section) -> dict[str, InterfaceField]:
    """The fields of a message; the first of each name."""
    return {field.name: field for field in reversed(section.fields)}


class Interface(Base, frozen=True):
    """An interface file.  ``kind`` is ``msg``, ``srv`` or ``action``; all its sections are always there."""

    kind: InterfaceKind
    sections: list[Section]
    problems: list[FileProblem] = msgspec.field(default_factory=list)

    def section(self, name: str) -> Section:
        """``message``; ``request`` or ``response``; ``goal``, ``result`` or ``feedback``."""
        return next(section for section in self.sections if section.name == name)


def parse_interface(text: str, kind: InterfaceKind) -> Interface:
    """Read an interface file.  Never raises for what is in the text."""
    names = SECTIONS[kind]
    sections = [_Filled(Section(name)) for name in names]
    problems: list[FileProblem] = []
    index = 0
    for number, line in enumerate(text.replace("\t", " ").splitlines(), start=1):
        if line == _SEPARATOR and index + 1 < len(names):
            index += 1
            continue
        try:
            _read_line(line, number, sections[index])
        except InvalidDefinition as error:
            column = len(line) - len(line.lstrip()) + 1
            problems.append(FileProblem(number, column, str(error)))
    if index + 1 < len(names):
        count, needed = index, len(names) - 1
        problems.append(FileProblem(1, 1, f"expected {needed} '---' in a .{kind} file, found {count}"))
    return Interface(kind, [filled.section for filled in sections], problems)


def interface_problems(path: str, given: bytes | None = None) -> list[tuple[int, int, str]]:
    """Line, column and words of all that ``rosidl`` would refuse in an interface file, whose bytes may be ``given``."""
    data = gate.read_bytes(path) if given is None else given
    if isinstance(data, gate.Refusal):
        return [(data.line, data.column, data.message)]
    kind = KIND_OF_SUFFIX[path.rpartition(".")[2]]
    interface = parse_interface(data.decode("utf-8", "replace"), kind)
    name = path.replace("\\", "/").rpartition("/")[2].rpartition(".")[0]
    if not _MESSAGE_NAME.match(_AROUND_NAME.sub("", name)):
        words = f"{name!r} is not a valid name for an interface: a capital letter first, then letters and digits"
        return [(1, 1, words)]
    return [(problem.line, problem.column, problem.message) for problem in interface.problems]


class InvalidDefinition(Exception):
    """What ``rosidl`` would refuse, in words."""


@dataclass
class _Filled:
    """A section that is being read, and the names that it has so far."""

    section: Section
    names: set[str] = field(default_factory=set)


def _read_line(line: str, number: int, filled: _Filled) -> None:
    definition = line.partition("#")[0].rstrip()
    if definition.startswith("@optional"):
        definition = definition.removeprefix("@optional").lstrip()
    if not definition.strip():
        return
    if line == _SEPARATOR:
        raise InvalidDefinition("one '---' too many")
    if definition.strip() == _SEPARATOR:
        raise InvalidDefinition("a '---' must be alone on its line, without any white space")
    type_name, _, rest = definition.lstrip().partition(" ")
    rest = rest.lstrip()
    if not rest:
        raise InvalidDefinition(f"expected a type and a name, found only {type_name!r}")
    if "=" in rest:
        name, _, value = rest.partition("=")
        _add_constant(filled, type_name, name.rstrip(), value.lstrip(), number)
    else:
        name, _, default = rest.partition(" ")
        _add_field(filled, parse_type(type_name), name, default.lstrip(), number)


def _add_constant(filled: _Filled, type_name: str, name: str, value: str, number: int) -> None:
    if type_name not in PRIMITIVE_TYPES:
        raise InvalidDefinition(f"a constant must have a primitive type, not {type_name!r}")
    if not _CONSTANT_NAME.match(name):
        raise InvalidDefinition(f"{name!r} is not a valid constant name: upper case, digits and single '_'")
    if name in filled.names:
        raise InvalidDefinition(f"constant {name!r} is defined twice")
    try:
        known = parse_primitive(type_name, value)
    except InvalidValue as error:
        raise InvalidDefinition(str(error)) from None
    filled.names.add(name)
    filled.section.constants.append(InterfaceConstant(name, type_name, known, number))


def _add_field(filled: _Filled, kind: FieldType, name: str, default: str, number: int) -> None:
    if not _FIELD_NAME.match(name):
        raise InvalidDefinition(f"{name!r} is not a valid field name: lower case, digits and single '_'")
    if name in filled.names:
        raise InvalidDefinition(f"field {name!r} is defined twice")
    value: Value | list[Value] | None = None
    if default:
        if not kind.is_primitive:
            raise InvalidDefinition(f"a field of type {kind.name!r} cannot have a default")
        try:
            value = parse_value(kind.name, default, kind.array, kind.size, kind.string_bound)
        except InvalidValue as error:
            raise InvalidDefinition(str(error)) from None
    filled.names.add(name)
    filled.section.fields.append(InterfaceField(name, kind, number, value))


def parse_type(text: str) -> FieldType:
    """The type of a field as it is written.  Raises :class:`InvalidDefinition`."""
    array: ArrayKind = ""
    size, element = None, text
    match = _ARRAY.match(text)
    if match is not None:
        element = match[1]
        size = None if match[3] is None else int(match[3])
        array = "unbounded" if size is None else "bounded" if match[2] else "fixed"
        if size == 0:
            raise InvalidDefinition(f"the size of {text!r} must be greater than 0")
    if element in PRIMITIVE_TYPES:
        return FieldType(element, array, size)
    bounded = _BOUNDED_STRING.match(element)
    if bounded is not None:
        if int(bounded[2]) == 0:
            raise InvalidDefinition(f"the bound of {element!r} must be greater than 0")
        return FieldType(bounded[1], array, size, int(bounded[2]))
    return FieldType(_message_name(element), array, size)


def _message_name(text: str) -> str:
    package, slash, name = text.rpartition("/")
    if not _MESSAGE_NAME.match(name) or (slash and not _PACKAGE_NAME.match(package)):
        raise InvalidDefinition(f"{text!r} is not a type: expected a primitive, a Name or a package/Name")
    return f"{package}/msg/{name}" if slash else name
