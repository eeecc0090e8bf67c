"""What a run did not look at: reported beside the findings, so that a run without any means something."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence, Set
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.workspace.around import is_below

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.engine.request import Request
    from archlint.globs import Glob
    from archlint.report.model import Summary
    from archlint.systems.model import System
    from archlint.workspace.model import Workspace

_SOMETIMES_THERE = frozenset(
    {"build", "install", "log", "venv", ".venv", "node_modules", "site-packages", "__pycache__"}
)
"""Folders that a fresh checkout does not have, so that leaving them out is no mistake there."""


def without_node(summary: Summary) -> Iterator[str]:
    """A sentence where no node was found."""
    if summary.nodes:
        return
    yield f"no node was found in {counted(summary.files, 'file')}"


def ignored_sources(workspace: Workspace) -> Iterator[str]:
    """A sentence where git ignores packages in a ``src`` of which nothing else is read."""
    read = [file.relative for file in workspace.files]
    ignored = [path for path in workspace.ignored_packages if not any(_is_beside(path, file) for file in read)]
    if ignored:
        count = counted(len(ignored), "package")
        verb = "is" if len(ignored) == 1 else "are"
        yield (
            f"{count} in src {verb} not read, since a .gitignore says so (such as {ignored[0]}): "
            f"`archlint check {ignored[0]}` reads it all the same"
        )


def _is_beside(package: str, file: str) -> bool:
    """Whether a file lies in the same ``src`` as a package; both by shown paths."""
    parts = package.split("/")
    outer = parts[: len(parts) - parts[::-1].index("src")] if "src" in parts else parts
    return file.split("/")[: len(outer)] == outer


def around(paths: Sequence[str], workspace: Workspace) -> Iterator[str]:
    """A sentence where archlint was started inside a workspace, of which the rest is read and not reported on."""
    here = os.path.abspath(os.curdir)
    folders = [folder for folder in workspace.complete_folders if folder != here and is_below(here, folder)]
    if list(paths) == ["."] and folders and any(file.context for file in workspace.files):
        wide = os.path.relpath(min(folders, key=len)).replace(os.sep, "/")
        yield f"The rest of {wide} was read, too, but is not reported on: `archlint check {wide}` checks all of it."


def without_plugins(settings: Settings) -> Iterator[str]:
    """A sentence where plugins are named and do not run."""
    if settings.leaves_out_plugins:
        running = {plugin.name for plugin in settings.running_plugins}
        names = ", ".join(name for name in settings.plugins if name not in running)
        where = settings.origins.get("plugins", settings.file)
        yield f"{where}: the rules of {names} are left out; --plugins runs them"


def for_ros1(python: Sequence[str], launch: Sequence[str]) -> Iterator[str]:
    """One sentence on the files that are for ROS 1."""
    if len(python) + len(launch) == 1:
        yield f"{[*python, *launch][0]} is for ROS 1 and skipped"
        return
    counts = [(len(launch), "launch file"), (len(python), "Python file")]
    what = " and ".join(f"{count} {kind}{'s' if count > 1 else ''}" for count, kind in counts if count)
    if what:
        yield f"{what} are for ROS 1 and skipped"


def for_own_rclpy(python: Sequence[str], own: str) -> Iterator[str]:
    """One sentence on the Python files of a workspace that has an rclpy of its own."""
    what = f"{python[0]} is" if len(python) == 1 else f"{len(python)} Python files are"
    if python:
        yield f"{what} for the rclpy of {own}, not that of ROS 2, and skipped"


def without_start(systems: Iterable[System], context: Set[str]) -> Iterator[str]:
    """A sentence for each launch file that starts nothing since it could not be followed."""
    for launched in (system.launched for system in systems):
        if launched is None or launched.started or launched.file in context:
            continue
        for gap in [gap for gap in launched.gaps if not gap.dormant][:1]:
            place = f"{gap.place.file}:{gap.place.line}"
            yield f"{place}: what this launch file starts is not known, so it is not checked: {gap.reason}"


def started_elsewhere(request: Request, system: System, workspace: Workspace) -> Iterator[str]:
    """A sentence where the launch file of ``--launch`` is another package's, and starts nothing of what was asked
    for."""
    asked = {file.relative: file.package for file in workspace.files if not file.context}
    if request.launch is None or request.launch in asked or not system.nodes:
        return
    packages = {package for package in asked.values() if package is not None}
    files = {blueprint.place.file for node in system.nodes for blueprint in node.blueprints}
    if files.isdisjoint(asked) and packages.isdisjoint(node.package for node in system.nodes):
        yield f"{request.launch} starts no node of {', '.join(request.paths)}, so little is checked there"


_NAMED = 10
"""How many files a sentence names."""


def followed_in_part(files: Sequence[str]) -> Iterator[str]:
    """A sentence on the programs that were cut short because those before them had run so much."""
    if not files:
        return
    more = f" and {len(files) - _NAMED} more" if len(files) > _NAMED else ""
    these = "this file is" if len(files) == 1 else f"these {len(files)} files are"
    named = ", ".join(files[:_NAMED])
    yield f"the workspace has too much code to follow all of it, so {these} analysed only in part: {named}{more}"


def idle_patterns(settings: Settings, workspace: Workspace) -> Iterator[str]:
    """A sentence for each pattern of the configuration that no file or package of the workspace matches."""
    files = [file.relative for file in workspace.files]
    for key, globs in (("launch", settings.launch), ("per-file-ignores", tuple(settings.per_file_ignores))):
        for glob in globs:
            if not any(map(glob.matches, files)):
                yield _matches_nothing(settings, key, glob.pattern, "file")
    for glob in settings.exclude:
        if set(glob.patterns()) <= set(workspace.idle_exclusions) and not _may_come(glob):
            yield _matches_nothing(settings, "exclude", glob.pattern, "file")
    names = [package.name for package in workspace.packages]
    for pattern in settings.per_package_ignores:
        if not any(fnmatchcase(name, pattern) for name in names):
            yield _matches_nothing(settings, "per-package-ignores", pattern, "package")


def _matches_nothing(settings: Settings, key: str, pattern: str, what: str) -> str:
    return f"{settings.origins.get(key, settings.file)}: no {what} here matches '{pattern}' under {key}"


def _may_come(glob: Glob) -> bool:
    return not _SOMETIMES_THERE.isdisjoint(glob.pattern.split("/"))
