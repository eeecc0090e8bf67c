"""Python's own functions and the methods of its texts and collections, as far as names need them."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import TYPE_CHECKING, Any

from archlint.facts import model as facts
from archlint.program.api import rclpy_names
from archlint.program.store import Entries, Items
from archlint.program.values import (
    FALSE,
    NONE,
    TRUE,
    ApiMethod,
    BoundMethod,
    Builtin,
    ClassValue,
    DictValue,
    External,
    FunctionValue,
    Holed,
    Instance,
    Known,
    ListValue,
    MessageValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
    via,
)

if TYPE_CHECKING:
    from archlint.program.run import Run

Arguments = list[Value]
Keywords = dict[str, Value]


def call_builtin(
    run: Run,
    function: Builtin,
    args: Arguments,
    keywords: Keywords,
    expression: facts.Call | None,
    open_arguments: bool,
) -> Value:
    target = function.self_value
    if target is not None:
        method = function.name.rpartition(".")[2]
        return call_method(run, target, method, args, keywords, expression, open_arguments)
    handler = BUILTINS.get(function.name)
    if handler is None:
        return Unknown(f"{function.name}() is not followed")
    if open_arguments and function.name not in ("print", "dict", "set", "list"):
        return Unknown(f"{function.name}() of arguments that are not known")
    return handler(run, args, keywords, expression)


def _first(args: Arguments, why: str = "an argument is missing") -> Value:
    return args[0] if args else Unknown(why)


def _nothing(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    return NONE


def _unknown(what: str) -> Callable[..., Value]:
    def handler(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
        return Unknown(reason(*args) if args else what)

    return handler


def _input(run: Run, args: Arguments, keywords: Keywords, e: facts.Call | None) -> Value:
    from archlint.program.api import effects, tables

    api = tables.find("builtins.input")
    if api is not None and e is not None:
        effects.record(run, api, None, {}, e)
    return Unknown("what a user types")


def _open(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    """A file; only launch files read any that matter here."""
    from archlint.program.launch.effects import open_file

    return open_file(run, args)


def _str(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    if not args:
        return Known("")
    found = []
    for option in alternatives(args[0]):
        text = expressions.text_of(run, option)
        found.append(Known(str(text.value), text.via, text.origin, text.kind) if isinstance(text, Known) else text)
    return one_of(found)


def _number(convert: Callable[[Any], Any]) -> Callable[..., Value]:
    def handler(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
        if not args:
            return Known(convert("0") if convert is not bool else False)
        found: list[Value] = []
        for option in alternatives(args[0]):
            if isinstance(option, Known):
                try:
                    found.append(Known(convert(option.value), option.via))
                except (TypeError, ValueError, OverflowError):
                    found.append(Unknown("a conversion that fails"))
            else:
                found.append(Unknown(reason(option), next(iter(sorted(via(option))), None)))
        return one_of(found)

    return handler


def _bool(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    if not args:
        return FALSE
    if isinstance(args[0], Known):
        return Known(bool(args[0].value), args[0].via)
    known = expressions.truth(run, args[0])
    return Unknown(reason(args[0])) if known is None else Known(known)


def _len(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    value = _first(args)
    if isinstance(value, Known) and isinstance(value.value, str):
        return Known(len(value.value), value.via)
    if isinstance(value, Known):
        return Unknown("the length of a number")
    items = expressions.iterate(run, value)
    if items is None or items.open or isinstance(value, OneOf):
        return Unknown("the length of a collection that is not known")
    return Known(len(items.values))


def _range(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    numbers = [arg.value for arg in args if isinstance(arg, Known) and isinstance(arg.value, int)]
    if not args or len(numbers) != len(args):
        return Unknown(reason(*args), next(iter(sorted(via(*args))), None))
    try:
        wanted = range(*numbers)
    except (TypeError, ValueError):
        return Unknown("a range that fails")
    if len(wanted) > expressions.ITEM_LIMIT:
        return Unknown("a range too long to follow")
    return expressions.new_list(run, [Known(number, via(*args)) for number in wanted])


def _enumerate(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    items = expressions.iterate(run, _first(args))
    start = args[1] if len(args) > 1 else keywords.get("start", Known(0))
    if items is None:
        return Unknown(reason(*args))
    rows: list[Value] = []
    for number, item in enumerate(items.values):
        at = Known(start.value + number) if isinstance(start, Known) and isinstance(start.value, int) else start
        rows.append(expressions.new_list(run, [at, item], "tuple"))
    return expressions.new_list(run, rows, "list", items.open)


def _zip(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    columns = [expressions.iterate(run, arg) for arg in args]
    if not columns or any(column is None for column in columns):
        return Unknown(reason(*args))
    known = [column for column in columns if column is not None]
    rows: list[Value] = [
        expressions.new_list(run, list(row), "tuple") for row in zip(*(column.values for column in known), strict=False)
    ]
    return expressions.new_list(run, rows, "list", any(column.open for column in known))


def _collect(kind: str) -> Callable[..., Value]:
    def handler(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
        from archlint.program import expressions

        if not args:
            return expressions.new_list(run, [], kind)
        found: list[Value] = []
        for option in alternatives(args[0]):
            items = expressions.iterate(run, option)
            if items is None:
                found.append(Unknown(reason(option), next(iter(sorted(via(option))), None)))
                continue
            values = list(items.values)
            if kind == "set":
                values = list(dict.fromkeys(values)) if all(isinstance(v, Known) for v in values) else values
            found.append(expressions.new_list(run, values, kind, items.open))
        return one_of(found)

    return handler


def _reversed(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    items = expressions.iterate(run, _first(args))
    if items is None:
        return Unknown(reason(*args))
    return expressions.new_list(run, list(reversed(items.values)), "list", items.open)


def _sorted(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    items = expressions.iterate(run, _first(args))
    if items is None:
        return Unknown(reason(*args))
    values = [item.value for item in items.values if isinstance(item, Known)]
    if len(values) == len(items.values) and "key" not in keywords:
        try:
            reverse = keywords.get("reverse", FALSE) == TRUE
            order = sorted(range(len(values)), key=lambda i: values[i], reverse=reverse)  # type: ignore[arg-type,return-value]
            return expressions.new_list(run, [items.values[i] for i in order], "list", items.open)
        except TypeError:
            pass
    return expressions.new_list(run, items.values, "list", items.open)


def _dict(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    entries: dict[Hashable, tuple[Value, Value]] = {}
    open_ = False
    if args:
        open_ = not _update(run, entries, args[0])
    for name, value in keywords.items():
        at = expressions.hashable(Known(name))
        assert at is not None
        entries[at] = (Known(name), value)
    return expressions.new_dict(run, entries, open_)


def _update(run: Run, entries: dict[Hashable, tuple[Value, Value]], source: Value) -> bool:
    """Add the entries of a dict or of pairs; False where not all are known."""
    from archlint.program import expressions

    if isinstance(source, DictValue):
        other = expressions.entries_of(run, source)
        entries.update(other.entries)
        return not other.open
    items = expressions.iterate(run, source)
    if items is None:
        return False
    for pair in items.values:
        row = expressions.iterate(run, pair)
        if row is None or row.open or len(row.values) != 2:
            return False
        at = expressions.hashable(row.values[0])
        if at is None:
            return False
        entries[at] = (row.values[0], row.values[1])
    return not items.open


def _getattr(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program.attributes import get_attribute

    if len(args) < 2:
        return Unknown("getattr() without a name")
    found = []
    for name in alternatives(args[1]):
        if isinstance(name, Known) and isinstance(name.value, str):
            value = get_attribute(run, args[0], name.value)
            missing = _is_missing(value)
            found.append(args[2] if missing and len(args) > 2 else value)
            if isinstance(value, Unknown) and not missing and len(args) > 2:
                found.append(args[2])
        else:
            found.append(Unknown(reason(name)))
    return one_of(found)


def _is_missing(value: Value) -> bool:
    """Whether an object certainly lacks an attribute: neither its class here nor rclpy's Node has it."""
    if isinstance(value, Unknown):
        return (value.name or "").startswith("missing:")
    if isinstance(value, ApiMethod):
        owner, _, name = value.path.rpartition(".")
        return owner in rclpy_names.NODE_CLASSES and not rclpy_names.is_node_attribute(name)
    return False


def _setattr(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program.attributes import set_attribute

    if len(args) == 3 and isinstance(args[1], Known) and isinstance(args[1].value, str):
        set_attribute(run, args[0], args[1].value, args[2])
    return NONE


def _hasattr(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program.attributes import get_attribute

    if len(args) != 2 or not isinstance(args[1], Known) or not isinstance(args[1].value, str):
        return Unknown("hasattr() of a name that is not known")
    if isinstance(args[0], MessageValue) and run.interfaces is not None:
        known = run.interfaces.has(args[0].type, args[0].part, args[1].value)
        return Unknown("hasattr() of a message that is not known") if known is None else Known(known)
    if not isinstance(args[0], Instance) or not isinstance(args[0].cls, ClassValue):
        return Unknown("hasattr() of an object that is not followed")
    value = get_attribute(run, args[0], args[1].value)
    if _is_missing(value):
        return FALSE if run.context.role in ("init", "main") else Unknown("whether it is set by then")
    return Unknown(value.reason) if isinstance(value, Unknown) else TRUE


_TYPES: dict[str, tuple[type, ...]] = {
    "str": (str,),
    "int": (int,),
    "float": (float,),
    "bool": (bool,),
}


def _isinstance(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    if len(args) != 2:
        return Unknown("isinstance() without a type")
    classes = expressions.iterate(run, args[1]) if isinstance(args[1], ListValue) else Items((args[1],))
    if classes is None or classes.open:
        return Unknown("isinstance() of a type that is not known")
    verdicts = {_is_a(value, cls) for value in alternatives(args[0]) for cls in classes.values}
    if verdicts == {False}:
        return FALSE
    if len(alternatives(args[0])) == 1 and True in verdicts:
        return TRUE
    return Unknown("the type of the value is not known")


def _is_a(value: Value, cls: Value) -> bool | None:
    if isinstance(cls, Builtin):
        if isinstance(value, Known):
            return isinstance(value.value, _TYPES[cls.name]) if cls.name in _TYPES else False
        if isinstance(value, Holed):
            return cls.name == "str"
        if isinstance(value, ListValue):
            return cls.name == value.kind
        if isinstance(value, DictValue):
            return cls.name == "dict"
        return False if isinstance(value, (Instance, ClassValue, FunctionValue, MessageValue)) else None
    if isinstance(value, MessageValue):
        return _is_message(value, cls)
    if isinstance(value, Instance) and isinstance(value.cls, ClassValue):
        if any(base is cls or base == cls for base in value.cls.mro):
            return True
        return None if any(isinstance(base, (External, Unknown)) for base in value.cls.mro) else False
    if isinstance(value, (Known, ListValue, DictValue)) and isinstance(cls, (ClassValue, External)):
        return False
    return None


def _is_message(value: MessageValue, cls: Value) -> bool | None:
    if isinstance(cls, ClassValue):
        return False
    interface, part = rclpy_names.interface_and_part(cls.path) if isinstance(cls, External) else (None, "")
    return None if interface is None else (interface, part) == (value.type, value.part)


def _map(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    if len(args) != 2:
        return Unknown("map() over several collections")
    items = expressions.iterate(run, args[1])
    if items is None:
        return Unknown(reason(args[1]))
    return expressions.new_list(run, [run.call(args[0], [item], {}) for item in items.values], "list", items.open)


def _filter(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    items = expressions.iterate(run, args[1]) if len(args) == 2 else None
    if items is None:
        return Unknown("what filter() leaves")
    kept: list[Value] = []
    open_ = items.open
    for item in items.values:
        verdict = expressions.truth(run, item if args[0] == NONE else run.call(args[0], [item], {}))
        if verdict is not False:
            kept.append(item)
        open_ = open_ or verdict is None
    return expressions.new_list(run, kept, "list", open_)


def _extreme(pick: Callable[..., Any]) -> Callable[..., Value]:
    def handler(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
        from archlint.program import expressions

        items = expressions.iterate(run, args[0]) if len(args) == 1 else Items(tuple(args))
        if items is None or items.open or "key" in keywords:
            return Unknown(reason(*args))
        values = [item.value for item in items.values if isinstance(item, Known)]
        if len(values) != len(items.values) or not values:
            return Unknown(reason(*items.values))
        try:
            return Known(pick(values), via(*items.values))
        except TypeError:
            return Unknown("an operation that fails")

    return handler


def _any_all(wanted: bool) -> Callable[..., Value]:
    def handler(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
        from archlint.program import expressions

        items = expressions.iterate(run, _first(args))
        if items is None:
            return Unknown(reason(*args))
        verdicts = [expressions.truth(run, item) for item in items.values]
        if wanted in verdicts:
            return Known(wanted)
        return Unknown("not all items are known") if None in verdicts or items.open else Known(not wanted)

    return handler


def _type(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    value = _first(args)
    if isinstance(value, Instance):
        return value.cls
    if isinstance(value, MessageValue) and not value.part:
        return External(value.type.replace("/", "."))
    return Unknown("the type of a value")


def _callable(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    value = _first(args)
    if isinstance(value, (FunctionValue, BoundMethod, ClassValue, Partial)):
        return TRUE
    return FALSE if isinstance(value, Known) else Unknown(reason(value))


def _next(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    from archlint.program import expressions

    items = expressions.iterate(run, _first(args))
    if items is not None and items.values:
        return one_of(items.values)
    return args[1] if len(args) > 1 and items is not None and not items.open else Unknown("what an iterator gives")


def _same(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    return _first(args)


def _object_setattr(run: Run, args: Arguments, keywords: Keywords, e: object) -> Value:
    """``object.__setattr__(self, 'x', value)``: how frozen dataclasses fill themselves."""
    return _setattr(run, args, keywords, e)


BUILTINS: dict[str, Callable[..., Value]] = {
    "object.__setattr__": _object_setattr,
    "print": _nothing,
    "str": _str,
    "repr": _unknown("a repr"),
    "int": _number(int),
    "float": _number(float),
    "bool": _bool,
    "abs": _number(abs),
    "round": _unknown("a rounded number"),
    "len": _len,
    "range": _range,
    "enumerate": _enumerate,
    "zip": _zip,
    "list": _collect("list"),
    "tuple": _collect("tuple"),
    "set": _collect("set"),
    "frozenset": _collect("set"),
    "iter": _same,
    "reversed": _reversed,
    "sorted": _sorted,
    "dict": _dict,
    "getattr": _getattr,
    "setattr": _setattr,
    "hasattr": _hasattr,
    "isinstance": _isinstance,
    "issubclass": _unknown("a class relation"),
    "map": _map,
    "filter": _filter,
    "min": _extreme(min),
    "max": _extreme(max),
    "sum": _extreme(sum),
    "any": _any_all(True),
    "all": _any_all(False),
    "type": _type,
    "callable": _callable,
    "next": _next,
    "input": _input,
    "open": _open,
    "id": _unknown("an identity"),
    "hash": _unknown("a hash"),
    "vars": _unknown("the attributes of an object"),
    "dir": _unknown("the attributes of an object"),
    "object": _unknown("an object"),
    "property": _same,
    "staticmethod": _same,
    "classmethod": _same,
    "super": _unknown("super()"),
    "chr": _unknown("a character"),
    "ord": _unknown("a character"),
    "eval": _unknown("what eval() gives"),
    "exec": _nothing,
    "exit": _nothing,
    "quit": _nothing,
    "bytes": _unknown("bytes"),
    "bytearray": _unknown("bytes"),
    "memoryview": _unknown("bytes"),
    "complex": _unknown("a number"),
    "divmod": _unknown("a number"),
    "pow": _unknown("a number"),
    "format": _unknown("a formatted text"),
    "globals": _unknown("the variables"),
    "locals": _unknown("the variables"),
    "__import__": _unknown("a module"),
    "hex": _unknown("a number"),
    "bin": _unknown("a number"),
    "slice": _unknown("a slice"),
    **{
        name: _unknown("an exception")
        for name in [
            "Exception",
            "BaseException",
            "RuntimeError",
            "ValueError",
            "TypeError",
            "KeyError",
            "IndexError",
            "AttributeError",
            "OSError",
            "IOError",
            "ImportError",
            "NotImplementedError",
            "KeyboardInterrupt",
            "SystemExit",
            "TimeoutError",
            "StopIteration",
            "AssertionError",
            "ConnectionError",
            "FileNotFoundError",
            "PermissionError",
            "ZeroDivisionError",
            "ArithmeticError",
        ]
    },
}


# ------------------------------------------------------------------------------------- methods of own types

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


def call_method(
    run: Run,
    target: Value,
    name: str,
    args: Arguments,
    keywords: Keywords,
    expression: facts.Call | None,
    open_arguments: bool,
) -> Value:
    if isinstance(target, Known) and isinstance(target.value, str):
        return _text_method(run, target, name, args, keywords, expression)
    if isinstance(target, Holed):
        return _holed_method(run, target, name, args)
    if isinstance(target, ListValue):
        return _list_method(run, target, name, args, keywords)
    if isinstance(target, DictValue):
        return _dict_method(run, target, name, args, keywords)
    return Unknown(f"{name}() of a value that is not followed")


def _text_method(
    run: Run, target: Known, name: str, args: Arguments, keywords: Keywords, e: facts.Call | None
) -> Value:
    from archlint.program import expressions

    text = target.value
    assert isinstance(text, str)
    if name == "format":
        return _format(run, target, args, keywords, e)
    if name in ("joinpath", "as_posix", "resolve", "absolute", "expanduser"):  # of a pathlib.Path
        rest = [arg.value for arg in args if isinstance(arg, Known)]
        if name != "joinpath" or len(rest) == len(args):
            return Known("/".join([text, *map(str, rest)]) if name == "joinpath" else text, target.via)
        return Unknown(reason(*args))
    if name == "join" and args:
        items = expressions.iterate(run, args[0])
        if items is None or items.open:
            return Unknown(reason(args[0]))
        parts: list[Value] = []
        for number, item in enumerate(items.values):
            parts.extend(([target] if number else []) + [item])
        return expressions._combine(run, parts, e.span if e is not None else None) if parts else Known("")
    if name in ("split", "rsplit", "splitlines", "partition", "rpartition"):
        plain = [arg.value for arg in args if isinstance(arg, Known)]
        named = {k: v.value for k, v in keywords.items() if isinstance(v, Known)}
        if len(plain) != len(args) or len(named) != len(keywords):
            return Unknown(reason(*args))
        try:
            pieces = getattr(text, name)(*plain, **named)
        except (TypeError, ValueError):
            return Unknown("an operation that fails")
        kind = "tuple" if name.endswith("partition") else "list"
        return expressions.new_list(run, [Known(piece, target.via) for piece in pieces], kind)
    if name in _TEXT_METHODS:
        found: list[Value] = []
        for row in _combinations(args):
            plain = [arg.value for arg in row if isinstance(arg, Known)]
            if len(plain) != len(row):
                tuple_argument = row and isinstance(row[0], ListValue)
                found.append(Unknown("a text method of values" if tuple_argument else reason(*row)))
                continue
            try:
                found.append(Known(getattr(text, name)(*plain), target.via | via(*row)))
            except (TypeError, ValueError):
                found.append(Unknown("an operation that fails"))
        return one_of(found)
    return Unknown(f"str.{name}() is not followed")


def _combinations(args: Arguments) -> list[Arguments]:
    rows: list[Arguments] = [[]]
    for arg in args:
        rows = [[*row, option] for row in rows for option in alternatives(arg)][:36]
    return rows


def _holed_method(run: Run, target: Holed, name: str, args: Arguments) -> Value:
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


def _format(run: Run, template: Known, args: Arguments, keywords: Keywords, e: facts.Call | None) -> Value:
    import string

    from archlint.program import expressions
    from archlint.program.attributes import get_attribute

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
        if first.isdigit():
            value = args[int(first)] if int(first) < len(args) else Unknown("format() has too few arguments")
        else:
            value = keywords.get(first, Unknown("format() has no such argument"))
        for step in rest:
            if step.startswith("["):
                inside = step[1:-1]
                index = Known(int(inside)) if inside.isdigit() else Known(inside)
                value = expressions.get_item(run, value, index)
            else:
                value = get_attribute(run, value, step)
        if spec or conversion == "r":
            value = one_of(expressions.format_one(option, conversion, spec) for option in alternatives(value))
        parts.append(value)
    return expressions._combine(run, parts, e.span if e is not None else None)


def _list_method(run: Run, target: ListValue, name: str, args: Arguments, keywords: Keywords) -> Value:
    from archlint.program import expressions

    items = expressions.items_of(run, target)

    def put(values: tuple[Value, ...], open_: bool) -> None:
        full = len(values) > expressions.ITEM_LIMIT
        run.store.set(target.key, "#items", Items(values[: expressions.ITEM_LIMIT], open_ or full))

    if name in ("append", "add") and args:
        if not (name == "add" and args[0] in items.values):
            put((*items.values, args[0]), items.open)
        return NONE
    if name in ("extend", "update") and args:
        more = expressions.iterate(run, args[0])
        put((*items.values, *(more.values if more else ())), items.open or more is None or more.open)
        return NONE
    if name == "insert" and len(args) == 2:
        at = args[0].value if isinstance(args[0], Known) and isinstance(args[0].value, int) else None
        values = list(items.values)
        values.insert(at if at is not None else len(values), args[1])
        put(tuple(values), items.open or at is None)
        return NONE
    if name == "pop":
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
        kept = tuple(value for value in items.values if value != args[0])
        put(kept, items.open or len(kept) == len(items.values))
        return NONE
    if name in ("sort", "reverse"):
        put(tuple(reversed(items.values)) if name == "reverse" else items.values, items.open)
        return NONE
    if name in ("copy",):
        return expressions.new_list(run, items.values, target.kind, items.open)
    if name in ("union",):
        more = expressions.iterate(run, args[0]) if args else Items(())
        joined = items.values + tuple(v for v in (more.values if more else ()) if v not in items.values)
        return expressions.new_list(run, joined, target.kind, items.open or more is None or more.open)
    return Unknown(f"{target.kind}.{name}() is not followed")


def _default(args: Arguments) -> Value:
    return args[1] if len(args) > 1 else NONE


def _dict_method(run: Run, target: DictValue, name: str, args: Arguments, keywords: Keywords) -> Value:
    from archlint.program import expressions

    entries = expressions.entries_of(run, target)
    if name == "items":
        rows: list[Value] = [
            expressions.new_list(run, [key, value], "tuple") for key, value in entries.entries.values()
        ]
        return expressions.new_list(run, rows, "list", entries.open)
    if name == "keys":
        return expressions.new_list(run, [key for key, _ in entries.entries.values()], "list", entries.open)
    if name == "values":
        return expressions.new_list(run, [value for _, value in entries.entries.values()], "list", entries.open)
    if name == "get" and args:
        return one_of(expressions.get_entry(run, target, at, _default(args)) for at in alternatives(args[0]))
    if name == "setdefault" and args:
        at = expressions.hashable(args[0])
        if at is not None and at in entries.entries:
            return entries.entries[at][1]
        value = args[1] if len(args) > 1 else NONE
        expressions.set_item(run, target, args[0], value)
        return value
    if name == "update":
        updated = dict(entries.entries)
        complete = all(_update(run, updated, arg) for arg in args)
        for key, value in keywords.items():
            at = expressions.hashable(Known(key))
            assert at is not None
            updated[at] = (Known(key), value)
        run.store.set(target.key, "#items", Entries(updated, entries.open or not complete))
        return NONE
    if name == "pop" and args:
        fallback = args[1] if len(args) > 1 else None
        value = expressions.get_entry(run, target, args[0], fallback)
        expressions.delete_item(run, target, args[0])
        return value
    if name == "copy":
        return expressions.new_dict(run, dict(entries.entries), entries.open)
    if name == "clear":
        run.store.set(target.key, "#items", Entries({}))
        return NONE
    return Unknown(f"dict.{name}() is not followed")


__all__ = ["BUILTINS", "call_builtin"]
