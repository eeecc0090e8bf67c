"""Modules of ROS that are not here."""

from __future__ import annotations

from interpreting import WITH_LIBRARIES, interpret


def test_no_class_inherits_from_a_module():
    found = interpret("import rclpy.node as Node\nclass Robot(Node):\n    pass\nit = Robot", WITH_LIBRARIES)
    assert found.reason("it") == "no class can inherit from a module"


def test_star_imports_of_packages_that_are_not_here():
    found = interpret("from outside.msg import *\nfrom other import *\nit = Scan\nwhich = helper", WITH_LIBRARIES)
    assert str(found.value("it")) == "External(path='outside.msg.Scan', via=frozenset())"
    assert "one of several star imports" in found.reason("which")
