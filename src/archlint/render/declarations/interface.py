"""What a node declares, as far as it is known for certain, and what had to be left out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.model import ENDPOINT_KINDS, EntityKind
from archlint.records import dataclass
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.model import Blueprint, ParameterDeclaration, ParameterDescription
    from archlint.place import Place
    from archlint.ros.parameter_types import ParameterType
    from archlint.ros.qos import Qos
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node

OF_MESSAGES = (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER)


@dataclass(frozen=True)
class DeclaredEnd:
    """An end of a topic, service or action.  ``name`` is as the code gives it: relative, private or absolute."""

    kind: EntityKind
    name: str
    type: str
    qos: Qos | None
    """None of services and actions, and where it is not wholly known."""
    description: str
    place: Place


@dataclass(frozen=True)
class DeclaredParameter:
    name: str
    type: ParameterType | None
    """None of one that takes values of any type."""
    default: object
    has_default: bool
    """False where there is none, or it is not known."""
    description: ParameterDescription | None
    place: Place


@dataclass(frozen=True)
class LeftOut:
    """Something of a node that cannot be declared, and why."""

    what: str
    reason: str
    place: Place

    @property
    def words(self) -> str:
        return f"{self.what} at {self.place.file}:{self.place.line}: {self.reason}"


@dataclass(frozen=True)
class NodeInterface:
    """A node as its code makes it, before a launch file renames or remaps anything."""

    name: str
    """Without its namespace."""
    package: str | None
    executables: tuple[str, ...]
    lifecycle: bool
    description: str
    place: Place
    ends: tuple[DeclaredEnd, ...]
    parameters: tuple[DeclaredParameter, ...]
    left_out: tuple[LeftOut, ...]

    def of_kind(self, kind: EntityKind) -> list[DeclaredEnd]:
        return [end for end in self.ends if end.kind == kind]


@dataclass(frozen=True)
class Declarations:
    nodes: tuple[NodeInterface, ...]
    left_out: tuple[LeftOut, ...]
    """Nodes that cannot be declared at all."""

    @property
    def all_left_out(self) -> list[LeftOut]:
        """What was left out of the nodes, too."""
        return [*self.left_out, *(item for node in self.nodes for item in node.left_out)]


def declarations_of(systems: Sequence[System]) -> Declarations:
    """The nodes of some systems whose source is here, each once, by package and name; test code is not declared."""
    nodes: list[NodeInterface] = []
    left_out: list[LeftOut] = []
    seen: set[object] = set()
    for node in (node for system in systems for node in system.nodes if node.blueprint is not None and not node.test):
        assert node.blueprint is not None
        name = node.blueprint.name.text
        key = (key_of(node.blueprint), name, node.executables or node.executable)
        if key in seen:
            continue
        seen.add(key)
        if name is None or node.blueprint.name.resolution == "partial" or node.error is not None:
            reason = node.error or node.blueprint.name.reason or "its name is not known"
            left_out.append(LeftOut(f"a node of {node.blueprint.class_name}", reason, node.blueprint.place))
        else:
            nodes.append(_interface(node, node.blueprint, name))
    return Declarations(
        tuple(sorted(nodes, key=lambda node: (node.package or "", node.name, node.place))),
        tuple(sorted(left_out, key=lambda item: (item.place, item.what))),
    )


def _interface(node: Node, blueprint: Blueprint, name: str) -> NodeInterface:
    left_out: list[LeftOut] = []
    ends = tuple(dict.fromkeys(_ends(node, left_out)))
    parameters = tuple(_parameters(node, left_out))
    for each in node.blueprints:
        left_out += [LeftOut("perhaps more", reason, place) for place, reason in each.gaps]
    return NodeInterface(
        name,
        node.package,
        node.executables,
        blueprint.lifecycle,
        blueprint.docstring,
        blueprint.place,
        tuple(sorted(ends, key=lambda end: (ENDPOINT_KINDS.index(end.kind), end.name, end.place))),
        tuple(sorted(parameters, key=lambda parameter: (parameter.name, parameter.place))),
        tuple(sorted(set(left_out), key=lambda item: (item.place, item.what, item.reason))),
    )


def _ends(node: Node, left_out: list[LeftOut]) -> Iterator[DeclaredEnd]:
    for end in node.endpoints:
        what = end.kind.replace("_", " ")
        reason = _unknown_name(end)
        if reason is not None or end.written is None:
            left_out.append(LeftOut(f"a {what}", reason or "its name is not known", end.place))
        elif end.type is None:
            reason = end.creation.type_reason or "no reason is recorded"
            left_out.append(LeftOut(f"the {what} {end.written}", f"its type is not known: {reason}", end.place))
        else:
            qos = end.qos if end.kind in OF_MESSAGES and end.qos is not None and end.qos.known else None
            yield DeclaredEnd(end.kind, end.written, end.type, qos, _description(end), end.place)


def _unknown_name(end: Endpoint) -> str | None:
    """Why the name of an end is not one known name."""
    if end.error is not None:
        return end.error
    if end.creation.name.resolution in ("partial", "unknown"):
        return f"its name is known only at run time: {end.creation.name.reason or end.reason or 'it is computed'}"
    return None


def _description(end: Endpoint) -> str:
    """The docstring of the callback."""
    return next((callback.docstring for callback in end.creation.callbacks.values() if callback.docstring), "")


def _parameters(node: Node, left_out: list[LeftOut]) -> Iterator[DeclaredParameter]:
    names: set[str] = set()
    for parameter in node.parameters:
        name = parameter.name.text
        if name is None or parameter.name.resolution not in ("exact", "parameter"):
            reason = f"its name is known only at run time: {parameter.name.reason or 'it is computed'}"
            left_out.append(LeftOut("a parameter", reason, parameter.place))
        elif parameter.type is None and not parameter.dynamic:
            left_out.append(LeftOut(f"the parameter {name}", "its type is not known", parameter.place))
        elif name not in names:
            names.add(name)
            yield _parameter(parameter, name)


def _parameter(parameter: ParameterDeclaration, name: str) -> DeclaredParameter:
    default = parameter.given[0] if parameter.given else parameter.default
    has_default = bool(parameter.given) or (parameter.known and not parameter.without_default)
    return DeclaredParameter(name, parameter.type, default, has_default, parameter.description, parameter.place)


__all__ = ["Declarations", "DeclaredEnd", "DeclaredParameter", "LeftOut", "NodeInterface", "declarations_of"]
