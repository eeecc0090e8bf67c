"""PKG011: package.xml files that colcon refuses."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others, with_the_same_cause
from archlint.checks.packages import workspace_of
from archlint.checks.registry import EMPTY, LEADS_OUT, Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.packaging.refused_manifests import (
    Mistyped,
    RefusedManifest,
    Untyped,
    mistyped_manifests,
    refused_manifests,
    untyped_manifests,
)
from archlint.packaging.same_names import copied_names

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.workspace.model import Package


@rule("PKG011", scope=Scope.WORKSPACE)
def refused_manifest(system: System, options: Options) -> Iterator[Finding]:
    """What catkin_pkg, with which colcon reads manifests, refuses."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    yield from map(_refused, refused_manifests(workspace))
    yield from map(_untyped, untyped_manifests(workspace))
    yield from map(_mistyped, mistyped_manifests(workspace))
    for copied, original in copied_names(workspace):
        yield _of_one_name(copied, original)


def _refused(row: RefusedManifest) -> Finding:
    manifest, line = row.package.manifest.relative, row.refusal.line
    therefore = f"and builds it as {row.builds}" if row.builds else "and passes over it"
    return finding(
        "PKG011",
        Place(manifest, line, 1, line, 1),
        f"colcon does not take '{row.package.name}' for a package of ROS, {therefore}: {row.refusal.what}",
        help=row.refusal.help,
        identity=(row.package.name, row.refusal.what),
        group=("refused",),
    )


def _untyped(row: Untyped) -> Finding:
    manifest, line = row.package.manifest.relative, row.package.name_line
    what, tag = "there is no <build_type>", f"<build_type>{row.build_type}</build_type>"
    return finding(
        "PKG011",
        Place(manifest, line, 1, line, 1),
        f"colcon takes '{row.package.name}' for a package of catkin, the build system of ROS 1: {what}",
        help=f"put {tag} into <export>" if row.has_export else f"add <export>{tag}</export>",
        identity=(row.package.name, what),
        group=("refused",),
    )


def _mistyped(row: Mistyped) -> Finding:
    name = row.package.name
    what = (
        f"'{row.written}' is built by a {row.missing}, which is not there"
        if row.missing
        else f"colcon knows no build type '{row.written}'"
    )
    return finding(
        "PKG011",
        row.place,
        f"colcon cannot build '{name}': {what}",
        help=f"write <build_type>{row.build_type}</build_type>",
        identity=(name, what),
        group=("refused",),
    )


def _of_one_name(copied: Package, original: Place) -> Finding:
    name, folder = copied.name, posixpath.basename(posixpath.dirname(copied.manifest.relative))
    what = f"the package beside it is called '{name}', too"
    return finding(
        "PKG011",
        Place(copied.manifest.relative, copied.name_line, 1, copied.name_line, 1),
        f"colcon builds nothing here: {what}",
        help=f"write <name>{folder}</name>, and that name where the package builds and looks for itself",
        related=[Related(original, f"'{name}' is this one")],
        identity=(name, what),
        group=("refused",),
    )


def _by_cause(findings: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    return with_the_same_cause(findings, lambda diagnostic: (diagnostic.identity[1], diagnostic.help))


@folds("PKG011", across_workspaces=True, rows=_by_cause)
def _of_one_cause(findings: Sequence[Finding]) -> Finding:
    """One finding for a manifest, or for what several of these have."""
    first, *others = findings
    if any(other.place.file != first.place.file for other in others):
        return with_others(findings, "another package.xml has", "more package.xml files have", "the same")
    rows = [Related(other.place, other.identity[1]) for other in others]
    return replace(first, related=(*first.related, *rows))


@folds("LNT002")
def _of_one_mistake(findings: Sequence[Finding]) -> Finding:
    """One finding for the manifests, or the descriptions of a package, that cannot be read for the same reason: one was
    copied for the others; for the links into one folder that is not there, and for the empty launch files of one."""
    if findings[0].group[0] == LEADS_OUT:
        return with_others(findings, "another link leads", "more links lead", "there, too")
    if findings[0].group[0] == EMPTY:
        return with_others(findings, "another file beside it is", "more files beside it are", "empty, too")
    is_manifest = findings[0].place.file.endswith("package.xml")
    another, more = (
        ("another package.xml is", "more package.xml files are")
        if is_manifest
        else ("another file of the package is", "more files of the package are")
    )
    return with_others(findings, another, more, "unreadable for the same reason")


__all__ = ["refused_manifest"]
