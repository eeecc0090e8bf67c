"""Paths as a service sees them: relative to the repository, wherever in it the run was started."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.report.model import Report

_CHECKOUTS = ("GITHUB_WORKSPACE", "CI_PROJECT_DIR")
"""Where GitHub and GitLab say that the checkout is: to them a path is relative to this folder."""


def folder_in_repository(here: Path, environment: Mapping[str, str]) -> str:
    """The path from the repository's root to ``here``, with ``/``; ``.`` for the root itself, or without one."""
    here = here.resolve()
    for checkout in (Path(environment[name]).resolve() for name in _CHECKOUTS if environment.get(name)):
        if here.is_relative_to(checkout):
            return here.relative_to(checkout).as_posix()
    for folder in (here, *here.parents):
        if os.path.lexists(folder / ".git"):
            return here.relative_to(folder).as_posix()
    return "."


def findings_in_repository(report: Report) -> list[Finding]:
    """The findings of a report, each place by its path in the repository."""
    if report.folder == ".":
        return list(report.findings)
    return [_moved(finding, report.folder) for finding in report.findings]


def _moved(finding: Finding, folder: str) -> Finding:
    related = tuple(replace(other, place=_place(other.place, folder)) for other in finding.related)
    system = None if finding.system is None else _path(finding.system, folder)
    return replace(finding, place=_place(finding.place, folder), related=related, system=system)


def _place(place: Place, folder: str) -> Place:
    return replace(place, file=_path(place.file, folder))


def _path(file: str, folder: str) -> str:
    return file if PurePath(file).is_absolute() else posixpath.normpath(posixpath.join(folder, file))
