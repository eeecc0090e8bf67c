"""``archlint advise``: how each connection is used, and whether a topic, a service or an action fits."""

from __future__ import annotations

import argparse
import sys

from archlint.cli import console, exits
from archlint.cli.asked_systems import add_asking, add_paths, asked_systems
from archlint.cli.parser import Parser

FORMATS = ("text", "json", "markdown")


def parser() -> Parser:
    parser = Parser(
        "advise",
        "Say for each topic, service and action what it is used as (stream, command, query or task), and whether a "
        "topic, a service or an action fits.",
    )
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument(
        "--format", metavar="F", choices=FORMATS, default="text", help=f"one of {', '.join(FORMATS)} (default: text)"
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write to FILE")
    add_asking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.advice.advising import advice_of  # wrong words need none of it
    from archlint.render.advice import FORMATS as RENDERERS

    asked = asked_systems(arguments)
    color = arguments.file in (None, "-") and console.wants_color(arguments.color, sys.stdout)
    render = RENDERERS[arguments.format]
    console.write(render(advice_of(asked.systems, asked.settings.distros), color), arguments.file)
    return asked.end(exits.CLEAN)
