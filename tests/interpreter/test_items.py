"""Items and slices, and what code asks of the type of a value: where not all is known, nothing too much is said."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import Known, Unknown
from interpreting import OUTSIDE, assert_like_python, evaluate, interpret


def test_slices():
    assert_like_python(
        """
        names = ['scan', 'odom', 'map', 'tf']
        parts = names[1:], names[:-1], names[::2], names[::-1], names[5:]
        of_tuple = (1, 2, 3)[1:]
        of_text = 'scan'[1:3], 'scan'[::-1], 'scan'[0], 'scan'[-1]
        """
    )


@pytest.mark.parametrize(
    "expression",
    ["[1, 2][::0]", "[1, 2][outside.at():]", "outside.items()[1:]", "list(outside.items())[1:]", "'scan'[9]", "5[1:]"],
)
def test_parts_of_which_nothing_is_known(expression: str):
    assert not interpret(f"{OUTSIDE}x = {expression}").is_known("x")


def test_a_letter_that_a_parameter_chose_comes_from_it():
    assert evaluate("'ab'[k]", k=Known(1, frozenset({"k"}))) == Known("b", frozenset({"k"}))
    assert isinstance(evaluate("'ab'[k]", k=Unknown("not here")), Unknown)


@pytest.mark.parametrize(
    "lines",
    ["it = {'a': 1, 'b': 2}\ndel it[outside.key()]", "it = [1, 2]\ndel it[outside.at()]", "it = [1, 2]\ndel it[0]"],
)
def test_what_is_deleted_leaves_the_rest_open(lines: str):
    assert not interpret(f"{OUTSIDE}{lines}\nx = len(it)").is_known("x")


def test_an_entry_of_one_of_several_dicts_may_be_set_in_each():
    found = interpret(
        f"{OUTSIDE}left, right = {{'a': 1}}, {{}}\nit = left if outside.flag() else right\nit['a'] = 2\n"
        "x, y = left['a'], right['a']"
    )
    assert found.options("x") == {1, 2}
    assert found.options("y") == {2}


def test_attributes_by_their_names():
    assert_like_python(
        """
        class Robot:
            kind = 'robot'

            def __init__(self):
                self.name = 'r2'

        robot = Robot()
        setattr(robot, 'speed', 1)
        asked = hasattr(robot, 'name'), hasattr(robot, 'speed'), hasattr(robot, 'kind'), hasattr(robot, 'wheel')
        vars(robot)['late'] = 3
        got = getattr(robot, 'speed'), getattr(robot, 'wheel', 4), robot.__dict__['name']
        again = type(robot)().name, type(robot).kind
        """
    )


@pytest.mark.parametrize(
    "expression", ["hasattr([1], outside.name())", "hasattr(outside.one(), 'x')", "type(5)", "type(outside.one())"]
)
def test_what_is_not_known_of_attributes_and_types(expression: str):
    assert not interpret(f"{OUTSIDE}x = {expression}").is_known("x")


def test_what_values_are_instances_of():
    assert_like_python(
        """
        import collections.abc

        class Base:
            pass

        class Robot(Base):
            pass

        class Text(str):
            pass

        def run():
            pass

        constants = isinstance('a', str), isinstance(1, (str, (list, int))), isinstance(1.5, int), isinstance(None, str)
        collections_ = isinstance([], list), isinstance((), (list, tuple)), isinstance({}, dict), isinstance({}, list)
        objects = isinstance(Robot(), Base), isinstance(Base(), Robot), isinstance(Text(), str)
        others = isinstance(run, str), isinstance(Robot, dict), isinstance('a', Robot), isinstance(Robot(), int)
        texts = isinstance(f'{1}', str), callable(run), callable(Robot), callable('a')
        abstract = isinstance([], collections.abc.Iterable), isinstance({1}, collections.abc.Iterable)
        """
    )


@pytest.mark.parametrize(
    "expression",
    [
        "isinstance(1)",
        "isinstance(1, tuple(outside.kinds()))",
        "isinstance(1, (str, (outside.Kind, list)))",
        "isinstance(outside.one(), (str, int))",
        "isinstance(1 if outside.flag() else 'a', str)",
        "isinstance({1}, set)",
        "isinstance(Derived(), str)",
        "isinstance(Derived(), Other)",
        "isinstance(len, str)",
    ],
)
def test_instances_of_what_is_not_known(expression: str):
    lines = "class Derived(outside.Base):\n    pass\nclass Other:\n    pass\n"
    assert not interpret(f"{OUTSIDE}{lines}x = {expression}").is_known("x")


@pytest.mark.parametrize(
    ("condition", "value"),
    [
        ("isinstance(it, Each) for it in outside.items()", ...),
        ("isinstance(it, str) for it in ['a', 'b']", True),
        ("isinstance(it, str) for it in ['a', outside.one()]", ...),
    ],
)
def test_a_test_of_each_item(condition: str, value: object):
    found = interpret(f"{OUTSIDE}class Each:\n    pass\nx = all({condition})")
    assert found.options("x") == {value}


def test_collections_of_what_is_walked_once():
    """A generator over what is not known gives its items to whatever walks it, and their number to nobody."""
    found = interpret(
        f"{OUTSIDE}def names():\n    for each in outside.items():\n        yield 'a'\n"
        "x = next(names(), 'none')\ncount = len(list(names()))\n"
        "for row in enumerate(names()):\n    number = row[0]\nhighest = max(names())\nordered = sorted(names())[0]"
    )
    assert "a" in found.options("x")
    assert not found.is_known("count")
    assert not found.is_known("number")


def test_more_arguments_than_are_followed():
    found = interpret(
        "x = list(map(max, [1], [2]))\ny = list(filter(None))\nz = len(enumerate(5))\nw = len(zip(5, [1]))"
    )
    assert [name for name in "xyzw" if found.is_known(name)] == []


def test_the_number_of_what_is_of_several_kinds():
    found = interpret(
        f"{OUTSIDE}it = [1] if outside.flag() else [1, 2]\nx = len(it)\ny = sum([1], [2], [3])\nz = sum([5], [1])"
    )
    assert not found.is_known("x")
    assert not found.is_known("z")


@pytest.mark.parametrize(
    "change", ["it[5] = 3", "outside.one()[0] = it", "del outside.one()[0]", "vars(robot)[5] = it"]
)
def test_what_does_not_touch_a_list_leaves_it(change: str):
    found = interpret(f"{OUTSIDE}class Robot:\n    pass\nrobot, it = Robot(), [1, 2]\n{change}")
    assert found.constant("it") == [1, 2]


def test_entries_under_keys_that_are_not_known():
    found = interpret(
        f"{OUTSIDE}it = {{'a': 1}}\nkey = outside.key()\nit[key] = 2\nit[key] = 2\nx, y = it['a'], it['b']"
    )
    assert not found.is_known("y")
    assert 1 in found.options("x")


def test_items_that_have_no_order_stay_where_they_are():
    """Python raises there."""
    assert interpret("it = [2, 'a', 1]\nit.sort()").constant("it") == [2, "a", 1]


def test_the_first_number_of_the_version_is_that_of_python_3():
    assert_like_python("import sys\nx = sys.version_info[0]")


def test_the_item_at_an_index_that_is_not_known_is_one_of_them():
    interpreted = interpret(f"{OUTSIDE}names = ['a', 'b']\none = names[outside.value()]\nnames += outside.items()")
    assert interpreted.options("one") == {"a", "b"}
    assert interpreted.evaluate("names[outside.value()]").why_unknown is not None


def test_items_of_objects():
    assert_like_python(
        """
        class Shelf:
            def __init__(self):
                self.boxes = {}

            def __getitem__(self, name):
                return self.boxes[name]

            def __setitem__(self, name, box):
                self.boxes[name] = box + '!'

        shelf = Shelf()
        shelf['a'] = 'nails'
        it = shelf['a']
        name = shelf.__dict__['boxes']['a']
        """
    )
    assert not interpret(f"{OUTSIDE}class Box:\n    pass\nit = Box()[0]\nouter = outside.Box()[0]").is_known("it")


def test_what_is_set_by_way_of_dict_is_an_attribute():
    interpreted = interpret(
        f"{OUTSIDE}class Box:\n    size = 1\nbox = Box()\nbox.__dict__['size'] = 2\n"
        "box.__dict__[outside.name()] = 3\nit = box.size"
    )
    assert interpreted.constant("it") == 2


def test_a_list_takes_no_item_that_it_has_not():
    interpreted = interpret("names = ['a']\nnames[3] = 'b'\nit = names[0]")
    assert interpreted.constant("it") == "a"


def test_tuples_as_keys():
    assert_like_python(
        """
        cells = {(0, 0): 'start', (0, (1, 'x')): 'wall'}
        cells[(2, 3)] = 'goal'
        found = [cells[(0, 0)], cells[0, (1, 'x')], cells.get((2, 3)), cells.get((9, 9), 'free')]
        is_there = [(0, 0) in cells, (1, 0) in cells]
        rows = [row + column for row, column in {(1, 2): 'a', (3, 4): 'b'}]
        squares = {(number, number): number * number for number in (1, 2)}
        square = squares[2, 2]
        cells.setdefault((0, 0), 'other')
        del cells[(2, 3)]
        left = sorted(cells.values())
        data = {}
        for path, value in {('a', 'b'): 1, ('a', 'c', 'd'): 2}.items():
            at = data
            for key in path[:-1]:
                at = at.setdefault(key, {})
            at[path[-1]] = value
        """
    )
