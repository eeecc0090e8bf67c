"""PKG001 about packages that nobody knows: neither of the workspace nor released, and declared nowhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused, is_not_installed
from archlint.checks.dependency_uses import How, Use
from archlint.checks.registry import finding
from archlint.connections.parts_elsewhere import (
    absent_dependencies_of,
    is_fetched,
    list_of_repositories,
    may_be_in_a_submodule,
    may_come_with_another,
)
from archlint.finding import Finding, Related
from archlint.packaging.absent_packages import (
    is_from_nowhere,
    is_in_a_document,
    is_told_as_another,
    is_untouched_template,
)
from archlint.packaging.missing_imports import missing_imports
from archlint.packaging.uninstalled_files import is_told_to_start
from archlint.ros.mistaken_dependencies import mistaken
from archlint.suggestions import listed

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package

_STOPS: frozenset[How] = frozenset(
    {
        "imports",
        "imports a module of",
        "starts a node of",
        "includes a launch file of",
        "takes files of",
        "looks for the folder of",
    }
)
"""Uses at which a program or launch stops without the package."""


def strangers(workspace: WorkspaceIndex, package: Package, uses: Sequence[Use]) -> Iterator[Finding]:
    """One finding for all such packages that the code and the launch files of a package name."""
    by_name: dict[str, list[Use]] = {}
    for use in uses:
        if use.how in _STOPS and not _is_left(workspace, use.place.file):
            by_name.setdefault(use.needed, []).append(use)
    names = [
        name
        for name in sorted(by_name)
        if is_from_nowhere(workspace, name)
        and not is_told_as_another(workspace, name)
        and not is_fetched(workspace, name)
        and not may_be_in_a_submodule(workspace, name)
        and not may_come_with_another(workspace, name)
    ]
    told = _told_lines(workspace) if names else set()
    declared = absent_dependencies_of(workspace, package)
    absent = [name for name in declared if name not in _TOOLS and mistaken(name, (), is_python=True) is None]
    brought = any(name.endswith(_BRING_OTHERS) for name in absent)
    optional = _optional_files(workspace, names, by_name)
    rows = {
        name: [
            use
            for use in by_name[name]
            if (use.place.file, use.place.line) not in told
            and use.place.file not in optional
            and not (brought and use.how in _AT_LAUNCH)
        ]
        for name in names
    }
    named = {name: left for name, left in rows.items() if left}
    if named:
        yield _finding(package, named, list_of_repositories(workspace), absent[:1])


_TOOLS = frozenset({"ament_cmake", "ament_python", "catkin", "cmake", "setuptools"})
"""What manifests have as a tool to build with, be it no package: no project brings these."""
_BRING_OTHERS = ("_bringup", "_launch")
"""How packages end that are there to bring others and start them."""
_AT_LAUNCH: frozenset[How] = frozenset({"includes a launch file of", "starts a node of", "takes files of"})
"""Uses of what may well be there because a package that is declared, and of which nothing is known, brings it."""


def _optional_files(workspace: WorkspaceIndex, names: Sequence[str], by_name: Mapping[str, Sequence[Use]]) -> set[str]:
    """The launch files that nothing asks for and that are for modules of which a document speaks: who has these beside
    the workspace starts them."""
    documented = (name for name in names if is_in_a_document(workspace, name))
    files = {use.place.file for name in documented for use in by_name[name] if use.how in _AT_LAUNCH}
    return {file for file in files if not is_told_to_start(workspace, file)}


def _is_left(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is put aside, nobody installs it, or it is a template in which no name was put yet: it has no part
    in what the manifest declares."""
    return (
        is_disused(workspace, file)
        or is_not_installed(workspace, file)
        or is_untouched_template(workspace, file) is True
    )


def _told_lines(workspace: WorkspaceIndex) -> set[tuple[str, int]]:
    """The imports of which API006 says what the package is called that was meant."""
    rows = (row for row in missing_imports(workspace) if row.present or row.near)
    return {(row.place.file, row.place.line) for row in rows}


def _finding(package: Package, by_name: dict[str, list[Use]], repositories: str, absent: Sequence[str]) -> Finding:
    names = list(by_name)
    first = min((uses[0] for uses in by_name.values()), key=lambda use: use.place)
    of_ros_1 = mistaken(names[0], (), is_python=False) if len(names) == 1 else None
    instead = of_ros_1.instead if of_ros_1 is not None else ""
    if len(names) == 1:
        what = f"package '{package.name}' {first.how} '{names[0]}', which"
        what += " is neither in this workspace nor in rosdistro, and which its package.xml does not declare"
    else:
        what = (
            f"package '{package.name}' uses {len(names)} packages that are neither in this workspace nor in rosdistro"
        )
        what += f", and that its package.xml does not declare: {listed(names)}"
    name = "the name" if len(names) == 1 else "each name"
    help = f"correct {name}, or declare it in package.xml and say where it comes from"
    if repositories:
        help = f"declare it in package.xml if a repository of {repositories} has it, else correct {name}"
    if absent:  # another project brings packages, and may bring this one
        it = "it" if len(names) == 1 else "each"
        help = f"declare {it} in package.xml if it comes from where '{absent[0]}' does, else correct {name}"
    return finding(
        "PKG001",
        first.place,
        what + (f"; did you mean '{instead}'?" if instead else ""),
        help=help,
        related=[
            Related(uses[0].place, f"'{name}' is named here")
            for name, uses in by_name.items()
            if uses[0].place != first.place
        ],
        identity=(package.name, "nowhere", *names),
    )


__all__ = ["strangers"]
