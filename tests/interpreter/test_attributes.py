"""Attributes: which class gives one, held against Python's own method resolution order."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from interpreting import OUTSIDE, assert_like_python, in_python, interpret

NAMES = "ABCDE"


@st.composite
def hierarchies(draw: st.DrawFn) -> str:
    """Classes that derive from each other in any way that Python allows, each with some of three attributes."""
    lines: list[str] = []
    for number, name in enumerate(NAMES):
        bases = draw(st.lists(st.sampled_from(NAMES[:number]), unique=True, max_size=3)) if number else []
        body = [
            f"    {attribute} = '{name}'" for attribute in draw(st.sets(st.sampled_from(["x", "y", "z"]), max_size=2))
        ]
        lines += [f"class {name}({', '.join(bases)}):", *(sorted(body) or ["    pass"])]
    return "\n".join(lines)


READ = "".join(
    f"\n{name}_{attribute} = getattr({name}(), '{attribute}', None)"
    f"\n{name}_{attribute}_of_class = getattr({name}, '{attribute}', None)"
    for name in NAMES
    for attribute in "xyz"
)


@given(hierarchies())
def test_an_attribute_is_of_the_class_that_python_finds_it_on(classes: str):
    try:
        expected = in_python(classes + READ)
    except TypeError:  # no consistent order: Python refuses such classes
        return
    found = interpret(classes + READ)
    for name, value in expected.items():
        if name.endswith("_of_class"):
            assert value in found.options(name), name
        elif "_" in name:
            assert found.constant(name) == value, name


@given(hierarchies())
def test_super_goes_on_where_python_does(classes: str):
    source = classes.replace(":\n", ":\n    def who(self):\n        return '{}' + getattr(super(), 'who', str)()\n")
    source = "\n".join(
        line.replace("{}", block) for block, line in _blocks(source)
    ) + "\n" + "\n".join(f"{name}_who = {name}().who()" for name in NAMES)  # fmt: skip
    try:
        expected = in_python(source)
    except TypeError:
        return
    found = interpret(source)
    for name in NAMES:
        if found.is_known(f"{name}_who"):
            assert found.constant(f"{name}_who") == expected[f"{name}_who"]


def _blocks(source: str) -> list[tuple[str, str]]:
    name, rows = "", []
    for line in source.splitlines():
        name = line[6] if line.startswith("class ") else name
        rows.append((name, line))
    return rows


def test_what_an_object_has_comes_before_what_its_class_has():
    assert_like_python(
        """
        class Robot:
            name = 'class'

            def method(self):
                return 'method'

        robot, other = Robot(), Robot()
        robot.name = 'own'
        robot.method = lambda: 'own method'
        names = robot.name, other.name, Robot.name, robot.method(), other.method()
        Robot.name = 'changed'
        changed = robot.name, other.name
        """
    )


def test_what_getattr_of_a_class_gives():
    assert_like_python(
        """
        class Any:
            real = 1

            def __getattr__(self, name):
                return name.upper()

        any_ = Any()
        values = any_.real, any_.other
        """
    )


def test_names_of_functions_and_classes():
    assert_like_python(
        """
        class Robot:
            def go(self):
                pass

        names = Robot.__name__, Robot().go.__name__, Robot.go.__name__, Robot().__class__.__name__
        same = type(Robot()) is Robot
        """
    )


def test_attributes_of_a_module():
    found = interpret(
        "import names\nimport package.inner\nnames.SET = 'here'\nit = names.PREFIX + names.SET\nno = names.MISSING\n"
        "inner = package.inner.X",
        names="PREFIX = '/'\nSET = 'there'",
        package____init__="",
        package__inner="X = 1",
    )
    assert found.constant("it") == "/here"
    assert found.reason("no") == "names has no 'MISSING'"
    assert found.constant("inner") == 1


@pytest.mark.parametrize(
    "expression",
    ["Robot().missing", "Robot.missing", "(lambda: 1).anything", "[].nothing", "'a'.nothing", "None.x", "Foreign().x"],
)
def test_what_is_not_there_is_unknown(expression: str):
    source = f"{OUTSIDE}class Robot:\n    pass\nclass Foreign(outside.Base):\n    pass\nit = {expression}"
    assert not interpret(source).is_known("it")


def test_an_attribute_that_an_outside_base_may_give_is_not_missing():
    found = interpret(
        f"{OUTSIDE}class Robot(outside.Base):\n    pass\nclass Plain:\n    pass\n"
        "maybe = getattr(Robot(), 'x', 'default')\nmissing = getattr(Plain(), 'x', 'default')"
    )
    assert not found.is_known("maybe")
    assert found.constant("missing") == "default"


def test_an_attribute_of_one_of_several_objects():
    found = interpret(
        f"{OUTSIDE}class Box:\n    def __init__(self, x):\n        self.x = x\n"
        "box = Box(1) if outside.value() else Box(2)\nit = box.x\nbox.x = 3\nafter = box.x"
    )
    assert found.options("it") == {1, 2}
    assert 3 in found.options("after")


def test_the_folder_of_a_path():
    assert interpret("from pathlib import Path\nit = str(Path('/a/b').parent)").options("it") <= {"/a", ...}


def test_what_python_says_of_classes_and_methods():
    found = interpret(
        f"{OUTSIDE}class Base:\n    def go(self):\n        return 'go'\n"
        "    @classmethod\n    def made(cls):\n        return cls.__name__\n"
        "class Robot(Base):\n    def go(self):\n        return super().go() + '!'\n"
        "    @classmethod\n    def made(cls):\n        return super().made() + '!'\n"
        "    def none(self):\n        return super().nothing\n"
        "robot = Robot()\nfunction = robot.go.__func__\nit = function(robot)\nmade = Robot.made(), robot.made()\n"
        "order = Robot.__mro__\nnone = robot.none()\nlength = len.__name__\nof_lambda = (lambda: 1).__name__\n"
        "class Own(outside.Base):\n    def more(self):\n        return super().more()\n"
        "more = Own().more()\nattr = Own.attr"
    )
    assert found.constant("it") == "go!"
    assert found.constant("made") == ("Robot!", "Robot!")
    for name in ("order", "none", "length", "of_lambda", "more", "attr"):
        assert not found.is_known(name), name


def test_attributes_that_are_set_on_what_is_not_an_object():
    found = interpret(
        f"{OUTSIDE}class Robot:\n    pass\ndef function():\n    pass\nRobot.name = 'a'\noutside.name = 'b'\n"
        "function.name = 'c'\noutside.value().name = 'd'\nit = Robot().name\nother = outside.name"
    )
    assert found.constant("it") == "a"
    assert not found.is_known("other")


def test_bases_that_are_not_known():
    found = interpret(
        f"{OUTSIDE}class Robot(outside.make()):\n    name = 'a'\n"
        "it = Robot.name\nother = Robot().other\nof_class = Robot.other\n"
        "class Plain(object):\n    pass\nplain = getattr(Plain(), 'x', 'none')"
    )
    assert found.constant("it") == "a"
    assert found.constant("plain") == "none"
    assert not found.is_known("other")
    assert not found.is_known("of_class")


def test_functions_and_methods_have_names():
    assert_like_python(
        """
        class Robot:
            def drive(self):
                return 'driven'

        robot = Robot()
        name, plain = robot.drive.__name__, Robot.drive.__name__
        driven = robot.drive.__func__(robot)
        """
    )
    assert interpret("def f():\n    pass\nit = f.__doc__").reason("it") == (
        "the attribute '__doc__' of a value that is not followed"
    )


def test_what_a_base_that_is_not_known_has_is_not_known():
    interpreted = interpret(
        f"{OUTSIDE}class Robot(outside.base()):\n    def ask(self):\n        return super().ask()\n"
        "attribute, method = Robot.speed, Robot().ask()\norder = Robot.__mro__"
    )
    assert not any(map(interpreted.is_known, ["attribute", "method", "order"]))


def test_a_property_without_a_setter_keeps_what_it_gives():
    # Python raises: nothing is assigned.
    interpreted = interpret(
        "class Robot:\n    @property\n    def speed(self):\n        return 1\n"
        "robot = Robot()\ntry:\n    robot.speed = 2\nexcept AttributeError:\n    pass\nit = robot.speed"
    )
    assert interpreted.constant("it") == 1


def test_a_name_grows_no_longer_than_is_followed():
    interpreted = interpret(f"{OUTSIDE}it = outside\nfor _ in range(40):\n    it = getattr(it, 'x' * 1000)")
    assert interpreted.reason("it") == "a name too long to follow"
