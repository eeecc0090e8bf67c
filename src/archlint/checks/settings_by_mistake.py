"""PRM004: what of a launch file or a parameter file is not the name that is meant: a dict that ROS splits, and a key
that Python joins with the text in front of it."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.checks.registry import finding
from archlint.finding import Finding, Place, Related

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration
    from archlint.systems.nodes import Node
    from archlint.systems.overrides import Setting


def declared_dict(
    setting: Setting, declared: Mapping[str, Sequence[ParameterDeclaration]]
) -> tuple[str, Place | None] | None:
    """The parameter that a node declares and that is given a dict, of which launch or a parameter file makes this
    setting; with the place where a launch file gives it."""
    parts = setting.name.split(".")
    prefixes = (".".join(parts[:count]) for count in range(1, len(parts)))
    name = next((prefix for prefix in prefixes if prefix in declared), None)
    if name is None or (not setting.within and setting.written is None):
        return None
    if setting.written is None:
        return next(((key, place) for key, place in setting.within if key == name), None)
    return name, None


def split_dict(node: Node, name: str, place: Place, parts: Sequence[Setting]) -> Finding:
    """The finding for a parameter that is given a dict, of which these are the parts."""
    rows = [row for row in node.parameters if row.name.text == name]
    text = bool(rows) and rows[0].type == "string"
    in_launch = parts[0].written is None
    more = f" and {len(parts) - 1} more" if len(parts) > 1 else ""
    advice = (
        f"declare each of them in the node ('{parts[0].name}'), and read them with get_parameters_by_prefix('{name}')"
    )
    if rows and rows[0].type:
        advice = f"give it one value of type {rows[0].type}"
    if text:
        # Without its type, launch_ros reads a text as YAML and comes to a dict again.
        wrapped = "ParameterValue(json.dumps(…), value_type=str)"
        advice = f"pass it as a string: {wrapped}" if in_launch else "pass it as a string: put it in quotes"
    return finding(
        "PRM004",
        place,
        f"'{name}' is set to a dict, which {'launch' if in_launch else 'ROS'} splits: it sets "
        f"'{parts[0].name}'{more}, which {node.shown} does not declare, and '{name}' keeps its default",
        help=advice,
        related=[Related(row.place, f"'{name}' is declared here") for row in rows[:1]],
        node=node.name,
        identity=(node.name or "", name),
    )


def joined_key(name: str, declared: Collection[str]) -> str | None:
    """The declared name that a key of several lines ends with: a text in quotes stands in front of it, most often meant
    as a comment, and Python makes one of both."""
    text, _, last = name.rpartition("\n")
    return last.strip() if text and last.strip() in declared else None


def joined(node: Node, setting: Setting, key: str, related: Sequence[Related]) -> Finding:
    """The finding for a key that such a text is joined with."""
    return finding(
        "PRM004",
        setting.place,
        f"{node.shown} gets no '{key}' here: Python joins the text in quotes with the key that follows, and the node "
        "declares no parameter of that name",
        help="write the text as a comment, with # in front of each of its lines",
        related=related,
        node=node.name,
        identity=(node.shown, setting.name),
    )


__all__ = ["declared_dict", "joined", "joined_key", "split_dict"]
