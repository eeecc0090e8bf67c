"""What an analysis finds of a system or of its surroundings, worked out once and kept with it."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Protocol, TypeVar, cast

from archlint.syntax import facts
from archlint.syntax.parts import once_for


class Keeps(Protocol):
    """What keeps the results of analyses, by the analysis: a ``System`` or a ``WorkspaceIndex``."""

    @property
    def kept(self) -> dict[object, object]: ...


class HasFiles(Keeps, Protocol):
    """A ``WorkspaceIndex``: it also has the facts of files."""

    def facts_at(self, file: str) -> facts.Facts | None: ...


_Owner = TypeVar("_Owner", bound=Keeps)
_Result = TypeVar("_Result")


def kept(owner: Keeps, key: object, work: Callable[[], _Result]) -> _Result:
    """What is kept under a key, which says which analysis and of what; ``work`` is done where nothing is yet."""
    if key not in owner.kept:
        owner.kept[key] = work()
    return cast("_Result", owner.kept[key])


def once(analysis: Callable[[_Owner], _Result]) -> Callable[[_Owner], _Result]:
    """Keep what an analysis finds, for as long as what it is of lives."""

    @wraps(analysis)
    def of(owner: _Owner) -> _Result:
        return kept(owner, analysis, lambda: analysis(owner))

    return of


def once_for_each_file(analysis: Callable[[facts.Facts], _Result]) -> Callable[[HasFiles, str], _Result | None]:
    """As :func:`once`, of the facts of each file; None for a file that has none.  It says nothing else of the file than
    its facts do, so that a later run that has the same facts in memory asks for nothing again."""
    known = once_for(analysis)

    @wraps(analysis)
    def of(workspace: HasFiles, file: str) -> _Result | None:
        file_facts = workspace.facts_at(file)
        return None if file_facts is None else known(file_facts)

    return of
