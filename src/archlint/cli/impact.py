"""``archlint impact NAME``: what breaks when something is taken away or changed."""

from __future__ import annotations

import argparse

from archlint.cli.parser import Parser
from archlint.cli.tracing import add_output, add_reading, give, not_found, read


def parser() -> Parser:
    parser = Parser(
        "impact",
        "Show what breaks when something is taken away or changed: its users, what depends on these through callbacks, "
        "launch files, parameter files and packages.",
    )
    parser.add_argument(
        "name", metavar="NAME", help="the name of a topic, service, action, node, node class or interface"
    )
    add_reading(parser)
    add_output(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.dataflow.impacts import impacts_of  # wrong words need none of it
    from archlint.dataflow.interface_users import known_interfaces
    from archlint.dataflow.subjects import known_names
    from archlint.render.tracing.impact import IMPACTS

    done = read(arguments)
    systems = done.systems
    impacts = impacts_of(systems, arguments.name)
    if not impacts:
        known = {name for system in systems for name in known_names(system)}
        known.update(
            name for system in systems if system.workspace for name in known_interfaces(system.workspace, systems)
        )
        raise not_found(arguments.name, "topic, service, action, node or interface", known)
    return give(arguments, IMPACTS, impacts, done)
