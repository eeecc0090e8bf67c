"""How many items a loop goes over, as the file itself shows."""

from __future__ import annotations

import textwrap

import pytest

from archlint.execution.collection_sizes import most_items
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from archlint.syntax.walk import statements_of


def items_of(source: str) -> int | None:
    """The most items of what the last loop goes over."""
    found = lower(textwrap.dedent(source))
    functions = [one for one in found.body if isinstance(one, facts.Function)]
    *_, loop = [one for part in (found, *functions) for one in statements_of(part.body, facts.For)]
    return most_items(loop.iterable, found)


@pytest.mark.parametrize(
    ("source", "items"),
    [
        ("for x in (1, 2, 3): pass", 3),
        ("for x in {'a': 1}: pass", 1),
        ("for x in []: pass", 0),
        ("for x in enumerate(['a', 'b']): pass", 2),
        ("sides = ['a', 'b']\nfor x in sides: pass", 2),
        ("sides: list = ['a', 'b']\nfor x in reversed(sides): pass", 2),
        ("SIDES = ['a', 'b']\ndef f():\n    for x in SIDES: pass", 2),
        ("self.sides = ['a']\nself.sides = ['a', 'b']\nfor x in self.sides: pass", 2),
        (
            "self.sides = {}\nself.sides['a'] = 1\nself.sides['b'] = 2\nself.sides['a'] = 3\nfor x in self.sides: pass",
            2,
        ),
        ("self.sides = {'a': 1}\nfor key, value in self.sides.items(): pass", 1),
        ("self.sides = ['a']\nprint(len(self.sides), self.sides)\nfor x in self.sides: pass", 1),
        ("self.sides = ['a']\nself.sides.clear()\nfor x in self.sides: pass", 1),
    ],
)
def test_what_the_file_fills(source: str, items: int) -> None:
    assert items_of(source) == items


@pytest.mark.parametrize(
    "source",
    [
        "for x in load(): pass",
        "for x in [1, *more]: pass",
        "for x in {**more}: pass",
        "for x in sides: pass",
        "sides = load()\nfor x in sides: pass",
        "sides = ['a']\nsides.append('b')\nfor x in sides: pass",
        "sides = ['a']\nsides += more\nfor x in sides: pass",
        "sides = ['a']\nfill(sides)\nfor x in sides: pass",
        "sides = ['a']\nother = sides\nother.append(1)\nfor x in sides: pass",
        "sides = {}\nsides[name] = 1\nfor x in sides: pass",
        "sides = ['a']\nsides, rest = split()\nfor x in sides: pass",
        "sides = ['a']\ndef f(sides):\n    for x in sides: pass",
        "sides = ['a']\nfor sides in more:\n    for x in sides: pass",
        "sides = ['a']\nwith more as sides:\n    for x in sides: pass",
        "self.sides = ['a']\ndef f():\n    return self.sides\nfor x in self.sides: pass",
    ],
)
def test_anything_else_may_fill_it(source: str) -> None:
    assert items_of(source) is None
