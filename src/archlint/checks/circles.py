"""PKG003: packages that need each other, by what they declare and by what their files use."""

from __future__ import annotations

import posixpath
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.checks.dependency_uses import Use, uses_by_package
from archlint.checks.folding import folds, with_others
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.packaging.avoided_circles import is_left_out_for_a_circle
from archlint.packaging.copies import are_copies
from archlint.packaging.idle_dependencies import is_named_by_no_file, is_only_asked_for
from archlint.packaging.missing_imports import missing_imports
from archlint.packaging.named_packages import descriptions_that_find, named_at
from archlint.suggestions import listed
from archlint.workspace.manifest import condition_verdict

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import DependencyKind, Package

_BUILD: frozenset[DependencyKind] = frozenset(
    {"depend", "build", "build_export", "buildtool", "buildtool_export", "exec", "run"}
)

_RUN: frozenset[DependencyKind] = frozenset({"exec", "run"})
"""What only a running program needs: the code can be built without it."""

_SHARED = "move what both need into a separate package"

Step = tuple[str, str]
"""A package, and one that it needs."""
Needs = Mapping[str, Mapping[str, Place]]
"""The packages of this workspace that each one needs, with the place that says so."""


@rule("PKG003", scope=Scope.WORKSPACE)
def circular_dependency(system: System, options: Options) -> Iterator[Finding]:
    """Packages that need each other: by what they declare, and by what their files use without declaring it."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    packages = sorted(workspace.packages.items())
    declared = {name: _declared(package, workspace.packages, _BUILD) for name, package in packages}
    at_build = {name: _declared(package, workspace.packages, _BUILD - _RUN) for name, package in packages}
    reported: set[str] = set()
    for several in _around_one_package(list(_circles(declared, reported))):
        yield _declared_circle(several, declared, at_build)
    used = _used(workspace, options)
    needs = {name: {**used.get(name, {}), **declared[name]} for name in declared}
    by_user: dict[str, list[list[Step]]] = {}
    circles_left = [*_circles(needs, reported)]
    for circle in circles_left:
        steps = _from_undeclared(circle, circles_left, needs, used)
        by_user.setdefault(steps[0][0], []).append(steps)
    for circles in by_user.values():
        # Launch files that start each other's nodes are found when they run, whatever is built first.
        of_launch = [steps for steps in circles if _are_of_launch([needs[start][end] for start, end in steps])]
        kept = [steps for steps in circles if steps not in of_launch] or [*_with_copies(workspace, of_launch, needs)]
        if kept:
            of_several = len(kept) > 1
            told = _of_one_package(workspace, kept, needs) if of_several else _undeclared(workspace, kept[0], needs)
            yield replace(told, severity=Severity.INFO if kept[0] in of_launch else Severity.WARNING)


def _around_one_package(circles: list[list[str]]) -> Iterator[list[list[str]]]:
    """The circles, those together that lead through the same package: what all others need and what starts them all."""
    while circles:
        counts = Counter(name for circle in circles for name in circle[1:])
        center = min(counts, key=lambda name: (-counts[name], name))
        yield [circle for circle in circles if center in circle]
        circles = [circle for circle in circles if center not in circle]


def _declared_circle(circles: list[list[str]], needs: Needs, at_build: Needs) -> Finding:
    """The finding for a circle, at the dependency that is easiest to drop, or for all circles through one package, at
    its own dependencies."""
    steps = [step for circle in circles for step in pairwise(circle)]
    if len(circles) == 1:
        first = next((step for step in steps if step[1] not in at_build[step[0]]), steps[0])
        at = steps.index(first)
        steps = steps[at:] + steps[:at]
        message = f"packages depend on each other in a circle: {' → '.join([first[0], *(end for _, end in steps)])}"
    else:
        package = min(set.intersection(*map(set, circles)))
        steps.sort(key=lambda step: (step[0] != package, needs[step[0]][step[1]]))
        others = sorted({name for circle in circles for name in circle} - {package})
        message = f"'{package}' and {len(others)} others depend on each other in circles: {listed(others)}"
    places = {needs[start][end]: f"'{start}' depends on '{end}' here" for start, end in steps}
    place, *_ = places
    return finding(
        "PKG003",
        place,
        message,
        help=f"remove one dependency of each circle, such as that of '{steps[0][0]}' on '{steps[0][1]}', or move what "
        "both need into a separate package, so that colcon can order them",
        related=[Related(other, words) for other, words in places.items() if other != place],
        identity=tuple(sorted({name for circle in circles for name in circle})),
    )


def _from_undeclared(circle: list[str], circles: Sequence[list[str]], needs: Needs, used: Needs) -> list[Step]:
    """The steps of a circle that colcon does not see, from the one on that is not declared; of several such one of
    code before one of a launch file, and that of the package that closes the most of all circles."""

    def undeclared(steps: list[Step]) -> list[Step]:
        return [step for step in steps if needs[step[0]][step[1]] == used.get(step[0], {}).get(step[1])]

    users = Counter(user for other in circles for user in {step[0] for step in undeclared([*pairwise(other)])})
    steps = list(pairwise(circle))
    at = steps.index(
        max(undeclared(steps), key=lambda step: (not _are_of_launch([needs[step[0]][step[1]]]), users[step[0]]))
    )
    return steps[at:] + steps[:at]


def _undeclared(workspace: WorkspaceIndex, steps: list[Step], needs: Needs) -> Finding:
    """The finding for a circle that colcon does not see, since one package does not declare what it uses."""
    (package, other), *others = steps
    names = [package, *(end for _, end in steps)]
    here = needs[package][other]
    copies = _copies(workspace, steps, needs)
    idle = _idle_step(workspace, others, needs)
    advice = f"remove {copies[0]}: it is a copy of this file" if copies else _cure(workspace, package, {other: here})
    is_shared = advice == _SHARED and not idle
    advice = (_cure_elsewhere(workspace, others, needs) or advice) if is_shared else advice
    return finding(
        "PKG003",
        here,
        f"packages depend on each other in a circle: {' → '.join(names)}; '{package}' uses '{other}' here without "
        "declaring it",
        help=f"remove the dependency of '{idle[0]}' on '{idle[1]}': nothing in '{idle[0]}' uses it" if idle else advice,
        related=[Related(needs[start][end], f"'{start}' depends on '{end}' here") for start, end in others],
        identity=tuple(sorted(names[1:])),
        group=(other,) if is_shared else (),
    )


@folds("PKG003")
def _of_one_shared_part(several: Sequence[Finding]) -> Finding:
    """One finding for all packages that use the same one and that it needs: what they share is moved once."""
    return with_others(
        several, "another package uses", "more packages use", f"'{several[0].group[0]}' in a circle, too"
    )


def _idle_step(workspace: WorkspaceIndex, steps: list[Step], needs: Needs) -> Step | None:
    """The first step of a circle that a manifest declares, and for which no file of the package has the name."""
    for package, other in steps:
        manifest = workspace.packages[package].manifest.relative
        if needs[package][other].file == manifest and is_named_by_no_file(workspace, package, other):
            return package, other
    return None


def _copies(workspace: WorkspaceIndex, steps: list[Step], needs: Needs) -> list[str]:
    """The files that close a circle and are copies of the one at which it is told."""
    (package, other), *others = steps
    here = needs[package][other]
    files = [needs[start][end].file for start, end in others]
    return [file for file in files if are_copies(workspace, file, here.file)]


def _with_copies(workspace: WorkspaceIndex, circles: list[list[Step]], needs: Needs) -> Iterator[list[Step]]:
    return (steps for steps in circles if _copies(workspace, steps, needs))


def _of_one_package(workspace: WorkspaceIndex, circles: list[list[Step]], needs: Needs) -> Finding:
    """The finding for a package that is in several such circles: what starts or includes everything, most often."""
    package, _ = circles[0][0]
    first, *others = sorted({steps[0][1] for steps in circles}, key=lambda other: needs[package][other])
    uses = [needs[package][other] for other in (first, *others)]
    return finding(
        "PKG003",
        uses[0],
        f"'{package}' uses {len(uses)} packages that depend on it, without declaring them: "
        f"{listed(sorted([first, *others]))}",
        help=_cure(workspace, package, dict(zip([first, *others], uses, strict=True))),
        related=[Related(place, f"'{other}' is used here") for other, place in zip(others, uses[1:], strict=True)],
        identity=(package, "several"),
    )


def _cure(workspace: WorkspaceIndex, package: str, used: Mapping[str, Place]) -> str:
    """What to do about uses that a package does not declare: launch files need no home beside a library.  Those that
    other packages include would only take the circle along.  What CMake only asks for needs no home at all."""
    uses, (other, *more) = list(used.values()), used
    if all(is_only_asked_for(workspace, package, name, place.file) for name, place in used.items()):
        return f"remove find_package() of {listed([other, *more])}: nothing else in '{package}' uses it"
    if _are_of_launch(uses):
        bringup = f"move the launch files that use it into a package of their own, such as {package}_bringup"
        if also := descriptions_that_find(workspace, package, [other, *more]):
            return f"{bringup}, and with them {also[0]}, which needs it, too"
        if not _are_included_elsewhere(workspace, package, {use.file for use in uses}):
            return bringup
        if any(include.place in uses for launched in workspace.launched for include in launched.included):
            return f"{bringup}, and with them those of other packages that include them"
        there = f"a launch file of '{other}'" if not more else "launch files of these packages"
        return f"move what uses it from here to {there}: other packages include this file"
    return _SHARED


def _cure_elsewhere(workspace: WorkspaceIndex, steps: list[Step], needs: Needs) -> str | None:
    """What ends a circle at another step than the first: launch files alone need a package there."""
    for package, other in steps:
        use = needs[package][other]
        if not _are_of_launch([use]) or _are_included_elsewhere(workspace, package, {use.file}):
            continue
        if not descriptions_that_find(workspace, package, [other]):
            its = f"the launch files of '{package}' that use '{other}'"
            return f"move {its} into a package of their own, such as {package}_bringup"
    return None


def _are_included_elsewhere(workspace: WorkspaceIndex, package: str, files: set[str]) -> bool:
    """Whether another package includes one of some launch files of a package."""
    return any(
        include.reference.source in files and workspace.package_of(include.place.file) != package
        for launched in workspace.launched
        for include in launched.included
    )


def _are_of_launch(uses: list[Place]) -> bool:
    """Whether only launch files say that one package needs another."""
    return all("launch" in re.split(r"[._]", posixpath.basename(place.file)) for place in uses)


def _declared(package: Package, packages: Mapping[str, Package], kinds: frozenset[DependencyKind]) -> dict[str, Place]:
    """The other packages of the workspace that a manifest names as one of these kinds, with the line.  One that names
    itself is refused by colcon before that looks for an order, as PKG011 says."""
    return {
        d.name: Place(package.manifest.relative, d.line, 1, d.line, 1)
        for d in reversed(package.dependencies)
        if d.kind in kinds and d.name in packages and d.name != package.name and condition_verdict(d.condition)
    }


def _used(workspace: WorkspaceIndex, options: Options) -> dict[str, dict[str, Place]]:
    """The packages of this workspace that each one uses and does not declare, with the first place.  An import of which
    nothing is used, or that finds nothing, is to be removed, and needs no package; what a comment of the manifest
    leaves out because of a circle is decided."""
    used: dict[str, dict[str, Place]] = {}
    failing = {missing.place for missing in missing_imports(workspace)}
    for folder, uses in uses_by_package(workspace, options).items():
        package = workspace.manifests[folder]
        if workspace.packages.get(package.name) is package:  # of two of one name, the other one is not spoken of
            kept = [use for use in uses if not use.unused and use.place not in failing]
            first = _first(kept, workspace).items()
            used[package.name] = {
                name: at for name, at in first if not is_left_out_for_a_circle(workspace, package, name)
            }
    return used


def _first(uses: list[Use], workspace: WorkspaceIndex) -> dict[str, Place]:
    """The first use of each package of the workspace; one in a launch file only where there is no other."""
    kept = [use for use in reversed(uses) if use.needed in workspace.packages]
    kept.sort(key=lambda use: not _are_of_launch([use.place]))  # what code needs is what counts
    return {
        use.needed: named_at(workspace, use.place, use.needed) if use.how == "takes files of" else use.place
        for use in kept
    }


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
