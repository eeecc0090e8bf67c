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
class Both(Own, elsewhere.Mixin, Plain): pass
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


BASES = """\
import abc
import elsewhere
import rclpy.lifecycle
from elsewhere.node import LifecycleNode
from rclpy.lifecycle import LifecycleNodeMixin
from rclpy.node import Node as RosNode
from typing import Generic, TypeVar

Data = TypeVar('Data')
try:
    from rclpy.node import Node
except ImportError:
    Node = object
Simulated = elsewhere.Node if elsewhere.simulated else RosNode
Optional = None if elsewhere.broken else RosNode
KNOWN = (RosNode, abc.ABC)

class Own(type): pass
class Robot({bases}): pass
"""


@pytest.mark.parametrize(
    ("bases", "just"),
    [
        ("Node", True),  # without rclpy the program does not run
        ("RosNode", True),
        ("rclpy.lifecycle.Node", True),
        ("LifecycleNodeMixin, Node", True),
        ("LifecycleNode", False),  # the name says nothing: it is another package's
        ("RosNode, Generic[Data]", True),
        ("RosNode, metaclass=abc.ABCMeta", True),
        ("RosNode, metaclass=elsewhere.Meta", False),
        ("RosNode, metaclass=Own", False),  # what it does with the class is not followed
        ("RosNode, rate=10", True),
        ("*KNOWN", True),
        ("*elsewhere.BASES", False),
        ("Simulated", False),
        ("Optional", True),  # no class derives from None
        ("object", False),
    ],
)
def test_which_class_is_just_an_rclpy_node(bases: str, just: bool):
    cls = interpret(BASES.format(bases=bases), WITH_LIBRARIES).value("Robot")
    assert isinstance(cls, ClassValue)
    assert [described.just_rclpy for described in node_classes.described(cls)] == [just]


def test_each_class_of_a_node_is_described_by_itself(classes):
    rows = [
        (cls.name, cls.just_rclpy, [name for _, name in cls.bases]) for cls in node_classes.described(classes("Both"))
    ]
    assert rows == [("Both", False, ["Own", "Plain"]), ("Own", True, []), ("Plain", False, [])]
