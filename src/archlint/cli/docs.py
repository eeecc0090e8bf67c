"""``archlint docs``: pages about nodes and launch files, to commit beside the code."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

from archlint.cli import console, exits
from archlint.cli.asked_systems import add_asking, add_paths, asked_systems
from archlint.cli.exits import UsageError
from archlint.cli.parser import Parser
from archlint.counted import counted

_FOLDER = "docs/architecture"


def parser() -> Parser:
    parser = Parser(
        "docs",
        "Write a page of Markdown for each node and each launch file, and an index of them: endpoints, parameters, "
        "what it needs to run, and a picture of who talks to whom.",
    )
    parser.usage = f"{parser.prog} [OPTIONS] [PATH ...]"
    add_paths(parser)
    output = parser.add_argument_group("output")
    output.add_argument(
        "-o", metavar="DIR", dest="folder", default=_FOLDER, help=f"the folder of the pages (default: {_FOLDER})"
    )
    output.add_argument(
        "--check",
        action="store_true",
        help="write nothing; name the pages that are stale, and end with exit status 1 if there are any",
    )
    add_asking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    if not arguments.folder:
        raise UsageError("-o: an empty word is no path: is a variable of the shell unset?")
    folder = Path(arguments.folder)
    if folder.exists() and not folder.is_dir():
        raise UsageError(f"{folder} is a file: -o names the folder of the pages")
    asked = asked_systems(arguments)
    from archlint.engine.page_files import NotOurs, bring_up_to_date, stale  # wrong words need none of it
    from archlint.render.pages import pages

    to_sources = Path(os.path.relpath(Path(), folder)).as_posix()
    written = pages(asked.opened, asked.launched, to_sources)
    try:
        todo = (stale if arguments.check else bring_up_to_date)(folder, written)
    except NotOurs as error:
        raise UsageError(str(error)) from None
    except OSError as error:
        raise UsageError(f"cannot write the pages: {error.filename}: {error.strerror}") from None
    if arguments.check:
        for words, names in (("stale", todo.changed), ("missing", todo.missing), ("not needed", todo.unneeded)):
            console.say("".join(f"{(folder / name).as_posix()}: {words}\n" for name in names))
        if todo and not arguments.quiet:
            console.note("Run `archlint docs` with the same options to bring the pages up to date.")
    elif not arguments.quiet:
        changes = len(todo.changed) + len(todo.missing)
        removed = f", {len(todo.unneeded)} removed" if todo.unneeded else ""
        console.note(f"{counted(len(written), 'page')} in {folder.as_posix()}: {changes} written{removed}.")
    return asked.end(exits.FINDINGS if arguments.check and todo else exits.CLEAN)
