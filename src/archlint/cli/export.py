"""``archlint export``: declarations made from the source, in the formats of other tools."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from archlint.cli import console, exits
from archlint.cli.asked_systems import AskedSystems, add_asking, add_paths, asked_systems
from archlint.cli.exits import UsageError
from archlint.cli.parser import Parser

if TYPE_CHECKING:
    from archlint.render.declarations.rendered import Rendered
    from archlint.systems.model import System

_FORMATS = ("interface-yaml", "nodl", "json", "sros2-policy", "graphml")
_MOST_WARNINGS = 20


def parser() -> Parser:
    parser = Parser(
        "export",
        "Declare what the source says, for other tools: the interface of each node, the access that a launched system "
        "needs, or its graph. What is not known is left out, and said to be.",
    )
    parser.usage = f"{parser.prog} --format F [OPTIONS] [PATH ...]"
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument(
        "--format",
        metavar="F",
        choices=_FORMATS,
        required=True,
        help="interface-yaml (a document a node), nodl (NoDL 1), json (the same as data), sros2-policy (least "
        "privilege for each node of a launched system) or graphml",
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write to FILE (default: standard output)")
    add_asking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    asked = asked_systems(arguments)
    rendered = _rendered(arguments.format, asked)
    console.write(rendered.text, arguments.file)
    if not arguments.quiet:
        _warn(rendered.left_out)
    return asked.end(exits.CLEAN)


def _rendered(format: str, asked: AskedSystems) -> Rendered:
    """The systems in a format.  Raises :class:`UsageError` where it is about one system and there are several."""
    from archlint.render.declarations.rendered import Rendered  # a wrong option needs none of it

    match format:
        case "interface-yaml" | "nodl" | "json":
            from archlint.render.declarations import render
            from archlint.render.declarations.interface import declarations_of

            return render(format, declarations_of(asked.opened or asked.launched))
        case "sros2-policy":
            from archlint.render.declarations import sros2_policy
            from archlint.systems.implicit import with_implicit

            system = _one_system(asked)
            return sros2_policy.render(with_implicit(system, asked.settings.distro, of_actions=False))
    from archlint.engine.loading import combined
    from archlint.render.declarations import graphml

    return Rendered(graphml.render(combined(asked.opened or asked.launched)))


def _one_system(asked: AskedSystems) -> System:
    """The system that a policy is for: that of the launch file, or of all code where there is none."""
    if len(asked.launched) > 1:
        files = ", ".join(system.name or "" for system in asked.launched[:5])
        more = ", …" if len(asked.launched) > 5 else ""
        raise UsageError(f"a policy is for one system: name its launch file with --launch ({files}{more})")
    from archlint.engine.loading import combined  # as above

    return combined(asked.launched or asked.opened)


def _warn(left_out: tuple[str, ...]) -> None:
    for words in left_out[:_MOST_WARNINGS]:
        console.note(f"archlint: warning: left out: {words}")
    if len(left_out) > _MOST_WARNINGS:
        console.note(f"archlint: warning: {len(left_out) - _MOST_WARNINGS} more are left out; the output names them")
