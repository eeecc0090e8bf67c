"""Which values a field of a message does not take, and what becomes of them.

Humble's messages check what they are given with ``assert``. Those of the later distributions do not, unless the
environment asks them to: a wrong value is found out when the message is converted to be sent, or never. What is no
float is then read as if it were one, which gives another number.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    BoundMethod,
    ClassValue,
    DictValue,
    EachValue,
    External,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
)
from archlint.libraries.rclpy import clocks
from archlint.libraries.values import EntityValue, FutureValue, MessageValue, NodeValue
from archlint.model import ValueEffect
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.interface_values import INTEGER_RANGES
from archlint.syntax.interfaces import FieldType
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.libraries.run import Run

_FLOATS = frozenset({"float32", "float64"})
_TEXTS = frozenset({"string", "wstring"})
_INTEGERS = frozenset(INTEGER_RANGES) - {"byte", "char"}
_SHOWN = 40
"""How much of a string a message shows."""


class _What(StringEnum):
    """The kinds of values that fields tell apart."""

    BOOL = "bool"
    INT = "int"
    FLOAT = "float"
    TEXT = "str"
    BYTES = "bytes"
    LIST = "list"
    DICT = "dict"
    NUMPY = "number of numpy"
    MESSAGE = "message"
    OBJECT = "object"


_NUMBERS = frozenset({_What.BOOL, _What.INT, _What.FLOAT})


@dataclass(frozen=True, slots=True)
class _Shape:
    """What is known of a value: its kind, and how a message calls it."""

    what: _What
    words: str
    cure: str = ""
    """What makes it something that a field takes, where that is plain."""


@dataclass(frozen=True, slots=True)
class Misfit:
    """What a field takes, what it is given, what comes of it, and what to write."""

    wanted: str
    given: str
    effect: ValueEffect
    cure: str
    of_items: bool = False
    """Whether it is about what is in a list."""
    checked: bool = True
    """Whether humble's messages raise AssertionError."""


def misfit_of_argument(run: Run, kind: FieldType, value: Value) -> Misfit | None:
    """Why a constructor does not take a value for a field. It converts the items of an array of numbers itself,
    before they are checked (rosidl_generator_py, ``_msg.py.em``)."""
    wrong = misfit(run, kind, value)
    numbers = kind.array and kind.name in _FLOATS | _INTEGERS
    if wrong is None or not numbers or not wrong.of_items:
        return wrong
    return None if wrong.effect is ValueEffect.NONE else replace(wrong, checked=False)


def misfit(run: Run, kind: FieldType, value: Value) -> Misfit | None:
    """Why a field does not take a value, whichever of its alternatives it is; None where it may take it. ``None``
    among others stands for what is not there yet."""
    options = [option for option in alternatives(value) if not option.is_none]
    misfits = [_misfit(run, kind, option) for option in options]
    if misfits and all(misfits):
        return misfits[0]
    return _on_some_paths(run, kind, value, options, misfits)


def _on_some_paths(
    run: Run, kind: FieldType, value: Value, options: Sequence[Value], misfits: Sequence[Misfit | None]
) -> Misfit | None:
    """A whole number among others that a float field gets in one branch of the code: ``speed = 1 if near else 0.5``.
    What an attribute holds until another callback has set it is no such number: nobody knows whether it is used."""
    if kind.array or kind.name not in _FLOATS or value.why_open is None:
        return None
    for option, wrong in zip(options, misfits, strict=True):
        number = option.value if isinstance(option, Known) and not option.via else None
        if wrong is None or wrong.effect is not ValueEffect.CHANGED:
            continue
        if type(number) is int and _is_written_here(run, number):
            return replace(wrong, given=f"{wrong.given} that it gets in one branch")
    return None


def _is_written_here(run: Run, number: int) -> bool:
    """Whether a number stands in one of the functions that are running."""
    functions = (activation.function.ir for activation in run.activations if activation.function is not None)
    literals = (part for function in functions for part in everything_in(function, facts.Literal))
    return any(literal.value in (number, -number) for literal in literals)


def _misfit(run: Run, kind: FieldType, value: Value) -> Misfit | None:
    shape = _shape_of(value)
    if shape is None:
        return None
    if kind.array:
        return _of_array(run, kind, value, shape)
    return _of_one(run, kind, value, shape)


# ----------------------------------------------------------------------------------------------- one value


def _of_one(run: Run, kind: FieldType, value: Value, shape: _Shape) -> Misfit | None:
    if kind.name in _FLOATS:
        return _of_float(value, shape)
    if kind.name in _INTEGERS:
        return _of_integer(kind.name, value, shape)
    if kind.name == "bool":
        return _of_bool(value, shape)
    if kind.name in _TEXTS:
        return _of_text(value, shape)
    return None if kind.is_primitive else _of_message(run, kind, value, shape)


def _of_text(value: Value, shape: _Shape) -> Misfit | None:
    if shape.what is _What.TEXT:
        return None
    number = value.constant
    if isinstance(number, int | float) and not isinstance(number, bool):
        cure = f"give it the string that is meant: str() would send '{number}'"
        return _wrong("a string", shape, ValueEffect.SENT, cure)
    return _wrong("a string", shape, ValueEffect.SENT, "convert it with str()")


def _of_float(value: Value, shape: _Shape) -> Misfit | None:
    if shape.what is _What.FLOAT:
        return None
    zero = isinstance(value, Known) and value.value in (0, False)
    known = value.constant if shape.what is _What.INT and not value.via else None
    cure = f"make it {float(known)}" if isinstance(known, int) and abs(known) < 10**15 else "convert it with float()"
    return _wrong("a float", shape, ValueEffect.NONE if zero else ValueEffect.CHANGED, cure)


_TO_INT = "convert it with int()"


def _of_integer(name: str, value: Value, shape: _Shape) -> Misfit | None:
    if shape.what is _What.BOOL:
        return None
    if shape.what is not _What.INT:
        number = value.constant
        if shape == _OF_CLASSES["numpy.integer"]:  # what converts it asks for __index__()
            return _wrong("an int", shape, ValueEffect.NONE, _TO_INT)
        is_part = isinstance(number, float) and not number.is_integer()
        cure = "use a whole number, or another field: int() would cut the fraction off" if is_part else _TO_INT
        return _wrong("an int", shape, ValueEffect.SENT, cure)
    least, most = INTEGER_RANGES[name]
    number = value.constant
    if not isinstance(number, int) or value.via or least <= number <= most:
        return None
    effect = ValueEffect.SENT if number < 0 <= least else ValueEffect.CHANGED
    return _wrong(f"an int from {least} to {most}", shape, effect, "use a number in this range")


def _of_bool(value: Value, shape: _Shape) -> Misfit | None:
    if shape.what is _What.BOOL:
        return None
    false = isinstance(value, Known) and not value.value
    cure = "convert it with bool()" if shape.what is _What.NUMPY else "assign True or False"
    return _wrong("a bool", shape, ValueEffect.NONE if false else ValueEffect.FALSE, cure)


def _of_message(run: Run, kind: FieldType, value: Value, shape: _Shape) -> Misfit | None:
    if isinstance(value, MessageValue):
        if (value.type, value.section_name) == (kind.name, ""):
            return None
        effect = ValueEffect.NONE if _has_fields_of(run, value, kind.name) else ValueEffect.SENT
        return _wrong(f"a {kind.name}", shape, effect, f"assign a {kind.name}")
    alike = isinstance(value, Instance) and _is_like(run, value, kind.name)
    return _wrong(f"a {kind.name}", shape, ValueEffect.NONE if alike else ValueEffect.SENT, f"assign a {kind.name}")


def _is_like(run: Run, value: Instance, wanted: str) -> bool:
    """Whether an object may have all fields of a message: then it is sent as one, but by humble."""
    assert run.interfaces is not None
    section, cls = run.interfaces.section(wanted, ""), value.own_class
    if cls is None:
        return False  # an object of rclpy's
    if section is None:
        return True
    return all(run.store.get(value.key, name) or cls.lookup(run, name)[0] for name in (f.name for f in section.fields))


def _has_fields_of(run: Run, value: MessageValue, wanted: str) -> bool:
    """Whether a message has all fields that another class has: then it is sent as one of these."""
    assert run.interfaces is not None
    own, other = run.interfaces.section(value.type, value.section_name), run.interfaces.section(wanted, "")
    return own is None or other is None or all(own.field(field.name) is not None for field in other.fields)


# ------------------------------------------------------------------------------------------- several values


def _of_array(run: Run, kind: FieldType, value: Value, shape: _Shape) -> Misfit | None:
    if shape.what is _What.LIST:
        return _of_list(run, kind, value)
    of_numpy = shape.what is _What.NUMPY or shape == _OF_CLASSES["numpy.ndarray"]  # of arrays, arrays
    if of_numpy or shape.what in (_What.DICT, _What.BYTES):
        return None
    many = _many(kind)
    if kind.name in _FLOATS | _INTEGERS:
        crashes = kind.array == "fixed" and shape.what in _NUMBERS
        effect = ValueEffect.CRASH if crashes else ValueEffect.SET
    else:
        letters = shape.what is _What.TEXT and kind.name in _TEXTS
        effect = ValueEffect.CHANGED if letters else ValueEffect.SENT
    return _wrong(many, shape, effect, "put it in a list: [...]" if kind.array != "fixed" else f"assign {many}")


def _of_list(run: Run, kind: FieldType, value: Value) -> Misfit | None:
    items = value.items(run) if isinstance(value, ListValue) and value.kind in ("list", "tuple") else None
    if items is None or items.open:
        return None
    numeric = kind.name in _FLOATS | _INTEGERS
    if kind.array == "fixed" and numeric and items.size != kind.size:
        given = _Shape(_What.LIST, f"{items.size} value{'' if items.size == 1 else 's'}")
        return _wrong(_many(kind), given, ValueEffect.CHANGED, f"give it {kind.size} values")
    wrong = [fault for item in items.values if (fault := misfit_of_item(run, kind, item)) is not None]
    by_gravity = sorted(wrong, key=lambda fault: fault.effect is ValueEffect.NONE)
    return by_gravity[0] if by_gravity else None


def misfit_of_item(run: Run, kind: FieldType, item: Value) -> Misfit | None:
    """Why an array does not take a value among others."""
    fault = misfit(run, FieldType(kind.name), item)
    if fault is None:
        return None
    effect = _effect_in_array(kind, item, fault)
    cure = fault.cure if kind.is_primitive else f"put a {kind.name} into it"
    return Misfit(_many(kind), f"{fault.given} in a list", effect, cure, of_items=True)


def _effect_in_array(kind: FieldType, item: Value, fault: Misfit) -> ValueEffect:
    """What comes of an item in an array, whose numbers are converted when they are set."""
    if kind.name not in _FLOATS | _INTEGERS:
        return fault.effect
    shapes = {shape.what for option in alternatives(item) if (shape := _shape_of(option)) is not None}
    numbers = shapes <= _NUMBERS | {_What.NUMPY}
    if kind.name in _FLOATS and numbers:
        return ValueEffect.NONE
    return ValueEffect.CHANGED if kind.array == "fixed" and numbers else ValueEffect.SET


def _many(kind: FieldType) -> str:
    name = "float" if kind.name in _FLOATS else "int" if kind.name in _INTEGERS else kind.name
    return f"{kind.size} {name}s" if kind.array == "fixed" else f"a list of {name}s"


# ------------------------------------------------------------------------------------ what is known of a value


_OF_CONSTANTS: Sequence[tuple[type, _What]] = (
    (bool, _What.BOOL),
    (int, _What.INT),
    (float, _What.FLOAT),
    (str, _What.TEXT),
    (bytes, _What.BYTES),
)
_OF_CLASSES = {
    "int": _Shape(_What.INT, "an int"),
    "float": _Shape(_What.FLOAT, "a float"),
    "str": _Shape(_What.TEXT, "a string"),
    "bool": _Shape(_What.BOOL, "a bool"),
    "bytes": _Shape(_What.BYTES, "bytes", "make a text of them: .decode()"),
    "numpy.bool": _Shape(_What.NUMPY, "a bool of numpy"),
    "numpy.integer": _Shape(_What.NUMPY, "an int of numpy"),
    "numpy.float32": _Shape(_What.NUMPY, "a float32 of numpy"),
    "numpy.ndarray": _Shape(_What.OBJECT, "an array of numpy"),
    clocks.TIME: _Shape(_What.OBJECT, "a Time of rclpy", "add .to_msg()"),
    "rclpy.duration.Duration": _Shape(_What.OBJECT, "a Duration of rclpy", "add .to_msg()"),
    "rclpy.parameter.Parameter": _Shape(_What.OBJECT, "a Parameter", "add .value"),
}
"""What is known of objects by the dotted names of their classes."""


def _shape_of(value: Value) -> _Shape | None:
    match value:
        case Known():
            return _of_constant(value)
        case Holed():
            return _OF_CLASSES["str"]
        case Unknown(of_class=str(name)) | Instance(cls=External(path=name)):
            return _OF_CLASSES.get(name)
        case ListValue() | EachValue():
            return _Shape(_What.LIST, "a list")
        case DictValue():
            return _Shape(_What.DICT, "a dict")
        case MessageValue(type=type_, section_name=part):
            return _Shape(_What.MESSAGE, f"a {type_}.{part}" if part else f"a {type_}")
        case Instance(cls=ClassValue() as cls):
            return _of_own_class(value, cls)
        case FutureValue():
            return _Shape(_What.OBJECT, "a future", "wait for its result")
        case EntityValue() | NodeValue():
            return _Shape(_What.OBJECT, "an object of rclpy")
        case FunctionValue() | BoundMethod(function=FunctionValue()):
            return _Shape(_What.OBJECT, "a function", "call it: add ()")
    return None


_PLAIN = frozenset({"object", "builtins.object", "abc.ABC"})
_ENUM = frozenset({"enum.Enum"})


def _of_own_class(value: Instance, cls: ClassValue) -> _Shape | None:
    """What is known of an object of a class of the workspace: one that derives from nothing else is no text and no
    number."""
    bases = {base.dotted for base in cls.mro if not isinstance(base, ClassValue)}
    if cls.other_bases or cls.metaclass is not None or not bases <= _PLAIN | (_ENUM if value.is_member else set()):
        return None
    if value.is_member:
        return _Shape(_What.OBJECT, "a member of an enum", "add .value")
    return _Shape(_What.OBJECT, f"an object of class {cls.ir.name}")


def _of_constant(value: Known) -> _Shape | None:
    what = next((what for type_, what in _OF_CONSTANTS if isinstance(value.value, type_)), None)
    if what is None or value.kind == "path":
        return None
    shown = repr(value.value)
    if what is _What.BOOL:
        return _Shape(what, shown)
    shown = shown if len(shown) <= _SHOWN else f"{shown[:_SHOWN]}…"
    return _Shape(what, f"{_NOUNS.get(what, '')}{shown}")


_NOUNS = {_What.INT: "the int ", _What.FLOAT: "the float ", _What.TEXT: "the string "}


def _wrong(wanted: str, shape: _Shape, effect: ValueEffect, cure: str) -> Misfit:
    return Misfit(wanted, shape.words, effect, shape.cure or cure)


__all__ = ["Misfit", "misfit", "misfit_of_argument", "misfit_of_item"]
