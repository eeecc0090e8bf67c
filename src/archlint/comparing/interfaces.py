"""Interfaces of the workspace: messages, services and actions, with their fields and constants."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.comparing.changes import Change, Judgement, Spot, Status, breaking, risky, safe
from archlint.comparing.graphs import Field, Graph, Interface
from archlint.comparing.parameters import shown


def interface_changes(before: Graph, after: Graph) -> Iterator[Change]:
    """What has changed of the interfaces; nothing where a side does not say which it has."""
    old = {interface.name: interface for interface in before.interfaces or ()}
    new = {interface.name: interface for interface in after.interfaces or ()}
    if before.interfaces is None or after.interfaces is None:
        return
    for name, interface in old.items():
        if name not in new:
            users = _users(after, name)
            judgement = (
                breaking(f"{users} still {'use' if ' and ' in users else 'uses'} it")
                if users
                else risky("no node here uses it; other packages may")
            )
            yield Change(Status.REMOVED, "interface", name, judgement, spot=Spot(interface.file, 1, before=True))
        else:
            yield from _of_fields(interface, new[name])
    for name, interface in new.items():
        if name not in old:
            yield Change(Status.ADDED, "interface", name, safe("nothing uses it yet that did before"),
                         spot=Spot(interface.file, 1))  # fmt: skip


def _users(graph: Graph, interface: str) -> str:
    names = sorted({node.shown for node in graph.nodes for _, end in node.ends() if end.type == interface})
    return f"{names[0]} and {len(names) - 1} more" if len(names) > 2 else " and ".join(names)


_REBUILD = "whatever was built with the old definition must be rebuilt, and bags recorded with it are not read"


def _of_fields(old: Interface, new: Interface) -> Iterator[Change]:
    before = {(field.section, field.name): field for field in old.fields}
    after = {(field.section, field.name): field for field in new.fields}
    for key, field in before.items():
        if key not in after:
            judgement = breaking(f"code that uses the field fails; {_REBUILD}")
            yield _field(Status.REMOVED, field, old, judgement, is_before=True)
        elif field.type != after[key].type:
            judgement = breaking(f"code that sets the field may fail; {_REBUILD}")
            yield _field(Status.CHANGED, after[key], new, judgement, aspect="type",
                         values=(field.type, after[key].type))  # fmt: skip
        elif field.default != after[key].default:
            yield _field(Status.CHANGED, after[key], new, risky("messages that do not set it have another value"),
                         aspect="default", values=(shown(field.default), shown(after[key].default)))  # fmt: skip
    for key, field in after.items():
        if key not in before:
            yield _field(Status.ADDED, field, new, risky(_REBUILD))
    common = [key for key in before if key in after], [key for key in after if key in before]
    if common[0] != common[1]:
        yield Change(
            Status.CHANGED, "interface", new.name, risky(_REBUILD), aspect="order of fields",
            values=(", ".join(name for _, name in common[0]), ", ".join(name for _, name in common[1])),
            spot=Spot(new.file, 1),
        )  # fmt: skip
    yield from _of_constants(old, new)


def _of_constants(old: Interface, new: Interface) -> Iterator[Change]:
    before = {(field.section, field.name): field for field in old.constants}
    after = {(field.section, field.name): field for field in new.constants}
    for key, constant in before.items():
        if key not in after:
            yield _field(Status.REMOVED, constant, old, breaking("code that uses the constant fails"), is_before=True,
                         is_constant=True)  # fmt: skip
        elif (constant.type, constant.value) != (after[key].type, after[key].value):
            judgement = risky("what was built before, and bags, have the old value")
            yield _field(Status.CHANGED, after[key], new, judgement, aspect="value", is_constant=True,
                         values=(shown(constant.value), shown(after[key].value)))  # fmt: skip
    for key, constant in after.items():
        if key not in before:
            yield _field(Status.ADDED, constant, new, safe("messages stay as they are"), is_constant=True)


def _field(
    status: Status,
    field: Field,
    interface: Interface,
    judgement: Judgement,
    is_before: bool = False,
    is_constant: bool = False,
    aspect: str | None = None,
    values: tuple[str, str] | None = None,
) -> Change:
    section = "" if field.section == "message" else f"{field.section}."
    return Change(
        status,
        "constant" if is_constant else "field",
        f"{section}{field.name}",
        judgement,
        owner=interface.name,
        aspect=aspect,
        values=values,
        type=field.type,
        spot=Spot(interface.file, field.line, is_before),
    )
