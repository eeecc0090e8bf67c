"""Files that no code reads here, but a tool of ROS does, and cannot: descriptions that are no XML, parameter files that
are no YAML, build files in which a merge is not done."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.checks.registry import EMPTY, unreadable
from archlint.finding import Severity
from archlint.launch_files.unloaded_parameter_files import is_template
from archlint.syntax.descriptions import malformed_description, may_be_description
from archlint.syntax.parameter_structure import ROOT
from archlint.workspace.cmake_problems import malformed_cmake
from archlint.workspace.comments import replace_xml_comments
from archlint.workspace.merge_marks import UNMERGED, merge_in

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Workspace
    from archlint.workspace.tree import Tree


def unread_data(index: WorkspaceIndex, workspace: Workspace) -> Iterator[Finding]:
    """What is found of the descriptions; of the parameter files what is wrong is known to the launch files."""
    _read_parameter_files(index, workspace)
    yield from _malformed_descriptions(index, workspace)
    yield from _build_files(index, workspace)


_KEEP = "keep one side of the merge, or both, and remove the three marks"
_BUILD_FILES = ("CMakeLists.txt", ".cmake", "setup.cfg")


def _build_files(index: WorkspaceIndex, workspace: Workspace) -> Iterator[Finding]:
    """One LNT002 for each build file in which git has left both sides of a merge, as CMake takes the marks for words,
    and for each that CMake cannot parse."""
    asked = {package.name for package in workspace.packages if not package.ros1 and not package.manifest.context}
    files = {file for name in asked & index.installs.keys() for file in index.installs[name].build_files}
    for file in sorted(files):
        text = (index.tree.text(file) or "") if file.endswith(_BUILD_FILES) and not is_aside(index, file) else ""
        merge = merge_in(text)
        if merge is not None:
            line = text.count("\n", 0, merge) + 1
            finding = unreadable(file, line, 1, f"{UNMERGED}: the build stops")
            yield replace(finding, help=_KEEP)
        elif not file.endswith("setup.cfg") and (problem := malformed_cmake(text)) is not None:
            finding = unreadable(file, problem.line, 1, f"CMake cannot read this file: {problem.message}")
            yield replace(finding, help="correct it: the build stops here")


def with_its_reason(finding: Finding, tree: Tree) -> Finding:
    """What could not be read, with the reason if the words of a parser do not say it: both sides of a merge are left in
    the file, or there is nothing in it."""
    if finding.code != "LNT002" or UNMERGED in finding.message:
        return finding
    text = tree.text(finding.place.file)
    if finding.place.file.endswith(".xml") and text is not None and (told := _of_nothing(finding, text)) is not None:
        return told
    if merge_in(text or "") is None:
        return finding
    return replace(finding, message=f"{finding.message}; {UNMERGED}", help=_KEEP)


_IN_A_COMMENT = re.compile(r"\s*(?:<\?xml[^>]*>\s*)?<!--\s*<(\w+)\b.*</\1>\s*-->\s*", re.DOTALL)
"""A file that somebody has made a comment of, with the comments in it, which end it too early."""


def _of_nothing(finding: Finding, text: str) -> Finding | None:
    """What to say of a manifest or a launch file in XML with nothing in it: a launch file that waits to be written."""
    folder, _, name = finding.place.file.rpartition("/")
    if not text.strip():
        message, help = "this file is empty", "delete it, or write it"
    elif not _ELEMENT_OF_XML.search(replace_xml_comments(text, lambda _: "")):
        message, help = "nothing is in this file but a comment", "delete it, or write it"
    elif _IN_A_COMMENT.fullmatch(text):
        message = "the whole file is in a comment, in which there are others, so that it is no XML"
        help = "delete it, or take it out of the comment"
    else:
        return None
    told = replace(finding, message=message, help=help, identity=(message,))
    if name == "package.xml":
        return told
    return replace(told, severity=Severity.INFO, group=(EMPTY, folder) if not text.strip() else ())


_ELEMENT_OF_XML = re.compile(r"<\w")


def _read_parameter_files(index: WorkspaceIndex, workspace: Workspace) -> None:
    """Read the parameter files that no launch file loads, too, so that what is wrong with their YAML is known."""
    old = {package.name for package in workspace.packages if package.ros1}
    for file in workspace.of_kind("parameters"):
        if file.context or file.package is None or file.package in old or is_aside(index, file.relative):
            continue
        text = index.tree.text(file.relative) or ""
        if ROOT in text and not is_template(text):
            index.launch_files.parameters(file.relative)


_NAME_TO_FILL = re.compile(r"<name>\s*(<[\w-]+>)\s*</name>")


def is_to_be_filled_in(file: str) -> bool:
    """Whether a file lies among templates: a generator makes code of it, and until then it need not be any."""
    return not {"template", "templates"}.isdisjoint(file.split("/")[:-1])


def is_manifest_to_fill(file: str, tree: Tree) -> bool:
    """Whether a package.xml is a template: instead of a name it has a word in angle brackets, and so has a build file
    beside it."""
    name = _NAME_TO_FILL.search(tree.text(file) or "") if posixpath.basename(file) == "package.xml" else None
    beside = (posixpath.join(posixpath.dirname(file), other) for other in ("setup.py", "setup.cfg", "CMakeLists.txt"))
    return name is not None and any(name[1] in (tree.text(path) or "") for path in beside)


def _malformed_descriptions(index: WorkspaceIndex, workspace: Workspace) -> Iterator[Finding]:
    """One LNT002 for each such description of a package that was asked for."""
    asked = {package.name for package in workspace.packages if not package.ros1 and not package.manifest.context}
    # Not all of the workspace: the cache lies in it, and what it holds is no question of a run.
    folders = [package.relative for package in workspace.packages if package.name in asked]
    for file in sorted({file for folder in folders for file in index.tree.files_below(folder)}):
        name = posixpath.basename(file)
        if not may_be_description(name) or index.package_of(file) not in asked or is_aside(index, file):
            continue
        problem = malformed_description(name, index.tree.text(file) or "")
        if problem is not None:
            finding = unreadable(file, problem.line, problem.column, problem.message)
            group = ("description", index.package_of(file) or "", problem.message)
            yield replace(finding, help="correct it: whatever reads this file stops there", group=group)
