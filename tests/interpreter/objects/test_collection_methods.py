"""What lists, tuples, sets and dicts answer when they are asked, and what stays open of them.

Where all is known, Python itself says what comes out; where something is not, the test says what may be there.
"""

from __future__ import annotations

import pytest

from archlint.interpreter.containers import ITEM_LIMIT
from interpreting import OUTSIDE, WITH_LIBRARIES, assert_like_python, interpret


def test_a_list_that_grows_and_shrinks():
    assert_like_python(
        """
        topics = ['scan']
        topics.append('odom')
        topics.extend(('map', 'tf'))
        topics.insert(1, 'cmd')
        topics.insert(-1, 'joy')
        before = list(topics)
        last, second = topics.pop(), topics.pop(1)
        topics.remove('map')
        after = topics.copy()
        topics.reverse()
        topics += ['end']
        topics.sort(reverse=True)
        topics.clear()
        empty = topics
        """
    )


def test_lists_of_one_identity():
    assert_like_python(
        """
        row = [0]
        rows = [row, row]
        row.append(1)
        rows[0].append(2)
        copied = row.copy()
        copied.append(3)
        counts = len(row), len(copied), len(rows[1])
        """
    )


def test_a_queue_has_two_ends():
    assert_like_python(
        """
        from collections import deque

        queue = deque([1, 2])
        queue.append(3)
        queue.appendleft(0)
        queue.extendleft([7, 8])
        first, last = queue.popleft(), queue.pop()
        rest = list(queue)
        """,
        WITH_LIBRARIES,
    )


def test_a_queue_that_turns_may_hold_anything():
    found = interpret("from collections import deque\nit = deque([1, 2])\nit.rotate(1)\nx = it[0]", WITH_LIBRARIES)
    assert not found.is_known("x")


def test_sets_hold_each_item_only_once():
    assert_like_python(
        """
        names = {'scan'}
        names.add('scan')
        names.update(['odom', 'scan'])
        both = names.union({'map', 'odom'})
        same = names.union()
        names.discard('odom')
        names.remove('scan')
        none = names
        """
    )


@pytest.mark.parametrize("change", ["difference_update({1})", "intersection_update({1})"])
def test_a_set_from_which_items_are_taken_is_open(change: str):
    assert not interpret(f"it = {{1, 2}}\nit.{change}\nx = len(it)").is_known("x")


def test_entries_come_and_go():
    assert_like_python(
        """
        depths = {'scan': 5}
        depths.update({'odom': 10}, map=1)
        depths.update([('tf', 100)])
        kept = depths.setdefault('scan', 7), depths.setdefault('joy', 3), depths.setdefault('none')
        taken = depths.pop('odom'), depths.pop('wheel', 'default')
        asked = depths.get('scan'), depths.get('wheel'), depths.get('wheel', 2)
        names, values, items = list(depths.keys()), list(depths.values()), list(depths.items())
        copied = depths.copy()
        depths.clear()
        """
    )


def test_a_default_dict_makes_what_is_asked_for():
    assert_like_python(
        """
        from collections import defaultdict

        groups = defaultdict(list)
        groups['a'].append(1)
        groups['a'].append(2)
        counts = defaultdict(lambda: 7)
        of_a, of_b = groups['a'], groups['b']
        count = counts['x'] + 1
        names = list(groups)
        absent = groups.get('c')
        """,
        WITH_LIBRARIES,
    )


@pytest.mark.parametrize("change", ["it.insert(outside.at(), 3)", "it.pop(outside.at())", "it[outside.at()] = 3"])
def test_a_place_that_is_not_known_leaves_the_list_open(change: str):
    found = interpret(f"{OUTSIDE}it = [1, 2]\n{change}\nx = it[0]\ncount = len(it)")
    assert not found.is_known("x")
    assert not found.is_known("count")


def test_what_pop_takes_from_a_place_that_is_not_known_is_one_of_the_items():
    found = interpret(f"{OUTSIDE}it = ['a', 'b']\nx = it.pop(outside.at())")
    assert found.options("x") == {"a", "b"}


def test_an_item_at_a_place_that_is_not_known_is_one_of_them():
    found = interpret(f"{OUTSIDE}it = ['a', 'b']\nx = it[outside.at()]\ny = {{'k': 1, 'l': 2}}[outside.key()]")
    assert found.options("x") == {"a", "b"}
    assert found.options("y") == {1, 2}


@pytest.mark.parametrize(
    "call",
    ["it.append()", "it.extend()", "it.insert(1)", "it.remove()", "it.appendleft()", "it.extendleft()"],
)
def test_a_call_that_python_refuses_changes_nothing(call: str):
    assert interpret(f"it = [1, 2]\n{call}").constant("it") == [1, 2]


@pytest.mark.parametrize("call", ["it.get()", "it.pop()", "it.setdefault()"])
def test_a_call_of_a_dict_that_python_refuses_changes_nothing(call: str):
    found = interpret(f"it = {{'a': 1}}\nx = {call}")
    assert found.constant("it") == {"a": 1}
    assert not found.is_known("x")


def test_a_dict_with_unknown_entries_gives_a_default_or_what_is_not_known():
    found = interpret(f"{OUTSIDE}it = {{'a': 1}}\nit.update(outside.more())\nx = it.pop('b', 'none')\ny = it['a']")
    assert found.options("x") == {"none", ...}


def test_what_a_pair_is_that_has_not_two_items():
    found = interpret("it = dict([('a', 1, 2)])\nx = len(it)\ny = dict([5])\nz = len(y)")
    assert not found.is_known("x")
    assert not found.is_known("z")


def test_a_list_is_followed_up_to_a_bound_and_open_beyond():
    lines = [f"it = list(range({ITEM_LIMIT}))", "before = len(it)", "it.insert(0, 'new')", "x = len(it)", "y = it[0]"]
    found = interpret("\n".join(lines))
    assert found.constant("before") == ITEM_LIMIT
    assert not found.is_known("x")
    assert not found.is_known("y"), "nothing is said of the items of a list that is open"


# ------------------------------------------------------------------------------------------- Python's functions


def test_functions_over_several_collections():
    assert_like_python(
        """
        names, depths = ['scan', 'odom'], (5, 10, 20)
        zipped = list(zip(names, depths, 'ab'))
        numbered = list(enumerate(names, start=1)) + list(enumerate(names, 5))
        table = dict(zip(names, depths))
        shortened = list(filter(lambda name: name != 'odom', names))
        true = list(filter(None, [0, 1, '', 'a']))
        longer = list(map(lambda name: '/' + name, names))
        total = sum(depths), sum([names, ['map']], []), max(depths), min(depths[1:]), max(3, 4)
        order = sorted(names), sorted(depths, reverse=True), list(reversed(names))
        verdicts = any(each == 'odom' for each in names), all(len(name) == 4 for name in names), any([]), all([])
        without_items = next(iter([]), 'none')
        ranges = list(range(3)), list(range(1, 7, 3)), list(range(3, 0, -1))
        """
    )


@pytest.mark.parametrize(
    ("expression", "options"),
    [
        ("next(iter(outside.items()), 'none')", {...}),
        ("next(each for each in outside.items())", {...}),
        ("next((name for name in ['a', 'b'] if outside.wanted(name)), None)", {"a", "b", None}),
        ("next((name for name in ['a', 'b'] if name != 'a'), None)", {"b"}),
        ("[name for name in ['a', 'b'] if outside.wanted(name)][0]", {...}),
        ("max(['a', 'b'], key=outside.size)", {...}),
        ("sum([1, 2], outside.start())", {...}),
        ("sum(outside.items(), [])", {...}),
        ("range(1, outside.end())", {...}),
        ("range(1, 5, 0)", {...}),
        ("len(list(map(max, [1], [2])))", {...}),
        ("len(list(filter(outside.wanted, [1, 2])))", {...}),
        ("len({outside.one(), 1})", {...}),
        ("any([outside.one(), 1])", {True}),
        ("all([outside.one(), 0])", {False}),
        ("any([outside.one(), 0])", {...}),
        ("next(iter(['a', outside.one()]))", {"a", ...}),
        ("next(iter(['a', 'b']))", {"a", "b"}),
    ],
)
def test_functions_of_what_is_not_known(expression: str, options: set[object]):
    assert interpret(f"{OUTSIDE}x = {expression}").options("x") == options


@pytest.mark.parametrize(
    ("loop", "known"),
    [
        ("for number, name in enumerate(outside.names()):\n    it = 'a' if number < 0 else 'b'", {"a", "b"}),
        ("for name, depth in zip(outside.names(), [1, 2]):\n    it = depth", {...}),
        ("for name in sorted(outside.names()):\n    it = 'seen'", {"seen"}),
        ("for name in filter(None, outside.names()):\n    it = 'seen'", {"seen"}),
    ],
)
def test_loops_over_what_is_not_known_run_all_the_same(loop: str, known: set[object]):
    """What the body sets may be set, or what was there before stays."""
    found = interpret(f"{OUTSIDE}it = 'start'\n{loop}")
    assert known <= found.options("it") <= {"start", *known}
