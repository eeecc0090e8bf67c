"""Where things stand on a page."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import pytest

from archlint.render import drawing
from archlint.render.page import places
from archlint.render.page.places import Drawing, Line, Shape, place

LESSON = [Shape(True, ("/talker",), ""), Shape(False, ("/chatter", "String"), ""), Shape(True, ("/listener",), "")]
BOTH = [Line(0, 1), Line(1, 2)]
BETWEEN = 0.22 * 72
"""Pixels between shapes of one column."""


def laid_out(shapes: Sequence[Shape], lines: Sequence[Line]) -> Drawing:
    found = place(shapes, lines)
    assert found is not None
    return found


def groups_of(many: int) -> list[Shape]:
    return [Shape(True, (f"/arm{number % 4}/node{number}",), f"/arm{number % 4}") for number in range(many)]


def overlap(one: places.Box, other: places.Box) -> bool:
    apart = one[0] + one[2] <= other[0] or other[0] + other[2] <= one[0]
    return not apart and one[1] < other[1] + other[3] and other[1] < one[1] + one[3]


def test_data_run_from_left_to_right():
    talker, chatter, listener = laid_out(LESSON, BOTH).boxes
    assert talker[0] + talker[2] < chatter[0]
    assert chatter[0] + chatter[2] < listener[0]


def test_a_line_begins_and_ends_at_its_shapes():
    found = laid_out(LESSON, BOTH)
    for line, path in zip(BOTH, found.paths, strict=True):
        assert path is not None
        assert len(path) % 6 == 2, "a point, and three more for each piece of a curve"
        tail, head = found.boxes[line.tail], found.boxes[line.head]
        assert (path[0], path[-2]) == pytest.approx((tail[0] + tail[2], head[0]), abs=2)
        assert tail[1] <= path[1] <= tail[1] + tail[3]
        assert head[1] <= path[-1] <= head[1] + head[3]


def test_a_shape_is_wide_enough_for_its_longest_line():
    [short, long] = [Shape(False, ("/x", words), "").size for words in ("A", "AVeryLongTypeOfAMessage")]
    assert long[0] > short[0]
    assert long[1] == short[1]


@pytest.mark.parametrize("many", [40, places.AS_A_WHOLE + 20])
def test_nothing_lies_on_anything_else(many: int):
    lines = [Line(number, (number * 7 + 4) % many) for number in range(many)]
    boxes = laid_out(groups_of(many), lines).boxes
    assert not [pair for pair in combinations(boxes, 2) if overlap(*pair)]


def test_a_large_graph_has_its_groups_in_rows_and_leaves_the_lines_in_between_to_the_page():
    many = places.AS_A_WHOLE + 20
    found = laid_out(groups_of(many), [Line(0, 4), Line(0, 1)])
    assert found.paths[0] is not None
    assert found.paths[1] is None
    width = max(box[0] + box[2] for box in found.boxes)
    height = max(box[1] + box[3] for box in found.boxes)
    assert 0.3 < width / height < 5


def test_what_is_in_no_group_stands_in_rows_too():
    shapes = [*groups_of(200), *(Shape(False, (f"/topic{number}",), "") for number in range(100))]
    boxes = laid_out(shapes, []).boxes[200:]
    assert len({box[1] for box in boxes}) < 20
    assert len({box[0] for box in boxes}) > 5


def test_the_same_graph_has_the_same_places():
    many = places.AS_A_WHOLE + 1
    lines = [Line(number, (number * 5 + 8) % many) for number in range(many)]
    assert laid_out(groups_of(many), lines) == laid_out(groups_of(many), lines)


def test_without_graphviz_there_are_no_places(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(drawing.shutil, "which", lambda name: None)
    monkeypatch.setattr(drawing, "find_spec", lambda name: None)
    assert place(LESSON, BOTH) is None


def test_there_are_none_where_graphviz_fails_either(monkeypatch: pytest.MonkeyPatch):
    def fails(source: str, format: str) -> bytes:
        raise drawing.CannotDraw("it took too long")

    monkeypatch.setattr(places, "layout", fails)
    assert place(LESSON, BOTH) is None


def test_nothing_has_no_places():
    assert place([], []) is None


@pytest.mark.parametrize("outwards", [True, False])
def test_many_ends_of_one_node_are_no_long_column(outwards: bool):
    ends = [Shape(False, (f"/topic{number:02}", "String"), "") for number in range(30)]
    lines = [Line(0, number) if outwards else Line(number, 0) for number in range(1, 31)]
    boxes = laid_out([Shape(True, ("/talker",), ""), *ends], lines).boxes
    assert not [pair for pair in combinations(boxes, 2) if overlap(*pair)]
    assert len({round(box[0]) for box in boxes[1:]}) == 4
    bottom, top = max(box[1] + box[3] for box in boxes), min(box[1] for box in boxes)
    assert bottom - top < 0.85 * 30 * (ends[0].size[1] + BETWEEN)


def test_few_ends_are_one_column():
    ends = [Shape(False, (f"/topic{number}",), "") for number in range(8)]
    boxes = laid_out([Shape(True, ("/talker",), ""), *ends], [Line(0, number) for number in range(1, 9)]).boxes
    assert len({round(box[0]) for box in boxes[1:]}) == 1
