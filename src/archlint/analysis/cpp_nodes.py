"""What C++ sources say, as far as their text does: they are not compiled."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept
from archlint.workspace.comments import blank

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex

CPP_SOURCES = (".cpp", ".cc", ".cxx", ".hpp")


def names_cpp_node(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a C++ source of the package that a parameter file lies in names a node so: one file may serve several
    programs, of which a launch file starts one."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None:
        return False
    node = re.compile(rf'"{re.escape(name)}"')
    sources = [path for path in workspace.tree.files_below(installs.folder) if path.endswith(CPP_SOURCES)]
    texts = (workspace.tree.text(path) or "" for path in sources)
    return any("rclcpp" in text and node.search(text) is not None for text in texts)


def makes_costmap(workspace: WorkspaceIndex, package: str, name: str) -> bool:
    """Whether C++ of a package makes a costmap of Nav2 of that name: a node of its own in the process, whose namespace
    and name no launch file changes, as ``Costmap2DROS`` gives itself arguments with them."""
    installs = workspace.installs.get(package)
    if installs is None:
        return False
    call = re.compile(rf'\bCostmap2DROS\b[^;"]*[({{]\s*"{re.escape(name)}"')
    code = kept(workspace, (_code_below, installs.folder), lambda: _code_below(workspace, installs.folder))
    return any(call.search(row) is not None for row in code)


_STORED = re.compile(r"(\w+)\s*=\s*(?:this\s*->\s*|\w+(?:->|\.))?create_publisher\b")
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def without_cpp_comments(text: str) -> str:
    """C++ with blanks for its comments, so that everything else stands where it stood."""
    return _COMMENT.sub(lambda comment: blank(comment[0]), text)


def is_never_used(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether a publisher of C++ is kept in a variable that the sources of its package do nothing else with but declare
    it: nothing is published with it."""
    if not place.file.endswith(CPP_SOURCES):
        return False  # before anything is read: whoever reads a text is asked again when it changes
    return kept(workspace, (is_never_used, place), lambda: _is_never_used(workspace, place))


def _is_never_used(workspace: WorkspaceIndex, place: Place) -> bool:
    folder = workspace.installs.get(workspace.package_of(place.file) or "")
    text = workspace.tree.text(place.file)
    if folder is None or text is None:
        return False
    lines = text.splitlines()[place.line - 1 : place.line + 1]
    stored = _STORED.search("\n".join(lines))
    if stored is None:
        return False
    word = re.escape(stored[1])
    uses = re.compile(rf"(?<!\w){word}(?!\w)(?!\s*=[^=])")
    declarations = re.compile(rf"(?:Ptr|>|\*)\s+{word}\s*(?:;|\{{\s*(?:nullptr)?\s*\}}|=\s*nullptr)")
    code = kept(workspace, (_code_below, folder.folder), lambda: _code_below(workspace, folder.folder))
    rows = [row for row in code if stored[1] in row]
    own = _class_at(text, sum(len(line) for line in text.splitlines(keepends=True)[: place.line]))
    declaring = {_class_at(row, match.start()) for row in rows for match in declarations.finditer(row)}
    others = declaring - {own, ""}  # these use their own variable of that name
    return not any(
        _class_at(row, use.start()) not in others
        for row in rows
        for use in uses.finditer(declarations.sub(_blank, row))
    )


_CLASS = re.compile(r"^(?:class|struct)\s+(\w+)[^;\n]*$|^(?![ \t#])[^\n;]*?\b(\w+)::~?\w+[ \t]*\(", re.MULTILINE)
"""Where a class begins, or a method of one that is defined outside of it."""


def _class_at(text: str, offset: int) -> str:
    """The class whose code stands at a place, empty where none is seen to."""
    begins = list(_CLASS.finditer(text, 0, offset))
    return begins[-1][1] or begins[-1][2] if begins else ""


def _blank(match: re.Match[str]) -> str:
    return " " * len(match[0])


def _code_below(workspace: WorkspaceIndex, folder: str) -> list[str]:
    """The C++ of a folder, without its comments."""
    sources = [path for path in workspace.tree.files_below(folder) if path.endswith((*CPP_SOURCES, ".h", ".hxx"))]
    return [_COMMENT.sub(" ", workspace.tree.text(path) or "") for path in sources]
