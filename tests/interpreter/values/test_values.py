"""What can be known of a value."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from archlint.finding import Place
from archlint.interpreter.values import (
    ALTERNATIVES,
    NUMBER_BITS,
    TEXT_LIMIT,
    External,
    Holed,
    Instance,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    as_default,
    constant,
    join_texts,
    one_of,
    reason,
    via,
    with_via,
)


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
    assert join_texts([Known("a" * 9_000)] * 2_000) == Unknown("a string too long to follow")
    assert join_texts([Known("a"), Known(""), Known("b")]) == Known("ab")
    unknown = Unknown("data")
    assert join_texts([Known(""), unknown, Known(""), unknown]) == Unknown("data", of_class="str")


PARAMETERS = st.frozensets(st.sampled_from(["x", "y"]), max_size=2)
KNOWN = st.builds(Known, st.one_of(st.integers(0, 3), st.booleans(), st.sampled_from("abc"), st.none()), PARAMETERS)
UNKNOWN = st.builds(Unknown, st.sampled_from(["data", "other"]), st.sampled_from([None, "x"]))
HOLED = st.builds(Holed, st.sampled_from([("a", None), (None, "b"), (None,)]), st.just("data"), PARAMETERS)
VALUES = st.one_of(KNOWN, UNKNOWN, HOLED)


@given(st.lists(VALUES, min_size=1, max_size=6))
def test_one_of_several_has_each_of_them_and_no_others(values: list[Value]):
    found = alternatives(one_of(values))
    assert set(found) <= set(values)
    assert len(set(found)) == len(found)
    assert {value for value in values if not isinstance(value, Unknown)} <= set(found)
    assert sum(isinstance(value, Unknown) for value in found) == any(isinstance(value, Unknown) for value in values)


@given(st.lists(VALUES, min_size=1, max_size=4))
def test_several_of_several_are_several(values: list[Value]):
    assert one_of([one_of(values)]) == one_of(values)
    assert one_of([one_of(values[:2]), *values[2:]]) == one_of(values)


def test_no_value_is_unknown():
    assert one_of([]) == Unknown("no value")


def test_more_values_than_are_followed_are_unknown():
    values = [Known(number) for number in range(ALTERNATIVES + 1)]
    assert isinstance(one_of(values[:-1]), OneOf)
    assert one_of(values) == Unknown("more values than can be followed")


def test_constants_of_different_types_are_different():
    assert len({Known(1), Known(1.0), Known(True), Known("1")}) == 4
    assert Known(1) != Known(1, frozenset({"x"}))
    assert Known("a", origin=Place("a.py", 1, 1, 1, 2)) == Known("a")


@given(st.lists(st.one_of(KNOWN, HOLED, UNKNOWN), max_size=5))
def test_a_text_is_put_together_of_what_is_known(parts: list[Value]):
    found = join_texts(parts)
    if all(isinstance(part, Known) for part in parts):
        assert isinstance(found, Known)
        assert found.value == "".join(str(part.value) for part in parts if isinstance(part, Known))
    else:
        assert isinstance(found, (Holed, Unknown))
    if isinstance(found, Holed):
        assert any(found.parts) and None in found.parts
        pairs = zip(found.parts, found.parts[1:], strict=False)
        assert all((one is None) != (other is None) for one, other in pairs)
    if not isinstance(found, Unknown):
        assert found.via == via(*parts)


@given(st.lists(VALUES, max_size=4))
def test_what_is_made_of_values_comes_from_all_their_parameters(values: list[Value]):
    expected = {name for value in values for name in getattr(value, "via", ())}
    expected |= {value.parameter for value in values if isinstance(value, Unknown) and value.parameter is not None}
    assert via(*values) == expected


@given(VALUES, st.frozensets(st.sampled_from(["p", "q"])))
def test_what_parameters_chose_comes_from_them(value: Value, parameters: frozenset[str]):
    found = with_via(value, parameters)
    if not parameters:
        assert found is value
    elif isinstance(value, Unknown):
        assert isinstance(found, Unknown)
        assert found.parameter == (value.parameter or min(parameters))
    else:
        assert via(found) == via(value) | parameters


def test_what_parameters_chose_of_several():
    several = OneOf((Known("a"), Known("b")))
    chosen = frozenset({"p"})
    assert with_via(several, chosen) == OneOf((Known("a", chosen), Known("b", chosen)))
    thing = Instance(External("a.B"), 1)
    assert with_via(thing, chosen) is thing


def test_why_a_result_is_not_known():
    assert reason(Known(1), Unknown("first"), Unknown("second")) == "first"
    assert reason(OneOf((Known(1), Holed((None, "a"), "hole")))) == "hole"
    assert reason(Known(1)) == "the value is not a constant"


def test_constants_have_bounds():
    assert constant("a" * TEXT_LIMIT) == Known("a" * TEXT_LIMIT)
    assert constant("a" * (TEXT_LIMIT + 1)) == Unknown("a string too long to follow")
    assert constant(2**NUMBER_BITS - 1) == Known(2**NUMBER_BITS - 1)
    assert constant(2**NUMBER_BITS) == Unknown("a number too large to follow")


def test_defaults_say_that_they_are():
    found = as_default(OneOf((Known("a"), Unknown("data"))))
    assert isinstance(found, OneOf)
    assert [getattr(option, "kind", None) for option in found.values] == ["argument_default", None]


def test_the_pattern_of_a_text_with_holes():
    assert Holed(("/", None, "/scan"), "data").pattern == "/*/scan"
