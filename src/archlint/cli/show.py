"""``archlint show NAME``: one node, topic, service, action or parameter with both ends and all places."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.keeping import keeper_of
from archlint.cli.options import (
    add_configuration,
    add_launch,
    add_paths,
    add_running,
    add_talking,
)
from archlint.cli.parser import Parser
from archlint.cli.progress import Progress
from archlint.cli.requests import request_of
from archlint.disk import read_regular
from archlint.engine.answers import Answer
from archlint.suggestions import name_meant
from archlint.workspace.tree import TEXT_LIMIT

if TYPE_CHECKING:
    from archlint.lookup.index import Index
    from archlint.systems.model import System


def parser() -> Parser:
    parser = Parser("show", "Show one name with both ends: who publishes, who listens, types, QoS, values and places.")
    parser.add_argument(
        "name",
        metavar="NAME",
        help="the name of a topic, service, action, node, node class, coordinate frame or parameter",
    )
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument(
        "--format", metavar="F", choices=("text", "json"), default="text", help="text (default) or json"
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write to FILE")
    add_launch(parser)
    add_configuration(parser)
    add_running(parser)
    add_talking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.engine.pipeline import NothingToDo, systems  # wrong words need none of it
    from archlint.lookup.by_name import known_names, summaries
    from archlint.render.shown import render_json, render_text

    keeper = keeper_of(arguments, drawn=False)
    request = replace(request_of(arguments), keeper=keeper)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with progress as monitor:
            indexes = _indexes(systems(replace(request, monitor=monitor)))
    except NothingToDo as error:
        raise UsageError(str(error)) from None
    answers = [answer for index in indexes for answer in summaries(index, arguments.name)]
    if not answers:
        known = sorted({name for index in indexes for name in known_names(index)})
        near = name_meant(arguments.name, known)
        raise UsageError(f"no node, topic, service, action, frame or parameter is called `{arguments.name}`{near}")
    color = arguments.file in (None, "-") and console.wants_color(arguments.color, sys.stdout)
    is_json = arguments.format == "json"
    text = render_json(arguments.name, answers) if is_json else render_text(answers, color=color)
    console.write(text, arguments.file)
    progress.note_costs()
    if keeper is not None:
        keeper.keep(Answer(text, "", "", exits.CLEAN))
    return exits.CLEAN


def _indexes(systems: list[System]) -> list[Index]:
    """One for each of the workspaces that were asked for."""
    from archlint.lookup.index import Index

    parts: dict[int, list[System]] = {}
    for system in systems:
        parts.setdefault(id(system.workspace), []).append(system)
    return [Index(part, _text_of) for part in parts.values()]


def _text_of(file: str) -> str | None:
    try:
        return read_regular(file, TEXT_LIMIT).decode("utf-8")
    except (OSError, UnicodeDecodeError):
        return None
