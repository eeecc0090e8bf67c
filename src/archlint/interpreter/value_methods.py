"""Methods of Python's own texts, lists, sets and dicts."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers, formatting
from archlint.interpreter.attributes import get_attribute
from archlint.interpreter.items import delete_item, get_entry, get_item, set_item
from archlint.interpreter.values import (
    ENTRIES,
    FALSE,
    ITEMS,
    JOINED_LIMIT,
    NONE,
    TEXT_LIMIT,
    ConstantKind,
    DictValue,
    Entries,
    Holed,
    Items,
    Known,
    ListKind,
    ListValue,
    Unknown,
    Value,
    alternatives,
    constant,
    file_origin,
    one_of,
    reason,
    via,
)
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.interpreter.machine import Machine

Arguments = list[Value]
Keywords = dict[str, Value]


def update_entries(machine: Machine, entries: dict[Hashable, tuple[Value, Value]], source: Value) -> bool:
    """Add the entries of a dict or of pairs; False where not all are known."""
    if isinstance(source, DictValue):
        other = containers.entries_of(machine, source)
        entries.update(other.entries)
        return not other.open
    items = containers.iterate(machine, source)
    if items is None:
        return False
    for pair in items.values:
        row = containers.iterate(machine, pair)
        if row is None or row.open or len(row.values) != 2:
            return False
        at = containers.hashable(row.values[0])
        if at is None:
            return False
        entries[at] = (row.values[0], row.values[1])
    return not items.open


def in_order(values: Sequence[Value], keywords: Keywords) -> tuple[Value, ...]:
    """Values as ``sorted`` orders them; where their order is not known, as they are."""
    constants = [value.value for value in values if isinstance(value, Known)]
    reverse = keywords.get("reverse", FALSE)
    if len(constants) < len(values) or "key" in keywords or not isinstance(reverse, Known):
        return tuple(values)
    try:
        order = sorted(range(len(constants)), key=lambda i: constants[i], reverse=bool(reverse.value))  # type: ignore[arg-type,return-value]
    except TypeError:
        return tuple(values)
    return tuple(values[i] for i in order)


_TEXT_METHODS = frozenset(
    [
        "lower",
        "upper",
        "strip",
        "lstrip",
        "rstrip",
        "replace",
        "title",
        "capitalize",
        "removeprefix",
        "removesuffix",
        "zfill",
        "casefold",
        "swapcase",
        "ljust",
        "rjust",
        "center",
        "startswith",
        "endswith",
        "find",
        "rfind",
        "count",
        "index",
        "isdigit",
        "isalpha",
        "isalnum",
        "islower",
        "isupper",
        "isidentifier",
        "isnumeric",
        "expandtabs",
    ]
)


def call_method(machine: Machine, target: Value, name: str, site: CallSite) -> Value:
    if isinstance(target, Known) and isinstance(target.value, str):
        return _text_method(machine, target, name, site.args, site.keywords, site.expression)
    if isinstance(target, Holed):
        return _holed_method(machine, target, name, site.args)
    if isinstance(target, (ListValue, DictValue)):
        return _method_of_container(machine, target, name, site)
    return Unknown(f"{name}() of a value that is not followed")


_PUTS = frozenset({"append", "add", "extend", "insert", "update", "setdefault", "appendleft", "extendleft"})
_ASKS = frozenset({"index", "count", "remove", "discard"})


def _method_of_container(machine: Machine, target: ListValue | DictValue, name: str, site: CallSite) -> Value:
    given = site.values
    if name in _PUTS:
        machine.library.kept(target.key, given)
    method: Callable[..., Value] = _list_method if isinstance(target, ListValue) else _dict_method
    found = method(machine, target, name, site.args, site.keywords)
    if name in _ASKS:
        return found
    inside = () if name in _PUTS else (target,)
    return machine.library.lost(found, (*given, *inside), f"{name}() of a container has it")


def _text_method(
    machine: Machine, target: Known, name: str, args: Arguments, keywords: Keywords, e: facts.Call | None
) -> Value:
    text = target.value
    assert isinstance(text, str)
    if name == "format":
        return _format(machine, target, args, keywords, e)
    if name == "__str__" and not args:
        return constant(text, target.via, kind="other")
    if name in ("joinpath", "as_posix", "resolve", "absolute", "expanduser"):  # of a pathlib.Path
        rest = [arg.value for arg in args if isinstance(arg, Known)]
        if name != "joinpath" or len(rest) == len(args):
            joined = "/".join([text, *map(str, rest)]) if name == "joinpath" else text
            path: ConstantKind = "other" if name == "as_posix" else "path"
            return constant(joined, target.via, path, file_origin(target, *args))
        return Unknown(reason(*args))
    if target.kind == "path" and name in ("exists", "is_file"):
        machine.library.asked_for_file(text)
        return Unknown("whether a file exists")
    if name == "join" and args:
        items = containers.iterate(machine, args[0])
        if items is None or items.open:
            return Unknown(reason(args[0]))
        parts: list[Value] = []
        for number, item in enumerate(items.values):
            parts.extend(([target] if number else []) + [item])
        return formatting.combine(machine, parts, e.span if e is not None else None) if parts else Known("")
    if name in ("split", "rsplit", "splitlines", "partition", "rpartition"):
        plain = [arg.value for arg in args if isinstance(arg, Known)]
        named = {k: v.value for k, v in keywords.items() if isinstance(v, Known)}
        if len(plain) != len(args) or len(named) != len(keywords):
            return Unknown(reason(*args))
        try:
            pieces = getattr(text, name)(*plain, **named)
        except (TypeError, ValueError, OverflowError):
            return Unknown("an operation that fails")
        kind: ListKind = "tuple" if name.endswith("partition") else "list"
        return containers.new_list(machine, [Known(piece, target.via) for piece in pieces], kind)
    if name in _TEXT_METHODS:
        if keywords:
            return Unknown(f"str.{name}() of arguments by name is not followed")
        found: list[Value] = []
        for row in _combinations(args):
            plain = [arg.value for arg in row if isinstance(arg, Known)]
            if len(plain) != len(row):
                tuple_argument = row and isinstance(row[0], ListValue)
                found.append(Unknown("a text method of values" if tuple_argument else reason(*row)))
                continue
            if _grows(text, name, plain):
                found.append(Unknown("a string too long to follow"))
                continue
            try:
                found.append(constant(getattr(text, name)(*plain), target.via | via(*row)))
            except (TypeError, ValueError, OverflowError):
                found.append(Unknown("an operation that fails"))
        return one_of(found)
    return Unknown(f"str.{name}() is not followed")


def _grows(text: str, name: str, args: Sequence[object]) -> bool:
    """Whether a method may make a longer text than is followed."""
    if name in ("ljust", "rjust", "center", "zfill", "expandtabs"):
        times = text.count("\t") if name == "expandtabs" else 1
        return any(isinstance(arg, int) and arg * times > TEXT_LIMIT for arg in args)
    if name == "replace" and len(args) > 1 and isinstance(args[0], str) and isinstance(args[1], str):
        return len(text) + (text.count(args[0]) + 1) * len(args[1]) > TEXT_LIMIT
    return False


def _combinations(args: Arguments) -> list[Arguments]:
    rows: list[Arguments] = [[]]
    for arg in args:
        rows = [[*row, option] for row in rows for option in alternatives(arg)][:36]
    return rows


def _holed_method(machine: Machine, target: Holed, name: str, args: Arguments) -> Value:
    if name in ("lower", "upper", "casefold"):
        parts = tuple(None if part is None else getattr(part, name)() for part in target.parts)
        return Holed(parts, target.reason, target.via, target.origin)
    first, last = target.parts[0], target.parts[-1]
    if name == "startswith" and len(args) == 1 and isinstance(args[0], Known) and isinstance(first, str):
        prefix = args[0].value
        if isinstance(prefix, str) and len(prefix) <= len(first):
            return Known(first.startswith(prefix))
    if name == "endswith" and len(args) == 1 and isinstance(args[0], Known) and isinstance(last, str):
        suffix = args[0].value
        if isinstance(suffix, str) and len(suffix) <= len(last):
            return Known(last.endswith(suffix))
    return Unknown(target.reason)


def _format(machine: Machine, template: Known, args: Arguments, keywords: Keywords, e: facts.Call | None) -> Value:
    import string

    parts: list[Value] = []
    automatic = 0
    try:
        rows = list(string.Formatter().parse(str(template.value)))
    except ValueError:
        return Unknown("a format that fails")
    for literal, field, spec, conversion in rows:
        if literal:
            parts.append(Known(literal, template.via))
        if field is None:
            continue
        first, *rest = field.replace("[", ".[").split(".")
        if first == "":
            first, automatic = str(automatic), automatic + 1
        if _is_index(first):
            value = args[int(first)] if int(first) < len(args) else Unknown("format() has too few arguments")
        else:
            value = keywords.get(first, Unknown("format() has no such argument"))
        for step in rest:
            if step.startswith("["):
                inside = step[1:-1]
                index = Known(int(inside)) if _is_index(inside) else Known(inside)
                value = get_item(machine, value, index)
            else:
                value = get_attribute(machine, value, step)
        if spec or conversion in ("r", "a"):
            value = one_of(formatting.format_one(option, conversion, spec) for option in alternatives(value))
        parts.append(value)
    return formatting.combine(machine, parts, e.span if e is not None else None)


def _is_index(text: str) -> bool:
    """Whether a field of a format is a number; one of more digits is of no list."""
    return text.isascii() and text.isdigit() and len(text) < 10


def _list_method(machine: Machine, target: ListValue, name: str, args: Arguments, keywords: Keywords) -> Value:
    items = containers.items_of(machine, target)

    def put(values: tuple[Value, ...], open_: bool, whole: bool = False) -> None:
        full = len(values) > containers.ITEM_LIMIT
        kept = Items(values[: containers.ITEM_LIMIT], open_ or full, whole and not full)
        machine.store.set(target.key, ITEMS, kept)

    if name in ("append", "add") and args:
        # What is not followed to its end anyway is left as it is: nothing to join, after the loops that fill it.
        saturated = not items.whole and len(items.values) >= JOINED_LIMIT
        if not saturated and not (name == "add" and args[0] in items.values):
            put((*items.values, args[0]), items.open, items.whole)
        return NONE
    if name in ("extend", "update") and args:
        more = containers.iterate(machine, args[0])
        whole = items.whole and more is not None and more.whole
        joined = (*items.values, *(more.values if more else ()))
        joined = containers.distinct(joined) if target.kind == "set" else joined
        put(joined, items.open or more is None or more.open, whole)
        return NONE
    if name == "insert" and len(args) == 2:
        at = args[0].value if isinstance(args[0], Known) and isinstance(args[0].value, int) else None
        values = list(items.values)
        values.insert(at if at is not None else len(values), args[1])
        put(tuple(values), items.open or at is None)
        return NONE
    if name in ("appendleft", "extendleft") and args:
        more = Items((args[0],)) if name == "appendleft" else containers.iterate(machine, args[0])
        before = tuple(reversed(more.values)) if more else ()
        put((*before, *items.values), items.open or more is None or more.open)
        return NONE
    if name in _CHANGES:
        put(items.values, True)
        return Unknown(f"{target.kind}.{name}() is not followed")
    if name in ("pop", "popleft"):
        args = [Known(0)] if name == "popleft" else args
        last: object = args[0].value if args and isinstance(args[0], Known) else -1 if not args else None
        if isinstance(last, int) and not items.open and -len(items.values) <= last < len(items.values):
            values = list(items.values)
            taken = values.pop(last)
            put(tuple(values), False)
            return taken
        put(items.values, True)
        return one_of(items.values) if items.values and not items.open else Unknown("what pop() takes")
    if name in ("clear",):
        put((), False)
        return NONE
    if name in ("remove", "discard") and args:
        first = next((number for number, value in enumerate(items.values) if value == args[0]), len(items.values))
        kept = (*items.values[:first], *items.values[first + 1 :])
        put(kept, items.open or len(kept) == len(items.values))
        return NONE
    if name in ("sort", "reverse"):
        put(tuple(reversed(items.values)) if name == "reverse" else in_order(items.values, keywords), items.open)
        return NONE
    if name in ("copy",):
        return containers.new_list(machine, items.values, target.kind, items.open)
    if name in ("union",):
        more = containers.iterate(machine, args[0]) if args else Items(())
        joined = items.values + tuple(v for v in (more.values if more else ()) if v not in items.values)
        return containers.new_list(machine, joined, target.kind, items.open or more is None or more.open)
    return Unknown(f"{target.kind}.{name}() is not followed")


_CHANGES = frozenset({"rotate", "difference_update", "intersection_update", "symmetric_difference_update"})
"""What leaves other items than were there."""


def _default(args: Arguments) -> Value:
    return args[1] if len(args) > 1 else NONE


def _dict_method(machine: Machine, target: DictValue, name: str, args: Arguments, keywords: Keywords) -> Value:
    entries = containers.entries_of(machine, target)
    if name == "items":
        rows: list[Value] = [
            containers.new_list(machine, [key, value], "tuple") for key, value in entries.entries.values()
        ]
        return containers.new_list(machine, rows, "list", entries.open)
    if name == "keys":
        return containers.new_list(machine, [key for key, _ in entries.entries.values()], "list", entries.open)
    if name == "values":
        return containers.new_list(machine, [value for _, value in entries.entries.values()], "list", entries.open)
    if name == "get" and args:
        return one_of(get_entry(machine, target, at, _default(args)) for at in alternatives(args[0]))
    if name == "setdefault" and args:
        at = containers.hashable(args[0])
        if at is not None and at in entries.entries:
            return entries.entries[at][1]
        value = args[1] if len(args) > 1 else NONE
        if entries.open:
            value = one_of((value, Unknown("the dict has entries that are not known")))
        set_item(machine, target, args[0], value)
        return value
    if name == "update":
        updated = dict(entries.entries)
        complete = all(update_entries(machine, updated, arg) for arg in args)
        for key, value in keywords.items():
            at = containers.hashable(Known(key))
            assert at is not None
            updated[at] = (Known(key), value)
        machine.store.set(target.key, ENTRIES, Entries(updated, entries.open or not complete))
        return NONE
    if name == "pop" and args:
        fallback = args[1] if len(args) > 1 else None
        value = get_entry(machine, target, args[0], fallback)
        delete_item(machine, target, args[0])
        return value
    if name == "popitem":
        machine.store.set(target.key, ENTRIES, Entries(entries.entries, True))
        return Unknown("what popitem() takes")
    if name == "copy":
        return containers.new_dict(machine, dict(entries.entries), entries.open)
    if name == "clear":
        machine.store.set(target.key, ENTRIES, Entries({}))
        return NONE
    return Unknown(f"dict.{name}() is not followed")
