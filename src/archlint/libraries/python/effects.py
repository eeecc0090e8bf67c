"""Functions of Python's library that names pass through."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.interpreter import containers, path_parts
from archlint.interpreter.builtins import BUILTINS
from archlint.interpreter.call_site import CallSite
from archlint.interpreter.containers import ITEM_LIMIT
from archlint.interpreter.values import (
    FACTORY,
    TUPLE_FIELDS,
    External,
    Instance,
    Known,
    Partial,
    PythonValue,
    Unknown,
    Value,
    alternatives,
    as_default,
    constant,
    file_origin,
    one_of,
    reason,
    via,
)
from archlint.libraries.python import argument_parsers
from archlint.libraries.python.copies import _copy, _deep_copy

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from archlint.libraries.api_use import ApiUse, Effect, Plain
    from archlint.libraries.run import Run


def partial(run: Run, call: ApiUse) -> Value:
    function = call.get("function")
    if function is None:
        return Unknown("partial() without a function")
    keywords = {name: value for name, value in call.keywords.items() if name != "function"}
    return one_of([_partial(option, call.rest, keywords) for option in alternatives(function)])


def _partial(function: Value, rest: Sequence[Value], keywords: Mapping[str, Value]) -> Value:
    if isinstance(function, Partial):
        # One of one, as Python makes it: a chain of them would be as deep as the loop that builds it.
        keywords = {**dict(function.keywords), **keywords}
        return Partial(function.function, (*function.args, *rest)[:ITEM_LIMIT], tuple(keywords.items()))
    return Partial(function, tuple(rest), tuple(keywords.items()))


def import_module(run: Run, call: ApiUse) -> Value:
    match call.get("name"):
        case Known(value=str(name), via=parameters):
            level = len(name) - len(name.lstrip("."))
            module = run.index.find(run.activation.module, name.lstrip("."), level)
            return External(name, parameters) if module is None else run.import_module(module)
    return Unknown("the module is chosen at run time")


def path_join(run: Run, call: ApiUse) -> Value:
    parts = [call.get("path"), *call.rest]
    texts = [part.text for part in parts if part is not None and part.text is not None]
    if len(texts) != len(parts):
        return Unknown(reason(*(part for part in parts if part is not None)))
    there = [part for part in parts if part is not None]
    return constant(posixpath.join(*texts), via(*there), origin=file_origin(*there))


def asks_for_file(run: Run, call: ApiUse) -> Value:
    """``os.path.exists(path)``: what depends on it may do without the file."""
    path = call.get("path")
    if isinstance(path, Known):
        return run.library.asked_for_file(str(path.value))
    return Unknown("whether a file exists")


def environment(run: Run, call: ApiUse) -> Value:
    """``os.environ.get('X', default)``: the default, or what the environment says."""
    key = call.get("key")
    known = run.library.environment(key.value) if isinstance(key, Known) else None
    if known is not None:
        return known
    name = f"the environment variable {key.value!s}" if isinstance(key, Known) else "an environment variable"
    default = call.get("default")
    return Unknown(name) if default is None else one_of((as_default(default), Unknown(name)))


def _identity(run: Run, site: CallSite) -> Value:
    return site.args[0] if site.args else Unknown("no argument")


def _namespace(run: Run, site: CallSite) -> Value:
    namespace = Instance(External("types.SimpleNamespace"), run.store.new_key())
    for name, value in site.keywords.items():
        run.library.kept(namespace.key, (value,), name)
        run.store.set(namespace.key, name, value)
    return namespace


def _auto(run: Run, site: CallSite) -> Value:
    return External("enum.auto")


def _default_dict(run: Run, site: CallSite) -> Value:
    dictionary = containers.new_dict(run, {}, len(site.args) > 1)
    if site.args:
        run.store.set(dictionary.key, FACTORY, site.args[0])
    return dictionary


def _named_tuple(run: Run, site: CallSite) -> Value:
    """``namedtuple('Point', 'x y')``: a class whose objects have these fields."""
    fields = site.args[1] if len(site.args) > 1 else site.keywords.get("field_names")
    if fields is not None and fields.text is not None:
        names: list[Value] = [Known(name) for name in fields.text.replace(",", " ").split()]
    else:
        items = fields.items(run) if fields is not None else None
        if items is None or items.open:
            return Unknown("a named tuple whose fields are not known")
        names = list(items.values)
    texts = tuple(name.text for name in names if name.text is not None)

    def make(*values: Value, **named: Value) -> Value:
        instance = Instance(External("collections.namedtuple"), run.store.new_key())
        for number, name in enumerate(texts):
            given = values[number] if number < len(values) else named.get(name, Unknown("a field that is not set"))
            run.store.set(instance.key, name, given)
        run.store.set(instance.key, TUPLE_FIELDS, texts)
        return instance

    return PythonValue("namedtuple", make)


def _in_a_screen(run: Run, site: CallSite) -> Value:
    """``curses.wrapper(main)`` calls ``main`` with the screen, and returns what that does."""
    if not site.args:
        return Unknown("no argument")
    function, *args = site.args
    screen = Unknown("the screen of curses")
    return run.call(function, CallSite([screen, *args], dict(site.keywords)))


def _product(run: Run, site: CallSite) -> Value:
    rows: list[list[Value]] = [[]]
    for arg in site.args:
        items = arg.items(run)
        if items is None or items.open or "repeat" in site.keywords or len(rows) * len(items.values) > 4096:
            return Unknown("the combinations are not known")
        rows = [[*row, item] for row in rows for item in items.values]
    return containers.new_list(run, [containers.new_list(run, row, "tuple") for row in rows])


def _result(path: str, of_class: str) -> Plain:
    """What gives something of one class, whatever it is given: ``time.time()``."""
    return lambda run, site: Unknown(f"{path}() is outside of this workspace", of_class=of_class)


_RESULTS = {
    "float": {
        "time": "time monotonic perf_counter",
        "math": "acos asin atan atan2 copysign cos degrees exp fabs fmod hypot log log10 log2 pow radians sin sqrt tan",
        "random": "gauss random uniform",
    },
    "int": {"time": "time_ns monotonic_ns perf_counter_ns", "random": "randint randrange", "math": "ceil floor trunc"},
    "str": {"json": "dumps", "time": "strftime ctime asctime"},
    "numpy.bool": {"numpy": "all any bool_"},
    "numpy.integer": {"numpy": "argmax argmin int8 int16 int32 int64 uint8 uint16 uint32 uint64"},
    "numpy.float32": {"numpy": "float16 float32"},
    "numpy.ndarray": {"numpy": "arange array empty eye full identity linspace ones zeros"},
}
"""The functions of Python's modules, and of numpy, that give a number, a text or an array, by its class."""


PLAIN: dict[str, Plain] = {
    "copy.copy": _copy,
    "copy.deepcopy": _deep_copy,
    "collections.OrderedDict": BUILTINS["dict"],
    "collections.deque": BUILTINS["list"],
    "collections.defaultdict": _default_dict,
    "collections.namedtuple": _named_tuple,
    "itertools.product": _product,
    "types.SimpleNamespace": _namespace,
    "enum.auto": _auto,
    "curses.wrapper": _in_a_screen,
    "asyncio.run": _identity,
    "asyncio.create_task": _identity,
    "asyncio.ensure_future": _identity,
    "typing.cast": lambda run, site: site.args[1] if len(site.args) > 1 else Unknown("no argument"),
    "itertools.chain": lambda run, site: _chain(run, site.args),
    "os.path.basename": lambda run, site: _file_name(site.args),
    "os.path.dirname": lambda run, site: _folder(run, site.args),
    "os.path.split": lambda run, site: containers.new_list(
        run, [_folder(run, site.args), _file_name(site.args)], "tuple"
    ),
    **{
        f"{module}.{name}": _result(f"{module}.{name}", of_class)
        for of_class, modules in _RESULTS.items()
        for module, names in modules.items()
        for name in names.split()
    },
}


def _chain(run: Run, args: list[Value]) -> Value:
    values: list[Value] = []
    open_ = False
    for arg in args:
        items = arg.items(run)
        if items is None:
            open_ = True
        else:
            values.extend(items.values[: containers.ITEM_LIMIT + 1 - len(values)])
            open_ = open_ or items.open
    open_ = open_ or len(values) > containers.ITEM_LIMIT
    return containers.new_list(run, values[: containers.ITEM_LIMIT], "list", open_)


def _folder(run: Run, args: list[Value]) -> Value:
    match args:
        case [Known(value=str(path)) as known, *_] if run.library.folder_around(path) is not None:
            return path_parts.folder_of(run, known)
        case [Known(value=str(path), via=parameters), *_]:
            return Known(posixpath.dirname(path), parameters)
    return Unknown(reason(*args))


def _file_name(args: list[Value]) -> Value:
    match args:
        case [Known(value=str(path), via=parameters), *_]:
            return Known(posixpath.basename(path), parameters)
    return Unknown(reason(*args))


EFFECTS: dict[str, Effect] = {
    "import_module": import_module,
    "partial": partial,
    "path_join": path_join,
    "asks_for_file": asks_for_file,
    "environment": environment,
    "argument_parser": argument_parsers.argument_parser,
}


__all__ = ["EFFECTS", "PLAIN"]
