"""An enumeration whose members are the words that JSON has and messages print."""

from __future__ import annotations

from enum import Enum


class StringEnum(str, Enum):
    """``enum.StrEnum``, which Python 3.10 does not have: a member is printed, sorted and written as its value."""

    def __str__(self) -> str:
        return str(self.value)
