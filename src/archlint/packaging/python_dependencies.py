"""Modules of Python that installed code imports and that no file of its package asks for."""

from __future__ import annotations

import posixpath
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside, is_not_installed
from archlint.analysis.kept import once
from archlint.analysis.pinned import ubuntu_releases
from archlint.packaging.imports import imports_at_start
from archlint.packaging.manifests import package_around
from archlint.records import dataclass
from archlint.ros import packages, python_modules, rosdep
from archlint.workspace.closure import closure
from archlint.workspace.comments import xml_comments
from archlint.workspace.manifest import condition_holds

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import Package, SourceFile

_LETTERS = re.compile(r"[^a-z0-9]+")
_BUILT_BY = ("setup.py", "setup.cfg", "pyproject.toml", "requirements.txt", "CMakeLists.txt")
"""Files beside a package.xml that may ask pip for a module."""


_CHANGE_OTHERS: Mapping[str, str] = {"mpl_toolkits": "matplotlib"}
"""Modules that come with another one, and add something to it by being imported."""
_EXTENSION = re.compile(r"(?:torch_?|tensorflow_|gym_|gymnasium_|pybullet_)[a-z]")
"""Modules of others that do so: the operations of ``torch_scatter``, which a model asks for that is loaded, are
registered by the import."""


@dataclass(frozen=True, order=True)
class ModuleUse:
    """A file imports a ``module``, which rosdep knows as ``key``, and may not use it."""

    place: Place
    module: str
    key: str
    unused: bool = False


def modules_to_declare(
    workspace: WorkspaceIndex, brought_by: Callable[[str], set[str]], asked_for: Mapping[str, Iterable[str]]
) -> dict[str, tuple[Package, list[ModuleUse]]]:
    """Those of each package, by its folder; ``brought_by`` says what a package brings along, ``asked_for`` by folder
    what another rule wants a package to declare."""
    rows: dict[str, tuple[Package, list[ModuleUse]]] = {}
    declared: dict[str, _Declared | None] = {}
    used_apart: set[tuple[str | None, str]] = set()
    without_key: set[tuple[str, str]] = set()
    releases = ubuntu_releases(workspace)
    for statement in imports_at_start(workspace):
        module = statement.module.partition(".")[0]
        changes_others = module in _CHANGE_OTHERS or _EXTENSION.match(module) is not None
        unused = statement.unused and not changes_others and not _has_comment(workspace, statement.place)
        module = _CHANGE_OTHERS.get(module, module)
        key = None if module in sys.stdlib_module_names else python_modules.key_of(module)
        if key is None or not all(rosdep.is_on(key, release) for release in releases):
            continue
        if _is_newer_than_ubuntu(workspace, module):
            continue
        if not _is_judged(workspace, statement.file):
            used_apart |= set() if unused else {(statement.file.package, module)}
            continue
        path = statement.file.relative
        package = package_around(workspace, posixpath.dirname(path) or ".")
        if package is None or _is_of_ros(workspace, path, statement.module, statement.names):
            continue
        if package.relative not in declared:
            more = asked_for.get(package.relative, ())
            declared[package.relative] = _declared(workspace, package, brought_by, more)
        known = declared[package.relative]
        if known is not None and not known.has(module, key):
            keys = python_modules.keys_of_parts(statement.module, statement.names) or [key]
            without_key |= {(package.relative, module)} if None in keys else set()
            uses = [ModuleUse(statement.place, module, each, unused) for each in keys if each is not None]
            rows.setdefault(package.relative, (package, []))[1].extend(uses)
    idle = {(package.name, use.module) for package, uses in rows.values() for use in uses if use.unused}
    used_apart |= {(package, module) for package, module in idle if _is_named_apart(workspace, package, module)}
    return {
        folder: (package, _with_uses_apart(package, _without_brought(uses), used_apart))
        for folder, (package, every) in rows.items()
        if (uses := [use for use in every if (folder, use.module) not in without_key])
    }


def _has_comment(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether the line of an import says what it is for, or to a linter that it is meant: it may be there for what
    importing the module does."""
    return any("#" in line for line in workspace.tree.lines(place.file, place.end_line, place.end_line))


def _without_brought(uses: Sequence[ModuleUse]) -> list[ModuleUse]:
    """The uses but for those of modules that pip brings along with another one of them: rosdep asks pip for that one,
    and what apt has beside it is a second copy."""
    by_pip = {use.module for use in uses if use.key.endswith("-pip") and not use.unused}
    return [use for use in uses if by_pip.isdisjoint(python_modules.brought_by_pip(use.module))]


def _is_newer_than_ubuntu(workspace: WorkspaceIndex, module: str) -> bool:
    """Whether some code uses what a module has only since a version newer than that of Ubuntu: pip brings it."""
    return any(workspace.code.files_that_mention(name) for name in _SINCE_PIP.get(module, ()))


_SINCE_PIP: Mapping[str, tuple[str, ...]] = {"cv2": ("ArucoDetector", "CharucoDetector", "generateImageMarker")}
"""Names that came with OpenCV 4.7, where Ubuntu 24.04 has 4.6.  Source: the changes of OpenCV 4.7.0."""


def _is_named_apart(workspace: WorkspaceIndex, package: str, module: str) -> bool:
    """Whether a file of a package names a module that has nothing to do with ROS, so that its imports are not read."""
    read = {file.relative for file, _ in workspace.code.asked_for()}
    own = set(workspace.code.files_of(package)) - read
    return any(file in own and not workspace.roles.is_test(file) for file in workspace.code.files_that_mention(module))


def _with_uses_apart(
    package: Package, uses: Sequence[ModuleUse], used_apart: AbstractSet[tuple[str | None, str]]
) -> list[ModuleUse]:
    """The uses, none of which is idle where a file of the package that no program runs uses the module."""
    return [replace(use, unused=use.unused and (package.name, use.module) not in used_apart) for use in uses]


def _is_judged(workspace: WorkspaceIndex, file: SourceFile) -> bool:
    """Whether a file is installed code: neither a test, nor an example, nor one that nothing starts or imports."""
    path = file.relative
    if file.package is None or file.kind != "python" or workspace.roles.is_test(path) or is_aside(workspace, path):
        return False
    aside = {"test", "tests", "doc", "docs", "example", "examples", "tools", "scripts"}
    if not aside.isdisjoint(path.split("/")[:-1]) and path not in workspace.code.in_use:
        return False
    return not (is_not_installed(workspace, path) or _is_in_no_build(workspace, file.package))


_INSTALL_PYTHON = frozenset({"ament_python_install_package", "ament_python_install_module", "PROGRAMS"})


def _is_in_no_build(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the CMake files of a package install no program and no code of Python: a setup.py beside them is not
    asked."""
    installs, manifest = workspace.installs.get(package), workspace.packages.get(package)
    if installs is None or manifest is None or manifest.build_type != "ament_cmake":
        return False
    scripts = any(executable.script is not None for executable in installs.executables.values())
    if scripts or installs.open_executables or installs.open_files or installs.mentioned:
        return False
    folders = {posixpath.normpath(row.source) for row in installs.files if row.folder}
    if any(file.startswith(f"{folder}/") for file in workspace.code.files_of(package) for folder in folders):
        return False
    return installs.words.isdisjoint(_INSTALL_PYTHON)


def _is_of_ros(workspace: WorkspaceIndex, path: str, module: str, names: tuple[str, ...]) -> bool:
    top = module.partition(".")[0]
    if top in workspace.packages or top in packages.table().names or workspace.code.path_of_import(path, top):
        return True
    return packages.package_of_module(module, names, lambda package: False) is not None


@dataclass(frozen=True)
class _Declared:
    """The letters of all that a package asks for, and the ROS packages that come with it."""

    letters: tuple[str, ...]
    there: frozenset[str]

    def has(self, module: str, key: str) -> bool:
        if not self.there.isdisjoint(python_modules.brought_along_by(module)):
            return True
        spellings = {_plain(module), _plain(key).removeprefix("python3").removeprefix("python").removesuffix("pip")}
        spellings.update(map(_plain, python_modules.brought_by_pip(module)))
        return any(spelling in asked for spelling in spellings for asked in self.letters)


def _plain(name: str) -> str:
    return _LETTERS.sub("", name.lower())


def _declared(
    workspace: WorkspaceIndex, package: Package, brought_by: Callable[[str], set[str]], more: Iterable[str]
) -> _Declared | None:
    """What a package asks for; None where nobody knows what something that it declares brings along."""
    if package.ros1 or package.build_type not in ("ament_python", "ament_cmake"):
        return None
    if _is_in_own_environment(workspace):
        return None
    direct = [d.name for d in package.dependencies if d.kind not in ("test", "doc") and condition_holds(d.condition)]
    known = packages.table().names | workspace.packages.keys() | rosdep.keys()
    there = closure([package.name, *direct, *(name for name in more if name in known)], brought_by)
    if any(name not in known and not name.endswith(("_msgs", "_interfaces")) for name in there):
        return None
    texts = [workspace.tree.text(posixpath.join(package.relative, name)) or "" for name in _BUILT_BY]
    texts += _taken_out(workspace.tree.text(package.manifest.relative) or "")
    return _Declared((*map(_plain, there), *map(_plain, [*texts, *_requirements(workspace)])), there)


def _taken_out(manifest: str) -> list[str]:
    """The dependencies that stand in comments of a manifest: somebody wants them there no longer, and knows of them."""
    return [name for comment in xml_comments(manifest) for name in _DEPENDENCY.findall(comment)]


_DEPENDENCY = re.compile(r"<(?:\w+_)?depend\b[^>]*>\s*([\w.-]+)\s*</")


@once
def _requirements(workspace: WorkspaceIndex) -> list[str]:
    """What in the whole workspace asks pip for modules, or may do so: files that do nothing else, and lines of others
    that install something."""
    tree = workspace.tree
    below = [path for folder in (tree.top, f"{tree.top}/.devcontainer") for path in tree.files_below(folder)]
    texts = []
    for path in dict.fromkeys(map(posixpath.normpath, below)):
        name = posixpath.basename(path)
        if _ASKS.fullmatch(name):
            texts.append(tree.text(path) or "")
        elif _TELLS.fullmatch(name) or path in _documents(workspace):
            texts += _INSTALLS.findall((tree.text(path) or "").replace("\\\n", " "))
    return texts


@once
def _documents(workspace: WorkspaceIndex) -> frozenset[str]:
    """The documents to which a README links: what one says of the set-up is often told there."""
    tree = workspace.tree
    linked: set[str] = set()
    for path in tree.files_below(tree.top):
        if _README.fullmatch(posixpath.basename(path)):
            folder = posixpath.dirname(path)
            links = (match[1] or match[2] for match in _LINK.finditer(tree.text(path) or ""))
            linked.update(posixpath.normpath(posixpath.join(folder, link)) for link in links)
    return frozenset(linked)


_README = re.compile(r"README(?:\.\w+)?", re.IGNORECASE)
_LINK = re.compile(r"\]\(\s*<?([\w./ -]+\.(?:md|rst|txt))(?:#[^)]*)?>?\s*\)|<([\w./-]+\.(?:md|rst|txt))>`_")
"""A link of Markdown or reStructuredText to a document beside or below."""


_ASKS = re.compile(
    r"[\w-]*(?:requirements|pip)[\w-]*\.(?:txt|in)|(?:conda|environment)[\w-]*\.ya?ml|(?:Pipfile|pdm|poetry|uv|pixi)\.lock"
    r"|Pipfile|pyproject\.toml|pixi\.toml|(?:[\w-]+\.)?[Dd]ockerfile(?:[._-]\w+)*|(?:install|setup)[\w-]*\.sh"
)
"""The names of files that say what is installed."""
_TELLS = re.compile(r".*\.sh|README.*|Makefile|devcontainer\.json|INSTALL.*", re.IGNORECASE)
"""The names of files with commands in them, some of which may install something."""
_INSTALLS = re.compile(r"\b(?:pip3?|conda|mamba|apt|apt-get|uv|poetry)\b[^\n]*\b(?:install|add)\b[^\n]*")


@once
def _is_in_own_environment(workspace: WorkspaceIndex) -> bool:
    """Whether somebody is told to work in a virtual environment, which has what pip installs: not what rosdep does."""
    tree = workspace.tree
    linked = _documents(workspace)
    below = map(posixpath.normpath, tree.files_below(tree.top))
    told = (path for path in below if path in linked or _TELLS.fullmatch(posixpath.basename(path)))
    return any(_ACTIVATES.search(tree.text(path) or "") for path in told)


_ACTIVATES = re.compile(r"(?:source|\.)\s+\S*/bin/activate\b")


__all__ = ["ModuleUse", "modules_to_declare"]
