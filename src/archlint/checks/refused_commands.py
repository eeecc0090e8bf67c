"""PKG015: commands of a CMakeLists.txt that CMake or ament refuses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_humble, named_distros
from archlint.checks.cmake_names import SYSTEM, found_with
from archlint.checks.folding import folds, with_others
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.packaging.cmake_packages import cmake_packages
from archlint.ros import packages
from archlint.workspace.closure import closure

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import CalledCommand, Installs, RefusedCommand


@rule("PKG015", scope=Scope.WORKSPACE)
def refused_command(system: System, options: Options) -> Iterator[Finding]:
    """Commands that stop the build as they are written, and those of packages that nothing finds."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    for _, installs in cmake_packages(workspace):
        yield from (_refused(installs, row) for row in installs.refused)
        yield from _undefined(workspace, installs, options)


def _refused(installs: Installs, row: RefusedCommand) -> Finding:
    message, help = _words(row)
    return finding(
        "PKG015",
        row.place,
        f"{message}: the build stops",
        help=help,
        related=[] if row.before is None else [Related(row.before, _BEFORE[row.kind == "two signatures"])],
        identity=(installs.package, row.command, row.kind, row.name),
        group=(row.place.file, row.kind),
    )


_BEFORE = ("this makes a target of that name", "this has the other signature")


def _words(row: RefusedCommand) -> tuple[str, str]:
    name = row.name
    match row.kind:
        case "two signatures":
            return (
                f"'{name}' is linked with PUBLIC, PRIVATE or INTERFACE in one command and without it in another",
                f"write the word in all of them that are for '{name}': ament_target_dependencies({name} PUBLIC …)",
            )
        case "made twice":
            return f"{row.command}() makes a target '{name}', and there is one", "give one of them another name"
        case "types made twice":
            return (
                f"'{name}' is the name of two targets: of a program or library, and of the package's interfaces",
                "call the program or library otherwise: rosidl_generate_interfaces() makes a target of its first "
                "argument",
            )
        case "two packages of Python":
            return (
                f"the Python package '{name}' is installed twice: rosidl_generate_interfaces() installs one of its own",
                "put the Python code, or the interfaces, into another package",
            )
        case "no destination":
            return "install() has no DESTINATION", "say where to: DESTINATION share/${PROJECT_NAME}"
        case "no target":
            return (
                f"rosidl_generate_interfaces() is given the file '{name}' first, where the name of its target belongs",
                "write rosidl_generate_interfaces(${PROJECT_NAME} …)",
            )
        case "no option":
            return (
                f"rosidl_generate_interfaces() takes no '{name}', so that it is looked for as a file",
                "write DEPENDENCIES in front of the packages whose types are used",
            )
        case "no package of Python":
            return (
                f"ament_python_install_package() installs '{name}', which has no __init__.py",
                f"add {name}/__init__.py",
            )


def _undefined(workspace: WorkspaceIndex, installs: Installs, options: Options) -> Iterator[Finding]:
    """The commands of packages that nothing finds, as far as all that is found is known."""
    there = closure(installs.looked_for, lambda name: found_with(workspace, name))
    read = packages.table().brings.keys() | workspace.packages.keys() | SYSTEM
    if not (installs.looked_for <= read and there <= read | packages.table().names):
        return
    finds_tests = _FINDS_TESTS in {row.name for row in installs.called}
    for row in installs.called:
        is_found_for_tests = finds_tests and row.name != _FINDS_TESTS and row.name.startswith("ament_add_")
        if row.package not in there and row.package not in options.external and not is_found_for_tests:
            by_humble = row.name == _GENERATES and not _BRING_IT_IN_HUMBLE.isdisjoint(there)
            if not (by_humble and is_for_humble(workspace)):
                yield _finding_of(installs, row, by_humble and not named_distros(workspace))


_FINDS_TESTS = "ament_lint_auto_find_test_dependencies"
"""Finds all that package.xml declares for tests."""
_GENERATES = "rosidl_generate_interfaces"
_BRING_IT_IN_HUMBLE = frozenset({"rosidl_typesupport_c", "rosidl_typesupport_cpp"})
"""What finds rosidl_cmake, which has that command, and the generators of C and C++ until Humble, where
``find_package(rclcpp)`` is enough.  Source: rosidl_typesupport_c-extras.cmake.in and the CMakeLists.txt of
rosidl_generator_c."""


def _finding_of(installs: Installs, row: CalledCommand, by_humble: bool) -> Finding:
    since = " from iron on" if by_humble else ""
    return finding(
        "PKG015",
        row.place,
        f"{row.name}() is a command of '{row.package}', which no find_package() finds: the build stops{since}",
        help=f"add find_package({row.package} REQUIRED)",
        identity=(installs.package, row.name),
        group=(row.place.file, row.package),
    )


@folds("PKG015")
def _of_one_kind(findings: Sequence[Finding]) -> Finding:
    """One finding for all that is wrong in the same way in a file."""
    return with_others(findings, "another command is", "more commands are", "refused, too")


__all__ = ["refused_command"]
