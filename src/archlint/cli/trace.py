"""``archlint trace NAME``: where what arrives at a name comes from, and what depends on it."""

from __future__ import annotations

import argparse
from itertools import pairwise

from archlint.cli.exits import UsageError
from archlint.cli.parser import Parser
from archlint.cli.tracing import add_output, add_reading, give, not_found, read


def parser() -> Parser:
    parser = Parser(
        "trace",
        "Show where what arrives at a name comes from and what depends on it: through callbacks, timers, services, "
        "actions and transforms, with periods and waits.",
    )
    parser.add_argument(
        "name", metavar="NAME", help="the name of a topic, service, action, node, node class or coordinate frame"
    )
    ways = parser.add_argument_group("ways")
    ways.add_argument("--from", metavar="NAME", dest="origin", help="only the ways that come from this name")
    ways.add_argument("--to", metavar="NAME", dest="end", help="only the ways that lead to this name")
    add_reading(parser)
    add_output(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.dataflow.subjects import known_names  # wrong words need none of it
    from archlint.dataflow.systems import traces_of
    from archlint.render.tracing.by_format import TRACES

    done = read(arguments)
    systems = done.systems
    known = {name for system in systems for name in known_names(system)}
    traced = traces_of(systems, arguments.name, arguments.origin, arguments.end)
    for name in filter(None, (arguments.name, arguments.origin, arguments.end)):
        if not traced and not traces_of(systems, name):
            raise not_found(name, "topic, service, action, frame or node", known)
    if not traced:
        raise UsageError(_no_way(arguments))
    return give(arguments, TRACES, traced, done)


def _no_way(arguments: argparse.Namespace) -> str:
    names = [name for name in (arguments.origin, arguments.name, arguments.end) if name is not None]
    ways = [f"from `{first}` to `{second}`" for first, second in pairwise(names)]
    return f"no way is known {' and '.join(ways)}: a system must have one that goes through all of them"
