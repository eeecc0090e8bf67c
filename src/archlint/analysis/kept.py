"""What an analysis finds of a system or of its surroundings, worked out once and kept with it."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Protocol, TypeVar, cast

from archlint.syntax import facts


class Keeps(Protocol):
    """What keeps the results of analyses, by the analysis: a ``System`` or a ``WorkspaceIndex``."""

    @property
    def kept(self) -> dict[object, object]: ...


class HasFiles(Keeps, Protocol):
    """A ``WorkspaceIndex``: it also has the facts of files."""

    def facts_at(self, file: str) -> facts.Facts | None: ...


_Owner = TypeVar("_Owner", bound=Keeps)
_Result = TypeVar("_Result")


def once(analysis: Callable[[_Owner], _Result]) -> Callable[[_Owner], _Result]:
    """Keep what an analysis finds, for as long as what it is of lives."""

    @wraps(analysis)
    def of(owner: _Owner) -> _Result:
        if analysis not in owner.kept:
            owner.kept[analysis] = analysis(owner)
        return cast("_Result", owner.kept[analysis])

    return of


def once_for_each_file(analysis: Callable[[facts.Facts], _Result]) -> Callable[[HasFiles, str], _Result | None]:
    """As :func:`once`, of the facts of each file; None for a file that has none."""

    @wraps(analysis)
    def of(workspace: HasFiles, file: str) -> _Result | None:
        file_facts = workspace.facts_at(file)
        if file_facts is None:
            return None
        key = (analysis, file)
        if key not in workspace.kept:
            workspace.kept[key] = analysis(file_facts)
        return cast("_Result", workspace.kept[key])

    return of
