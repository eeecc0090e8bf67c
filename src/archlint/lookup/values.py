"""Where parameters are mentioned: declared, read, and set by launch files and parameter files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.parameter_uses import names_listed
from archlint.lookup.ends import subject_of
from archlint.lookup.mentions import Mention, Role, Subject
from archlint.lookup.parameter_objects import SETTING, compared_in, set_by
from archlint.model.given import Constant
from archlint.systems.overrides import key_matches, settings_of
from archlint.systems.parameter_overrides import known_name

if TYPE_CHECKING:
    from archlint.lookup.texts import Texts
    from archlint.model import ApiCall, Blueprint, ParameterDeclaration
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting

READING = frozenset(
    f"rclpy.node.Node.{name}" for name in ("get_parameter", "get_parameter_or", "has_parameter", "undeclare_parameter")
)


def owner_of(blueprint: Blueprint) -> str:
    """Which node class a parameter is of."""
    place = blueprint.place
    return f"{place.file}:{place.line}:{place.column} {blueprint.class_name}"


def mentions_of_parameters(system: System, rank: int, workspace: WorkspaceIndex, texts: Texts) -> Iterator[Mention]:
    """The parameters of a system's nodes."""
    for node in system.entries:
        for blueprint in node.blueprints:
            for declaration in blueprint.parameters:
                yield from _declared(declaration, node, blueprint, rank)
            for callback in blueprint.callbacks:
                yield from compared_in(system, callback, owner_of(blueprint), rank)
        yield from _set(node, rank, workspace, texts)
    for program in system.programs:
        for call in program.calls:
            if call.node is not None:
                yield from _read(system, call, call.node, rank)


def _declared(declaration: ParameterDeclaration, node: Node, blueprint: Blueprint, rank: int) -> Iterator[Mention]:
    name = declaration.name
    if name.text is None or name.resolution not in ("exact", "parameter"):
        return
    subject = Subject("parameter", name.text, owner_of(blueprint))
    if name.origin is not None:
        yield Mention(name.origin, subject, "declare", rank, name.text, node=node)
    if name.origin != declaration.place:
        yield Mention(declaration.place, subject, "call", rank, node=node)


def _read(system: System, call: ApiCall, blueprint: Blueprint, rank: int) -> Iterator[Mention]:
    if call.api in READING:
        place = call.argument_places.get("name")
        match call.arguments.get("name"):
            case Constant(value=str(name), origin=origin):
                subject = Subject("parameter", name, owner_of(blueprint))
                for where in dict.fromkeys((place, origin)):
                    if where is not None:
                        role: Role = "get" if where == (origin or place) else "argument"
                        yield Mention(where, subject, role, rank, name if where == origin else None)
    elif call.api == "rclpy.node.Node.get_parameters":
        for name, where in names_listed(system, call):
            yield Mention(where, Subject("parameter", name, owner_of(blueprint)), "get", rank, name)
    elif call.api in SETTING:
        yield from set_by(system, call, owner_of(blueprint), rank)


def _set(node: Node, rank: int, workspace: WorkspaceIndex, texts: Texts) -> Iterator[Mention]:
    if node.started is None:
        return
    owners = [owner_of(blueprint) for blueprint in node.blueprints] or [node.name or ""]
    name = known_name(node)
    for setting in settings_of(node.started, workspace.parameters_of):
        if key_matches(setting.key, name):
            place, written = _key_of(setting, texts)
            for owner in owners:
                yield Mention(place, Subject("parameter", setting.name, owner), "set", rank, written, node=node)
            yield from _names_in(setting, node, rank, texts)


def _key_of(setting: Setting, texts: Texts) -> tuple[Place, str | None]:
    """Where the name of a parameter that is set stands, and what of it: its last part, where it is the key of a map in
    other maps."""
    for written in dict.fromkeys((setting.name, setting.name.rpartition(".")[2])):
        place = texts.name_at(setting.place, written) or texts.value_behind(setting.place, written)
        if place is not None:
            return place, written
    return setting.place, None


def _names_in(setting: Setting, node: Node, rank: int, texts: Texts) -> Iterator[Mention]:
    """The topics that are called as the value of a parameter says."""
    if setting.value_place is not None:
        return
    written = setting.value if isinstance(setting.value, str) else None
    place = None if written is None else texts.value_set(setting.place, written)
    if place is None:
        return
    for end in node.endpoints:
        subject = subject_of(end)
        if end.parameter == setting.name and end.written == written and subject is not None:
            yield Mention(place, subject, "value", rank, written, end, node)


__all__ = ["READING", "mentions_of_parameters", "owner_of"]
