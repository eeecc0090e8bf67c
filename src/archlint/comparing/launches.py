"""Launch files: their arguments, and what they remap."""

from __future__ import annotations

from collections.abc import Iterator

from archlint.comparing.changes import Change, Judgement, Spot, Status, breaking, risky, safe
from archlint.comparing.graphs import Graph, LaunchArgument, Node


def argument_changes(before: Graph, after: Graph) -> Iterator[Change]:
    """What has changed of the arguments of a launch file; nothing where a side does not say which it has."""
    if before.launch_arguments is None or after.launch_arguments is None:
        return
    old = {argument.name: argument for argument in before.launch_arguments}
    new = {argument.name: argument for argument in after.launch_arguments}
    for name, argument in old.items():
        if name not in new:
            judgement = risky("whoever sets it is not heard any more")
            yield _argument(Status.REMOVED, argument, after, judgement, is_before=True)
        else:
            yield from _changed(argument, new[name], after)
    for name, argument in new.items():
        if name not in old:
            judgement = (
                breaking("it has no default: whoever launches the file must set it")
                if argument.required
                else safe("it has a default")
            )
            yield _argument(Status.ADDED, argument, after, judgement)


def _changed(was: LaunchArgument, now: LaunchArgument, graph: Graph) -> Iterator[Change]:
    values = _default(was), _default(now)
    if now.required and not was.required:
        judgement = breaking("it has no default any more: whoever launches the file must set it")
        yield _argument(Status.CHANGED, now, graph, judgement, aspect="default", values=values)
    elif was.required and not now.required:
        yield _argument(Status.CHANGED, now, graph, safe("it need not be set any more"), aspect="default",
                        values=values)  # fmt: skip
    elif was.default != now.default:
        judgement = risky("launches that do not set it start something else")
        yield _argument(Status.CHANGED, now, graph, judgement, aspect="default", values=values)
    if was.choices != now.choices:
        refused = [choice for choice in was.choices if choice not in now.choices] if now.choices else []
        if refused or not was.choices:
            judgement = breaking(f"refused now: {', '.join(refused)}" if refused else "every other value is refused")
        else:
            judgement = safe("every value that was taken still is")
        listed = ", ".join(was.choices) or "any", ", ".join(now.choices) or "any"
        yield _argument(Status.CHANGED, now, graph, judgement, aspect="choices", values=listed)


def _default(argument: LaunchArgument) -> str:
    if argument.required:
        return "none"
    return "not known" if argument.default is None else f"'{argument.default}'"


def _argument(
    status: Status,
    argument: LaunchArgument,
    graph: Graph,
    judgement: Judgement,
    is_before: bool = False,
    aspect: str | None = None,
    values: tuple[str, str] | None = None,
) -> Change:
    return Change(
        status,
        "launch_argument",
        argument.name,
        judgement,
        owner=graph.system,
        aspect=aspect,
        values=values,
        spot=Spot(argument.file, argument.line, is_before),
        cause=(argument.file, argument.name, *(values or ())),
    )


def remapping_changes(old: Node, new: Node, moves: bool) -> Iterator[Change]:
    """The remappings of a started node that came and went; ``moves`` says whether ends of it have other names now,
    which are changes of their own."""
    before = {remap.source: remap.target for remap in old.remappings if remap.source is not None}
    after = {remap.source: remap.target for remap in new.remappings if remap.source is not None}
    if moves:
        judgement = safe("what it moves is said of the ends that it moves")
    elif new.external:
        judgement = risky(f"what it moves is not known: the source of {new.shown} is not here")
    else:
        judgement = safe("no end that is known has another name by it")
    spot = Spot(new.file, new.line) if new.file is not None and new.line is not None else None
    for source in dict.fromkeys((*before, *after)):
        was, now = before.get(source), after.get(source)
        if was == now and (source in before) == (source in after):
            continue
        status = Status.ADDED if source not in before else Status.REMOVED if source not in after else Status.CHANGED
        yield Change(
            status,
            "remapping",
            source,
            judgement,
            owner=new.shown,
            aspect="target",
            values=(
                (was or "not known") if source in before else None,
                (now or "not known") if source in after else None,
            ),
            spot=spot,
        )
