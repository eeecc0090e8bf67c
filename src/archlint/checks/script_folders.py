"""PKG013: programs that are installed where ros2 run and launch do not look."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.packaging.script_folders import out_of_sight
from archlint.systems.model import System

_DECLARED = "it is declared here"


@rule("PKG013", scope=Scope.WORKSPACE, in_use=True)
def programs_out_of_sight(system: System, options: Options) -> Iterator[Finding]:
    """Packages of ament_python whose setup.cfg does not send the programs to the folder of the package."""
    workspace = workspace_of(system)
    for row in out_of_sight(workspace) if workspace is not None else ():
        where = f"lib/{row.folder}" if row.folder else "bin"
        program = row.executable
        message = "programs of the package would be" if program is None else f"'{program.name}' is"
        told = finding(
            "PKG013",
            row.place,
            f"{message} installed in {where}, where ros2 run and launch do not look: they want lib/{row.package}",
            help=f"write install_scripts=$base/lib/{row.package} below [install] in the package's setup.cfg, and "
            f"script_dir=$base/lib/{row.package} below [develop]",
            related=[] if program is None or row.place == program.place else [Related(program.place, _DECLARED)],
            identity=(row.package,),
        )
        yield replace(told, severity=Severity.INFO) if program is None else told


__all__ = ["programs_out_of_sight"]
