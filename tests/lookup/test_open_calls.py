"""What is open where somebody types."""

from __future__ import annotations

import pytest

from archlint.lookup.open_calls import typing_at


def opened(before: str) -> tuple[list[str], str, bool] | None:
    typing = typing_at(before)
    if typing is None:
        return None
    rows = [f"{each.callee}{each.bracket}{each.keyword or each.number}" for each in typing.opened]
    return rows, typing.typed, typing.in_text


@pytest.mark.parametrize(
    ("before", "expected"),
    [
        ("self.create_client(Trigger, 're", (["self.create_client(1"], "re", True)),
        ("create_client(srv_name='re", (["create_client(srv_name"], "re", True)),
        ("f(a, b == c, [g(1, 2), {'k': x", (["f(2", "[1", "{0"], "x", False)),
        ("f('a(b', \"c,d\", # e(\n'h", (["f(2"], "h", True)),
        ("f('it\\'s', 'x", (["f(1"], "x", True)),
        ("f('''\n(''', x", (["f(1"], "x", False)),
        ("f(a  # , (", None),
        ('def f():\n    """says (', None),
        ("broken((\ndef f():\n    g(x", (["g(0"], "x", False)),
        ("f('unclosed\ng(h", (["f(0", "g(0"], "h", False)),
        ("", ([], "", False)),
    ],
)
def test_brackets_and_texts(before: str, expected: tuple[list[str], str, bool] | None):
    assert opened(before) == expected


def test_a_text_with_holes_is_told_apart():
    plain, holes = typing_at("f('a"), typing_at("f(f'a")
    assert plain is not None and plain.is_plain
    assert holes is not None and not holes.is_plain
