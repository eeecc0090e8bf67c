"""What attributes may hold when a method runs that nothing here is seen to call.

Code that is not followed (a user interface, an event loop, another package) may call it at any time.  What the
program leaves in an attribute at last is then only one of the values that the classes give it: ``self.running`` is
true before somebody calls ``stop()``.
"""

from __future__ import annotations

from archlint.interpreter.changing import changed_attributes
from archlint.interpreter.heap import Layer
from archlint.interpreter.values import Value, one_of
from archlint.libraries.run import Run
from archlint.programs.left_behind import is_plain


def attributes_at_any_time(run: Run) -> Layer:
    """What the plain attributes of the program's objects may hold, where a method gives them another value."""
    layer: Layer = {}
    changed: dict[int, dict[str, tuple[Value, ...]]] = {}
    for instance in run.instances.values():
        cls = instance.own_class
        if cls is None:
            continue
        if cls.key not in changed:
            changed[cls.key] = changed_attributes(cls)
        for name, others in changed[cls.key].items():
            value = run.store.get(instance.key, name)
            if value is not None and is_plain(run, value):
                joined = one_of([value, *others])
                if joined != value:
                    layer[(instance.key, name)] = joined
    return layer
