"""LCH010: paths that are there on the machine of one person only."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.launch_files.personal_paths import PersonalPath, personal_paths

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH010", scope=Scope.LAUNCH_FILE, taste=True)
def personal_path(system: System, options: Options) -> Iterator[Finding]:
    """Paths into the home folder of one person, in launch files and in the parameter files that they load."""
    for row in personal_paths(system):
        yield finding(
            "LCH010",
            row.place,
            f"'{row.path}' is in the home folder of '{row.who}': on any other machine it is not there",
            help=_help(row),
            identity=(row.path,),
            group=(row.place.file, row.who),
        )


def _help(row: PersonalPath) -> str:
    if row.inside is None:
        return "declare a launch argument for it, without a default or with one that is there for everybody"
    package, below = row.inside
    if row.place.file.endswith(".py"):
        return f"install it, and write os.path.join(get_package_share_directory('{package}'), '{below}')"
    return f"install it, and write $(find-pkg-share {package})/{below} in the launch file"


@folds("LCH010", across_systems=True)
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all paths of a file into one home folder."""
    if len(findings) == 1:
        return findings[0]
    return with_others(findings, "another path of this file is", "more paths of this file are", "in it, too")


__all__ = ["personal_path"]
