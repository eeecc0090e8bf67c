"""A name that the code computes, as far as it is known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from archlint.origins import OriginKind
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place


Resolution = Literal["exact", "parameter", "partial", "unknown"]
"""How far a name is known: one text, that of a parameter, one with holes, or not at all."""


@dataclass(frozen=True)
class Text:
    """A string that the code computes: a name, as far as it is known.

    ``resolution`` is ``exact`` (one known text), ``parameter`` (``text`` is the default or override of the
    parameter called ``parameter``, or built from it), ``partial`` (``*`` in ``text`` stands for what only
    data decides) or ``unknown`` (``text`` is None).  ``reason`` says why for the last two.
    ``origin`` is where the text is written down, if it is written in one place, and ``origin_kind`` how it came to be.
    """

    text: str | None
    resolution: Resolution
    parameter: str | None = None
    reason: str | None = None
    origin: Place | None = None
    origin_kind: OriginKind = "other"
