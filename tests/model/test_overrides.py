"""What a program asks of its overrides, and with which others it would do the same."""

from __future__ import annotations

import pytest

from archlint.model import Asked, Overrides

NODE = (None, None)


def overrides(**values: object) -> Overrides:
    return Overrides(others=values)


@pytest.mark.parametrize(
    ("before", "now", "alike"),
    [
        (0.5, 0.7, True),
        ("fast", "slow", True),
        (["a", "b"], ["c", "d"], True),
        ("fast", "", False),  # whether a text is empty may decide a test
        (1, 1.5, False),
        (True, 1, False),
        (["a", "b"], ["a"], False),
        ("fast", "f" * 1_000, False),
        ("fast", ["fast"], False),
    ],
)
def test_what_nobody_has_looked_at_may_be_another_of_its_kind(before, now, alike):
    asked = Asked(overrides(speed=before))
    assert asked.value(None, "speed") == (before,)
    assert asked.hold_for(overrides(speed=now, other=3)) is alike
    assert not asked.hold_for(overrides())


def test_what_somebody_has_looked_at_has_to_be_the_same():
    asked = Asked(overrides(speed=0.5, limit=2.0))
    asked.value(None, "speed")
    asked.value(None, "limit")
    asked.look_at_value(None, "speed")()
    assert asked.hold_for(overrides(speed=0.5, limit=3.0))
    assert not asked.hold_for(overrides(speed=0.7, limit=2.0))


def test_a_parameter_that_nothing_sets_stays_so():
    asked = Asked(overrides())
    assert asked.value(None, "speed") == ()
    assert not asked.hold_for(overrides(speed=0.5))
