"""Nodes that nothing in the workspace passes to what works on them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.finding import Place
from archlint.interpreter.values import (
    ClassValue,
    Instance,
)
from archlint.libraries.rclpy.blueprints import new_blueprint
from archlint.reasons import NotPassed

if TYPE_CHECKING:
    from archlint.libraries.run import Run


def _whose(cls: ClassValue) -> tuple[str, Place, str | None]:
    module = cls.scope.module
    return cls.qualified, Place(module.path, *cls.ir.name_span), module.file.package


def _holder(run: Run, instance: Instance | None = None) -> tuple[str, Place, str | None]:
    """Which class (or function) holds a node that nobody passes: the object whose method is running."""
    cls = None if instance is None else instance.own_class
    if cls is not None:
        return _whose(cls)
    for activation in reversed(run.activations):
        cls = None if activation.self_value is None else activation.self_value.own_class
        if cls is not None:
            return _whose(cls)
        if activation.function is not None:
            place = Place(activation.module.path, *activation.function.ir.name_span)
            return activation.qualified, place, activation.module.file.package
    activation = run.activation
    return activation.qualified, Place(activation.module.path, 1, 1, 1, 1), activation.module.file.package


def blueprint_of_unknown_caller(
    run: Run, instance: Instance | None = None, annotated: tuple[model.ClassKey, str] | None = None
) -> model.Blueprint:
    """The blueprint of a node that nobody in the workspace passes to a helper."""
    name, place, package = _holder(run, instance)
    key = f"{place.file}:{place.line}#held" + (f" {annotated}" if annotated is not None else "")
    known = run.nodes.by_key.get(key)
    if known is not None:
        return known
    blueprint = new_blueprint(run, name, place, key, package)
    blueprint.caller_unknown = True
    blueprint.annotated = annotated
    blueprint.constructed = True
    blueprint.name = model.Text(None, "unknown", reason=NotPassed("nothing in the workspace passes a node"))
    # Like every node that no launch file puts elsewhere, it is in the root namespace.
    return blueprint


def unknown_caller_key(run: Run) -> int:
    name, place, _ = _holder(run)
    return -abs(hash_of(f"{place.file}:{place.line}:{name}"))


def hash_of(text: str) -> int:
    """A number for a text that is the same in every process."""
    import zlib

    return zlib.crc32(text.encode("utf-8", "surrogatepass")) + 1
