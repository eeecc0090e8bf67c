"""Collections that start empty and grow while the program runs.

``self.items = {}`` in a constructor says nothing of what a callback finds there, if some method fills it.  When the
callbacks begin, such a collection holds what is not known: loops over it are judged once, both ways of a test are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from archlint.interpreter.values import ENTRIES, ITEMS, ClassValue, Entries, Items, Value, alternatives
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

_FILLS = frozenset({"append", "appendleft", "add", "extend", "insert", "update", "setdefault"})
_EMPTY_CALLS = frozenset({"dict", "list", "set", "deque", "defaultdict", "OrderedDict"})


def open_up(machine: Machine) -> None:
    """Forget that collections are empty which objects keep and methods of theirs fill, once for each."""
    for instance in list(machine.instances.values()):
        cls = instance.own_class
        if cls is not None and instance.key not in machine.opened:
            machine.opened.add(instance.key)
            for name in _filled_of(cls) & machine.store.holds(instance.key).keys():
                value = machine.store.get(instance.key, name)
                if value is not None:
                    _open(machine, value)


def may_be_filled(machine: Machine, values: Iterable[Value]) -> None:
    """Forget that collections are empty which are given to a function that is not followed: it may fill them."""
    for value in values:
        _open(machine, value)


def _open(machine: Machine, value: Value) -> None:
    for option in alternatives(value):
        key = option.heap_key or 0
        items, entries = machine.store.get(key, ITEMS), machine.store.get(key, ENTRIES)
        if items is not None and not items.size:
            machine.store.set(key, ITEMS, Items((), True))
        if entries is not None and not entries.size:
            machine.store.set(key, ENTRIES, Entries({}, True))


def _filled_of(cls: ClassValue) -> frozenset[str]:
    """The attributes that methods other than constructors fill, of a class and of those it derives from."""
    return frozenset().union(*(_filled(Itself(base.ir)) for base in cls.classes))


@lru_cache(maxsize=4096)
def _filled(key: Itself[facts.Class]) -> frozenset[str]:
    methods = (method for method in key.fact.body if isinstance(method, facts.Function) and method.name != "__init__")
    return frozenset(name for method in methods for part in everything_in(method) for name in _fills(part) if name)


def _fills(part: object) -> Iterator[str]:
    """The attributes that a statement or a call puts something into; empty of what is none."""
    match part:
        case facts.Assign():
            for target in part.targets:
                if isinstance(target, facts.Subscript):
                    yield target.value.attribute
                elif not _is_empty(part.value):
                    yield target.attribute
        case facts.Augmented():
            yield part.target.attribute
        case facts.Call(func=facts.Attribute(value=facts.Subscript(value=filled), attr=name)) if name in _FILLS:
            yield filled.attribute
        case facts.Call(func=facts.Attribute(value=filled, attr=name)) if name in _FILLS:
            yield filled.attribute


def _is_empty(value: facts.Expr) -> bool:
    """Whether an expression makes an empty collection."""
    match value:
        case facts.Sequence():
            return not value.elements
        case facts.Mapping():
            return not value.keys
        case facts.Call():
            return value.func.last_name in _EMPTY_CALLS
        case facts.Literal():
            return value.value is None
    return False
