"""Attributes that the objects of the workspace's own classes do not have when code reads them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place


@dataclass(frozen=True)
class AbsentRead:
    """A read of an attribute that no object there has at that time; whether the class never gives it is for the reader
    to find out."""

    place: Place
    name: str
    cls: Place
    """Where the name of their class is defined."""


__all__ = ["AbsentRead"]
