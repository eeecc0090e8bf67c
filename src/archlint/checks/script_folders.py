"""PKG013: programs that are installed where ros2 run and launch do not look."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace

from archlint.checks.folding import folds, with_others
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.packaging.built_programs import BuiltOutOfSight, built_out_of_sight
from archlint.packaging.script_folders import out_of_sight
from archlint.packaging.unbuilt_programs import UnbuiltProgram, unbuilt_programs
from archlint.packaging.unlisted_programs import UnlistedProgram, unlisted_programs
from archlint.systems.model import System

_DECLARED = "it is declared here"


@rule("PKG013", scope=Scope.WORKSPACE, in_use=True)
def programs_out_of_sight(system: System, options: Options) -> Iterator[Finding]:
    """Programs that setup.cfg or CMake does not send to the folder of their package."""
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
    yield from map(_built, built_out_of_sight(workspace) if workspace is not None else ())
    yield from map(_unlisted, unlisted_programs(workspace) if workspace is not None else ())
    yield from map(_unbuilt, unbuilt_programs(workspace) if workspace is not None else ())


_BUILT, _UNLISTED, _UNBUILT = "built", "unlisted", "not built"


def _built(row: BuiltOutOfSight) -> Finding:
    name, package = row.executable.name, row.executable.package
    return finding(
        "PKG013",
        row.place,
        f"'{name}' is installed in {row.folder}, where ros2 run and launch do not look: they want lib/{package}"
        if row.folder
        else f"'{name}' is built and not installed: ros2 run does not find it",
        help="install it with DESTINATION lib/${PROJECT_NAME}"
        if row.folder
        else f"add install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})",
        related=[] if row.place == row.executable.place else [Related(row.executable.place, "it is built here")],
        identity=(package, name),
        group=(row.place.file, _BUILT, row.folder),
    )


def _unlisted(row: UnlistedProgram) -> Finding:
    told = [] if row.told is None else [Related(row.told, "it is to be started here")]
    why = "no entry point names it" if row.told is not None else "the package has no entry points"
    unlisted = finding(
        "PKG013",
        row.place,
        f"ros2 run does not find '{row.name}', though {row.module} has a main(): {why}",
        help=f"add '{row.name} = {row.module}:main' to console_scripts",
        related=[*told, Related(row.main, "its main() is here")],
        identity=(row.package, row.name),
        group=(row.place.file, _UNLISTED),
    )
    return unlisted if row.told is not None else replace(unlisted, severity=Severity.WARNING)


def _unbuilt(row: UnbuiltProgram) -> Finding:
    is_script = row.file.endswith(".py")
    below = posixpath.relpath(row.file, posixpath.dirname(row.place.file) or ".")
    renamed = f" RENAME {row.name}" if posixpath.basename(row.file) != row.name else ""
    script = f"install(PROGRAMS {below} DESTINATION lib/${{PROJECT_NAME}}{renamed})"
    return finding(
        "PKG013",
        row.place,
        f"ros2 run does not find '{row.name}': nothing {'installs' if is_script else 'compiles'} {row.file}",
        help=f"add {script}" if is_script else f"add a target: add_executable({row.name} {below}), and install it",
        related=[Related(row.told, "it is to be started here")],
        identity=(row.package, row.name),
        group=(row.place.file, _UNBUILT),
    )


@folds("PKG013")
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for the programs of a CMake file that come to one folder, or the modules that a setup.py makes none
    of."""
    if findings[0].group[1] == _UNBUILT:
        return with_others(findings, "another file is", "more files are", "left out, too")
    if findings[0].group[1] == _UNLISTED:
        return with_others(findings, "another module is", "more modules are", "no program, either")
    return with_others(findings, "another program is", "more programs are", "out of sight, too")


__all__ = ["programs_out_of_sight"]
