"""Which launch argument a value comes from, however often it is passed on under other names."""

from __future__ import annotations

from archlint.interpreter.values import Known, Value

AGAIN = "#"
"""Between the name of a configuration and a number, where it has had other values before."""


class ArgumentNames:
    """Names for the values that nothing decides: the same value has one name, two values never share one."""

    def __init__(self) -> None:
        self._names: dict[int, tuple[Value, str]] = {}  # the value is kept: its id is then its own
        self._used: dict[str, int] = {}
        self._numbers: dict[int, tuple[Value, int]] = {}

    def behind(self, name: str, value: Value | None) -> str:
        """The name under which the value of a configuration was met first."""
        if value is None or isinstance(value, Known):
            return name
        first_name = self.of(value)
        if first_name is None:
            number = self._used[name] = self._used.get(name, 0) + 1
            first_name = name if number == 1 else f"{name}{AGAIN}{number}"
            self._names[id(value)] = (value, first_name)
        return first_name

    def of(self, value: Value) -> str | None:
        """The name of a value that a configuration has held."""
        row = self._names.get(id(value))
        return None if row is None else row[1]

    def number(self, value: Value) -> int:
        """A number of its own for each object."""
        return self._numbers.setdefault(id(value), (value, len(self._numbers)))[1]
