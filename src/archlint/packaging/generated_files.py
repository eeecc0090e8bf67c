"""Files that are not in the source because something of the workspace writes them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.cpp_nodes import CPP_SOURCES
from archlint.analysis.kept import kept
from archlint.workspace.folders import folders_above
from archlint.workspace.ignore import GITIGNORE, Ignores, Patterns, patterns_of
from archlint.workspace.submodules import paths_of_submodules
from archlint.workspace.words import WORD

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_TEMPLATES = (".in", ".j2", ".jinja", ".jinja2", ".em", ".erb", ".mako", ".template", ".tmpl", ".xacro")

_OPENED = r"""\bopen\([^#]{{0,200}}?(?<![\w.-]){name}["'][\s)]*,\s*(?:mode\s*=\s*)?["'][wax]"""
_WRITTEN = r"""(?<![\w.-]){name}["'][\s)]*\)\.write_(?:text|bytes)\("""
_STREAMED = r"""\bofstream\b[^;]{{0,200}}?(?<![\w.-]){name}\""""
_SHARE = re.compile(r"\bget_package_share_(?:directory|path)\b")
_SAVES = re.compile(r"\bmap_saver|\bsave_?map|\bserialize_?map", re.IGNORECASE)
"""What a source names that has a map saved: Nav2's or slam_toolbox's program or service."""


def is_generated(workspace: WorkspaceIndex | None, package: str, path: str) -> bool:
    """Whether a missing file of a package is evidently made later: a source of the package opens a file of its name in
    a share folder to write, or its folder is not in the source either, and any source of the workspace does so or has a
    map saved under it, or a template of that name lies in the package.

    ``path`` starts at the package's share folder.
    """
    installs = None if workspace is None else workspace.installs.get(package)
    if workspace is None or installs is None:
        return False
    folder, name = posixpath.split(posixpath.normpath(posixpath.join(installs.folder, path)))
    if not name:
        return False
    if workspace.tree.is_folder(folder):
        return _is_written(workspace, name, [installs.folder], into_share=True)
    return has_template(workspace, package, path) or _is_written(workspace, name, [*workspace.manifests])


def is_called_generated(workspace: WorkspaceIndex, launch_file: str, path: str) -> bool:
    """Whether a line of a launch file, such as the description of an argument, says of a missing file that something
    generates it."""
    name = re.escape(posixpath.basename(path))
    spoken = rf"(?<![\w.-]){name}\b.*\bgenerated\b|\bgenerated\b.*(?<![\w.-]){name}\b"
    return bool(name) and bool(workspace.tree.lines_with(launch_file, spoken))


def has_template(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether a template of a missing file lies in its package: the build may make the file of it."""
    name, installs = posixpath.basename(path), workspace.installs.get(package)
    made_of = {f"{stem}{ending}" for stem in (name, posixpath.splitext(name)[0]) for ending in _TEMPLATES}
    files = () if installs is None else workspace.tree.files_below(installs.folder)
    return any(posixpath.basename(file) in made_of for file in files)


_HOLD_BINARIES = frozenset(
    {"assets", "bag", "bags", "data", "images", "maps", "mesh", "meshes", "models", "rosbags", "textures", "weights"}
)
"""Folders of files that are large, and often kept out of a repository by their endings."""
_BINARIES = ("bag", "bt", "dae", "db3", "engine", "jpg", "mcap", "obj", "onnx", "pcd", "pgm", "ply", "png", "pt", "stl")


def is_ignored(workspace: WorkspaceIndex, path: str, *, by_name: bool = False) -> bool:
    """Whether git ignores a missing file, or all that a missing folder would have: it is made on each machine then.
    ``by_name`` asks of a folder itself alone, not of files with the endings that it may be there for."""
    inside = [f"{path}/file"]
    if posixpath.basename(path) in _HOLD_BINARIES and not by_name:
        inside += [f"{path}/file.{ending}" for ending in _BINARIES]
    return any(_ignores(workspace, file) for file in (path, *inside))


def is_kept_for_ignored(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether git ignores a missing file, whose folder is in the repository for such files alone: it has nothing but
    the ``.gitignore`` that says so."""
    folder = posixpath.dirname(path)
    own = posixpath.join(folder, GITIGNORE)
    is_empty = all(file == own for file in workspace.tree.files_below(folder))
    return is_empty and workspace.tree.text(own) is not None and is_ignored(workspace, path)


def is_ignored_by_name(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether a ``.gitignore`` names a missing file itself: everyone is to have one of his own."""
    name = posixpath.basename(path)
    texts = (workspace.tree.text(posixpath.join(folder, GITIGNORE)) or "" for folder in (*folders_above(path), ""))
    lines = (line.strip() for text in texts for line in text.splitlines())
    is_named = any(posixpath.basename(line) == name and not line.startswith("#") for line in lines)
    return is_named and _ignores(workspace, path)


def _ignores(workspace: WorkspaceIndex, path: str) -> bool:
    """Whether git ignores a file, or a folder around it."""
    top = "/"  # shown paths may begin with '..'; here all folders are below one
    around = [*folders_above(path)][::-1]
    patterns: tuple[Patterns, ...] = ()
    for folder, entry in zip(["", *around], [*around, path], strict=True):
        patterns += _gitignore(workspace, folder, posixpath.join(top, folder))
        if Ignores(patterns).ignored(posixpath.join(top, entry), is_folder=entry != path):
            return True
    return False


def _gitignore(workspace: WorkspaceIndex, folder: str, base: str) -> tuple[Patterns, ...]:
    def read() -> tuple[Patterns, ...]:
        text = workspace.tree.text(posixpath.join(folder, GITIGNORE))
        return () if text is None else patterns_of(base, text)

    return kept(workspace, (_gitignore, folder), read)


def submodule_around(workspace: WorkspaceIndex, path: str) -> str | None:
    """The submodule of git that a path is, or lies in; None for a path in none."""
    for folder in (*folders_above(path), ""):
        text = workspace.tree.text(posixpath.join(folder, ".gitmodules")) or ""
        for module in (posixpath.join(folder, module) for module in paths_of_submodules(text)):
            if path == module or path.startswith(f"{module}/"):
                return module
    return None


def _is_written(workspace: WorkspaceIndex, name: str, folders: Sequence[str], *, into_share: bool = False) -> bool:
    """Whether a source in some folders opens a file of a name to write or has a map saved under it; ``into_share``
    asks of those alone that look for a share folder, and open it."""
    quoted = re.escape(name)
    writes = re.compile("|".join(form.format(name=quoted) for form in (_OPENED, _WRITTEN, _STREAMED)))
    saved = re.compile(rf"""[/"']{re.escape(posixpath.splitext(name)[0])}(?:\.yaml)?["']""")
    sources = {path for folder in folders for path in workspace.tree.files_below(folder)}
    sources = {path for path in sources if path.endswith((".py", *CPP_SOURCES))}
    words = WORD.findall(posixpath.splitext(name)[0])
    mentioning = (path for path in sorted(sources) if all(workspace.code.mentions(path, word) for word in words))
    for path in mentioning:
        text, launches = workspace.tree.text(path) or "", workspace.launch_files.can_be_launched(path)
        if writes.search(text) and (not into_share or _SHARE.search(text)):
            return True
        if not into_share and not launches and _SAVES.search(text) and saved.search(text):
            return True
    return False
