"""The DDS domains that a launch file puts processes into: nodes of different domains do not see each other."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.interpreter.values import Value


class Domains:
    """What ``ROS_DOMAIN_ID`` is set to in one launch."""

    def __init__(self) -> None:
        self._unknown: list[Value] = []

    def named(self, value: Value) -> str:
        """The number of a domain, or a name for one that is not known: the same only where it is the same value."""
        text = known_text(value)
        if text is not None:
            return text
        if not any(value is other for other in self._unknown):
            self._unknown.append(value)
        return f"?{next(number for number, other in enumerate(self._unknown) if other is value)}"
