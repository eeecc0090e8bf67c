"""What includes hand over, and who reads it after them: an include is not scoped.

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


class GivenArguments:
    """What includes have set last, by the name of the launch configuration; ``read_on`` gets the places of what is read
    after them, by those where the values are written."""

    def __init__(self, read_on: dict[Place, Place]) -> None:
        self._given: dict[str, _Given] = {}
        self._read_on = read_on

    def note(self, name: str, value: Value, place: Place, file: str, include: Place) -> None:
        """An include in a file gives an argument a value; ``place`` is where that is written."""
        self._given[name] = _Given(value, place, file, include)

    def note_read(self, name: str, value: Value | None, file: str, action: Place) -> None:
        """An action of a file reads a value, perhaps one that an include in front of it has set there."""
        given = self._given.get(name)
        if given is not None and given.value is value and given.file == file and given.include != action:
            self._read_on.setdefault(given.place, action)
