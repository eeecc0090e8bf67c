"""PKG001: what the files of a package use and its package.xml does not declare."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused
from archlint.analysis.ignored import words_ignored_at
from archlint.analysis.kept import once
from archlint.checks.dependency_uses import BUILDS, FOR_OTHERS, How, Use, uses_by_package
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.strangers import strangers
from archlint.checks.unknown_dependencies import names_meant
from archlint.connections.parts_elsewhere import (
    is_fetched,
    may_be_in_a_submodule,
    may_come_with_another,
    unknown_repository,
)
from archlint.edit_sites import MissingDependencies, Sites
from archlint.finding import Finding, Place, Related
from archlint.packaging.absent_packages import is_told_as_another
from archlint.packaging.skipped_packages import skipped_packages
from archlint.packaging.uninstalled_files import is_left_out_launch_file
from archlint.packaging.unused_files import nothing_runs
from archlint.ros import packages, rosdep
from archlint.rulebook import rules
from archlint.suggestions import distance, have_same_words, meant, nearest
from archlint.workspace.closure import closure
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.model import Dependency, Package


@rule("PKG001", scope=Scope.WORKSPACE)
def undeclared_dependency(system: System, options: Options) -> Iterator[Finding]:
    """ROS packages that are imported or launched and that package.xml does not name: one finding a package."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    by_package = uses_by_package(workspace, options)
    used: dict[str, set[str]] = {}
    for folder, uses in by_package.items():
        used.setdefault(workspace.manifests[folder].name, set()).update(use.needed for use in uses)
    for folder, uses in sorted(by_package.items()):
        yield from strangers(workspace, workspace.manifests[folder], uses)
        renamed = names_meant(workspace, workspace.manifests[folder], options)  # PKG008 tells to write these
        uses = [use for use in uses if _is_somewhere(workspace, use.needed) and use.needed not in renamed]
        uses = [use for use in uses if not _is_in_launch_file_left_out(workspace, use.place.file)]
        uses.sort(key=lambda use: _spare(workspace, use.place.file))
        hidden = [use for use in uses if _is_hidden(workspace, use)]
        # What a comment allows is a finding of its own, for the comment to hide.
        shown = [use for use in uses if use not in hidden and not _closes_circle(use, workspace, folder, used)]
        for group in (*_by_whether_they_run(workspace, shown), *([use] for use in hidden)):
            for told in _by_repository(workspace, group):
                yield _undeclared(workspace, workspace.manifests[folder], told)


def _is_somewhere(workspace: WorkspaceIndex, name: str) -> bool:
    """Whether a package is known: of this workspace, of ROS, in a ``.repos`` file, perhaps in a submodule that is not
    checked out, or to another manifest here.  Of a name that is nowhere nobody knows what to declare, and rosdep stops
    at it."""
    known = name in packages.table().names or name in workspace.packages or name in _declared_anywhere(workspace)
    if not known and is_told_as_another(workspace, name):
        return False  # LCH001 or LCH004 says what is to be written for it
    return (
        known
        or is_fetched(workspace, name)
        or may_be_in_a_submodule(workspace, name)
        or may_come_with_another(workspace, name)
    )


def _is_in_launch_file_left_out(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is a launch file that its package leaves out while it installs others, and that none includes and
    no document starts: the package does not need what is in it."""
    return workspace.launch_files.can_be_launched(file) and is_left_out_launch_file(workspace, file)


def _by_whether_they_run(workspace: WorkspaceIndex, uses: Sequence[Use]) -> tuple[list[Use], list[Use]]:
    """The uses of packages that something needs which runs, and those of packages that only other files name: they are
    a finding of their own, which is counted and not shown, for who starts the package's programs needs none of them."""
    running = {use.needed for use in uses if not nothing_runs(workspace, use.place.file)}
    return [use for use in uses if use.needed in running], [use for use in uses if use.needed not in running]


def _by_repository(workspace: WorkspaceIndex, uses: Sequence[Use]) -> list[list[Use]]:
    """The uses of packages that are known, or of which something says where they are, and those of packages that may be
    in a repository which is not here, as anything may: a line in package.xml is no cure for a name that is wrong."""
    doubtful = {use.needed for use in uses if _unknown_place(workspace, use.needed)}
    parts = ([use for use in uses if (use.needed in doubtful) is doubt] for doubt in (False, True))
    return [part for part in parts if part]


def _unknown_place(workspace: WorkspaceIndex, name: str) -> str:
    """The repository of which nobody knows what is in it that a package may be in, where it is nowhere else."""
    known = name in packages.table().names or name in workspace.packages or name in _declared_anywhere(workspace)
    if known or is_fetched(workspace, name) or may_come_with_another(workspace, name):
        return ""
    return unknown_repository(workspace, name)


def _spare(workspace: WorkspaceIndex, file: str) -> int:
    """How poor an example a file is of what a package uses: 1 for a module that no program runs, 2 for what is put
    aside, such as ``driver copy.py``."""
    if nothing_runs(workspace, file) or is_disused(workspace, file):
        return 2
    return int(workspace.code.kind_of(file) == "python" and file not in workspace.code.in_use)


@once
def _declared_anywhere(workspace: WorkspaceIndex) -> frozenset[str]:
    return frozenset(d.name for package in workspace.manifests.values() for d in package.dependencies)


def _closes_circle(use: Use, workspace: WorkspaceIndex, folder: str, used: Mapping[str, AbstractSet[str]]) -> bool:
    """Whether to declare it would close a circle of packages, which colcon refuses: PKG003 reports that.  ``used``
    is what each package uses and does not declare: if all follow the advice, they declare it."""
    return workspace.manifests[folder].name in _reachable(use.needed, workspace, used)


def _is_hidden(workspace: WorkspaceIndex, use: Use) -> bool:
    """Whether a comment hides what the rule says of a place."""
    names = {"PKG001", rules()["PKG001"].name.upper()}
    return any(word.upper() in names for word in words_ignored_at(workspace, use.place))


# -------------------------------------------------------------------------------------------------- the finding

_NAMED = 12
"""How many packages a message lists."""


def _undeclared(workspace: WorkspaceIndex, package: Package, uses: Sequence[Use]) -> Finding:
    """The finding for a package."""
    by_needed: dict[str, list[Use]] = {}
    for use in uses:
        by_needed.setdefault(use.needed, []).append(use)
    needed = sorted(by_needed)
    return finding(
        "PKG001",
        uses[0].place,
        _message(workspace, package, uses[0], needed),
        help=_help(workspace, package, by_needed),
        related=[
            *(related for related in _related(by_needed) if related.place != uses[0].place),
            *_misplaced(package, needed),
            *_left_out(workspace, needed),
        ],
        identity=(package.name, *needed),
        sites=_sites(workspace, package, by_needed),
    )


def _message(workspace: WorkspaceIndex, package: Package, first: Use, needed: Sequence[str]) -> str:
    declared = {d.name for d in package.dependencies if d.kind == "test" and condition_holds(d.condition)}
    for_tests = [name for name in needed if name in declared]
    if len(needed) == 1:
        verb = "declares for tests only" if for_tests else "does not declare"
        what = f"package '{package.name}' {first.how} '{first.needed}', which its package.xml {verb}"
        return what + _hint(workspace, package, first)
    more = f" and {len(needed) - _NAMED} more" if len(needed) > _NAMED else ""
    listed = ", ".join(needed[:_NAMED]) + more
    partly = f"{', '.join(for_tests[:_NAMED])}: for tests only" if for_tests else ""
    what = f"package '{package.name}' uses {len(needed)} packages that its package.xml does not declare"
    return f"{what}: {listed}" + (f" ({partly})" if partly else "")


def _hint(workspace: WorkspaceIndex, package: Package, use: Use) -> str:
    """The declared name that was meant, if no package is called so."""
    near = _misspelt(workspace, package, use.needed)
    return meant(f"'{use.needed}' by '{near.name}'") if near is not None else ""


def _misspelt(workspace: WorkspaceIndex, package: Package, needed: str) -> Dependency | None:
    """The dependency that was to be on a package: the name of none, it is a slip or has its words in another order."""
    there = (packages.table().names, workspace.packages.keys(), rosdep.keys())
    unknown = (d for d in package.dependencies if not any(d.name in names for names in there))
    declared = {d.name: d for d in unknown if d.name != needed}
    near = next((name for name in declared if have_same_words(needed, name)), None) or nearest(needed, declared)
    is_slip = near is not None and (distance(needed, near, 2) <= 2 or have_same_words(needed, near))
    return declared[near] if near is not None and is_slip else None


def _help(workspace: WorkspaceIndex, package: Package, by_needed: Mapping[str, Sequence[Use]]) -> str:
    needed = sorted(by_needed)
    repository = _unknown_place(workspace, needed[0])
    if repository:
        each, name = ("it", "the name") if len(needed) == 1 else ("each", "each name")
        return f"declare {each} in package.xml if the repository '{repository}' has it, else correct {name}"
    if not package.in_export.keys().isdisjoint(needed):
        return f"declare {'it' if len(needed) == 1 else 'each'} outside of <export>: entries inside it do not count"
    wrong = {name: entry for name in needed if (entry := _misspelt(workspace, package, name)) is not None}
    others = [name for name in needed if name not in wrong]
    manifest = package.manifest.relative
    cures = [f"write '{name}' for '{entry.name}' in line {entry.line} of {manifest}" for name, entry in wrong.items()]
    if others:
        cures.append(f"add {_lines(package, by_needed, others)} to {manifest}")
    return "; ".join(cures)


def _lines(package: Package, by_needed: Mapping[str, Sequence[Use]], names: Sequence[str]) -> str:
    """What to add to a manifest, one example for all that are declared in the same way."""
    alike: dict[tuple[str, ...], list[str]] = {}
    for name in names:
        alike.setdefault(_tags(package, by_needed[name]), []).append(name)
    parts = []
    for tags, own in sorted(alike.items(), key=lambda row: row[0] == ("test_depend",)):
        line = " and ".join(f"<{tag}>{own[0]}</{tag}>" for tag in tags)
        like = f"{'a line' if len(tags) == 1 else 'lines'} like {line} for "
        more = f" and {len(own) - _NAMED} more" if len(own) > _NAMED else ""
        each = "each" if len(alike) == 1 else ", ".join(own[:_NAMED]) + more
        parts.append(line if len(own) == 1 else like + each)
    return (" and " if all(len(own) == len(tags) == 1 for tags, own in alike.items()) else ", and ").join(parts)


def _related(by_needed: Mapping[str, Sequence[Use]]) -> Iterator[Related]:
    """The first use of each package; that of the primary place is in the message."""
    for name, uses in sorted(by_needed.items()):
        first = _FIRST[uses[0].how].format(name)
        more = len(uses) - 1
        yield Related(uses[0].place, first + (f" and at {more} more place{'s' * (more > 1)}" if more else ""))


_FIRST: dict[How, str] = {
    "imports": "'{}' is imported here",
    "imports a module of": "a module of '{}' is imported here",
    "starts a node of": "a node of '{}' is started here",
    "uses types of": "a type of '{}' is used here",
    "includes a launch file of": "a launch file of '{}' is included here",
    "takes files of": "a file of '{}' is named here",
    "looks for the folder of": "the folder of '{}' is looked for here",
    "includes headers of": "a header of '{}' is included here",
    "loads a plugin of": "a plugin of '{}' is named here",
    "runs the program": "the program '{}' is run here",
    "builds with": "find_package() asks for '{}' here",
    "builds its tests with": "find_package() asks for '{}' here, for tests",
    "tests with": "a test imports '{}' here",
}


def _misplaced(package: Package, needed: Sequence[str]) -> Iterator[Related]:
    """Where the manifest has a dependency inside ``<export>``."""
    for name in needed:
        line = package.in_export.get(name)
        if line is not None:
            place = Place(package.manifest.relative, line, 1, line, 1)
            yield Related(place, f"'{name}' is inside <export> here, where it does not count")


def _left_out(workspace: WorkspaceIndex, needed: Sequence[str]) -> Iterator[Related]:
    """Where a script leaves packages of the workspace out of a build."""
    here = [name for name in needed if name in workspace.packages]
    for name, place in ((name, skipped_packages(workspace).get(name)) for name in here):
        if place is not None:
            yield Related(place, f"'{name}' is left out of a build here: one that depends on it would fail")


def _reachable(name: str, workspace: WorkspaceIndex, used: Mapping[str, AbstractSet[str]]) -> frozenset[str]:
    """The packages of this workspace that one of them may need, directly or not, itself included."""

    def needs(dependent: str) -> set[str]:
        package = workspace.packages.get(dependent)
        declared = [] if package is None else [d for d in package.dependencies if d.kind not in FOR_OTHERS]
        named = {d.name for d in declared if condition_holds(d.condition)} | used.get(dependent, set())
        return named & workspace.packages.keys()

    return closure([name], needs)


_OF_THE_BUILD = re.compile(r"ament_(?!index_)|rosidl_default_generators$|rosidl_generator_|\w+_cmake_module$")
"""The packages that are tools of a build; ``ament_index_cpp`` is a library."""


def _tags(package: Package, uses: Sequence[Use]) -> tuple[str, ...]:
    """How a dependency is called in the format of a package.xml, by what needs it.  In format 1 nothing says that it is
    for the build and for running."""
    ways = {use.how for use in uses}
    if ways <= {"tests with", "builds its tests with"}:
        return ("test_depend",)
    if ways == {"builds with"} and _OF_THE_BUILD.match(uses[0].needed):
        return ("buildtool_depend",)
    if package.format > 1:
        return ("exec_depend",) if ways.isdisjoint(BUILDS) else ("depend",)
    there = {f"{d.kind}_depend" for d in package.dependencies if d.name == uses[0].needed}
    tags = ("run_depend",) if ways.isdisjoint(BUILDS) else ("build_depend", "run_depend")
    return tuple(tag for tag in tags if tag not in there) or tags


def _sites(workspace: WorkspaceIndex, package: Package, by_needed: Mapping[str, Sequence[Use]]) -> Sites | None:
    """What a fix adds to the manifest: only packages that are known, of this workspace or of rosdistro.  Format 1
    refuses one that is declared for tests, too; and who leaves a package out of a build decides what depends on it."""
    taken = {d.name for d in package.dependencies if package.format == 1}
    spared = taken | package.in_export.keys()
    known = (name for name in sorted(by_needed) if name in workspace.packages or name in packages.table().names)
    names = tuple(name for name in known if name not in spared)
    names = tuple(name for name in names if _misspelt(workspace, package, name) is None)
    here = any(name in workspace.packages for name in names)
    names = tuple(name for name in names if not here or name not in skipped_packages(workspace))
    if not names:
        return None
    tags = {name: _tags(package, by_needed[name]) for name in names}
    rows = (
        MissingDependencies(package.manifest.relative, tag, tuple(name for name in names if tag in tags[name]))
        for tag in dict.fromkeys(tag for own in tags.values() for tag in own)
    )
    return Sites(dependencies=tuple(rows))
