"""Which classes of the workspace are nodes."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import ClassValue
from archlint.libraries.rclpy import node_classes
from interpreting import WITH_LIBRARIES, interpret

SOURCE = """\
import enum
import elsewhere
from rclpy.lifecycle import Node as Managed
from rclpy.node import Node
from turtlebot4_navigation.turtlebot4_navigator import TurtleBot4Navigator

class Own(Node): pass
class Below(Own): pass
class Lifecycle(Managed): pass
class Mixed(elsewhere.Mixin, Node): pass
class Named(elsewhere.BaseNode): pass
class Navigator(TurtleBot4Navigator): pass
class Other(elsewhere.Widget): pass
class Plain: pass
class Colour(enum.Enum): pass
class Computed(elsewhere.base()): pass
"""


@pytest.fixture(scope="module")
def classes():
    found = interpret(SOURCE, WITH_LIBRARIES)

    def of(name: str) -> ClassValue:
        value = found.value(name)
        assert isinstance(value, ClassValue)
        return value

    return of


@pytest.mark.parametrize(
    ("name", "node", "may_be", "may_inherit", "only"),
    [
        ("Own", True, True, True, True),
        ("Below", True, True, True, True),
        ("Lifecycle", True, True, True, True),
        ("Mixed", True, True, True, False),
        ("Named", False, True, True, False),
        ("Navigator", False, True, True, False),
        ("Other", False, False, True, False),
        ("Plain", False, False, False, True),
        ("Colour", False, False, False, True),
        ("Computed", False, False, True, False),
    ],
)
def test_what_a_class_is_follows_from_its_bases(classes, name, node, may_be, may_inherit, only):
    cls = classes(name)
    assert node_classes.is_node(cls) is node
    assert node_classes.may_be_node(cls) is may_be
    assert node_classes.may_inherit(cls) is may_inherit
    assert node_classes.has_only(cls) is only


def test_a_lifecycle_node_is_told_from_others(classes):
    assert [name for name in ("Own", "Lifecycle", "Navigator") if node_classes.is_lifecycle(classes(name))] == [
        "Lifecycle"
    ]


def test_a_class_has_the_keys_of_all_its_own_bases(classes):
    assert [qualified for _, qualified in node_classes.keys(classes("Below"))] == ["Below", "Own"]
