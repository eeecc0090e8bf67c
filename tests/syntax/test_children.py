"""The facts that a fact is made of: all of them, in the order of the source."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.python.lowering import lower

ROOT = Path(__file__).parents[2]
FILES = [file for file in sorted((ROOT / "fixtures" / "forms").rglob("*.py")) if file.stat().st_size > 1000]


def every_child(fact: facts.Base) -> list[facts.Base]:
    """What its fields hold, whatever their types say."""
    values = [getattr(fact, name) for name in fact.__struct_fields__]
    lists = [value if isinstance(value, list) else [value] for value in values]
    return [item for row in lists for item in row if isinstance(item, facts.Base)]


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_no_child_is_left_out(file: Path):
    found = lower(file.read_text("utf-8"))
    for piece in everything_in(found):
        assert [id(child) for child in piece.children()] == [id(child) for child in every_child(piece)]


def test_the_children_of_a_call():
    [statement] = lower("publish(message, to=topic, *rest)\n").body
    call = statement.children()[0]
    assert [child.variable for child in call.children()[:1]] == ["publish"]
    assert [argument.children()[0].variable for argument in call.children()[1:]] == ["message", "topic", "rest"]
