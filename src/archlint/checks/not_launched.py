"""GRF002: nodes that an executable starts and no launch file does."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.launch_files.launch_code import has_action_for, started_programs, words_of_launch_code

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Node


@rule("GRF002", scope=Scope.CODE)
def node_not_launched(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that an executable starts and no launch file does."""
    workspace = system.workspace
    if system.launched is not None or workspace is None or not workspace.launched:
        return
    started = started_programs(workspace)
    spoken = words_of_launch_code(workspace)
    for node in system.nodes:
        blueprint = node.blueprint
        if blueprint is None or node.test or not node.executables:
            continue
        runs = {(_run_package(node), name) for name in node.executables}
        installed = workspace.installs.get(_run_package(node) or "")
        runs = {run for run in runs if installed is not None and run[1] in installed.executables}
        if not runs or not runs.isdisjoint(started):
            continue
        if any(_spoken_of(words, *run) for run in runs for words in spoken) or any(
            has_action_for(workspace, *run) for run in runs
        ):
            continue
        shown = node.name or blueprint.class_name
        yield finding(
            "GRF002",
            blueprint.place,
            f"no launch file of this workspace starts {shown}",
            help="add it to a launch file, or run it with "
            f"`ros2 run {_run_package(node)} {min(name for _, name in runs)}`",
            node=node.name,
            identity=(blueprint.class_name,),
        )


def _spoken_of(words: frozenset[str], package: str | None, executable: str) -> bool:
    """Whether a file names an executable and its package, or the command that runs it."""
    if executable in words:
        return package in words
    return any(f"ros2 run {package} {executable}" in word for word in words)


def _run_package(node: Node) -> str | None:
    return node.program.package if node.program is not None else node.package
