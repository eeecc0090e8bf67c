"""What annotations say of the messages that callbacks are called with."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.libraries.rclpy.names import canonical, interface_and_section
from archlint.python_code.signatures import signature_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.ros.interfaces import MessageClass
    from archlint.systems.model import System


@dataclass(frozen=True)
class AnnotatedMessage:
    """A parameter of a callback whose annotation is an interface, or one of its classes."""

    position: int
    """Which of the arguments it takes that the executor passes."""
    name: str
    place: Place
    interface: str
    section_name: MessageClass


def annotated_messages(system: System, callback: Callback) -> Iterator[AnnotatedMessage]:
    """The parameters of a callback, of those that nothing has bound yet, that are annotated with an interface."""
    signature, function = signature_of(system, callback), callback.function
    code = None if function is None else source_code(system).facts_at(function.place.file)
    if signature is None or function is None or code is None:
        return
    by_name = {param.name: param for param in signature.params}
    for position, name in enumerate(signature.names):
        match by_name[name].annotation:
            case facts.Name(span=span) | facts.Attribute(span=span) as annotation:
                interface, section_name = interface_of(code, annotation.dotted)
                if interface is not None:
                    place = Place(function.place.file, *span)
                    yield AnnotatedMessage(position, name, place, interface, section_name)


def interface_of(code: facts.Facts, dotted: str) -> tuple[str | None, MessageClass]:
    """The interface, and which of its classes, that a name means by the imports of its file; None for anything else,
    and for a name that the file binds in several ways."""
    path = imported_as(code, dotted)
    return (None, "") if path is None else interface_and_section(canonical(path))


def imported_as(code: facts.Facts, dotted: str) -> str | None:
    """What a dotted name means by the imports of its file; None where the file binds it otherwise, too."""
    root, _, rest = dotted.partition(".")
    paths = set(_bound_to(code.body, root)) if root else set()
    path = paths.pop() if len(paths) == 1 else None
    return f"{path}.{rest}" if path is not None and rest else path


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


__all__ = ["AnnotatedMessage", "annotated_messages", "imported_as", "interface_of"]
