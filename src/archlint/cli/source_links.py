"""``--source-links``: where the places of an HTML page lead."""

from __future__ import annotations

import argparse
import os
import re
from pathlib import Path

from archlint.cli.exits import UsageError
from archlint.engine.git import GitError, Repository
from archlint.render.page.model import SourceLink
from archlint.report.paths import folder_in_repository

_EDITORS = {"vscode": "vscode://file{path}:{line}:{column}", "file": "file://{path}"}
_REFUSED = {"javascript", "data", "vbscript", "blob", "about"}
"""Schemes with which a click would do something else than open a file."""
_KNOWN = {"file", "path", "line", "column", "commit"}


def add_source_links(group: argparse._ArgumentGroup) -> None:
    group.add_argument(
        "--source-links",
        metavar="WHERE",
        help="of an HTML page: open places in vscode, as file, or at an address such as "
        "'https://github.com/me/robot/blob/{commit}/{file}#L{line}'",
    )


def source_link_of(where: str | None, format: str) -> SourceLink | None:
    """Raises :class:`UsageError`."""
    if where is None:
        return None
    if format != "html":
        raise UsageError("--source-links is for --format html: no other format has links")
    address = _EDITORS.get(where, where)
    scheme, _, rest = address.partition(":")
    names = set(re.findall(r"\{(\w*)\}", address))
    if not rest or not re.fullmatch(r"[A-Za-z][A-Za-z0-9+.-]*", scheme) or scheme.lower() in _REFUSED:
        raise UsageError(
            f"--source-links: {where} is neither vscode nor file nor an address with a scheme such as https:"
        )
    if not names <= _KNOWN or not names & {"file", "path"}:
        raise UsageError(
            "--source-links: the address needs {file} or {path}; {line}, {column} and {commit} may be in it"
        )
    if "commit" in names:
        address = address.replace("{commit}", _commit())
    return SourceLink(address, Path.cwd().as_posix(), folder_in_repository(Path.cwd(), os.environ))


def _commit() -> str:
    try:
        commit = Repository(os.getcwd()).commit("HEAD")
    except GitError as error:
        raise UsageError(f"--source-links: {{commit}} is not known: {error}") from None
    if commit is None:
        raise UsageError("--source-links: {commit} is not known: the repository has no commit yet")
    return commit


__all__ = ["add_source_links", "source_link_of"]
