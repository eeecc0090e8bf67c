"""``archlint graph``: the communication graph, as text, data or a drawing."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace

from archlint import render
from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    Parser,
    add_configuration,
    add_launch,
    add_observed,
    add_paths,
    add_running,
    add_talking,
    launch_of,
    observed_of,
    paths_of,
    settings_of,
)
from archlint.cli.watch import Watch
from archlint.engine.pipeline import NothingToDo, Request, draw
from archlint.render.errors import CannotDraw


def parser() -> argparse.ArgumentParser:
    parser = Parser("graph", "Draw which node talks to which, from the source alone.")
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument(
        "--format",
        metavar="F",
        choices=list(render.FORMATS),
        help=f"one of {', '.join(render.FORMATS)} (default: the suffix of -o, else text)",
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write to FILE; its suffix chooses the format")
    output.add_argument("--all", action="store_true", help="include what rclpy creates for every node, such as /rosout")
    add_launch(parser)
    add_observed(parser)
    add_configuration(parser)
    add_running(parser)
    add_talking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    format = _format(arguments.format, arguments.file)
    launch, launch_arguments = launch_of(arguments)
    paths = paths_of(arguments)
    settings = settings_of(arguments, paths[0])
    request = Request(
        paths,
        settings,
        cached=not arguments.no_cache,
        jobs=arguments.jobs,
        launch=launch,
        launch_arguments=launch_arguments,
        observed=observed_of(arguments),
    )
    to_terminal = arguments.file in (None, "-")
    color = to_terminal and console.wants_color(arguments.color, sys.stdout)
    watch = Watch(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with watch as monitor:
            drawn = draw(replace(request, monitor=monitor), format, color, arguments.all)
    except (NothingToDo, CannotDraw) as error:
        raise UsageError(str(error)) from None
    console.write(drawn.output, arguments.file)
    if not arguments.quiet:
        for notice in drawn.notices:
            console.note(f"archlint: warning: {notice}")
        for sentence in drawn.compared:
            console.note(sentence)
        for notice in drawn.compared_notices:
            console.note(f"archlint: warning: {notice}")
    watch.note_costs()
    for fault in drawn.faults:
        console.note(f"archlint: {fault}")
    if drawn.faults:
        console.note("This is a fault of archlint, not of your code; everything else was followed.")
    return exits.FAILED if drawn.faults else exits.CLEAN


def _format(format: str | None, file: str | None) -> str:
    """The format asked for, or that of the file's suffix, or text."""
    to_terminal = file in (None, "-")
    if format is None and not to_terminal:
        assert file is not None
        format = render.by_suffix(file)
        if format is None:
            raise UsageError(f"the suffix of {file} does not name a format; use --format")
    format = format or "text"
    if render.FORMATS[format].binary and to_terminal and sys.stdout.isatty():
        raise UsageError(f"{format} cannot be printed to a terminal; write it to a file with -o")
    return format
