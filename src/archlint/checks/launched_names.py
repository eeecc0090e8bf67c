"""NME002 at the launch file that gives the bad name: launch, or rcl on the command line, refuses it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

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
    findings: dict[tuple[str, Place | str], _BadName] = {}
    namespaces: dict[str, tuple[str, Place | str]] = {}
    launched = system.launched
    if launched is None:
        return
    empty = _wants_a_value(launched)
    for started in launched.started:
        if started.dormant or started.kind == StartedKind.PROCESS:
            continue
        for bad in _bad_names(started):
            if _is_placeholder(bad.finding) or (empty and _has_empty_part(bad.finding)):
                continue
            key = (bad.finding.identity[0], bad.cause)  # the rounds of a loop give several names at one place
            if bad.rejected[0] == "namespace":
                key = namespaces.setdefault(bad.rejected[1], key)  # one value that all nodes are given
            first = findings.setdefault(key, bad)
            others = reported.setdefault(key, [Related(started.place, "")])
            if bad.rejected != first.rejected:
                others.append(Related(started.place, bad.finding.message))
            elif started.place not in (first.finding.place, others[0].place):
                others.append(Related(started.place, "this is part of the invalid name, too"))
    for key, (diagnostic, _, _) in findings.items():
        yield finding(
            diagnostic.code,
            diagnostic.place,
            diagnostic.message,
            help=diagnostic.help,
            related=reported[key][1:],
            identity=diagnostic.identity,
        )


def _wants_a_value(launched: Launched) -> bool:
    """Whether an argument says nothing unless somebody gives it a value: names that are made of it wait for that."""
    return any(
        argument.default is not None
        and _says_nothing(argument.default.text or "")
        and argument.name not in launched.arguments
        for argument in launched.declared
    )


def _has_empty_part(diagnostic: Finding) -> bool:
    """Whether the bad name is empty, or has nothing between two slashes or behind the last, or a mere ``-``."""
    _, *given = diagnostic.identity
    return any(_says_nothing(part) for name in given if name != "/" for part in name.removeprefix("/").split("/"))


def _is_placeholder(diagnostic: Finding) -> bool:
    """Whether the bad name has a part such as ``-``, which is there until somebody says how it is called."""
    _, *given = diagnostic.identity
    parts = (part for name in given for part in name.split("/"))
    return any(part not in ("", "~") and _says_nothing(part) for part in parts)


def _says_nothing(text: str) -> bool:
    """Whether a text is empty or has no letter and no digit, as what stands where a value is to be given; ``~`` is the
    node's own namespace."""
    return text != "~" and not any(character.isalnum() for character in text)


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


class _BadName(NamedTuple):
    """What ROS rejects, and why: ``cause`` is a place, or for a namespace that was pushed its name."""

    finding: Finding
    cause: Place | str
    rejected: tuple[str, str]
    """What is rejected of a node or a remapping, and its text."""


def _bad_names(started: Started) -> Iterator[_BadName]:
    for wrong, key in _wrong_of(started):
        text = started.name if key == "name" else started.namespace
        shown = "" if text is None or text.text is None else text.text
        own = started.places.get(key)
        what = "name of the node" if key == "name" else "namespace"
        yield _BadName(
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
            (key, shown),
        )
    for remap in started.remaps:
        refused = rejection_of(remap)
        if refused is not None:
            message, rejected = refused
            yield _BadName(
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
                rejected,
            )


def rejection_of(remap: Remap) -> tuple[str, tuple[str, str]] | None:
    """Why ROS rejects a remapping, and what of it."""
    source, target = remap.source, remap.target
    if source.text is None or target.text is None or not (_is_known(source) and _is_known(target)):
        return None
    rule = f"{source.text}:={target.text}"
    try:
        RemapRule.parse(rule)
    except ValueError as error:
        for text, end in ((target.text, "target"), (source.text, "source")):
            wrong = names.validate_topic_name(text)
            if wrong is not None:
                return f"ROS rejects the name '{text}', the {end} of this remapping: {wrong.message}", (end, text)
        return f"ROS rejects this remapping: {error}", ("rule", rule)
    return None


def _is_known(text: Text) -> bool:
    return text.resolution in ("exact", "parameter") and not names.has_placeholder(text.text or "")
