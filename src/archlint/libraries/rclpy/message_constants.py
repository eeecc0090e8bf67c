"""The constants of messages that code names."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.libraries.rclpy import names
from archlint.libraries.rclpy.message_uses import OF_EVERY_MESSAGE, is_certain
from archlint.model import FieldUse

if TYPE_CHECKING:
    from archlint.libraries.run import Run
    from archlint.ros.interfaces import InterfaceTable, MessageClass
    from archlint.syntax.facts import Span
_CONSTANT = re.compile(r"[A-Z][A-Z0-9_]*\Z")


def note_constant(run: Run, path: str, name: str, span: Span) -> None:
    """Note that the code reads what looks like a constant from an interface class; ``path`` is dotted.

    Other attributes of such a class are functions, descriptors of its fields, and default values.
    """
    interface, section_name = names.interface_and_section(path)
    if run.interfaces is None or interface is None or not _CONSTANT.match(name) or not is_certain(run):
        return
    if name in OF_EVERY_MESSAGE or name.endswith("__DEFAULT"):
        return
    section = run.interfaces.section(interface, section_name)
    known = run.interfaces.has(interface, section_name, name)
    if section is None or known is None:
        return
    constants = tuple(constant.name for constant in section.constants)
    use = FieldUse(
        run.place(span),
        interface,
        section_name,
        name,
        "constant",
        known,
        () if known else constants,
        run.context.node,
        inside=None if known else _section_with(run.interfaces, interface, name),
    )
    run.program.field_uses.append(use)


def _section_with(interfaces: InterfaceTable, interface: str, constant: str) -> str | None:
    """The class of a service or action that has a constant: ``Dock.Response``."""
    sections: tuple[MessageClass, ...] = ("Request", "Response", "Goal", "Result", "Feedback")
    having = (section for section in sections if interfaces.constant(interface, section, constant) is not None)
    return next((f"{interface.rpartition('/')[2]}.{section}" for section in having), None)
