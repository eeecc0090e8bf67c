"""``archlint diff BASE [HEAD]``: what a change does to the architecture."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    add_configuration,
    add_launch,
    add_running,
    add_talking,
    launch_of,
    paths_of,
    plugins_of,
    settings_of,
)
from archlint.cli.output_format import add_format, format_of
from archlint.cli.parser import Parser
from archlint.cli.progress import Progress

if TYPE_CHECKING:
    from archlint.comparing.changes import Change
    from archlint.engine.request import Request
    from archlint.engine.sides import Side
    from archlint.monitor import Monitor
    from archlint.render.changes.model import Difference

FORMATS = ("text", "json", "markdown", "mermaid", "dot", "svg", "png", "pdf")
_SUFFIXES = {
    **{"txt": "text", "json": "json", "md": "markdown", "mmd": "mermaid", "mermaid": "mermaid", "dot": "dot"},
    **{"gv": "dot", "svg": "svg", "png": "png", "pdf": "pdf"},
}


def parser() -> argparse.ArgumentParser:
    parser = Parser(
        "diff",
        "Show what a change does to the architecture: nodes, topics, services, actions, types, QoS, parameters, "
        "launch files, interfaces and findings, each change with what it breaks.",
    )
    what = "a git revision, a folder, or a file that `archlint graph --format json` has written"
    parser.add_argument("base", metavar="BASE", help=f"what to compare with: {what}")
    parser.add_argument(
        "head",
        metavar="HEAD",
        nargs="?",
        help="the same, after the change (default: the working tree, compared with where its branch left BASE)",
    )
    output = parser.add_argument_group("output")
    add_format(output, FORMATS)
    output.add_argument(
        "--fail-on",
        metavar="IMPACT",
        choices=("breaking", "risky"),
        help="end with exit status 1 where a change is breaking, or risky and worse (default: never)",
    )
    reading = parser.add_argument_group("what is read")
    reading.add_argument(
        "--paths",
        metavar="PATH",
        nargs="+",
        default=[],
        help="compare only what lies in these paths of both revisions (default: .)",
    )
    add_launch(parser)
    add_configuration(parser, with_plugins=True)
    add_running(parser)
    add_talking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.engine.request import NothingToDo  # wrong words need none of it
    from archlint.engine.sides import NoSide
    from archlint.render.errors import CannotDraw

    format = format_of(arguments, _SUFFIXES)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with progress as monitor:
            base, head = _sides(arguments, monitor)
    except (NoSide, NothingToDo) as error:
        raise UsageError(str(error)) from None
    if base.is_empty and head.is_empty:
        raise UsageError("neither side has anything that archlint reads")
    difference = _difference(base, head)
    color = arguments.file in (None, "-") and console.wants_color(arguments.color, sys.stdout)
    try:
        console.write(_rendered(format, difference, color), arguments.file)
    except CannotDraw as error:
        raise UsageError(str(error)) from None
    for notice in () if arguments.quiet else difference.notices:
        console.note(f"archlint: warning: {notice}")
    progress.note_costs()
    return exits.FINDINGS if _fails(arguments.fail_on, difference.changes) else exits.CLEAN


def _sides(arguments: argparse.Namespace, monitor: Monitor) -> tuple[Side, Side]:
    from archlint.engine.sides import of_request, same_systems

    is_change = arguments.head is None
    base = _side(arguments, arguments.base, "BASE", monitor, fork=is_change)
    if is_change:
        head = of_request(replace(_request(arguments), monitor=monitor), "the working tree")
    else:
        head = _side(arguments, arguments.head, "HEAD", monitor)
    return same_systems(base, head)


def _side(arguments: argparse.Namespace, word: str, name: str, monitor: Monitor, fork: bool = False) -> Side:
    from archlint.engine.sides import of_file, of_folder, of_revision

    if not word:
        raise UsageError(f"an empty word is no {name}: is a variable of the shell unset?")
    if os.path.isfile(word) and word.endswith(".json"):
        return of_file(word)
    if os.path.isdir(word):
        if arguments.paths:
            raise UsageError(f"--paths: {word} is a folder, all of which is compared")
        return of_folder(replace(_request(arguments, word), monitor=monitor), word)
    if word.endswith(".json"):
        raise UsageError(f"there is no file {word}")
    return of_revision(replace(_request(arguments), monitor=monitor), word, fork)


def _request(arguments: argparse.Namespace, folder: str | None = None) -> Request:
    from archlint.engine.request import Request

    launch, launch_arguments = (None, ()) if not arguments.launch else launch_of(arguments)
    paths = (".",) if folder is not None else paths_of(arguments)
    return Request(
        paths,
        settings_of(arguments, folder or paths[0], plugins_of(arguments)),
        cached=not arguments.no_cache,
        jobs=arguments.jobs,
        fixes=False,
        launch=launch,
        launch_arguments=launch_arguments,
    )


def _difference(base: Side, head: Side) -> Difference:
    from archlint.comparing.compare import compare
    from archlint.engine.sides import finding_changes
    from archlint.render.changes.model import Difference, SideName

    compared = compare(base.graphs, head.graphs)
    findings = finding_changes(base, head)
    return Difference(
        SideName(base.shown, base.commit),
        SideName(head.shown, head.commit),
        compared.changes,
        compared.sketch,
        None if findings is None else findings.appeared,
        None if findings is None else findings.vanished,
        (*base.notices, *head.notices),
    )


def _rendered(format: str, difference: Difference, color: bool) -> str | bytes:
    """Raises :class:`archlint.render.errors.CannotDraw`."""
    from archlint.render import dot, drawing
    from archlint.render.changes import json, markdown, mermaid, picture, text

    match format:
        case "json":
            return json.render(difference)
        case "markdown":
            return markdown.render(difference)
        case "mermaid":
            return mermaid.render(difference.sketch)
        case "text":
            return text.render(difference, color)
        case "dot":
            return dot.render(picture.diagram_of(difference))
        case "svg":
            return drawing.svg(picture.diagram_of(difference))
        case "png":
            return drawing.png(picture.diagram_of(difference))
    return drawing.pdf(picture.diagram_of(difference))


def _fails(limit: str | None, changes: Sequence[Change]) -> bool:
    from archlint.comparing.changes import Impact

    if limit is None:
        return False
    return any(change.impact.rank <= Impact(limit).rank for change in changes)
