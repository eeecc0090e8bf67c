"""Which package each file belongs to, and by which name Python imports it."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Mapping
from contextlib import suppress
from dataclasses import replace

from archlint.workspace.installed_modules import installed_modules
from archlint.workspace.manifest import read_manifest
from archlint.workspace.model import PYTHON_KINDS, Link, Package, Problem, SourceFile, Workspace
from archlint.workspace.module_names import ModuleNames

MAX_BYTES = 1_000_000
"""Nobody writes a package.xml or a CMakeLists.txt of this size."""


def place(
    root: str,
    files: Iterable[SourceFile],
    problems: Iterable[Problem],
    complete_folders: Iterable[str] = (),
    cpp_folders: Iterable[str] = (),
) -> Workspace:
    """The workspace that files make up: reads the manifests, gives each file its package and its module.

    ``complete_folders`` are the folders of which all files are there, ``cpp_folders`` those with C++ sources.
    """
    files = sorted(files, key=lambda file: file.relative)
    problems = list(problems)
    packages: dict[str, Package | None] = {}
    for file in _manifests(files):
        package = package_of(file)
        packages[os.path.dirname(file.path)] = None if isinstance(package, Problem) else package
        if isinstance(package, Problem) and not file.context:
            problems.append(package)
    texts = _build_files(packages, files)
    packages = {root: _as_built(package, texts.get(root)) for root, package in packages.items()}
    names = _names_by_root(packages, files, texts)
    homes: dict[str, str | None] = {}
    placed = []
    for file in files:
        folder = os.path.dirname(file.path)
        if folder not in homes:
            homes[folder] = _innermost(packages, folder)
        owner = names[homes[folder]]
        module = owner.module(file.path) if file.kind in PYTHON_KINDS else None
        links = []
        for link in sorted(file.links, key=lambda link: link.path):
            around = names[_innermost(packages, os.path.dirname(link.path))]
            links.append(Link(link.path, around.package, around.module(link.path)))
        placed.append(_member(file, owner.package, module, tuple(links)))
    known = [package for package in packages.values() if package is not None]
    with_cpp = {_innermost(packages, folder) for folder in cpp_folders}
    return Workspace(
        root,
        tuple(placed),
        tuple(sorted(known, key=lambda package: (package.name, package.relative))),
        tuple(sorted(problems, key=lambda problem: (problem.file, problem.line, problem.column))),
        tuple(sorted(set(complete_folders))),
        tuple(sorted(package.name for package in known if package.root in with_cpp)),
    )


def _member(file: SourceFile, package: str | None, module: str | None, links: tuple[Link, ...]) -> SourceFile:
    # dataclasses.replace takes four times as long.
    status = file.size, file.mtime_ns, file.inode, file.context, file.ctime_ns
    return SourceFile(file.path, file.relative, file.kind, package, module, *status, links)


def _manifests(files: Iterable[SourceFile]) -> list[SourceFile]:
    """The manifests of packages, those of outer folders first.

    A package.xml inside a package makes no package of its own, for colcon does not look there: it is a
    template, or somebody's test data.
    """
    by_folder: dict[str, SourceFile] = {}
    manifests = [file for file in files if file.kind == "package_xml"]
    for file in sorted(manifests, key=lambda file: (len(file.path), file.path)):
        folder = os.path.dirname(file.path)
        if _innermost(by_folder, os.path.dirname(folder)) is None:
            by_folder[folder] = file
    return list(by_folder.values())


def _innermost(roots: Collection[str], folder: str) -> str | None:
    """The nearest of ``roots`` upwards from ``folder``, itself included."""
    while folder not in roots:
        parent = os.path.dirname(folder)
        if parent == folder:
            return None
        folder = parent
    return folder


def package_of(file: SourceFile) -> Package | Problem:
    """What a manifest says, or why it cannot be read."""
    try:
        data = _read(file)
    except OSError as error:
        return Problem(file.relative, 1, 1, f"cannot read this file: {error.strerror}")
    return read_manifest(file, data, os.path.dirname(file.path), os.path.dirname(file.relative) or ".")


def _build_files(packages: Mapping[str, Package | None], files: Iterable[SourceFile]) -> dict[str, str]:
    """The text of each package's own CMakeLists.txt, by its folder."""
    texts: dict[str, str] = {}
    for file in files:
        folder = os.path.dirname(file.path)
        if file.kind == "cmake" and packages.get(folder) is not None:
            with suppress(OSError):
                texts[folder] = _read(file).decode("utf-8", "replace")
    return texts


_COMMENT = re.compile(r"#[^\n]*")
_CATKIN = re.compile(r"\bfind_package\s*\(\s*catkin\b", re.IGNORECASE)


def _as_built(package: Package | None, text: str | None) -> Package | None:
    """A package whose manifest names no build type is one of catkin where its CMakeLists.txt looks for that, and for
    nothing of ament: such packages are left over from a port, and nothing of ROS 2 builds them."""
    if package is None or text is None or package.build_type != "catkin":
        return package
    code = _COMMENT.sub("", text)
    if _CATKIN.search(code) is None or "ament" in code:
        return package
    return replace(package, ros1=True, catkin_code=True)


def _names_by_root(
    packages: Mapping[str, Package | None], files: Iterable[SourceFile], build_files: Mapping[str, str]
) -> dict[str | None, ModuleNames]:
    inits = {os.path.dirname(file.path) for file in files if os.path.basename(file.path) == "__init__.py"}
    installed = {
        folder: _installed(text, folder, package.name)
        for folder, text in build_files.items()
        if (package := packages.get(folder)) is not None
    }
    names: dict[str | None, ModuleNames] = {
        root: ModuleNames(root, package.name if package else None, inits, installed.get(root, {}))
        for root, package in packages.items()
    }
    names[None] = ModuleNames(None, None, inits)
    return names


def _installed(text: str, folder: str, package: str) -> dict[str, str]:
    return {
        os.path.normpath(os.path.join(folder, below)): name for below, name in installed_modules(text, package).items()
    }


def _read(file: SourceFile) -> bytes:
    with open(file.path, "rb") as stream:
        return stream.read(MAX_BYTES)
