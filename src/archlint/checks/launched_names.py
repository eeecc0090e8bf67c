"""NME002 at the launch file that gives the bad name: launch, or rcl on the command line, refuses it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Related
from archlint.launch.kinds import StartedKind
from archlint.ros import names
from archlint.ros.remapping import RemapRule
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.model import Launched
    from archlint.launch.started import Remap, Started
    from archlint.model import Text
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


def names_given_by_launch(system: System) -> Iterator[Finding]:
    """Every bad name that a launch file gives: of nodes, of namespaces, and in remappings; each cause once."""
    reported: dict[tuple[str, Place | str], list[Related]] = {}
    findings: dict[tuple[str, Place | str], Finding] = {}
    launched = system.launched
    if launched is None:
        return
    empty = _wants_a_value(launched)
    for started in launched.started:
        if started.dormant or started.kind == StartedKind.PROCESS:
            continue
        for diagnostic, cause in _bad_names(started):
            if empty and _has_empty_part(diagnostic):
                continue
            key = (diagnostic.identity[0], cause)  # the rounds of a loop give several names at one place
            findings.setdefault(key, diagnostic)
            others = reported.setdefault(key, [Related(started.place, "")])
            if diagnostic.message != findings[key].message:
                others.append(Related(started.place, diagnostic.message))
            elif started.place not in (findings[key].place, others[0].place):
                others.append(Related(started.place, "this is part of the invalid name, too"))
    for key, diagnostic in findings.items():
        yield finding(
            diagnostic.code,
            diagnostic.place,
            diagnostic.message,
            help=diagnostic.help,
            related=reported[key][1:],
            identity=diagnostic.identity,
        )


def _wants_a_value(launched: Launched) -> bool:
    """Whether an argument is empty unless somebody gives it a value: names that are made of it wait for that."""
    return any(
        argument.default is not None and not argument.default.text and argument.name not in launched.arguments
        for argument in launched.declared
    )


def _has_empty_part(diagnostic: Finding) -> bool:
    """Whether the bad name is empty, or has nothing between two slashes or behind the last."""
    _, *given = diagnostic.identity
    return any(not name or "//" in name or (name.endswith("/") and name != "/") for name in given)


def is_given_by_launch(node: Node) -> bool:
    """Whether what is wrong with the name of a node is the launch file's doing."""
    return node.started is not None and any(key != "remap" for _, key in _wrong_of(node.started))


def is_renamed(system: System, node: Node) -> bool:
    """Whether launch files start a node of the open system: their systems have its final names."""
    workspace = system.workspace
    if system.launched is not None or workspace is None or node.blueprint is None:
        return False
    return key_of(node.blueprint) in workspace.started_by_launch


def _wrong_of(started: Started) -> Iterator[tuple[names.InvalidName, str]]:
    for text, check, key in (
        (started.name, names.validate_node_name, "name"),
        (started.namespace, names.validate_namespace, "namespace"),
    ):
        wrong = check(text.text) if text is not None and text.text is not None and _is_known(text) else None
        if wrong is not None:
            yield wrong, key


def _bad_names(started: Started) -> Iterator[tuple[Finding, Place | str]]:
    """Findings with what tells one cause from another: a place, or for a namespace that was pushed its name."""
    for wrong, key in _wrong_of(started):
        text = started.name if key == "name" else started.namespace
        shown = "" if text is None or text.text is None else text.text
        own = started.places.get(key)
        what = "name of the node" if key == "name" else "namespace"
        yield (
            finding(
                "NME002",
                own or started.place,
                f"ROS rejects the {what} '{shown}': {wrong.message}",
                help=(
                    "launch stops with an error at this node: use letters, digits and '_' only, with no digit in front"
                ),
                identity=(key, shown),
            ),
            own or shown,
        )
    for remap in started.remaps:
        message = _refused(remap)
        if message is not None:
            yield (
                finding(
                    "NME002",
                    remap.place,
                    message,
                    help=(
                        "rcl rejects the rule and the process ends before it creates a node: use letters, digits, "
                        "'_' and '/' only, with no digit after a '/'"
                    ),
                    identity=("remap", remap.source.text or "", remap.target.text or ""),
                ),
                remap.place,
            )


def _refused(remap: Remap) -> str | None:
    source, target = remap.source, remap.target
    if source.text is None or target.text is None or not (_is_known(source) and _is_known(target)):
        return None
    try:
        RemapRule.parse(f"{source.text}:={target.text}")
    except ValueError as error:
        wrong = names.validate_topic_name(target.text)
        if wrong is not None:
            return f"ROS rejects the name '{target.text}', the target of this remapping: {wrong.message}"
        wrong = names.validate_topic_name(source.text)
        if wrong is not None:
            return f"ROS rejects the name '{source.text}', the source of this remapping: {wrong.message}"
        return f"ROS rejects this remapping: {error}"
    return None


def _is_known(text: Text) -> bool:
    return text.resolution in ("exact", "parameter")
