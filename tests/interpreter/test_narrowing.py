"""What a test decides, and what it proves of a variable inside a branch."""

from __future__ import annotations

from typing import Any

import pytest

from archlint.interpreter.values import Holed, Known, OneOf, Unknown
from interpreting import OUTSIDE, evaluate, interpret

SETUP = f"""{OUTSIDE}
class Robot:
    name = 'robot'

x = outside.which() and 'a' or 'b'
maybe = None
if outside.value():
    maybe = 'set'
choice = 1
if outside.one():
    choice = 2
elif outside.two():
    choice = 3
side = 'a'
if outside.side():
    side = 'b'
thing = Robot()
if outside.three():
    thing = 'text'
"""


@pytest.mark.parametrize(
    ("test", "name", "inside", "otherwise"),
    [
        ("maybe", "maybe", {"set"}, {None}),
        ("not maybe", "maybe", {None}, {"set"}),
        ("maybe is None", "maybe", {None}, {"set"}),
        ("maybe is not None", "maybe", {"set"}, {None}),
        ("maybe == 'set'", "maybe", {"set"}, {None}),
        ("choice == 1", "choice", {1}, {2, 3}),
        ("choice != 1", "choice", {2, 3}, {1}),
        ("choice in (1, 2)", "choice", {1, 2}, {3}),
        ("choice not in [3]", "choice", {1, 2}, {3}),
        ("choice == 1 and maybe", "choice", {1}, {1, 2, 3}),
        ("choice == 1 or choice == 2", "choice", {1, 2, 3}, {3}),
        ("not (choice == 1)", "choice", {2, 3}, {1}),
        ("(seen := choice) == 9 or maybe", "choice", {1, 2, 3}, {1, 2, 3}),
        ("outside.test(choice)", "choice", {1, 2, 3}, {1, 2, 3}),
        ("side.startswith('a')", "side", {"a"}, {"b"}),
        ("not side.endswith('a')", "side", {"b"}, {"a"}),
        ("side[0] == 'a'", "side", {"a"}, {"b"}),
        ("side[:1] != 'a'", "side", {"b"}, {"a"}),
        ("side[-1] == 'a'", "side", {"a"}, {"b"}),
        ("side[1] == 'a'", "side", {"a", "b"}, {"a", "b"}),
        ("isinstance(thing, str)", "thing", {"text"}, {...}),
        ("not isinstance(thing, (str, int))", "thing", {...}, {"text"}),
        ("isinstance(choice, int)", "choice", {1, 2, 3}, set()),
    ],
)
def test_what_a_test_proves(test: str, name: str, inside: set[Any], otherwise: set[Any]):
    found = interpret(f"{SETUP}\nyes = no = 'never'\nif {test}:\n    yes = {name}\nelse:\n    no = {name}\n")
    assert found.options("yes") - {"never"} == inside
    assert found.options("no") - {"never"} == otherwise


def test_what_is_proven_of_an_attribute():
    found = interpret(
        f"{OUTSIDE}class Box:\n    def __init__(self):\n        self.x = 1 if outside.value() else None\n"
        "    def read(self):\n        if self.x is None:\n            return 'none'\n"
        "        return self.x\nit = Box().read()"
    )
    assert found.options("it") == {"none", 1}


def test_after_a_way_out_the_rest_knows():
    found = interpret(
        f"{OUTSIDE}def read():\n    x = 1 if outside.value() else None\n"
        "    if x is None:\n        return 'none'\n    return x\nit = read()\n"
        "def checked():\n    x = 1 if outside.value() else None\n    assert x is not None\n    return x\n"
        "sure = checked()"
    )
    assert found.options("it") == {"none", 1}
    assert found.options("sure") == {1}


def test_what_equals_an_unknown_value_is_it():
    found = interpret(f"{OUTSIDE}x = outside.value()\nit = 'other'\nif x == 'a':\n    it = x")
    assert found.options("it") == {"a", "other"}


def test_a_parameters_default_decides_nothing_and_is_ruled_out_by_its_opposite():
    flag = Known(False, frozenset({"flag"}))
    assert evaluate("'on' if x else 'off'", x=flag) == OneOf((Known("on"), Known("off")))
    name = Known("", frozenset({"name"}))
    found = evaluate("x if x else 'none'", x=name)
    assert isinstance(found, OneOf)
    assert Known("", frozenset({"name"})) not in found.values  # where it is true, it is another one


@pytest.mark.parametrize(
    ("value", "verdict"),
    [
        (Known(""), False),
        (Known("a"), True),
        (Known(0.0), False),
        (Holed(("a", None), "data"), True),
        (Holed((None, None), "data"), None),
        (Unknown("data"), None),
        (OneOf((Known(1), Known(2))), True),
        (OneOf((Known(1), Known(0))), None),
    ],
)
def test_truth(value: Any, verdict: bool | None):
    found = evaluate("bool(x)", x=value)
    assert found.value is verdict if isinstance(found, Known) else verdict is None


@pytest.mark.parametrize(
    ("source", "verdict"),
    [
        ("[]", False),
        ("[1]", True),
        ("{}", False),
        ("{'a': 1}", True),
        ("print", True),
        ("(lambda: 1)", True),
        ("()", False),
    ],
)
def test_truth_of_collections_and_functions(source: str, verdict: bool):
    assert interpret(f"it = 1 if {source} else 0").options("it") == {int(verdict)}


@pytest.mark.parametrize(
    ("test", "arms"),
    [
        ("x and False", {"no"}),
        ("x and off", {"no"}),
        ("x and y and off", {"no"}),
        ("x and off and y", {"no"}),
        ("x or True", {"yes"}),
        ("not (x and off)", {"yes"}),
        ("not (x or not off)", {"no"}),
        ("(x and off) or off", {"no"}),
        ("y or (x and off)", {"yes", "no"}),
        ("x and True", {"yes", "no"}),
        ("x or off", {"yes", "no"}),
        ("x and y", {"yes", "no"}),
        ("x and flag", {"yes", "no"}),  # a parameter's default decides nothing
    ],
)
@pytest.mark.parametrize(
    "form",
    [
        "if {test}:\n    it = 'yes'\nelse:\n    it = 'no'\n",
        "it = 'yes' if {test} else 'no'\n",
        "it = 'no'\nwhile {test}:\n    it = 'yes'\n    break\nelse:\n    it = 'no'\n",
    ],
)
def test_an_operand_that_is_known_decides_a_test_behind_one_that_is_not(test: str, arms: set[str], form: str):
    parameter = "from rclpy.node import Node\nflag = Node('n').declare_parameter('flag', False).value\n"
    start = f"{OUTSIDE}{parameter}x = outside.one()\ny = outside.two()\noff = False\n"
    assert interpret(start + form.format(test=test)).options("it") == arms


def test_the_value_of_a_test_that_never_holds_is_still_not_known():
    found = interpret(f"{OUTSIDE}x = outside.one()\nit = x and ''\n")
    assert isinstance(found.value("it"), OneOf) and found.options("it") == {..., ""}


def test_an_attribute_of_what_a_call_gives_is_not_kept():
    # The next call may give another.
    interpreted = interpret(
        f"{OUTSIDE}class Robot:\n    def __init__(self):\n        self.arm = None\nrobot = Robot()\n"
        "if outside.value():\n    robot.arm = 'arm'\n"
        "def get():\n    return robot\nif get().arm is not None:\n    it = robot.arm"
    )
    assert interpreted.options("it") == {None, "arm"}


def test_a_test_proves_nothing_of_what_is_no_variable_or_shared():
    interpreted = interpret(
        f"{OUTSIDE}if print is not None and outside.value is not None and isinstance(outside.x, outside.Class):\n"
        "    it = 'yes'\n"
    )
    assert interpreted.options("it") == {"yes"}


def test_a_branch_that_the_default_of_a_parameter_contradicts():
    mode = Known("fast", frozenset({"mode"}))
    given = interpret("def f(mode):\n    if mode == 'slow':\n        return mode\n    return 'other'")
    assert {value.constant for value in given.evaluate("f(mode)", mode=mode).inner} == {"slow", "other"}


@pytest.mark.parametrize(
    ("pattern", "options"),
    [
        ("{'a': _, **rest}", {"it"}),
        ("{'b': _}", {"other"}),
        ("[1, int()]", {"it", "other"}),
        ("{'a': [x]}", {"it", "other"}),
    ],
)
def test_patterns_that_take_a_value_apart(pattern: str, options: set[str]):
    subject = "[1, 2]" if pattern.startswith("[") else "{'a': outside.value()}"
    lines = f"match {subject}:\n    case {pattern}:\n        it = 'it'\n    case _:\n        it = 'other'"
    assert interpret(OUTSIDE + lines).options("it") == options
