"""What is passed to includes, and who reads it after them: an include is not scoped.

Source: launch, ``IncludeLaunchDescription.execute`` sets each argument in the context of the including file.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.interpreter.values import Value


class _Given(NamedTuple):
    value: Value
    place: Place
    file: str
    include: Place
    was_set: bool


class GivenArguments:
    """What includes have set last, by the name of the launch configuration; ``read_on`` gets the places of what is read
    after them, by those where the values are written.  ``set_by_includes`` gets files, each with a configuration that
    only its includes give a value and that it reads after them: that is what they are for."""

    def __init__(self, read_on: dict[Place, Place], set_by_includes: set[tuple[str, str]]) -> None:
        self._given: dict[str, _Given] = {}
        self._read_on = read_on
        self._set_by_includes = set_by_includes

    def note(self, name: str, value: Value, place: Place, file: str, include: Place, before: Value | None) -> None:
        """An include in a file gives an argument a value; ``place`` is where that is written, ``before`` the value of
        the configuration in front of it."""
        last = self._given.get(name)
        was_set = last.was_set if last is not None and last.value is before else before is not None
        self._given[name] = _Given(value, place, file, include, was_set)

    def note_read(self, name: str, value: Value | None, file: str, action: Place) -> None:
        """An action of a file reads a value, perhaps one that an include in front of it has set there."""
        given = self._given.get(name)
        if given is None or given.value is not value or given.file != file or given.include == action:
            return
        if given.was_set:
            self._read_on.setdefault(given.place, action)
        else:
            self._set_by_includes.add((file, name))
