"""What ``trace`` and ``impact`` share: their options, the systems that they look at, and where output goes."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

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
from archlint.cli.output_format import add_format, format_of
from archlint.cli.progress import Progress
from archlint.cli.requests import request_of
from archlint.engine.answers import Answer
from archlint.records import dataclass
from archlint.suggestions import name_meant

if TYPE_CHECKING:
    from archlint.engine.keeper import Keeper
    from archlint.systems.model import System

FORMATS = ("text", "json", "mermaid", "dot", "svg")
_SUFFIXES = {
    "txt": "text",
    "json": "json",
    "mmd": "mermaid",
    "mermaid": "mermaid",
    "dot": "dot",
    "gv": "dot",
    "svg": "svg",
}

_Result = TypeVar("_Result")
Render = Callable[[str, Sequence[_Result], bool], str]
"""A format: of the name that was asked for, what was found, and whether colours are wanted."""


def add_reading(parser: argparse.ArgumentParser) -> None:
    """What is read, and how."""
    add_paths(parser)
    add_launch(parser)
    add_configuration(parser)
    add_running(parser)
    add_talking(parser)


def add_output(parser: argparse.ArgumentParser) -> None:
    """The format, and where it goes."""
    output = parser.add_argument_group("output")
    add_format(output, FORMATS)


@dataclass(frozen=True)
class Read:
    """The systems that were asked for, open ones first, who says how long that took, and who keeps the answer."""

    systems: list[System]
    progress: Progress
    keeper: Keeper | None


def read(arguments: argparse.Namespace) -> Read:
    """Raises :class:`UsageError`."""
    from archlint.engine.pipeline import NothingToDo, systems  # wrong words need none of it

    keeper = keeper_of(arguments, drawn=format_of(arguments, _SUFFIXES) == "svg")
    request = replace(request_of(arguments), keeper=keeper)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with progress as monitor:
            return Read(systems(replace(request, monitor=monitor)), progress, keeper)
    except NothingToDo as error:
        raise UsageError(str(error)) from None


def not_found(name: str, what: str, known: Iterable[str]) -> UsageError:
    """The error for a name that nothing has."""
    return UsageError(f"no {what} is called `{name}`{name_meant(name, known)}")


def give(
    arguments: argparse.Namespace, formats: Mapping[str, Render[_Result]], results: Sequence[_Result], by: Read
) -> int:
    """Write what was found in the format that was asked for; returns the exit status.  Raises :class:`UsageError`."""
    from archlint.render.errors import CannotDraw

    color = arguments.file in (None, "-") and console.wants_color(arguments.color, sys.stdout)
    try:
        drawn = formats[format_of(arguments, _SUFFIXES)](arguments.name, results, color)
    except CannotDraw as error:
        raise UsageError(str(error)) from None
    console.write(drawn, arguments.file)
    by.progress.note_costs()
    if by.keeper is not None:
        by.keeper.keep(Answer(drawn, "", "", exits.CLEAN))
    return exits.CLEAN


__all__ = ["FORMATS", "add_output", "add_reading", "give", "not_found", "read"]
