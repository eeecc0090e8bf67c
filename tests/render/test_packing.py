"""Parts of a picture on a page: none over another, little white, and the same wherever they come from."""

from __future__ import annotations

from itertools import combinations

import pytest

from archlint.render.arranging import ROOM
from archlint.render.packing import PAGE, Size, packed

MANY = [(400.0, 250.0), *[(90.0, 40.0 + 7 * number) for number in range(6)], *[(120.0, 30.0)] * 12, (60.0, 200.0)]


def apart(sizes: list[Size], room: float) -> bool:
    boxes = [(*corner, *size) for corner, size in zip(packed(sizes, room).corners, sizes, strict=True)]
    return all(
        first[0] + first[2] + room <= other[0] + 0.01
        or other[0] + other[2] + room <= first[0] + 0.01
        or first[1] + first[3] + room <= other[1] + 0.01
        or other[1] + other[3] + room <= first[1] + 0.01
        for first, other in combinations(boxes, 2)
    )


@pytest.mark.parametrize("sizes", [MANY, MANY[::-1], [(10.0, 10.0)] * 40, [(900.0, 20.0), (20.0, 900.0)]], ids=len)
def test_there_is_room_between_all(sizes: list[Size]) -> None:
    assert apart(sizes, ROOM)


def test_a_page_is_filled() -> None:
    made = packed(MANY, ROOM)
    used = sum((width + ROOM) * (height + ROOM) for width, height in MANY)
    assert used / (made.width * made.height) > 0.75
    assert 0.7 < made.width / made.height / PAGE < 1.4


def test_what_is_wider_than_a_page_has_the_rest_below() -> None:
    made = packed([(1000.0, 100.0), (300.0, 100.0), (300.0, 100.0)], 10)
    assert made.corners == [(0.0, 0.0), (0.0, 110.0), (310.0, 110.0)]


def test_nothing_and_one() -> None:
    assert packed([], 10).corners == ()
    assert packed([(30.0, 20.0)], 10).corners == [(0.0, 0.0)]
