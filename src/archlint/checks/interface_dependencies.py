"""PKG007: interface packages whose build does not know what their files use."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.dependency_uses import brought_by
from archlint.checks.folding import folds
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.packaging.interface_dependencies import (
    NotHanded,
    UndefinedType,
    not_handed,
    undefined_types,
    without_group,
)
from archlint.ros import packages
from archlint.suggestions import hint, meant, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import Package

_SLIP = 2
"""By how many letters the name of a package that is nowhere may differ from the one that was meant."""
_SHOWN = 5
"""How many places that use a package are related."""


@rule("PKG007", scope=Scope.WORKSPACE, in_use=True)
def interface_dependency(system: System, options: Options) -> Iterator[Finding]:
    """Packages whose types interface files use and that the build is not given, types that there are not, and interface
    packages that do not say that they are one."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    for row in not_handed(workspace, lambda name: brought_by(name, workspace)):
        yield _not_handed(workspace, row)
    for undefined in undefined_types(workspace):
        yield _undefined(undefined)
    for package, place in without_group(workspace):
        yield _without_group(package, place)


def _not_handed(workspace: WorkspaceIndex, row: NotHanded) -> Finding:
    name, needed = row.package.name, row.needed
    [first, *others] = row.uses
    known = packages.table().names | workspace.packages.keys()
    near = nearest(needed, known, _SLIP) if needed not in known else None
    if near is not None:
        return finding(
            "PKG007",
            first.place,
            f"the interfaces of '{name}' use {first.type}, and there is no package '{needed}': the build fails"
            f"{hint(near)}",
            help=f"write {first.type.replace(needed, near, 1)}",
            related=[Related(use.place, f"{use.type} is used here") for use in others[:_SHOWN]],
            identity=(name, needed),
            meant=near,
        )
    help = f"add {needed} to DEPENDENCIES"
    if "ament_auto_find_build_dependencies" not in workspace.installs[name].words:
        help += f", and find_package({needed} REQUIRED) before it"
    if needed not in {dependency.name for dependency in row.package.dependencies}:
        help += f"; declare <depend>{needed}</depend> in package.xml, too"
    return finding(
        "PKG007",
        row.command,
        f"the interfaces of '{name}' use {first.type}, and rosidl_generate_interfaces is not given '{needed}': the "
        "build fails",
        help=help,
        related=[Related(use.place, f"{use.type} is used here") for use in row.uses[:_SHOWN]],
        identity=(name, needed),
        group=(name, str(row.command)),
    )


def _undefined(row: UndefinedType) -> Finding:
    [first, *others] = row.places
    slip = f"'{row.meant}'" if row.meant else ""
    return finding(
        "PKG007",
        first,
        f"{row.owner} defines no message '{row.name}': the build of '{row.package}' fails{meant(slip)}",
        help=f"write {row.meant}" if row.meant else f"add {row.name}.msg to {row.owner}, or correct the type",
        related=[Related(place, f"'{row.name}' is the type of this field, too") for place in others[:_SHOWN]],
        identity=(row.package, row.owner, row.name),
    )


@folds("PKG007")
def _of_one_command(findings: Sequence[Finding]) -> Finding:
    """The finding for all packages that one command is not given."""
    first, *others = findings
    rows = tuple(Related(finding.related[0].place, f"'{finding.identity[1]}' is missing, too") for finding in others)
    missing = ", ".join(f"'{finding.identity[1]}'" for finding in others)
    return replace(
        first,
        message=f"{first.message}; nor is it given {missing}",
        help=f"{first.help}; so with {missing}",
        related=(*first.related, *rows),
        identity=(*first.identity, *(finding.identity[1] for finding in others)),
    )


def _without_group(package: Package, command: Place) -> Finding:
    manifest = package.manifest.relative
    return finding(
        "PKG007",
        command,
        f"package '{package.name}' generates interfaces, and its package.xml does not say so: the build stops here",
        help=f"add <member_of_group>rosidl_interface_packages</member_of_group> to {manifest}",
        related=[Related(Place(manifest, package.name_line, 1, package.name_line, 1), "the package is named here")],
        identity=(package.name, "member_of_group"),
    )
