"""One run of archlint, top to bottom: find, compile, link, load, judge, suppress, sort."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.config import Settings
    from archlint.report.model import Report
    from archlint.system.model import System


class NothingToDo(Exception):
    """No file to look at; ``str()`` says where none was found."""


@dataclass(frozen=True)
class Request:
    """What is to be analysed and how.  ``paths`` exist; ``jobs`` None leaves the number of processes to us."""

    paths: tuple[str, ...]
    settings: Settings
    cached: bool = True
    jobs: int | None = None


def check(request: Request) -> Report:
    """Everything that the selected rules find, in order.  Raises :class:`NothingToDo`."""
    raise NotImplementedError


def graph(request: Request, everything: bool = False) -> System:
    """The system of all nodes, for drawing.  Raises :class:`NothingToDo`."""
    raise NotImplementedError
