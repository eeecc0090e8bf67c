"""LCH010 and LCH014: paths that are there on the machine of one person only."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.launch_files.personal_paths import PersonalPath, maps_by_personal_path, personal_paths

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH010", scope=Scope.LAUNCH_FILE, taste=True)
def personal_path(system: System, options: Options) -> Iterator[Finding]:
    """Paths into the home folder of one person, in launch files and in the parameter files that they load."""
    help = "declare a launch argument for it, without a default or with one that is there for everybody"
    return (_finding("LCH010", row, help) for row in personal_paths(system) if row.inside is None)


@rule("LCH014", scope=Scope.LAUNCH_FILE)
def own_file_by_personal_path(system: System, options: Options) -> Iterator[Finding]:
    """Those of them that lead to a file of a package of the workspace, and the images of maps."""
    launch_files = () if system.launched is None else system.launched.sources
    for row in personal_paths(system):
        if row.inside is not None:
            yield _finding("LCH014", row, _help(row, *row.inside, row.place.file in launch_files))
    for row in [] if system.workspace is None else maps_by_personal_path(system.workspace):
        yield _finding(
            "LCH014", row, f"write image: {posixpath.basename(row.path)}, which is looked for beside the map"
        )


def _finding(code: str, row: PersonalPath, help: str) -> Finding:
    return finding(
        code,
        row.place,
        f"'{row.path}' is in the home folder of '{row.who}': on any other machine it is not there",
        help=help,
        identity=(row.path,),
        group=(row.place.file, row.who),
    )


def _help(row: PersonalPath, package: str, below: str, is_launch_file: bool) -> str:
    first = "" if row.installed else "install it, and "
    if row.place.file.endswith(".py"):
        return f"{first}write os.path.join(get_package_share_directory('{package}'), '{below}')"
    if is_launch_file:
        return f"{first}write $(find-pkg-share {package})/{below}"
    return f"{first}let the launch file give the parameter: {below} in the share folder of '{package}'"


@folds("LCH010", across_systems=True)
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all paths of a file into one home folder."""
    return with_others(findings, "another path of this file is", "more paths of this file are", "in it, too")


@folds("LCH014", across_systems=True)
def _own_of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all own files that a file names so."""
    return with_others(findings, "another path of this file is", "more paths of this file are", "in it, too")


__all__ = ["own_file_by_personal_path", "personal_path"]
