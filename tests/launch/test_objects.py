"""Launch's objects, and what they answer for."""

from __future__ import annotations

import pytest

from archlint.interpreter.heap import Store
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.modules import ModuleIndex
from archlint.interpreter.values import NONE, External, Instance, Known, ListValue, Unknown, Value
from archlint.launch.objects import MADE_BY_BASE, argument, class_name, kind_of, known_text, launch_object, made_by_base
from archlint.launch.tables import LaunchClass

NODE = launch_object(1, LaunchClass.NODE, None, {"name": Known("a"), "package": NONE})


def test_an_argument_that_is_none_was_not_given():
    assert NODE.argument("name") == Known("a")
    assert NODE.argument("package") is None
    assert NODE.given("package") == NODE.given("executable") == NONE
    assert argument(NODE, "name") == Known("a")
    assert argument(Unknown("why"), "name") is argument(None, "name") is None


@pytest.mark.parametrize(
    ("value", "kind", "name"),
    [
        (NODE, LaunchClass.NODE, "Node"),
        (Instance(External("launch.Node"), 2), LaunchClass.NODE, "Node"),
        (Instance(External("launch.actions.Later"), 2), None, "actions.Later"),  # launch's, and in no table
        (Instance(External("other.Node"), 2), None, ""),
        (Known("Node"), None, ""),
        (None, None, ""),
    ],
)
def test_the_class_of_launch_that_an_object_is_of(value: Value | None, kind: LaunchClass | None, name: str):
    assert (kind_of(value), class_name(value)) == (kind, name)


def test_what_stands_for_a_text():
    assert launch_object(1, LaunchClass.LAUNCH_CONFIGURATION, None, {}).is_substitution
    assert not NODE.is_substitution


@pytest.mark.parametrize(("value", "text"), [(Known("a"), "a"), (Known(5), "5"), (Unknown("why"), None), (None, None)])
def test_the_text_of_a_constant(value: Value | None, text: str | None):
    assert known_text(value) == text


def test_an_object_whose_class_derives_from_one_of_launchs():
    machine = Interpreter(ModuleIndex([], lambda file: None), Store())
    own = Instance(External("robot.Talker"), machine.store.new_key())
    assert made_by_base(machine, own) is None
    machine.store.set(own.key, MADE_BY_BASE, NODE)
    assert made_by_base(machine, own) is NODE
    assert made_by_base(machine, ListValue(own.key)) is None
