"""What annotations say of the messages that callbacks are called with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.libraries.rclpy.names import canonical, interface_and_section
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.ros.interfaces import MessageClass


def interface_of(code: facts.Facts, annotation: facts.Expr) -> tuple[str, MessageClass] | None:
    """The interface, and which of its classes, that an annotation in a file names through the imports of that file;
    None for anything else, and for a name that the file binds in several ways."""
    root, _, rest = annotation.dotted.partition(".")
    paths = set(_bound_to(code.body, root)) if root else set()
    if len(paths) != 1:
        return None
    [path] = paths
    if path is None:
        return None
    interface, section_name = interface_and_section(canonical(f"{path}.{rest}" if rest else path))
    return None if interface is None else (interface, section_name)


def _bound_to(body: Sequence[facts.Stmt], name: str) -> Iterator[str | None]:
    """The dotted names that a module imports under a name; None for each time that it binds it otherwise."""
    for statement in statements_of(body):
        match statement:
            case facts.Import(module=module, alias=None):
                first = module.partition(".")[0]
                if first == name:
                    yield first
            case facts.Import(module=module, alias=alias):
                if alias == name:
                    yield module
            case facts.ImportFrom(module=module, level=level, names=names):
                yield from (None if level else f"{module}.{what}" for what, bound in names if bound == name)
            case facts.Function(name=own) | facts.Class(name=own):
                if own == name:
                    yield None
            case facts.Assign(targets=targets):
                if any(target.variable == name for target in targets):
                    yield None


__all__ = ["interface_of"]
