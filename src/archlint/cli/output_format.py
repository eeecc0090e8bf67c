"""The options ``--format`` and ``-o`` of what is written in several formats: the suffix of a file chooses one, too."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Mapping

from archlint.cli.exits import UsageError


def add_format(output: argparse._ArgumentGroup, formats: Iterable[str]) -> None:
    """``--format`` and ``-o`` for these formats, the first of which is meant where neither names one."""
    names = [*formats]
    output.add_argument(
        "--format",
        metavar="F",
        choices=names,
        help=f"one of {', '.join(names)} (default: the suffix of -o, else text)",
    )
    output.add_argument("-o", metavar="FILE", dest="file", help="write to FILE; its suffix chooses the format")


def format_of(arguments: argparse.Namespace, suffixes: Mapping[str, str]) -> str:
    """The format asked for, or that of the file's suffix, or text.  Raises :class:`UsageError`."""
    if arguments.format is not None:
        return str(arguments.format)
    file = arguments.file
    if file in (None, "-"):
        return "text"
    suffix = file.rpartition(".")[2].lower() if "." in file else ""
    if suffix not in suffixes:
        known = ", ".join(f".{known}" for known in suffixes)
        raise UsageError(f"the suffix of {file} does not name a format: use one of {known}, or --format")
    return suffixes[suffix]


__all__ = ["add_format", "format_of"]
