"""What values answer for themselves, and the laws of joining them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.finding import Place
from archlint.interpreter.fields import Field
from archlint.interpreter.heap import Store
from archlint.interpreter.values import (
    ALTERNATIVES,
    ENTRIES,
    FALSE,
    ITEMS,
    NONE,
    TRUE,
    TUPLE_FIELDS,
    ApiMethod,
    BoundMethod,
    Builtin,
    DictValue,
    EachValue,
    Entries,
    External,
    Holed,
    Instance,
    Items,
    Known,
    ListValue,
    OneOf,
    Partial,
    Unknown,
    Value,
    alternatives,
    constants_of,
    depends_on,
    join_entries,
    join_items,
    one_of,
)

PLACE = Place("node.py", 1, 1, 1, 5)
CONSTANTS = st.one_of(st.none(), st.booleans(), st.integers(-3, 3), st.sampled_from(["", "a", "b"])).map(Known)
SIMPLE = st.one_of(CONSTANTS, st.sampled_from([External("sys.argv"), Unknown("data"), Unknown("other data")]))
VALUES = st.lists(SIMPLE, min_size=1, max_size=4).map(one_of)
ROWS = st.builds(Items, st.lists(SIMPLE, max_size=3).map(tuple), st.booleans())
DICTS = st.builds(
    lambda texts, open_: Entries({Known(text).entry_key(): (Known(text), NONE) for text in texts}, open_),
    st.sets(st.sampled_from(["a", "b", "c"])),
    st.booleans(),
)


class Run:
    """A run in which some parameters are settled."""

    def __init__(self, *settled: str) -> None:
        self.store = Store()
        self.settled = frozenset(settled)

    def are_settled(self, parameters: frozenset[str]) -> bool:
        return parameters <= self.settled

    def list(self, *values: Value, open_: bool = False) -> ListValue:
        made = ListValue(self.store.new_key())
        self.store.set(made.key, ITEMS, Items(values, open_))
        return made

    def dict(self, *names: str, open_: bool = False) -> DictValue:
        made = DictValue(self.store.new_key())
        rows = {Known(name).entry_key(): (Known(name), Known(len(name))) for name in names}
        self.store.set(made.key, ENTRIES, Entries(rows, open_))
        return made


def known(value: Value) -> set[Value]:
    """The alternatives of a value; which of several reasons an unknown one gives is the first that was met."""
    return {Unknown("") if isinstance(option, Unknown) else option for option in alternatives(value)}


class TestJoining:
    @given(VALUES, VALUES)
    def test_it_does_not_matter_which_branch_comes_first(self, left: Value, right: Value):
        assert known(one_of((left, right))) == known(one_of((right, left)))

    @given(VALUES)
    def test_the_same_from_both_branches_is_the_same(self, value: Value):
        assert one_of((value, value)) == value

    @given(VALUES, VALUES, VALUES)
    def test_it_does_not_matter_which_are_joined_first(self, first: Value, second: Value, third: Value):
        early = one_of((one_of((first, second)), third))
        late = one_of((first, one_of((second, third))))
        assert known(early) == known(late)

    @given(st.lists(VALUES, min_size=1, max_size=4))
    def test_what_may_be_unknown_stays_so_and_so_is_too_much(self, values: list[Value]):
        every = set[Value]().union(*map(known, values))
        assert (Unknown("") in known(one_of(values))) == (Unknown("") in every or len(every) > ALTERNATIVES)

    @given(st.integers(ALTERNATIVES + 1, ALTERNATIVES + 9))
    def test_too_many_are_unknown(self, count: int):
        assert isinstance(one_of(map(Known, range(count))), Unknown)

    @given(st.lists(ROWS, min_size=1, max_size=3))
    def test_of_lists_no_item_is_lost(self, rows: list[Items]):
        joined = join_items(rows)
        options = {option for item in joined.values for option in known(item)}
        assert options == {option for row in rows for item in row.values for option in known(item)}
        assert joined.open or not any(row.open for row in rows)

    @given(ROWS)
    def test_a_list_joined_with_itself_is_the_same(self, row: Items):
        assert join_items([row, row]) == row

    @given(DICTS, DICTS)
    def test_of_dicts_no_key_is_lost(self, left: Entries, right: Entries):
        joined = join_entries([left, right])
        assert joined.entries.keys() == left.entries.keys() | right.entries.keys()
        assert joined.open == (left.open or right.open or left.entries.keys() != right.entries.keys())
        assert join_entries([right, left]) == joined


@pytest.mark.parametrize(
    ("value", "truth"),
    [
        (Known(""), False),
        (Known("a"), True),
        (NONE, False),
        (Known(1, frozenset({"rate"})), None),
        (Known(1, frozenset({"fixed"})), True),
        (OneOf((TRUE, Known(2))), True),
        (OneOf((TRUE, FALSE)), None),
        (Holed(("a", None), "data"), True),
        (Holed((None,), "data"), None),
        (Unknown("data"), None),
        (External("sys.argv"), None),
        (Instance(External("threading.Lock"), 1), True),
        (Builtin("print"), True),
        (Partial(Builtin("print"), (), ()), True),
        (ApiMethod("rclpy.action.Handle.is_active", NONE), None),
        (EachValue(NONE), None),
    ],
)
def test_whether_a_value_is_true(value: Value, truth: bool | None):
    assert value.truth(Run("fixed")) is truth


def test_collections_are_true_if_something_is_in_them():
    run = Run()
    assert run.list(NONE).truth(run) is True
    assert run.list().truth(run) is False
    assert run.list(NONE, open_=True).truth(run) is None
    assert run.dict("a").truth(run) is True
    assert run.dict().truth(run) is False
    assert run.dict(open_=True).truth(run) is None


def test_what_iterating_yields():
    run = Run()
    assert run.list(TRUE, NONE).items(run) == Items((TRUE, NONE))
    assert run.dict("a", "b").items(run) == Items((Known("a"), Known("b")))
    assert Known("ab").items(run) == Items((Known("a"), Known("b")))
    assert Known("a" * 300).items(run) is None
    assert Known(3).items(run) is None
    assert Unknown("data").items(run) is None
    assert ListValue(99).items(run) == Items((), True)
    assert DictValue(99).entries(run) == Entries({}, True)
    assert run.list().entries(run) is None


def test_of_several_collections_all_items_may_come():
    run = Run()
    several = OneOf((run.list(TRUE), run.list(NONE)))
    assert several.items(run) == Items((TRUE, NONE), True, True)
    assert OneOf((run.list(TRUE), run.list(TRUE))).items(run) == Items((TRUE,))
    some = OneOf((run.list(TRUE), Unknown("data"))).items(run)
    assert some is not None
    assert (some.values, some.open, some.exhaustive) == ((TRUE,), True, False)
    assert OneOf((NONE, TRUE)).items(run) is None


def test_a_named_tuple_yields_its_fields():
    run, point = Run(), Instance(External("collections.namedtuple"), 5)
    assert point.items(run) is None
    run.store.set(5, TUPLE_FIELDS, ("x", "y"))
    run.store.set(5, "x", Known(1))
    assert point.items(run) == Items((Known(1),))


def test_what_parameters_choose_depends_on_them():
    run, rate = Run(), frozenset({"rate"})
    for value in (Known(1), Holed((None,), "data"), External("a.b"), Unknown("data"), ListValue(1), DictValue(1)):
        assert value.chosen_by(rate).via == rate
    assert Unknown("data", "other").chosen_by(rate) == Unknown("data", "other")
    assert OneOf((TRUE, NONE)).chosen_by(rate) == OneOf((TRUE.chosen_by(rate), NONE.chosen_by(rate)))
    assert Builtin("print").chosen_by(rate) == Builtin("print")
    items = run.list(TRUE).chosen_by(rate).items(run)
    assert [item.via for item in items.values] == [rate]
    entries = run.dict("a").chosen_by(rate).entries(run)
    assert [value.via for value in entries.values] == [rate]
    assert depends_on(Known(1), Unknown("data", "b"), Known(2, frozenset({"a"}))) == "a"
    assert depends_on(Known(1)) is None


def test_constants_say_what_they_are():
    assert (Known("a").text, Known("a").is_text, Known(1).text, Unknown("data").text) == ("a", True, None, None)
    assert (Known(3).whole_number, Known("3").whole_number, Known(3.0).whole_number) == (3, None, None)
    assert (NONE.is_none, TRUE.is_none, Unknown("data").is_none) == (True, False, False)
    assert (Known(3).constant, Unknown("data").constant) == (3, None)
    assert Known(3).pieces == ("3",)
    assert Holed(("a", None), "data").pieces == ("a", None)
    assert Unknown("data").pieces == (None,)
    assert constants_of([Known(3), NONE]) == [3, None]
    assert constants_of([Known(3), Unknown("data")]) is None


def test_a_suffix_alone_names_no_file():
    assert Known("a.yaml", origin=PLACE).written_at == PLACE
    assert Known(".yaml", origin=PLACE).written_at is None
    assert Holed((None, "/a.yaml"), "data", origin=PLACE).written_at == PLACE
    assert Holed(("/a", None), "data", origin=PLACE).written_at is None
    assert Unknown("data").written_at is None


def test_objects_are_themselves_and_not_none():
    lock = Instance(External("threading.Lock"), 1)
    assert lock.has_identity
    assert lock.is_object
    assert lock.own_class is None
    assert lock.heap_key == 1
    assert BoundMethod(Builtin("f"), lock).is_callable
    assert BoundMethod(Builtin("f"), lock).inner == (Builtin("f"), lock)
    assert not Unknown("data").is_object
    assert not Builtin("print").has_identity
    assert EachValue(lock).each is lock
    assert OneOf((NONE, lock)).inner == (NONE, lock)
    assert OneOf((NONE, Unknown("data"))).why_unknown == "data"
    assert OneOf((NONE, lock)).why_unknown is None


def test_keys_of_dicts():
    lock = Instance(External("threading.Lock"), 1)
    assert Known("1").entry_key() != Known(1).entry_key()
    assert Known(1).entry_key() == Known(True).entry_key()
    assert lock.entry_key() == lock.entry_key() != Instance(External("threading.Lock"), 1).entry_key()
    assert External("a.b").entry_key() == External("a.b").entry_key()
    assert Unknown("data").entry_key() is None


def test_a_field_shows_its_name():
    assert repr(Field[int]("size")) == "<size>"
