"""Who uses an interface: endpoints of its type, interfaces that hold it, fields that code names, imports."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.lookup.mentions import Subject
from archlint.lookup.texts import Texts
from archlint.lookup.types_named import mentions_of_fields, mentions_of_imports
from archlint.place import Place
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


@dataclass(frozen=True, order=True)
class InterfaceUse:
    """A place that uses an interface, or one that holds it.  ``kind`` is ``endpoint``, ``interface``, ``field`` or
    ``import``."""

    kind: str
    place: Place
    words: str
    package: str | None = None


def interfaces_named(workspace: WorkspaceIndex, systems: Sequence[System], name: str) -> list[str]:
    """The interfaces that a name means: ``package/msg/Name``, ``package/Name`` or ``Name``."""
    return sorted(each for each in _all(workspace, systems) if name in _names_of(each))


def known_interfaces(workspace: WorkspaceIndex, systems: Sequence[System]) -> Iterator[str]:
    """All names that :func:`interfaces_named` knows."""
    for interface in _all(workspace, systems):
        yield from _names_of(interface)


def _all(workspace: WorkspaceIndex, systems: Sequence[System]) -> set[str]:
    """The interfaces of the workspace, and those that its nodes use."""
    table = workspace.interfaces
    own = set() if table is None else set(table.names())
    return own | {end.type for system in systems for end in system.endpoints if end.type is not None}


def _names_of(interface: str) -> tuple[str, str, str]:
    package, _, rest = interface.partition("/")
    name = rest.rpartition("/")[2]
    return interface, f"{package}/{name}", name


def uses_of(workspace: WorkspaceIndex, systems: Sequence[System], interface: str) -> list[InterfaceUse]:
    """All uses of an interface, in the order of kinds and source."""
    texts = Texts(workspace.tree.text)
    holders = _holders(workspace, interface)
    uses = {
        *_endpoints(systems, interface, holders),
        *_holding(workspace, texts, {interface, *holders}),
        *_fields(workspace, systems, interface),
    }
    for mention in mentions_of_imports(workspace, texts):
        if mention.subject == Subject("interface", interface):
            uses.add(InterfaceUse("import", mention.place, "imports it", workspace.package_of(mention.place.file)))
    return sorted(uses, key=lambda use: (_ORDER.index(use.kind), use.place, use.words))


_ORDER = ["endpoint", "interface", "field", "import"]


def _holders(workspace: WorkspaceIndex, interface: str) -> set[str]:
    """The interfaces of the workspace that have a field of it, directly or in another."""
    table = workspace.interfaces
    holds: dict[str, set[str]] = {}
    for name in () if table is None else table.names():
        definition = None if table is None else table.get(name)
        for section in () if definition is None else definition.sections:
            for field in section.fields:
                if not field.type.is_primitive:
                    holds.setdefault(field.type.qualified(name.partition("/")[0]), set()).add(name)
    holders: set[str] = set()
    left = [interface]
    while left:
        for holder in sorted(holds.get(left.pop(), ())):
            if holder not in holders:
                holders.add(holder)
                left.append(holder)
    return holders - {interface}


def _endpoints(systems: Sequence[System], interface: str, holders: set[str]) -> Iterator[InterfaceUse]:
    for system in systems:
        for end in system.endpoints:
            if end.type == interface or end.type in holders:
                inside = "" if end.type == interface else f", inside {end.type}"
                kind = end.kind.replace("_", " ")
                words = f"{kind} of {end.name or '?'} in {end.node.name or '?'}{inside}"
                yield InterfaceUse("endpoint", end.place, words, end.node.package)


def _holding(workspace: WorkspaceIndex, texts: Texts, interfaces: set[str]) -> Iterator[InterfaceUse]:
    for mention in mentions_of_fields(workspace, texts):
        if mention.subject.name in interfaces:
            words = f"a field of {mention.subject.name}"
            yield InterfaceUse("interface", mention.place, words, workspace.package_of(mention.place.file))


def _fields(workspace: WorkspaceIndex, systems: Sequence[System], interface: str) -> Iterator[InterfaceUse]:
    for system in systems:
        for program in system.programs:
            for use in program.field_uses:
                if use.type == interface:
                    does = {"read": "reads", "constant": "reads", "write": "sets", "keyword": "sets"}[use.access]
                    of = f" of the {use.section_name}" if use.section_name else ""
                    words = f"{does} {use.name}{of}"
                    yield InterfaceUse("field", use.place, words, workspace.package_of(use.place.file))


__all__ = ["InterfaceUse", "interfaces_named", "known_interfaces", "uses_of"]
