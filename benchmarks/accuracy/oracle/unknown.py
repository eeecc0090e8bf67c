"""Values that a run cannot know, and how they are distinguished from real ones.

`Unknown` stands for whatever a missing module would have given: it can be called, subclassed, unpacked,
compared, awaited, used as a decorator or in arithmetic. Turned into text it carries private-use
characters, so that a name built from it is recognised and never taken for the truth.
"""

from __future__ import annotations

import dis
import inspect
import re
import sys
import types
from abc import ABCMeta
from collections import Counter
from collections.abc import Iterator
from typing import Any

OPEN, CLOSE = "\ue000", "\ue001"
_TAINT = re.compile(f"{OPEN}[^{CLOSE}]*{CLOSE}?|{CLOSE}")
_PATIENCE = 20  # how often one place sees a true answer before it turns false, so that `while x:` ends
_NUMBER = 1009  # recognisable in a name even after some arithmetic, and bearable as a loop bound
_NUMBERS = re.compile(r"(?<!\d)1\d{3}(?!\d)")

other_way = False
"""Whether this run decides what is unknown, and parameters that are true or false, the other way."""

_answers: Counter[tuple[types.CodeType, int]] = Counter()


def is_tainted(text: object) -> bool:
    """Whether a text was built from an unknown value."""
    return isinstance(text, str) and (OPEN in text or CLOSE in text)


def is_uncertain(name: str) -> bool:
    """Whether a name holds an unknown value, or a number like those that unknown values turn into."""
    return is_tainted(name) or _NUMBERS.search(name) is not None


def mask(text: str) -> str:
    """The text with a plain word in the place of each unknown part."""
    return _TAINT.sub("unknown", text)


def pattern(text: str) -> str:
    """The text with `*` in the place of each unknown part."""
    return re.sub(r"\*+", "*", _NUMBERS.sub("*", _TAINT.sub("*", text)))


def _any_schema(source: object, handler: object) -> Any:
    """To pydantic, where it is installed, an unknown type admits any value."""
    from pydantic_core import core_schema

    return core_schema.any_schema()


class UnknownType(ABCMeta):
    """Classes that have any attribute: what a missing module's class becomes when it is subclassed."""

    def __getattr__(cls, name: str) -> Any:
        if name == "__get_pydantic_core_schema__":
            return _any_schema
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        return make(f"{cls.__name__}.{name}")

    def __iter__(cls) -> Iterator[Any]:
        return iter(())

    def __getitem__(cls, item: object) -> Any:
        return cls

    def __len__(cls) -> int:
        return 0

    def __bool__(cls) -> bool:
        return True

    def __contains__(cls, item: object) -> bool:
        return False


class UnknownBase(metaclass=UnknownType):
    """The base class that an unknown value gives to `class X(unknown)`."""

    def __new__(cls, *args: Any, **kwargs: Any) -> Any:
        return object.__new__(cls)

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        mro = type(self).__mro__
        for base in mro[mro.index(UnknownBase) + 1 :]:
            if "__init__" in vars(base) and base is not object and not isinstance(base, UnknownType):
                base.__init__(self, *args, **kwargs)  # type: ignore[misc]
                return
        for key, value in kwargs.items():
            try:
                setattr(self, key, value)
            except Exception:
                continue

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        return make(f"{type(self).__name__}.{name}")

    def __init_subclass__(cls, **kwargs: Any) -> None:
        return None

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        return make(f"{type(self).__name__}()")

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> bool:
        return False


class _UnknownErrorType(UnknownType):
    pass


def _error_class(path: str) -> type[Exception]:
    return _UnknownErrorType(path.rpartition(".")[2], (Exception,), {"__module__": path.rpartition(".")[0]})


_ERROR_NAME = re.compile(r"(Error|Exception|Exit|Interrupt|Empty|Full|Timeout|Warning|NotFound)$")


def make(path: str) -> Any:
    """The stand-in for what a dotted path names: an exception class if it is called so, else an Unknown."""
    if _ERROR_NAME.search(path) and "(" not in path and path.rpartition(".")[2][:1].isupper():
        return _error_class(path)
    return Unknown(path)


def unpacked_by(frame: types.FrameType) -> int | None:
    """How many values the caller unpacks into, when it does `a, b = value`."""
    code, at = frame.f_code.co_code, frame.f_lasti
    name = dis.opname[code[at]]
    if name == "UNPACK_SEQUENCE":
        return code[at + 1]
    if name == "UNPACK_EX":
        return code[at + 1]
    return None


class Unknown:
    """One value that the run cannot know; `_path` says where it came from."""

    def __init__(self, path: Any = "unknown", *args: Any, **kwargs: Any) -> None:
        if not isinstance(path, str):
            return  # somebody's `unknown.Base.__init__(self, ...)`
        object.__setattr__(self, "_path", path)
        object.__setattr__(self, "_known", {})

    # Looked at -----------------------------------------------------------------------------------
    def __getattr__(self, name: str) -> Any:
        if name == "__get_pydantic_core_schema__":
            return _any_schema
        if name in ("__name__", "__qualname__"):
            return str(self._path).rpartition(".")[2]
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        known = object.__getattribute__(self, "_known")
        if name not in known:
            known[name] = make(f"{object.__getattribute__(self, '_path')}.{name}")
        return known[name]

    def __setattr__(self, name: str, value: Any) -> None:
        object.__getattribute__(self, "_known")[name] = value

    def __delattr__(self, name: str) -> None:
        object.__getattribute__(self, "_known").pop(name, None)

    def __repr__(self) -> str:
        return f"{OPEN}{self._path}{CLOSE}"

    __str__ = __repr__

    def __format__(self, spec: str) -> str:
        return repr(self)

    def __fspath__(self) -> str:
        return repr(self)

    def __bytes__(self) -> bytes:
        return b""

    def __hash__(self) -> int:
        return id(self)

    def __bool__(self) -> bool:
        frame = sys._getframe(1)
        place = (frame.f_code, frame.f_lasti)
        _answers[place] += 1
        return not other_way and _answers[place] <= _PATIENCE

    # Called and subclassed -----------------------------------------------------------------------
    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        if len(args) == 1 and not kwargs and isinstance(args[0], type):
            return args[0]  # a decorated class
        if len(args) == 1 and not kwargs and isinstance(args[0], types.FunctionType):
            return Decorated(args[0])
        return make(f"{self._path}()")

    def __mro_entries__(self, bases: tuple[Any, ...]) -> tuple[type, ...]:
        if node_class := _known_base(self._path):
            return (node_class,)
        seen = [base for base in bases if isinstance(base, Unknown)]
        real = [base for base in bases if isinstance(base, type) and issubclass(base, UnknownBase)]
        return (UnknownBase,) if seen and seen[0] is self and not real else ()

    def __instancecheck__(self, instance: object) -> bool:
        return False

    def __subclasscheck__(self, subclass: type) -> bool:
        return False

    # A container ---------------------------------------------------------------------------------
    def __iter__(self) -> Iterator[Any]:
        count = unpacked_by(sys._getframe(1))
        return iter([make(f"{self._path}[{index}]") for index in range(count or 0)])

    def __next__(self) -> Any:
        raise StopIteration

    def __reversed__(self) -> Iterator[Any]:
        return iter(())

    def __len__(self) -> int:
        return 0

    def __contains__(self, item: object) -> bool:
        return False

    def __getitem__(self, item: Any) -> Any:
        return make(f"{self._path}[]")

    def __setitem__(self, item: Any, value: Any) -> None:
        return None

    def __delitem__(self, item: Any) -> None:
        return None

    # Compared ------------------------------------------------------------------------------------
    def __eq__(self, other: object) -> bool:
        return self is other

    def __ne__(self, other: object) -> bool:
        return self is not other

    def __lt__(self, other: object) -> bool:
        return False

    __le__ = __gt__ = __ge__ = __lt__

    # A number ------------------------------------------------------------------------------------
    def __int__(self) -> int:
        return _NUMBER

    def __index__(self) -> int:
        return 1

    def __float__(self) -> float:
        return float(_NUMBER)

    def __complex__(self) -> complex:
        return complex(_NUMBER)

    def __round__(self, digits: int | None = None) -> Any:
        return self

    def __trunc__(self) -> int:
        return _NUMBER

    __floor__ = __ceil__ = __trunc__

    # Waited for ----------------------------------------------------------------------------------
    def __enter__(self) -> Any:
        return self

    def __exit__(self, *exc: object) -> bool:
        return False

    async def __aenter__(self) -> Any:
        return self

    async def __aexit__(self, *exc: object) -> bool:
        return False

    def __aiter__(self) -> Any:
        return self

    async def __anext__(self) -> Any:
        raise StopAsyncIteration

    def __await__(self) -> Iterator[Any]:
        return self
        yield  # a generator that ends at once

    # Pickled and copied --------------------------------------------------------------------------
    def __copy__(self) -> Any:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Any:
        return self

    def __reduce__(self) -> Any:
        return (make, (self._path,))


def _known_base(path: str) -> type | None:
    """rclpy's class for what a ROS library that is not installed calls `Node`: those derive from it."""
    module, _, name = path.rpartition(".")
    if "ros" in module.partition(".")[0] and name in ("Node", "LifecycleNode"):
        home = "rclpy.node" if name == "Node" else "rclpy.lifecycle"
        found: type | None = getattr(sys.modules.get(home), name, None)
        return found
    return None


class Decorated(Unknown):
    """A function under an unknown decorator: it still runs, given what the decorator would have added."""

    def __init__(self, function: types.FunctionType) -> None:
        super().__init__(function.__qualname__)
        self._known.update(__wrapped__=function)
        object.__setattr__(self, "__wrapped__", function)
        object.__setattr__(self, "__qualname__", function.__qualname__)
        object.__setattr__(self, "__name__", function.__name__)
        object.__setattr__(self, "__doc__", function.__doc__)
        object.__setattr__(self, "__module__", function.__module__)

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        function = object.__getattribute__(self, "__wrapped__")
        signature = inspect.signature(function)
        try:
            signature.bind(*args, **kwargs)
        except TypeError:
            given = signature.bind_partial(*args).arguments if len(args) <= len(signature.parameters) else {}
            for name, parameter in signature.parameters.items():
                plain = parameter.kind not in (parameter.VAR_POSITIONAL, parameter.VAR_KEYWORD)
                if plain and parameter.default is parameter.empty and name not in given and name not in kwargs:
                    kwargs[name] = Unknown(f"argument {name}")
        return function(*args, **kwargs)

    def __get__(self, instance: object, owner: type | None = None) -> Any:
        return self if instance is None else types.MethodType(self, instance)


class VaryingInt(int):
    """A number that is another in each run; as text it is unknown."""

    def __str__(self) -> str:
        return f"{OPEN}varying{CLOSE}"

    __repr__ = __str__

    def __format__(self, spec: str) -> str:
        return str(self)


def _operator(name: str) -> Any:
    def apply(self: Unknown, *others: Any) -> Any:
        # Text joined with an unknown value stays text, so that a name built from it is still a string.
        if name in ("__add__", "__radd__") and others and isinstance(others[0], str):
            return repr(self) + others[0] if name == "__add__" else others[0] + repr(self)
        return make(f"{self._path}")

    return apply


for _name in (
    "add",
    "sub",
    "mul",
    "truediv",
    "floordiv",
    "mod",
    "pow",
    "matmul",
    "and",
    "or",
    "xor",
    "lshift",
    "rshift",
    "divmod",
):
    setattr(Unknown, f"__{_name}__", _operator(f"__{_name}__"))
    setattr(Unknown, f"__r{_name}__", _operator(f"__r{_name}__"))
for _name in ("neg", "pos", "abs", "invert"):
    setattr(Unknown, f"__{_name}__", _operator(f"__{_name}__"))
