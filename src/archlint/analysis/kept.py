"""What an analysis finds of a system or of its surroundings, worked out once and kept with it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, wraps
from typing import Any, Protocol, TypeVar, cast, get_type_hints

from archlint.syntax import facts
from archlint.syntax.parts import once_for
from archlint.syntax.summaries import Summaries


class Keeps(Protocol):
    """What keeps the results of analyses, by the analysis: a ``System`` or a ``WorkspaceIndex``."""

    @property
    def kept(self) -> dict[object, object]: ...


class HasFiles(Keeps, Protocol):
    """A ``WorkspaceIndex``: it also has the facts of files."""

    def facts_at(self, file: str) -> facts.Facts | None: ...
    @property
    def summaries(self) -> Summaries: ...


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


def kept_for_each_file(analysis: Callable[[facts.Facts], _Result]) -> Callable[[HasFiles, str], _Result | None]:
    """As :func:`once_for_each_file`, and kept for the next run with the facts: what it finds is data with no fact in
    it."""
    return wraps(analysis)(kept_as(name_of(analysis), cache(lambda: result_type(analysis)), analysis))


def kept_as(
    name: str, kind: Callable[[], Any], analysis: Callable[[facts.Facts], _Result]
) -> Callable[[HasFiles, str], _Result | None]:
    """The same under a name, for an analysis that finds something of a type ``kind``."""
    known = once_for_each_file(analysis)
    or_nothing = cache(lambda: kind() | None)

    def of(workspace: HasFiles, file: str) -> _Result | None:
        return workspace.summaries.of(file, name, or_nothing(), lambda: known(workspace, file))

    analyses.of_files.append(of)
    return of


class Analyses:
    """All analyses whose findings are kept with the facts of a file, from the moment they are defined."""

    def __init__(self) -> None:
        self.of_files: list[Callable[[HasFiles, str], object]] = []

    def say_all(self, workspace: HasFiles, file: str) -> None:
        """Have all of them look at a file."""
        for analysis in self.of_files:
            analysis(workspace, file)


analyses = Analyses()


def kept_for_few_files(
    analysis: Callable[[facts.Facts], Sequence[_Result]],
) -> Callable[[HasFiles, str], Sequence[_Result]]:
    """As :func:`once_for_each_file`, for what few files have, be it facts: whether there is anything is kept for the
    next run."""
    known = once_for(analysis)
    has_any = kept_as(name_of(analysis), lambda: bool, lambda code: bool(known(code)))

    @wraps(analysis)
    def of(workspace: HasFiles, file: str) -> Sequence[_Result]:
        code = workspace.facts_at(file) if has_any(workspace, file) else None
        return () if code is None else known(code)

    return of


def name_of(analysis: Callable[..., object]) -> str:
    """By which what an analysis finds is kept."""
    return f"{analysis.__module__}.{analysis.__qualname__}"


def result_type(analysis: Callable[..., object]) -> Any:
    """What an analysis finds."""
    return get_type_hints(analysis)["return"]
