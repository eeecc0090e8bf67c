"""What attributes may hold when a method runs that nothing here is seen to call, and after a spin that ends.

Code that is not followed (a user interface, an event loop, another package) may call a method at any time.  What the
program leaves in an attribute at last is then only one of the values that the classes give it: ``self.running`` is
true before somebody calls ``stop()``.  A text or a number that an attribute starts with may only be there until a
method has read the real one, though: a name that is made of it would be a guess.  While a spin lasts, callbacks run:
``node.answer`` is None before it, and may be anything after it that a method puts there.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import compress, count, islice
from operator import is_not

from archlint.interpreter.changing import CHANGED, Changes, changed_attributes
from archlint.interpreter.heap import Layer
from archlint.interpreter.values import TOO_MANY, Known, OneOf, Unknown, Value, alternatives, one_of
from archlint.libraries.run import Run
from archlint.libraries.state import ChangedAttributes
from archlint.programs.left_behind import is_plain


def attributes_at_any_time(run: Run) -> Layer:
    """What the plain attributes of the program's objects may hold, where a method gives them another value.

    This is asked for each method, and most attributes hold from one to the next what they held: the last answer is
    kept for as long as they do.
    """
    attributes = _attributes(run)
    values = run.store.values_at(attributes.slots)
    changed = [*compress(count(), map(is_not, values, attributes.values))]
    attributes.values = values
    for number in changed:
        attributes.options[number] = _options(values[number], attributes.changes[number])
    if changed:
        rows = zip(attributes.slots, attributes.options, strict=True)
        attributes.changing = [(at, options) for at, options in rows if options is not None]
    # Each method has an object of its own: the same one would count as unchanged where branches are joined.
    return {at: _one_of_its_own(options) for at, options in attributes.changing}


def _one_of_its_own(options: tuple[Value, ...]) -> Value:
    if len(options) > 1:
        return OneOf(options)
    return Unknown(CHANGED if options else TOO_MANY)


def let_attributes_change(run: Run) -> None:
    """After a spin that ends: callbacks may have run, or not, and left another value in what methods change."""
    for (key, slot), value in attributes_at_any_time(run).items():
        before = run.store.get(key, slot) if isinstance(slot, str) else None
        if isinstance(slot, str) and isinstance(value, Value) and before is not None:
            run.store.set(key, slot, one_of([before, value]))


def _attributes(run: Run) -> ChangedAttributes:
    """The attributes of the program's objects that methods change, in the order in which the objects were made."""
    known, instances = run.callbacks.changed_attributes, run.instances
    for instance in islice(instances.values(), known.seen_instances, None):
        cls = instance.own_class
        if cls is not None:
            for name, changes in changed_attributes(run, cls).items():
                known.add((instance.key, name), changes)
    known.seen_instances = len(instances)
    return known


def _options(value: Value | None, changes: Changes) -> tuple[Value, ...] | None:
    """What an attribute may hold beside its value, with that; empty where that is too much to say, None where it holds
    no other."""
    if value is None or not is_plain(value):
        return None
    joined = one_of(_without_first(value, changes))
    if joined == value:
        return None
    if isinstance(joined, Unknown):
        return () if joined.reason == TOO_MANY else (joined,)
    return joined.values if isinstance(joined, OneOf) else ()


def _without_first(value: Value, changes: Changes) -> Iterator[Value]:
    """What an attribute may hold, without the text or number that it starts with if a method puts there what is not
    written in the code."""
    replaced = any(isinstance(other, Unknown) for other in changes.later)
    for option in (*alternatives(value), *changes.first, *changes.later):
        is_first = option in changes.first and option not in changes.later
        yield Unknown(CHANGED) if replaced and is_first and _is_content(option) else option


def _is_content(value: Value) -> bool:
    """Whether a value is a text or a number, which names and calls are made of, and no flag that a test asks."""
    return isinstance(value, Known) and not isinstance(value.value, (bool, type(None)))
