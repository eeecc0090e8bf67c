"""What callbacks leave in attributes, and which callbacks have to run again for it.

The first time, each callback meets what the constructors left and what the callbacks before it did: ``self.state`` may
be a constant then that decides a test.  Where another callback leaves something else there, those that have read it
run again on the joined state, so that no live branch counts as dead.  Who has not read it would do the same again, and
who has begun later has met it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from archlint.interpreter.heap import Layer, Slot
from archlint.interpreter.repeats import is_older
from archlint.interpreter.values import (
    ClassValue,
    Entries,
    Instance,
    Items,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
)
from archlint.libraries.interest import MAKERS
from archlint.libraries.rclpy.callables import function_of
from archlint.libraries.rclpy.callback_arguments import GOAL_HANDLE
from archlint.libraries.values import EntityValue, ExecutorValue, NodeValue
from archlint.syntax import facts
from archlint.syntax.parts import Source, names_in
from archlint.workspace.kinds import is_cpp

if TYPE_CHECKING:
    from archlint.libraries.run import Run
from archlint.libraries.state import Left, Pending

Written = list[tuple[int, str, object, Value]]
"""Object, attribute, what it held before and what was left in it."""
News = dict[str, dict[int, set[Left]]]
"""By attribute, and by the key of the object."""


def written(run: Run, layer: Layer) -> Written:
    """What a callback wrote into attributes of the program's objects and into variables of modules."""
    modules = run.index.scopes
    return [
        (key, slot, run.store.get(key, slot), value)
        for (key, slot), value in layer.items()
        if isinstance(slot, str)
        if (key in run.instances or key in modules) and isinstance(value, Value)
    ]


def _doors(layer: Layer, oldest: int) -> frozenset[Slot]:
    """Where something that was there before a callback ran leads to what it has made, with keys from ``oldest`` on."""
    return frozenset(at for at, content in layer.items() if at[0] < oldest and not _is_older(content, oldest))


def _is_older(content: object, oldest: int) -> bool:
    """Whether a slot holds nothing that was made from the key ``oldest`` on; of what no code reaches nobody knows."""
    match content:
        case Items(values=values) | Entries(values=values):
            return all(is_older(value, oldest) for value in values)
        case Value():
            return is_older(content, oldest)
    return False


def note(run: Run, rows: Written, layer: Layer, pending: Pending, oldest: int) -> None:
    """Take note of the attributes that now hold what another callback may act on than the one that has just run.

    ``layer`` is all that this one has written, and ``oldest`` the first key of the objects that it has made."""
    after, within = run.callbacks.count, (*run.callbacks.within, *run.branch_arms)
    news = [(key, slot) for key, slot, before, value in rows if _is_news(run, before, value)]
    doors = _doors(layer, oldest) if any(key >= oldest for key, _ in news) else frozenset()
    for key, slot in news:
        is_own = key >= oldest
        row = Left(after, within, pending.began if is_own and not doors else 0, doors if is_own else frozenset())
        run.callbacks.news.setdefault(slot, {}).setdefault(key, set()).add(row)


def _is_news(run: Run, before: object, value: Value) -> bool:
    """Whether an attribute now holds an object to work with, or what may decide a test in another way than before."""
    earlier = alternatives(before) if isinstance(before, Value) else ()
    fresh = [option for option in alternatives(value) if not any(_alike(run, option, other) for other in earlier)]
    if any(_is_entity(option) for option in fresh):
        return True
    return bool(fresh) and not any(isinstance(option, Unknown) for option in earlier)


def _is_entity(value: Value) -> bool:
    entity = isinstance(value, (EntityValue, NodeValue, ExecutorValue))
    return entity or (isinstance(value, Instance) and value.cls == GOAL_HANDLE)


def _alike(run: Run, first: Value, second: Value) -> bool:
    """Whether no test distinguishes two values; each run of a callback makes messages and lists of its own."""
    if first == second or type(first) is not type(second):
        return first == second
    if isinstance(first, (Known, EntityValue, NodeValue, ExecutorValue)):
        return False
    if isinstance(first, Instance) and isinstance(second, Instance):
        return first.cls == second.cls and not first.is_member and not _is_entity(first)
    return True


def readers(run: Run, pending: Iterable[Pending], news: News) -> list[Pending]:
    """The callbacks that have not met what was left in an attribute that they have read, or of an object that they may
    find now.

    Of those in C++, only the ones that may add something to a node: what else they do there, no rule asks for.
    """
    left: dict[Slot, set[Left]] = {(key, slot): rows for slot, keys in news.items() for key, rows in keys.items()}
    leaking = {slot: {row for rows in keys.values() for row in rows if row.doors} for slot, keys in news.items()}
    leaking = {slot: rows for slot, rows in leaking.items() if rows}
    called = _functions(run)

    def concerns(each: Pending) -> bool:
        in_cpp = is_cpp(each.callback.file)
        used = _all_names(_code_of(run, each.value), called) if in_cpp or leaking else set()
        if in_cpp and MAKERS.isdisjoint(used):
            return False
        # Who finds an object has not asked it before: what counts is what the functions that it names read, and
        # whether it has read what leads there.
        findable = (
            row for slot in used & leaking.keys() for row in leaking[slot] if not each.read.isdisjoint(row.doors)
        )
        rows = chain(chain.from_iterable(left[at] for at in each.read & left.keys()), findable)
        return any(row.is_new_to(each) for row in rows)

    return [each for each in pending if concerns(each)]


def _code_of(run: Run, value: Value) -> facts.Function | facts.Lambda | None:
    function = function_of(run, value)
    return None if function is None else function.ir


def _functions(run: Run) -> dict[str, list[facts.Function]]:
    """The methods of the program's objects and the functions beside them, by name."""
    classes = {id(base): base for instance in run.instances.values() for base in _classes_of(instance)}
    bodies: dict[int, Sequence[facts.Stmt]] = {}
    for cls in classes.values():
        bodies[id(cls.ir)] = cls.ir.body
        bodies[id(cls.scope.module.facts)] = cls.scope.module.facts.body
    functions: dict[str, list[facts.Function]] = {}
    for body in bodies.values():
        for statement in body:
            if isinstance(statement, facts.Function):
                functions.setdefault(statement.name, []).append(statement)
    return functions


def _classes_of(instance: Instance) -> Iterator[ClassValue]:
    if isinstance(instance.cls, ClassValue):
        yield from (base for base in instance.cls.mro if isinstance(base, ClassValue))


def _all_names(function: Source, called: dict[str, list[facts.Function]]) -> set[str]:
    names: set[str] = set()
    rest = list(names_in(function))
    while rest:
        name = rest.pop()
        if name not in names:
            names.add(name)
            rest.extend(inner for callee in called.get(name, ()) for inner in names_in(callee))
    return names


def forget(run: Run, news: News) -> None:
    """What goes on changing, such as the state of a state machine, may be anything from now on."""
    after = run.callbacks.count
    for slot, keys in news.items():
        for key in sorted(keys):
            value = run.store.get(key, slot)
            if isinstance(value, (Known, OneOf, Instance)) and is_plain(value):
                run.store.set(key, slot, one_of([value, Unknown("callbacks change it")]))
                keys[key].add(Left(after))


def is_plain(value: Value) -> bool:
    """Whether a value is a constant or a member of an enumeration, or one of several."""
    return all(
        isinstance(option, Known) or (isinstance(option, Instance) and option.is_member)
        for option in alternatives(value)
    )
