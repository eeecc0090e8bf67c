"""Frozen dataclasses that are quick to make, for what a run makes by the million.

The ``__init__`` of a frozen dataclass goes through ``object.__setattr__`` for each field, which takes several times as
long as an assignment.  Type checkers see ``dataclasses.dataclass`` here, so that they refuse to write a field; at run
time nothing does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:
    import dataclasses
    from collections.abc import Callable

    def dataclass(*, frozen: bool, slots: bool = False, eq: bool = True, order: bool = False) -> Callable[[type], type]:
        """A frozen dataclass: equal and hashed by its fields, where the class itself does not say how."""
        assert frozen

        def decorate(cls: type) -> type:
            by_fields = eq and vars(cls).get("__hash__") is None
            return dataclasses.dataclass(slots=slots, eq=eq, order=order, unsafe_hash=by_fields)(cls)

        return decorate


__all__ = ["dataclass"]
