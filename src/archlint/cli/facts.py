"""``archlint facts``: compile here, to link elsewhere."""

from __future__ import annotations

import argparse
import os
import posixpath
import sys
from dataclasses import replace
from pathlib import Path

from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    add_configuration,
    add_paths,
    add_running,
    add_scheduler,
    add_talking,
    paths_of,
    pool_of,
    settings_of,
)
from archlint.cli.parser import Parser
from archlint.cli.progress import Progress
from archlint.counted import counted
from archlint.engine.compile_facts import FactsError, write_facts
from archlint.engine.request import NothingToDo, Request


def parser() -> Parser:
    parser = Parser(
        "facts",
        "Compile a workspace into shards, one a package, which `archlint check --facts DIR...` links elsewhere.",
    )
    parser.usage = f"{parser.prog} -o DIR [OPTIONS] [PATH ...]"
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument("-o", metavar="DIR", dest="folder", required=True, help="the folder of the shards")
    output.add_argument(
        "--prefix",
        metavar="FOLDER",
        type=_inside,
        default="",
        help="where the working directory lies in the workspace that is linked, such as src/my_robot",
    )
    add_configuration(parser)
    add_running(parser)
    add_scheduler(parser)
    add_talking(parser)
    return parser


def _inside(text: str) -> str:
    folder = posixpath.normpath(text.replace(os.sep, "/"))
    if folder.startswith(("/", "../")) or folder == ".." or "\0" in folder:
        raise argparse.ArgumentTypeError(f"must be a folder inside the workspace, not {text}")
    return "" if folder == "." else folder


def run(arguments: argparse.Namespace) -> int:
    paths = paths_of(arguments)
    settings = settings_of(arguments, paths[0])
    request = Request(paths, settings, cached=not arguments.no_cache, jobs=arguments.jobs)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with pool_of(arguments) as pool, progress as monitor:
            written = write_facts(
                replace(request, monitor=monitor, pool=pool), Path(arguments.folder), arguments.prefix
            )
    except (NothingToDo, FactsError) as error:
        raise UsageError(str(error)) from None
    if not arguments.quiet:
        what = f"{counted(written.packages, 'package')} and {counted(written.files, 'file')}"
        console.note(f"Wrote the facts of {what} to {arguments.folder}.")
    progress.note_costs()
    return exits.FAILED if console.note_faults(written.faults, "compiled") else exits.CLEAN
