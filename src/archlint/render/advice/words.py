"""What is said of a connection in all formats for people."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.advice.model import Use

if TYPE_CHECKING:
    from archlint.advice.model import Advice

TITLES: tuple[tuple[bool | None, str], ...] = (
    (False, "something else fits better"),
    (True, "fits"),
    (None, "not known"),
)
"""The sections, by :attr:`Advice.is_fitting`."""
_ARTICLES = {"action": "an action"}


def used_words(advice: Advice) -> str:
    """``used as a stream, 10 Hz``."""
    if advice.judged.use == Use.UNKNOWN:
        return "how it is used is not known"
    rate = "" if advice.judged.rate is None else f", {advice.judged.rate:.3g} Hz"
    return f"used as a {advice.judged.use}{rate}"


def verdict(advice: Advice) -> str:
    """Whether its kind fits, and why."""
    fits, reason = advice.judged.fits, advice.judged.reason
    if fits is None:
        return reason
    kind = _ARTICLES.get(fits, f"a {fits}")
    return f"{kind} {'fits' if advice.is_fitting else 'fits better'}: {reason}"


def of_section(rows: Sequence[Advice], fitting: bool | None) -> list[Advice]:
    return [advice for advice in rows if advice.is_fitting is fitting]


__all__ = ["TITLES", "of_section", "used_words", "verdict"]
