"""Methods of texts and of paths, which are texts here."""

from __future__ import annotations

import posixpath
import string
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import path_parts
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.containers import new_list
from archlint.interpreter.formatting import CARTESIAN, combine, format_one
from archlint.interpreter.items import get_item
from archlint.interpreter.text_methods import result_of
from archlint.interpreter.values import (
    TEXT_LIMIT,
    Holed,
    Known,
    ListValue,
    Unknown,
    Value,
    alternatives,
    constant,
    constants_of,
    file_origin,
    one_of,
    reason,
    via,
)
from archlint.origins import OriginKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine
    from archlint.syntax import facts


@dataclass(frozen=True)
class TextCall:
    """``target.name(…)`` of a text whose content is known."""

    machine: Machine
    target: Known
    name: str
    site: CallSite


Method = Callable[[TextCall], "Value | None"]
"""None where a call with these arguments is not followed."""

_PLAIN = frozenset(
    {"lower", "upper", "title", "capitalize", "casefold", "swapcase", "strip", "lstrip", "rstrip", "replace"}
    | {"removeprefix", "removesuffix", "zfill", "ljust", "rjust", "center", "expandtabs"}
    | {"startswith", "endswith", "find", "rfind", "count", "index"}
    | {"isdigit", "isalpha", "isalnum", "islower", "isupper", "isidentifier", "isnumeric"}
)
"""Methods that give a constant for constants."""


def call(machine: Machine, target: Known, name: str, site: CallSite) -> Value | None:
    """``target.name(…)``; None where that is not followed."""
    method = _plain_method if name in _PLAIN else _METHODS.get(name)
    return None if method is None else method(TextCall(machine, target, name, site))


def call_holed(target: Holed, name: str, site: CallSite) -> Value:
    """The same of a text with holes."""
    if name in ("lower", "upper", "casefold"):
        parts = tuple(None if part is None else getattr(part, name)() for part in target.parts)
        return Holed(parts, target.reason, target.via, target.origin)
    first, last = target.parts[0], target.parts[-1]
    given = site.args[0].text if len(site.args) == 1 else None
    if given is not None:
        if name == "startswith" and first is not None and len(given) <= len(first):
            return Known(first.startswith(given))
        if name == "endswith" and last is not None and len(given) <= len(last):
            return Known(last.endswith(given))
    return result_of(name, target.reason)


def _plain_method(call: TextCall) -> Value:
    if call.site.keywords:
        return Unknown(f"str.{call.name}() of arguments by name is not followed")
    return one_of(
        _plain_result(call.target, str(call.target.value), call.name, row) for row in _combinations(call.site.args)
    )


def _plain_result(target: Known, text: str, name: str, row: Sequence[Value]) -> Value:
    constants = constants_of(row)
    if constants is None:
        return Unknown("a string method of unknown values" if isinstance(row[0], ListValue) else reason(*row))
    if _grows(text, name, constants):
        return Unknown("a string too long to follow")
    try:
        return constant(getattr(text, name)(*constants), target.via | via(*row))
    except (TypeError, ValueError, OverflowError):
        return Unknown("an operation that fails")


def _grows(text: str, name: str, args: Sequence[object]) -> bool:
    """Whether a method may make a longer text than is followed."""
    if name in ("ljust", "rjust", "center", "zfill", "expandtabs"):
        times = text.count("\t") if name == "expandtabs" else 1
        return any(isinstance(arg, int) and arg * times > TEXT_LIMIT for arg in args)
    if name == "replace" and len(args) > 1 and isinstance(args[0], str) and isinstance(args[1], str):
        return len(text) + (text.count(args[0]) + 1) * len(args[1]) > TEXT_LIMIT
    return False


def _combinations(args: Sequence[Value]) -> list[list[Value]]:
    rows: list[list[Value]] = [[]]
    for arg in args:
        rows = [[*row, option] for row in rows for option in alternatives(arg)][:CARTESIAN]
    return rows


def _split(call: TextCall) -> Value:
    constants, named = constants_of(call.site.args), constants_of(call.site.keywords.values())
    if constants is None or named is None:
        return Unknown(reason(*call.site.args))
    try:
        pieces = getattr(call.target.value, call.name)(*constants, **dict(zip(call.site.keywords, named, strict=True)))
    except (TypeError, ValueError, OverflowError):
        return Unknown("an operation that fails")
    values = [Known(piece, call.target.via) for piece in pieces]
    return new_list(call.machine, values, "tuple" if call.name.endswith("partition") else "list")


def _join(call: TextCall) -> Value | None:
    if not call.site.args:
        return None
    items = call.site.args[0].items(call.machine)
    if items is None or items.open:
        return Unknown(reason(call.site.args[0]))
    parts: list[Value] = []
    for number, item in enumerate(items.values):
        parts.extend([call.target, item] if number else [item])
    return combine(call.machine, parts, _span(call.site)) if parts else Known("")


def _span(site: CallSite) -> facts.Span | None:
    return None if site.expression is None else site.expression.span


def _as_text(call: TextCall) -> Value | None:
    return None if call.site.args else constant(str(call.target.value), call.target.via)


def _same_path(call: TextCall) -> Value:
    kind: OriginKind = "other" if call.name == "as_posix" else "path"
    return constant(str(call.target.value), call.target.via, kind, file_origin(call.target, *call.site.args))


def _resolved(call: TextCall) -> Value:
    same = _same_path(call)
    return path_parts.shortest(call.machine, same) if isinstance(same, Known) else same


def _join_path(call: TextCall) -> Value:
    constants = constants_of(call.site.args)
    if constants is None:
        return Unknown(reason(*call.site.args))
    joined = "/".join([str(call.target.value), *map(str, constants)])
    return constant(joined, call.target.via, "path", file_origin(call.target, *call.site.args))


def _with_other_name(call: TextCall) -> Value | None:
    """``path.with_name('other.py')`` and ``path.with_suffix('.yaml')`` of a pathlib.Path."""
    given = constants_of(call.site.args)
    if call.target.kind != "path" or given is None or len(given) != 1:
        return None
    folder, last = posixpath.split(str(call.target.value))
    other = str(given[0]) if call.name == "with_name" else posixpath.splitext(last)[0] + str(given[0])
    return constant(posixpath.join(folder, other), call.target.via, "path", file_origin(call.target, *call.site.args))


def _exists(call: TextCall) -> Value | None:
    if call.target.kind != "path":
        return None
    return call.machine.library.asked_for_file(str(call.target.value))


def _listed(call: TextCall) -> Value | None:
    """``folder.glob('*.yaml')`` and ``folder.iterdir()`` of a pathlib.Path."""
    pattern = "*" if call.name == "iterdir" else call.site.args[0].text if len(call.site.args) == 1 else None
    if call.target.kind != "path" or pattern is None:
        return None
    paths = call.machine.library.matches(str(call.target.value), pattern)
    if paths is None:
        return Unknown("the files of a folder")
    return new_list(call.machine, [Known(path, call.target.via, kind="path") for path in paths])


def _is_absolute(call: TextCall) -> Value | None:
    """A path that starts with ``$(`` is that of an installed file, which is absolute when a program asks."""
    return Known(str(call.target.value).startswith(("/", "$("))) if call.target.kind == "path" else None


def _open(call: TextCall) -> Value | None:
    return call.machine.library.opened(call.target) if call.target.kind == "path" else None


# --------------------------------------------------------------------------------------------------- format


def _format(call: TextCall) -> Value:
    parts: list[Value] = []
    automatic = 0
    try:
        rows = list(string.Formatter().parse(str(call.target.value)))
    except ValueError:
        return Unknown("a format that fails")
    for literal, field, spec, conversion in rows:
        if literal:
            parts.append(Known(literal, call.target.via))
        if field is None:
            continue
        first, *steps = field.replace("[", ".[").split(".")
        if first == "":
            first, automatic = str(automatic), automatic + 1
        value = _followed(call.machine, _argument(call.site, first), steps)
        if spec or conversion in ("r", "a"):
            value = one_of(format_one(option, conversion, spec) for option in alternatives(value))
        parts.append(value)
    return combine(call.machine, parts, _span(call.site))


def _argument(site: CallSite, name: str) -> Value:
    """The argument that a field of a format names, by position or by name."""
    if not _is_index(name):
        return site.keywords.get(name, Unknown("format() has no such argument"))
    number = int(name)
    return site.args[number] if number < len(site.args) else Unknown("format() has too few arguments")


def _followed(machine: Machine, value: Value, steps: Sequence[str]) -> Value:
    """The attribute or item that the steps of a field lead to: ``[0]``, ``name``."""
    for step in steps:
        if step.startswith("["):
            inside = step[1:-1]
            value = get_item(machine, value, Known(int(inside) if _is_index(inside) else inside))
        else:
            value = get_attribute(machine, value, step)
    return value


def _is_index(text: str) -> bool:
    """Whether a field of a format is a number; one of more digits is of no list."""
    return text.isascii() and text.isdigit() and len(text) < 10


_METHODS: dict[str, Method] = {
    "__str__": _as_text,
    "absolute": _same_path,
    "as_posix": _same_path,
    "exists": _exists,
    "expanduser": _same_path,
    "format": _format,
    "is_absolute": _is_absolute,
    "glob": _listed,
    "is_dir": _exists,
    "is_file": _exists,
    "iterdir": _listed,
    "join": _join,
    "joinpath": _join_path,
    "open": _open,
    "partition": _split,
    "read_text": _open,
    "resolve": _resolved,
    "rpartition": _split,
    "rsplit": _split,
    "split": _split,
    "splitlines": _split,
    "with_name": _with_other_name,
    "with_suffix": _with_other_name,
}

__all__ = ["call", "call_holed"]
