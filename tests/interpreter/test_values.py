"""What can be known of a value."""

from __future__ import annotations

from archlint.interpreter.values import ALTERNATIVES, Known, Unknown, join_texts, one_of


class Counted(Known):
    """A constant that counts how often it is compared."""

    compared = 0

    def __eq__(self, other: object) -> bool:
        Counted.compared += 1
        return super().__eq__(other)

    __hash__ = Known.__hash__


def test_choosing_among_thousands_compares_as_many_as_are_kept():
    Counted.compared = 0
    assert isinstance(one_of([Counted(number) for number in range(4_000)]), Unknown)
    assert Counted.compared <= (ALTERNATIVES + 2) ** 2


def test_of_what_is_not_known_the_first_reason_stays():
    unknowns = [Unknown(f"reason {number}") for number in range(50)]
    found = one_of([Known(1), *unknowns, Known(2), Known(1)])
    assert found == one_of([Known(1), unknowns[0], Known(2)])


def test_a_text_too_long_is_never_put_together():
    assert join_texts([Known("a" * 9_000)] * 2_000) == Unknown("a text too long to follow")
    assert join_texts([Known("a"), Known(""), Known("b")]) == Known("ab")
    unknown = Unknown("data")
    assert join_texts([Known(""), unknown, Known(""), unknown]) == unknown
