"""Callback groups that an entity is put into."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import (
    ClassValue,
    External,
    Instance,
    Known,
    Value,
)
from archlint.libraries.rclpy import names as rclpy_names

if TYPE_CHECKING:
    from archlint.libraries.run import Run


_GROUPS = {
    "rclpy.callback_groups.MutuallyExclusiveCallbackGroup": model.GroupKind.MUTUALLY_EXCLUSIVE,
    "rclpy.callback_groups.ReentrantCallbackGroup": model.GroupKind.REENTRANT,
}


def group_of(run: Run, value: Value | None) -> model.Group:
    """The callback group that an argument names."""
    match value:
        case None | Known(value=None):
            return model.Group(model.GroupKind.DEFAULT)
        case External(path=path) if path.endswith("default_callback_group"):
            return model.Group(model.GroupKind.DEFAULT)
        case Instance(cls=cls, key=key, place=place):
            bases = cls.external_bases() if isinstance(cls, ClassValue) else [cls.path]
            kinds = (_GROUPS.get(rclpy_names.canonical(base)) for base in bases)
            kind = next((kind for kind in kinds if kind is not None), None)
            if kind is not None:
                return model.Group(kind, str(key), place)
    return model.Group(model.GroupKind.UNKNOWN)
