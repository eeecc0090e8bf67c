"""PKG003: packages that need each other, by what they declare and by what their files use."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.undeclared import Use, uses_by_package
from archlint.finding import Finding, Place, Related, Severity
from archlint.workspace.manifest import condition_verdict

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import DependencyKind, Package

_BUILD: frozenset[DependencyKind] = frozenset(
    {"depend", "build", "build_export", "buildtool", "buildtool_export", "exec", "run"}
)

Needs = Mapping[str, Mapping[str, Place]]
"""The packages of this workspace that each one needs, with the place that says so."""


@rule("PKG003", scope=Scope.WORKSPACE)
def circular_dependency(system: System, options: Options) -> Iterator[Finding]:
    """Packages that need each other: by what they declare, and by what their files use without declaring it."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    declared = {name: _declared(package, workspace.packages) for name, package in sorted(workspace.packages.items())}
    reported: set[str] = set()
    for circle in _circles(declared, reported):
        yield finding(
            "PKG003",
            declared[circle[0]][circle[1]],
            f"packages depend on each other in a circle: {' → '.join(circle)}",
            help="move what both need into a separate package, so that colcon can order them",
            identity=tuple(sorted(circle[:-1])),
        )
    used = _used(workspace, options)
    needs = {name: {**used.get(name, {}), **declared[name]} for name in declared}
    for circle in _circles(needs, reported):
        yield _undeclared(circle, needs, used)


def _undeclared(circle: list[str], needs: Needs, used: Needs) -> Finding:
    """The finding for a circle that colcon does not see, since one package does not declare what it uses."""
    steps = list(pairwise(circle))
    at = next(
        n for n, (package, other) in enumerate(steps) if needs[package][other] == used.get(package, {}).get(other)
    )
    steps = steps[at:] + steps[:at]
    (package, other), *others = steps
    names = [package, *(end for _, end in steps)]
    diagnostic = finding(
        "PKG003",
        needs[package][other],
        f"packages depend on each other in a circle: {' → '.join(names)}; '{package}' uses '{other}' here without "
        "declaring it",
        help="move what both need into a separate package",
        related=[Related(needs[start][end], f"'{start}' depends on '{end}' here") for start, end in others],
        identity=tuple(sorted(circle[:-1])),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _declared(package: Package, packages: Mapping[str, Package]) -> dict[str, Place]:
    return {
        d.name: Place(package.manifest.relative, d.line, 1, d.line, 1)
        for d in reversed(package.dependencies)
        if d.kind in _BUILD and d.name in packages and condition_verdict(d.condition)
    }


def _used(workspace: WorkspaceIndex, options: Options) -> dict[str, dict[str, Place]]:
    """The packages of this workspace that each one uses and does not declare, with the first place."""
    used: dict[str, dict[str, Place]] = {}
    for folder, uses in uses_by_package(workspace, options).items():
        package = workspace.manifests[folder]
        if workspace.packages.get(package.name) is package:  # of two of one name, the other one is not spoken of
            used[package.name] = _first(uses, workspace)
    return used


def _first(uses: list[Use], workspace: WorkspaceIndex) -> dict[str, Place]:
    return {use.needed: use.place for use in reversed(uses) if use.needed in workspace.packages}


def _circles(needs: Needs, reported: set[str]) -> Iterator[list[str]]:
    """A shortest circle for each package that is in one and in none that was ``reported``."""
    for start in needs:
        circle = [] if start in reported else _circle(start, needs)
        reported.update(circle)
        if circle:
            yield circle


def _circle(start: str, needs: Needs) -> list[str]:
    """A shortest way from a package back to itself; empty where there is none."""
    waiting = [[start]]
    seen: set[str] = set()
    while waiting:
        path = waiting.pop(0)
        for name in sorted(needs[path[-1]]):
            if name == start:
                return [*path, start]
            if name not in seen:
                seen.add(name)
                waiting.append([*path, name])
    return []
