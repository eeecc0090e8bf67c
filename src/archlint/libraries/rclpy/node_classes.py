"""Which classes of the workspace are nodes: this is decided here, and nowhere else."""

from __future__ import annotations

import sys

from archlint import model
from archlint.finding import Place
from archlint.interpreter.python_classes import PLAIN_BASES
from archlint.interpreter.values import ClassValue, External, Unknown, Value
from archlint.libraries.rclpy import names


def is_node(cls: ClassValue) -> bool:
    """Whether a class derives from rclpy's Node."""
    return any(path in names.NODE_CLASSES for path in cls.external_bases())


def is_lifecycle(cls: ClassValue) -> bool:
    """Whether a class derives from rclpy's LifecycleNode, or from what makes one of a Node."""
    return not {names.LIFECYCLE_NODE, names.LIFECYCLE_MIXIN}.isdisjoint(cls.external_bases())


def may_be_node(cls: ClassValue) -> bool:
    """Whether a class derives from rclpy's Node, or from something elsewhere that is called or known as a node."""
    return is_node(cls) or any(map(_may_be_node, cls.external_bases()))


def _may_be_node(path: str) -> bool:
    return path in names.FOREIGN_NODES or (path.endswith("Node") and not names.is_of_other_system(path))


def may_inherit(cls: ClassValue) -> bool:
    """Whether a class has a base outside of the workspace that may give it attributes."""
    return any(
        isinstance(base, Unknown) or (isinstance(base, External) and base.path not in PLAIN_BASES) for base in cls.mro
    )


def has_only(cls: ClassValue) -> bool:
    """Whether a class has nothing but what the workspace and, where it is a node, rclpy's Node give it: no base is
    unknown or of another package, whichever branch is taken, and no metaclass has a say in it."""
    return all(_adds_nothing_unseen(base) for base in cls.mro)


def _adds_nothing_unseen(base: Value) -> bool:
    match base:
        case ClassValue(other_bases=others, metaclass=metaclass):
            return all(map(_is_seen, others)) and (metaclass is None or metaclass.dotted in PLAIN_BASES)
        case _:
            return base.dotted in _KNOWN


def _is_seen(other: Value) -> bool:
    match other:
        case ClassValue():
            return has_only(other)
        case _:
            return other.dotted in _KNOWN


_KNOWN = names.NODE_CLASSES | PLAIN_BASES


def is_harmless(path: str) -> bool:
    """Whether a foreign class is rclpy's or Python's own, none of which spins a node that derives from it."""
    return path.partition(".")[0] in _HARMLESS


_HARMLESS = sys.stdlib_module_names | {"rclpy", "?"}


def may_spin_itself(cls: ClassValue) -> bool:
    """Whether the constructor of a base from elsewhere may start a thread that spins the node."""
    foreign = (path for path in cls.external_bases() if path not in _KNOWN and path not in names.FOREIGN_NODES)
    return not all(map(is_harmless, foreign))


def described(cls: ClassValue) -> tuple[model.NodeClass, ...]:
    """A class of a node and the bases of it that are of this workspace, in Python's order of resolution."""
    return tuple(_described(base) for base in cls.classes)


def _described(cls: ClassValue) -> model.NodeClass:
    (place, name), *bases = keys(cls)
    just_rclpy = is_node(cls) and has_only(cls)
    return model.NodeClass(place, name, tuple(bases), just_rclpy=just_rclpy, docstring=cls.ir.docstring)


def keys(cls: ClassValue) -> tuple[model.ClassKey, ...]:
    """What names a class, and the bases of it that are of this workspace, in all programs."""
    return tuple((Place(base.scope.module.path, *base.ir.name_span), base.qualified) for base in cls.classes)


__all__ = [
    "described",
    "has_only",
    "is_harmless",
    "is_lifecycle",
    "is_node",
    "keys",
    "may_be_node",
    "may_inherit",
    "may_spin_itself",
]
