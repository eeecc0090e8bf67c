"""Boxes of different sizes on one page, close together and in the shape of the page."""

from __future__ import annotations

from collections.abc import Sequence

from archlint.records import dataclass

Size = tuple[float, float]
Corner = tuple[float, float]
"""Left and top, counted from the upper left corner."""

PAGE = 2**0.5
"""Width by height of a sheet of paper that lies on its side."""
_TRIED = 24
"""Widths that are tried."""


@dataclass(frozen=True)
class Packed:
    corners: Sequence[Corner]
    width: float
    height: float


def packed(sizes: Sequence[Size], room: float) -> Packed:
    """The boxes, in their order, with at least ``room`` between them: each as far up as it goes, then to the left.

    Of several widths of the whole, the one is taken that the letters are largest with on a page.
    """
    if not sizes:
        return Packed((), 0, 0)
    least = max(width for width, _ in sizes)
    area = sum((width + room) * (height + room) for width, height in sizes)
    most = max(least, 1.5 * (area * PAGE) ** 0.5)
    widths = [least + (most - least) * step / _TRIED for step in range(_TRIED + 1)]
    return min((_in_width(sizes, width, room) for width in widths), key=_scale)


def _scale(page: Packed) -> float:
    return round(max(page.width / PAGE, page.height), 3)


def _in_width(sizes: Sequence[Size], limit: float, room: float) -> Packed:
    """What lies uppermost so far is kept from left to right, as steps: where each begins, and how far down it is."""
    steps: list[tuple[float, float]] = [(0.0, 0.0)]
    corners: list[Corner] = []
    for width, height in sizes:
        left, top = min(_seats(steps, width, limit), key=lambda seat: (seat[1], seat[0]))
        corners.append((left, top))
        steps = _covered(steps, left, left + width + room, top + height + room)
    right = max(left + width for (left, _), (width, _) in zip(corners, sizes, strict=True))
    bottom = max(top + height for (_, top), (_, height) in zip(corners, sizes, strict=True))
    return Packed(corners, right, bottom)


def _seats(steps: Sequence[tuple[float, float]], width: float, limit: float) -> list[Corner]:
    """Where a box of this width may go: at the left of each step, below all that it then covers."""
    seats = []
    for index, (left, _) in enumerate(steps):
        if left and left + width > limit + 0.01:
            break
        under = [top for start, top in steps[index:] if start < left + width]
        seats.append((left, max(under)))
    return seats


def _covered(
    steps: Sequence[tuple[float, float]], left: float, right: float, bottom: float
) -> list[tuple[float, float]]:
    before = [step for step in steps if step[0] < left]
    after = [step for step in steps if step[0] > right]
    edge = next(top for start, top in reversed(steps) if start <= right)
    return [*before, (left, bottom), (right, edge), *after]


__all__ = ["PAGE", "Packed", "packed"]
