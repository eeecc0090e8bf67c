"""Constants that a launch gives, and who looks at them."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import Given, Holed, Known, Unknown, join_texts, one_of
from archlint.model.overrides import SHORT

SPEED = frozenset({"speed"})


class Looks:
    """How often something has looked."""

    def __init__(self) -> None:
        self.count = 0

    def __call__(self) -> None:
        self.count += 1

    def given(self, value: str | int | float | bool, source: object = "speed", via: frozenset[str] = SPEED) -> Given:
        return Given(value, via, look=self, source=source, longest=SHORT)


@pytest.fixture
def looks() -> Looks:
    return Looks()


def test_who_reads_the_value_has_looked(looks):
    speed = looks.given(0.5)
    assert speed.value == 0.5
    assert looks.count == 1


@pytest.mark.parametrize("name", ["text", "whole_number", "pieces", "is_true"])
def test_what_only_the_value_says(looks, name):
    getattr(looks.given(3 if name == "whole_number" else "fast" if name == "text" else 0.5), name)
    assert looks.count


def test_what_the_type_says_needs_no_look(looks):
    text, number, flag = looks.given("fast"), looks.given(2), looks.given(True)
    assert (text.is_text, text.is_true, text.whole_number, text.python_type) == (True, True, None, str)
    assert (number.number_class, number.text, number.is_none) == ("int", None, False)
    assert (flag.python_type, flag.text) == (bool, None)
    assert looks.count == 0


def test_of_one_source_or_of_two_parameters_no_look_is_needed_to_compare(looks):
    speed = looks.given(0.5)
    assert one_of([speed, looks.given(0.5), speed.chosen_by(SPEED)]) is speed
    assert speed != looks.given(0.5, "limit", frozenset({"limit"}))
    assert speed != Known(0.5)
    assert speed != looks.given("fast", "other")
    assert looks.count == 0


def test_two_constants_of_one_parameter_are_compared_by_their_values(looks):
    first, second = looks.given("left", ("sides", 0)), looks.given("left", ("sides", 1))
    assert first == second
    assert hash(first) == hash(second) == hash(Known("left", SPEED))
    assert looks.count == 2
    assert Known("left", SPEED) == first


def test_a_text_made_of_it_stays_closed(looks):
    text = join_texts([Known("at "), looks.given(0.5)])
    assert isinstance(text, Given)
    assert (text.is_text, text.is_true, text.via) == (True, True, SPEED)
    assert looks.count == 0
    assert text == Known("at 0.5", SPEED)
    assert looks.count == 1


def test_texts_of_other_parts_are_others(looks):
    speed = looks.given("fast")
    assert join_texts([Known("str"), speed]) != speed.shown
    assert join_texts([Known("a"), speed]) == join_texts([Known("a"), speed])


def test_a_text_with_a_hole_shows_the_constants_in_it(looks):
    text = join_texts([looks.given("fast"), Unknown("data")])
    assert isinstance(text, Holed)
    assert text.parts == ("fast", None)
    assert looks.count == 1


def test_a_text_that_may_become_too_long_is_looked_at(looks):
    assert join_texts([looks.given("fast")] * 100) == Known("fast" * 100, SPEED)
    assert looks.count >= 100
