"""The heap: layers of what branches write, and how they are joined."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.heap import MISSING, Store
from archlint.interpreter.values import (
    ITEMS,
    JOINED_LIMIT,
    Entries,
    Items,
    Known,
    OneOf,
    Unknown,
    Value,
    join_entries,
    join_items,
    one_of,
)

A, B, C = Known("a"), Known("b"), Known("c")
KEYS = st.sampled_from([(1, "x"), (1, "y"), (2, "x")])
VALUES = st.sampled_from([A, B, C, Unknown("data")])
WRITES = st.dictionaries(KEYS, VALUES, max_size=3)


def written(**slots: Value) -> dict:
    return {(1, name): value for name, value in slots.items()}


def test_the_newest_layer_is_read_first():
    store = Store()
    store.set(1, "x", A)
    store.push()
    assert store.get(1, "x") is A
    store.set(1, "x", B)
    assert store.get(1, "x") is B
    assert store.pop() == written(x=B)
    assert store.get(1, "x") is A
    assert store.get(1, "nothing") is None
    assert store.value_at((1, "nothing")) is MISSING
    assert store.value_at((1, "x")) is A


def test_layers_are_taken_off_and_flattened():
    store = Store()
    store.set(1, "x", A)
    for value in (B, C):
        store.push()
        store.set(1, "x", value)
        store.set(1, value.value, value)
    assert store.above(1) == written(x=C, b=B, c=C)
    assert store.cut(1) == written(x=C, b=B, c=C)
    assert (store.depth, store.get(1, "x")) == (1, A)


def test_keys_are_new():
    store = Store()
    assert len({store.new_key() for _ in range(100)}) == 100


def test_what_one_branch_wrote_and_the_other_did_not_may_be_either():
    store = Store()
    store.set(1, "x", A)
    assert store.merge([written(x=B), {}])
    assert store.get(1, "x") == OneOf((B, A))


def test_what_was_not_there_before_is_what_the_branches_have():
    store = Store()
    assert store.merge([written(x=A), {}])
    assert store.get(1, "x") is A
    store.merge([written(y=A), written(y=B)])
    assert store.get(1, "y") == OneOf((A, B))


def test_what_all_branches_left_as_it_was_changes_nothing():
    store = Store()
    store.set(1, "x", A)
    assert not store.merge([written(x=A), {}])
    assert not store.merge([written(x=A), written(x=Known("a"))])
    assert store.get(1, "x") == A


def test_one_branch_is_the_way_on():
    store = Store()
    store.set(1, "x", A)
    store.merge([written(x=B)])
    assert store.get(1, "x") is B


@given(WRITES, st.lists(WRITES, min_size=1, max_size=3))
def test_after_a_join_each_slot_is_one_of_what_the_branches_left(before: dict, branches: list[dict]):
    store = Store()
    store.layers[0].update(before)
    store.push()
    store.merge(branches)
    for slot in {*before, *(slot for branch in branches for slot in branch)}:
        ends = [branch.get(slot, before.get(slot)) for branch in branches]
        expected = one_of(end for end in ends if end is not None)
        found = store.get(*slot)
        assert isinstance(found, Value)
        assert set(_options(found)) == set(_options(expected))


def _options(value: Value) -> tuple[Value, ...]:
    return value.values if isinstance(value, OneOf) else (value,)


def test_modules_run_on_the_base():
    store = Store()
    store.set(1, "x", A)
    store.push()
    store.set(1, "x", B)
    with store.at_base():
        assert store.get(1, "x") is A
        store.set(2, "x", C)
    assert (store.get(1, "x"), store.get(2, "x"), store.depth) == (B, C, 2)
    store.pop()
    assert store.get(2, "x") is C


def test_the_base_is_left_even_if_something_fails():
    store = Store()
    store.push()
    try:
        with store.at_base():
            raise ValueError
    except ValueError:
        pass
    assert store.depth == 2


class TestWatching:
    """What a function read of the state, and what it left there."""

    def test_what_is_read_is_noted_with_what_it_was(self):
        store = Store()
        key = store.new_key()
        store.set(key, "x", A)
        with store.watched() as around:
            store.get(key, "x")
        assert around == {(key, "x"): A}

    def test_what_is_written_and_the_same_as_before_holds(self):
        store = Store()
        key = store.new_key()
        store.set(key, "x", A)
        with store.watched() as around:
            store.get(key, "x")
            store.set(key, "x", A)
        assert around == {(key, "x"): A}

    def test_what_is_read_and_then_changed_never_holds_again(self):
        store = Store()
        key = store.new_key()
        store.set(key, "x", A)
        with store.watched() as around:
            store.get(key, "x")
            store.set(key, "x", B)
        assert store.get(key, "x") is B
        assert around[(key, "x")] not in (A, B)

    def test_what_was_made_inside_is_nobodys_business(self):
        store = Store()
        with store.watched() as around:
            key = store.new_key()
            store.set(key, "x", A)
            store.get(key, "x")
        assert around == {}

    def test_who_watches_around_sees_what_is_read_inside(self):
        store = Store()
        key = store.new_key()
        store.set(key, "x", A)
        with store.watched() as outer:
            with store.watched() as inner:
                store.get(key, "x")
            store.get(key, "nothing")
        assert inner == {(key, "x"): A}
        assert set(outer) == {(key, "x"), (key, "nothing")}

    def test_a_join_reads_what_was_there_before(self):
        store = Store()
        key = store.new_key()
        store.set(key, "x", A)
        with store.watched() as around:
            store.merge([{(key, "x"): B}, {}])
        assert (key, "x") in around


def test_lists_of_one_length_are_joined_item_by_item():
    joined = join_items([Items((A, B)), Items((A, C))])
    assert joined == Items((A, OneOf((B, C))))
    assert not joined.open


def test_lists_of_different_lengths_may_have_fewer_items_and_no_others():
    joined = join_items([Items((A,)), Items((A, B))])
    assert joined.values == (A, B)
    assert joined.open
    assert joined.exhaustive


def test_a_list_that_may_have_more_stays_so():
    joined = join_items([Items((A,), True), Items((B,), True)])
    assert joined.open
    assert not joined.exhaustive


def test_long_lists_are_cut_when_they_are_joined():
    long = [Items(tuple(map(Known, range(start, start + JOINED_LIMIT)))) for start in (0, JOINED_LIMIT)]
    joined = join_items([*long, Items(())])
    assert len(joined.values) == JOINED_LIMIT
    assert joined.open
    assert not joined.exhaustive


def test_joining_is_work():
    store = Store()
    items = Items(tuple(map(Known, range(100))))
    store.merge([{(1, ITEMS): items}, {(1, ITEMS): Items((A,))}])
    assert store.work >= 101


def test_dicts_are_joined_key_by_key():
    one, other = Entries({"k": (A, B)}), Entries({"k": (A, C)})
    assert join_entries([one, other]) == Entries({"k": (A, OneOf((B, C)))})
    assert join_entries([one, Entries({})]) == Entries({"k": (A, B)}, True)
    assert join_entries([one, Entries({"k": (A, B)}, True)]).open


class TestFields:
    """What the run itself keeps of an object, out of reach of the names of the code."""

    def test_a_field_is_no_attribute(self):
        store, color = Store(), Field[str]("color")
        store.set(1, "color", A)
        store.set(1, color, "red")
        assert (store.get(1, "color"), store.get(1, color)) == (A, "red")
        assert repr(color) == "<color>"
        assert store.variables(1) == [("color", A)]

    def test_fields_of_one_name_are_two(self):
        store = Store()
        store.set(1, Field[str]("color"), "red")
        assert store.get(1, Field[str]("color")) is None

    def test_what_branches_leave_in_a_field_is_joined_as_the_field_says(self):
        last, longest = Field[str]("last"), Field[str]("longest", lambda texts: max(texts, key=len))
        store = Store()
        store.merge([{(1, last): "red", (1, longest): "red"}, {(1, last): "on", (1, longest): "on"}])
        assert (store.get(1, last), store.get(1, longest)) == ("on", "red")

    def test_a_family_has_a_field_for_each_name(self):
        store, colors, sizes = Store(), Fields[str]("color"), Fields[str]("size")
        store.set(1, colors["dark"], "blue")
        store.set(2, colors["dark"], "brown")
        store.set(1, sizes["dark"], "small")
        store.push()
        store.set(1, colors["light"], "yellow")
        store.set(1, colors["dark"], "black")
        assert store.get(1, colors["dark"]) == "black"
        assert store.family(1, colors) == {"dark": "black", "light": "yellow"}
        assert store.family(3, colors) == {}
        assert colors["dark"] == colors["dark"] != sizes["dark"]

    def test_a_family_joins_its_fields_as_it_says(self):
        store, speeds = Store(), Fields[int]("speed", max)
        store.merge([{(1, speeds["top"]): 3}, {(1, speeds["top"]): 2}])
        assert store.get(1, speeds["top"]) == 3


def test_items_are_equal_by_what_they_hold():
    assert Items((A,)) == Items((A,))
    assert hash(Items((A,))) == hash(Items((A,)))
    assert Items((A,)) != Items((A,), True)
    assert Items((A,), True) != Items((A,), True, exhaustive=True)
