"""``archlint graph``: the communication graph, as text, data or a drawing."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace

from archlint import render
from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.keeping import keeper_of
from archlint.cli.options import (
    add_configuration,
    add_facts,
    add_launch,
    add_observed,
    add_paths,
    add_running,
    add_scheduler,
    add_talking,
    observed_of,
    pool_of,
)
from archlint.cli.output_format import add_format, format_of
from archlint.cli.parser import Parser
from archlint.cli.progress import Progress
from archlint.cli.requests import request_of
from archlint.cli.source_links import add_source_links, source_link_of
from archlint.cli.view_options import add_view, view_of
from archlint.engine.answers import Answer
from archlint.engine.drawn import Drawn
from archlint.engine.pipeline import NothingToDo, draw
from archlint.render.errors import CannotDraw
from archlint.render.selection import NothingOfThatName


def parser() -> Parser:
    parser = Parser("graph", "Draw which node talks to which, from the source alone.")
    parser.usage = f"{parser.prog} [OPTIONS] [PATH ...]"
    add_paths(parser)
    output = parser.add_argument_group("output")
    add_format(output, render.FORMATS)
    add_source_links(output)
    add_view(parser)
    add_launch(parser)
    add_observed(parser)
    add_facts(parser)
    add_configuration(parser)
    add_running(parser)
    add_scheduler(parser)
    add_talking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    format, view = _format(arguments), view_of(arguments)
    source_link = source_link_of(arguments.source_links, format)
    keeper = keeper_of(arguments, render.FORMATS[format].drawn)
    request = replace(request_of(arguments), observed=observed_of(arguments), keeper=keeper)
    to_terminal = arguments.file in (None, "-")
    color = to_terminal and console.wants_color(arguments.color, sys.stdout)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with pool_of(arguments) as pool, progress as monitor:
            drawn = draw(replace(request, monitor=monitor, pool=pool), format, color, view, source_link)
    except (NothingToDo, CannotDraw, NothingOfThatName) as error:
        raise UsageError(str(error)) from None
    if isinstance(drawn.output, str) and to_terminal:
        text = drawn.output
    else:
        text = ""
        console.write(drawn.output, arguments.file)
    answer = Answer(text, "" if arguments.quiet else _warnings(drawn), "", exits.CLEAN)
    console.give(answer)
    progress.note_costs()
    if console.note_faults(drawn.faults):
        return exits.FAILED
    if keeper is not None:
        keeper.keep(answer)
    return exits.CLEAN


def _warnings(drawn: Drawn) -> str:
    lines = [f"archlint: warning: {notice}" for notice in drawn.notices]
    lines += drawn.compared
    lines += [f"archlint: warning: {notice}" for notice in drawn.compared_notices]
    return "".join(map(console.noted, lines))


def _format(arguments: argparse.Namespace) -> render.FormatName:
    """The format asked for, or that of the file's suffix, or text."""
    asked = format_of(arguments, render.SUFFIXES)
    format = next(name for name in render.FORMATS if name == asked)
    if render.FORMATS[format].binary and arguments.file in (None, "-") and sys.stdout.isatty():
        raise UsageError(f"{format} cannot be printed to a terminal; write it to a file with -o")
    return format
