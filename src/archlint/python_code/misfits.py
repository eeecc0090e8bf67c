"""Whether the arguments of a call fit the parameters of a function."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.model import Misuse
from archlint.records import dataclass
from archlint.syntax import facts


@dataclass(frozen=True)
class OwnCall:
    """A call of which all arguments are written out."""

    name: str
    """What is called, as it is written."""
    span: facts.Span
    cls: int | None
    """For a method of ``self``: the class that the method around it is of, by its position in the file."""
    given: int
    """How many arguments are given by position."""
    keywords: tuple[str, ...]
    within: int | None = None
    """The class in a method of which with ``self`` it stands, by its position in the file."""


@dataclass(frozen=True)
class Misfit:
    """What is wrong with the arguments of a call: the parameters it is about, how many it takes by position, and what
    is ``missing`` beside unknown keywords."""

    misuse: Misuse
    parameters: tuple[str, ...] = ()
    takes: int = 0
    missing: tuple[str, ...] = ()


def misfit_of(params: Sequence[facts.Param], call: OwnCall) -> Misfit | None:
    """What is wrong with the arguments of a call for such parameters; None where nothing is."""
    by_position = by_position_of(params)
    by_name = {param.name for param in params if param.kind in ("normal", "keyword_only")}
    kinds = {param.kind for param in params}
    if call.given > len(by_position) and "star" not in kinds:
        return Misfit(Misuse.TOO_MANY, takes=len(by_position))
    unknown = tuple(name for name in call.keywords if name not in by_name)
    filled = {*by_position[: call.given], *call.keywords}
    missing = tuple(name for name in needed_of(params) if name not in filled)
    if unknown and "double_star" not in kinds:
        return Misfit(Misuse.UNKNOWN_KEYWORD, unknown, missing=missing)
    twice = tuple(name for name in call.keywords if name in by_position[: call.given])
    if twice:
        return Misfit(Misuse.TWICE, twice)
    return Misfit(Misuse.MISSING, missing) if missing else None


def by_position_of(params: Sequence[facts.Param]) -> list[str]:
    return [param.name for param in params if param.kind in ("positional_only", "normal")]


def needed_of(params: Sequence[facts.Param]) -> Iterator[str]:
    """The parameters that may not be left out."""
    for param in params:
        if param.default is None and param.kind in ("positional_only", "normal", "keyword_only"):
            yield param.name


__all__ = ["Misfit", "OwnCall", "by_position_of", "misfit_of", "needed_of"]
