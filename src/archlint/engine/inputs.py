"""Which files, and which of several workspaces side by side, a request is about."""

from __future__ import annotations

import os
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.counted import counted
from archlint.engine.request import NothingToDo, Request
from archlint.records import dataclass
from archlint.syntax.summaries import Summaries
from archlint.workspace.around import is_below
from archlint.workspace.discovery import find
from archlint.workspace.model import CODE_KINDS, COMPILED_KINDS, LAUNCH_TEXT_KINDS, PYTHON_KINDS, SourceKind
from archlint.workspace.parts import parts
from archlint.workspace.tree import SourceTree

if TYPE_CHECKING:
    from archlint.engine.kept_programs import ResultsInMemory
    from archlint.engine.memory import Memory
    from archlint.syntax.cache import NullStore, Store
    from archlint.syntax.files import FactsOfFiles
    from archlint.systems.instances import KnownNodes
    from archlint.workspace.importable import Importable
    from archlint.workspace.model import SourceFile, Workspace


@dataclass(frozen=True)
class Inputs:
    """What a run works on: a request, the workspace that it is about, its folders, and where results are kept."""

    request: Request
    workspace: Workspace
    tree: SourceTree
    store: Store | NullStore
    memory: Memory | None = None
    """What an earlier run has left, and what is kept of this one, where another will follow in the same process."""
    results: ResultsInMemory | None = None
    """What such runs have followed."""
    importable: Importable | None = None
    """The files of the workspace as they can be imported, where such a run has sorted them."""
    nodes: KnownNodes | None = None
    """The nodes that such runs have made."""
    summaries: Summaries = field(default_factory=Summaries)
    """What analyses say of single files, in this run and in those before."""


_INPUTS: tuple[SourceKind, ...] = (*CODE_KINDS, *LAUNCH_TEXT_KINDS, "cpp")
_OF_PACKAGES: tuple[SourceKind, ...] = ("package_xml", "interface")
_FOR_ROS: tuple[SourceKind, ...] = (*_OF_PACKAGES, "launch_python", *LAUNCH_TEXT_KINDS)


def find_files(request: Request) -> Workspace:
    """The files of a request and what lies around them.  Raises :class:`NothingToDo` where there are none."""
    exclude = [pattern for glob in request.settings.exclude for pattern in glob.patterns()]
    if request.linked is None:
        workspace = find(request.paths, exclude=exclude, working_directory=request.folder)
    else:
        workspace = request.linked.workspace(exclude)
    if not workspace.problems and not any(is_input(file) or is_of_package(file) for file in workspace.files):
        raise NothingToDo(_nothing_found(request))
    return workspace


def _nothing_found(request: Request) -> str:
    if request.linked is not None:
        return (
            f"nothing to check: no package.xml, no Python or C++ file and no launch file in {', '.join(request.paths)}"
        )
    from archlint.engine.nothing import nothing_found  # looks at the disk once more, to say what is there

    return nothing_found(request.paths, request.settings.file if _is_excluded(request) else None)


def _is_excluded(request: Request) -> bool:
    """Whether there would be something to check without ``exclude``."""
    if not request.settings.exclude:
        return False
    workspace = find(request.paths, working_directory=request.folder)
    return any(is_input(file) or is_of_package(file) for file in workspace.files)


def tree_of(request: Request, workspace: Workspace) -> SourceTree:
    """What is read beside the Python code."""
    if request.linked is not None:
        return request.linked.tree
    inside = (*workspace.inside, *workspace.complete_folders)
    return SourceTree(Path(request.folder or Path.cwd()), Path(workspace.root), inside)


def is_input(file: SourceFile) -> bool:
    """Whether a file was asked for, and starts or holds code."""
    return not file.context and file.kind in _INPUTS


def is_of_package(file: SourceFile) -> bool:
    """Whether a file can be judged without any Python: a manifest, an interface."""
    return not file.context and file.kind in _OF_PACKAGES


def _is_for_ros(workspace: Workspace) -> bool:
    """Whether files say by their kind that this is ROS."""
    return any(file.kind in _FOR_ROS for file in workspace.files)


def python_files(workspace: Workspace) -> list[SourceFile]:
    """The files of Python, launch files among them."""
    return [file for file in workspace.files if file.kind in PYTHON_KINDS]


def compiled_files(workspace: Workspace) -> list[SourceFile]:
    """The files that are lowered to facts: of Python and of C++."""
    return [file for file in workspace.files if file.kind in COMPILED_KINDS]


def catkin_files(workspace: Workspace) -> list[SourceFile]:
    """Those of them that packages build which catkin builds.  A package for ROS 2 beside these may have the same name,
    in a folder of its own."""
    folders: dict[str, list[str]] = {}
    for package in workspace.packages:
        if package.catkin_code:
            folders.setdefault(package.name, []).append(package.root)
    compiled = compiled_files(workspace) if folders else []
    return [file for file in compiled if any(is_below(file.path, root) for root in folders.get(file.package or "", ()))]


def is_subset(request: Request, workspace: Workspace) -> bool:
    """Whether less is known than the folder that the configuration is for holds."""
    if request.settings.file is None:
        return False
    base = Path(request.settings.file).parent.resolve()
    return not any(base.is_relative_to(Path(folder).resolve()) for folder in workspace.complete_folders)


def known_files(request: Request, workspace: Workspace, facts: FactsOfFiles) -> list[SourceFile]:
    """The Python files that matter, and those that were asked for by name and cannot be compiled."""
    named = {os.path.abspath(path) for path in request.paths}

    def broken(file: SourceFile) -> bool:
        read = facts.facts_of(file) if file.path in named and not facts.is_ros1(file) else None
        return read is not None and bool(read.problems)

    return [file for file in python_files(workspace) if facts.relevant(file) or broken(file)]


def refuse_nothing(request: Request, workspace: Workspace, facts: FactsOfFiles) -> None:
    """Raises :class:`NothingToDo` where nothing is for ROS 2: a run that finds nothing there would say nothing."""
    if known_files(request, workspace, facts) or any(map(facts.relevant, workspace.of_kind("cpp"))):
        return
    if not _is_for_ros(workspace):
        files = counted(len(compiled_files(workspace)), "file")
        problems = "".join(f"\n{problem.file}: {problem.message}" for problem in workspace.problems[:3])
        raise NothingToDo(
            f"nothing to check in {', '.join(request.paths)}: no package.xml, no launch file, and nothing that uses "
            f"rclpy or rclcpp in {files} of Python or C++{problems}"
        )


def parts_of(request: Request, workspace: Workspace) -> list[Workspace]:
    """The workspace, or the several that it is, of which those that were asked for; with ``--launch`` the one that
    has the launch file."""
    asked = [part for part in parts(workspace) if any(not file.context for file in part.files)] or [workspace]
    if request.launch is None and request.observed is not None and len(asked) > 1:
        folders = ", ".join(sorted(part.root for part in asked))
        raise NothingToDo(f"--observed describes one system, but there are several workspaces here: {folders}")
    if request.launch is None or len(asked) == 1:
        return asked
    return [part for part in asked if any(file.relative == request.launch for file in part.files)][:1] or asked[:1]
