"""PKG014: CMake targets that are not given the packages whose headers their sources include."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.checks.dependency_uses import brought_by
from archlint.checks.folding import folds, with_others
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.packaging.target_headers import HeaderNotGiven, headers_not_given
from archlint.suggestions import listed
from archlint.systems.model import System
from archlint.workspace.installed import Installs


@rule("PKG014", scope=Scope.WORKSPACE, in_use=True)
def target_without_dependency(system: System, options: Options) -> Iterator[Finding]:
    """One finding for each target, with all that it lacks."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    by_target: dict[tuple[str, str], tuple[Installs, list[HeaderNotGiven]]] = {}
    for installs, row in headers_not_given(workspace, lambda name: brought_by(name, workspace)):
        if row.package not in options.external:
            by_target.setdefault((installs.package, row.target.name), (installs, []))[1].append(row)
    for installs, rows in by_target.values():
        own = [row for row in rows if row.package == installs.package]
        others = [row for row in rows if row.package != installs.package]
        yield from (_finding(installs, group, is_own=group is own) for group in (own, others) if group)


def _finding(installs: Installs, rows: Sequence[HeaderNotGiven], *, is_own: bool) -> Finding:
    target, names = rows[0].target, sorted(row.package for row in rows)
    what = "the interfaces of its own package" if is_own else f"package {listed(names)}"
    if len(names) > 1:
        what = f"these {len(names)} packages: {listed(names)}"
    first = rows[0]
    return finding(
        "PKG014",
        target.place,
        f"target '{target.name}' includes headers of {what}, and nothing gives it their folder: the build stops at "
        f"<{first.header}>",
        help=_cure_for_own(target.name) if is_own else _cure(target.name, rows),
        related=[Related(row.at, f"<{row.header}> is included here") for row in rows],
        identity=(installs.package, target.name, *names),
        group=(target.place.file, "own" if is_own else " ".join(names)),
    )


def _cure(target: str, rows: Sequence[HeaderNotGiven]) -> str:
    names = sorted(row.package for row in rows)
    lines = [f"find_package({row.package} REQUIRED)" for row in rows if not row.is_found]
    added = f"add {' and '.join(sorted(lines))}, and write" if lines else "write"
    return f"{added} ament_target_dependencies({target} {' '.join(names)})"


def _cure_for_own(target: str) -> str:
    return (
        "write rosidl_get_typesupport_target(types ${PROJECT_NAME} rosidl_typesupport_cpp) behind "
        f'rosidl_generate_interfaces(), and target_link_libraries({target} "${{types}}")'
    )


@folds("PKG014")
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all targets of a file that lack the same."""
    return with_others(findings, "another target lacks", "more targets lack", "the same")


__all__ = ["target_without_dependency"]
