"""What attributes may hold when a method runs that nothing here is seen to call.

Code that is not followed (a user interface, an event loop, another package) may call it at any time.  What the
program leaves in an attribute at last is then only one of the values that the classes give it: ``self.running`` is
true before somebody calls ``stop()``.
"""

from __future__ import annotations

from archlint.interpreter.changing import changed_attributes
from archlint.interpreter.heap import Layer
from archlint.interpreter.values import ClassValue, OneOf, Unknown, Value, one_of
from archlint.libraries.run import Run
from archlint.programs.left_behind import is_plain


def attributes_at_any_time(run: Run) -> Layer:
    """What the plain attributes of the program's objects may hold, where a method gives them another value."""
    layer: Layer = {}
    for instance in run.instances.values():
        cls = instance.own_class
        if cls is not None:
            for name, others in _changed_by(run, cls).items():
                value = run.store.get(instance.key, name)
                joined = None if value is None else _joined(run, (instance.key, name), value, others)
                if joined is not None:
                    layer[(instance.key, name)] = joined
    return layer


def _changed_by(run: Run, cls: ClassValue) -> dict[str, tuple[Value, ...]]:
    changed = run.callbacks.changed_attributes
    if cls.key not in changed:
        changed[cls.key] = changed_attributes(cls)
    return changed[cls.key]


def _joined(run: Run, at: tuple[int, str], value: Value, others: tuple[Value, ...]) -> Value | None:
    """What an attribute may hold beside its value; None where that is no more.  Most hold from one method to the next
    what they held, and this is asked for each method: the last answer is kept."""
    before, known = run.callbacks.at_any_time.get(at, (None, None))
    if before is not value:
        joined = one_of([value, *others]) if is_plain(value) else value
        known = None if joined == value else joined
        run.callbacks.at_any_time[at] = value, known
    # Each method has a value of its own: what is the same object counts as the same state where branches are joined.
    match known:
        case OneOf(values):
            return OneOf(values)
        case Unknown(reason):
            return Unknown(reason)
    return known
