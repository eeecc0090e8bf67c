"""Parameters of a node: declared, set by launch and parameter files."""

from __future__ import annotations

import json
from collections.abc import Iterator

from archlint.comparing.changes import Change, Judgement, Spot, Status, breaking, risky, safe
from archlint.comparing.graphs import Node, Parameter


def parameter_changes(old: Node, new: Node) -> Iterator[Change]:
    """What has changed of the parameters of a node that both sides have."""
    before = {parameter.name: parameter for parameter in old.parameters if parameter.name is not None}
    after = {parameter.name: parameter for parameter in new.parameters if parameter.name is not None}
    for name, parameter in before.items():
        if name in after:
            yield from _changed(name, parameter, after[name], new)
        else:
            yield _change(Status.REMOVED, name, parameter, old, _loss(name, new), is_before=True)
    for name, parameter in after.items():
        if name not in before:
            yield _change(Status.ADDED, name, parameter, new, _gain(name, parameter, new))


def _loss(name: str, new: Node) -> Judgement:
    if new.external:
        return risky("the launch no longer sets it")
    if not new.complete or any(parameter.name is None for parameter in new.parameters):
        return risky(f"not all parameters of {new.shown} are known: it may still be there")
    if name in (new.overrides or ()):
        return breaking("a launch or parameter file still sets it, which has no effect any more")
    return risky("no launch or parameter file here sets it; who does elsewhere is not heard")


def _gain(name: str, parameter: Parameter, new: Node) -> Judgement:
    if new.external:
        return risky("the launch sets it now")
    if name in (new.overrides or ()):
        return safe(f"a launch or parameter file sets it to {shown(parameter.override)}")
    return safe("nobody has to set it" if parameter.default is not None else "it has no default that is known")


def _changed(name: str, was: Parameter, now: Parameter, node: Node) -> Iterator[Change]:
    if was.type != now.type and was.type is not None and now.type is not None:
        is_set = name in (node.overrides or ())
        reason = "a launch or parameter file here sets it" if is_set else "files and commands that set it"
        yield _change(
            Status.CHANGED,
            name,
            now,
            node,
            breaking(f"{reason}: a value of the old type is refused" if is_set else f"{reason} with the old type fail"),
            aspect="type",
            values=(was.type, now.type),
        )
    if was.default != now.default:
        judgement = _of_default(was, now, node)
        yield _change(
            Status.CHANGED, name, now, node, judgement, aspect="default",
            values=(shown(was.default), shown(now.default)),
        )  # fmt: skip
    values = [parameter.override if parameter.override is not None else parameter.value for parameter in (was, now)]
    if values[0] != values[1]:
        names_end = any(end.parameter == name for _, end in node.ends())
        judgement = (
            safe("what it names is said of the ends that have this name")
            if names_end
            else risky("a launch or parameter file sets another value, and the node behaves otherwise")
        )
        yield _change(
            Status.CHANGED, name, now, node, judgement, aspect="value", values=(shown(values[0]), shown(values[1]))
        )


def _of_default(was: Parameter, now: Parameter, node: Node) -> Judgement:
    if any(end.parameter == now.name for _, end in node.ends()):
        return safe("what it names is said of the ends that have this name")
    if now.override is not None:
        return safe(f"a launch or parameter file sets it to {shown(now.override)}")
    known = was.default is not None and now.default is not None
    return risky("a node that nobody sets it for behaves otherwise" if known else "one of the values is not known")


def shown(value: object) -> str:
    """A value as in a parameter file."""
    return "not known" if value is None else json.dumps(value, ensure_ascii=False)


def _change(
    status: Status,
    name: str,
    parameter: Parameter,
    node: Node,
    judgement: Judgement,
    is_before: bool = False,
    aspect: str | None = None,
    values: tuple[str, str] | None = None,
) -> Change:
    return Change(
        status,
        "parameter",
        name,
        judgement,
        owner=node.shown,
        aspect=aspect,
        values=values,
        type=parameter.type,
        spot=Spot(parameter.file, parameter.line, is_before),
        cause=(node.class_name, parameter.file, parameter.line, name, *(values or ())),
    )
