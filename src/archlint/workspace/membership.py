"""Which package each file belongs to, and by which name Python imports it."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

from archlint.workspace.cmake_run import Step, run_alone
from archlint.workspace.installed_modules import installed_modules
from archlint.workspace.manifest import read_manifest
from archlint.workspace.model import PYTHON_KINDS, Link, Package, Problem, SourceFile, SourceKind, Workspace
from archlint.workspace.module_names import ModuleNames
from archlint.workspace.package_folders import package_folders
from archlint.workspace.parameter_libraries import generated_by_cmake, generated_by_setup

MAX_BYTES = 1_000_000
"""Nobody writes a package.xml or a CMakeLists.txt of this size."""

Read = Callable[[SourceFile], bytes]
"""Gives the bytes of a file; raises ``OSError``."""


def place(
    root: str,
    files: Iterable[SourceFile],
    problems: Iterable[Problem],
    complete_folders: Iterable[str] = (),
    read: Read | None = None,
) -> Workspace:
    """The workspace that files make up: reads the manifests, gives each file its package and its module.

    ``complete_folders`` are the folders of which all files are there.  ``read``
    gives the bytes of files that are not on the disk.
    """
    read = read or read_file
    files = sorted(files, key=lambda file: file.relative)
    problems = list(problems)
    packages: dict[str, Package | None] = {}
    for file in _manifests(files):
        package = package_of(file, read)
        packages[os.path.dirname(file.path)] = None if isinstance(package, Problem) else package
        if isinstance(package, Problem) and not file.context:
            problems.append(package)
    texts = _build_files(packages, files, "cmake", read)
    packages = {root: _as_built(package, texts.get(root)) for root, package in packages.items()}
    setups = _build_files(packages, files, "setup_py", read)
    names, beside = _names_by_root(packages, files, texts, setups)
    homes: dict[str, str | None] = {}
    libraries = _parameter_libraries(packages, files, texts, setups, read)
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
        links.extend(_other_name(file, module, beside.get(homes[folder])))
        if file.path in libraries:
            placed.append(_generating(file, owner.package, libraries[file.path]))
            continue
        placed.append(_member(file, owner.package, module, tuple(links)))
    known = [package for package in packages.values() if package is not None]
    return Workspace(
        root,
        tuple(placed),
        tuple(sorted(known, key=lambda package: (package.name, package.relative))),
        tuple(sorted(problems, key=lambda problem: (problem.file, problem.line, problem.column))),
        tuple(sorted(set(complete_folders))),
    )


def _member(file: SourceFile, package: str | None, module: str | None, links: tuple[Link, ...]) -> SourceFile:
    # dataclasses.replace takes four times as long.
    status = file.size, file.mtime_ns, file.inode, file.context, file.ctime_ns
    return SourceFile(file.path, file.relative, file.kind, package, module, *status, links)


def _parameter_libraries(
    packages: Mapping[str, Package | None],
    files: Iterable[SourceFile],
    texts: Mapping[str, str],
    setups: Mapping[str, str],
    read: Read,
) -> dict[str, list[str]]:
    """The files that code is generated from, each with the names of what is generated.  ``texts`` and ``setups`` are
    those of the packages' own folders; a CMakeLists.txt below them is read here."""
    libraries: dict[str, list[str]] = {}
    for file in files:
        folder = os.path.dirname(file.path)
        package = packages.get(_innermost(packages, folder) or "") if file.kind in ("cmake", "setup_py") else None
        if package is None:
            continue
        if file.kind == "cmake":
            rows = generated_by_cmake(texts.get(folder) or _text_of(file, read), package.name)
        else:
            rows = generated_by_setup(setups.get(folder, ""), package.name)
        for path, module in rows:
            libraries.setdefault(os.path.normpath(os.path.join(folder, path)), []).append(module)
    return libraries


def _generating(file: SourceFile, package: str | None, modules: Iterable[str]) -> SourceFile:
    """A file of parameters, by the names of the headers and modules that are generated from it."""
    first, *others = dict.fromkeys(modules)
    links = tuple(Link(file.path, package, module) for module in others)
    return replace(file, kind="parameter_library", package=package, module=first, links=links)


def _other_name(file: SourceFile, module: str | None, beside: ModuleNames | None) -> Iterator[Link]:
    """The name by which a file is imported where it lies, for one that is installed under another."""
    if module is None or beside is None or file.kind not in PYTHON_KINDS:
        return
    name = beside.module(file.path)
    if name not in (None, module):
        yield Link(file.path, beside.package, name)


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


def package_of(file: SourceFile, read: Read | None = None) -> Package | Problem:
    """What a manifest says, or why it cannot be read."""
    try:
        data = (read or read_file)(file)
    except OSError as error:
        return Problem(file.relative, 1, 1, f"cannot read this file: {error.strerror}")
    return read_manifest(file, data, os.path.dirname(file.path), os.path.dirname(file.relative) or ".")


def _build_files(
    packages: Mapping[str, Package | None], files: Iterable[SourceFile], kind: SourceKind, read: Read
) -> dict[str, str]:
    """The text of each package's own CMakeLists.txt, or setup.py, by its folder."""
    texts: dict[str, str] = {}
    for file in files:
        folder = os.path.dirname(file.path)
        if file.kind == kind and packages.get(folder) is not None and (text := _text_of(file, read)):
            texts[folder] = text
    return texts


def _text_of(file: SourceFile, read: Read) -> str:
    """The text of a build file; empty where it cannot be read."""
    with suppress(OSError):
        return read(file).decode("utf-8", "replace")
    return ""


def _as_built(package: Package | None, text: str | None) -> Package | None:
    """A package whose manifest names no build type, or that of catkin among others, is one of catkin where its
    CMakeLists.txt looks for that, and for nothing of ament: such packages are left over from a port, and nothing of
    ROS 2 builds them."""
    if package is None or text is None:
        return package
    if package.build_type != "catkin" and all(each.name != "catkin" for each in package.dependencies):
        return package
    run = run_alone(text, package.name)
    if not any(map(_looks_for_catkin, run.steps)) or any("ament" in word for word in run.words):
        return package
    return replace(package, ros1=True, catkin_code=True)


def _looks_for_catkin(step: Step) -> bool:
    return step.command.name == "find_package" and [text.lower() for text in step.command.texts[:1]] == ["catkin"]


def _names_by_root(
    packages: Mapping[str, Package | None],
    files: Collection[SourceFile],
    texts: Mapping[str, str],
    setups: Mapping[str, str],
) -> tuple[dict[str | None, ModuleNames], dict[str | None, ModuleNames]]:
    """The names of each package's modules, and those that they have where they lie, for packages that install some
    under others.  ``texts`` are those of the CMakeLists.txt, ``setups`` those of the setup.py."""
    inits = {os.path.dirname(file.path) for file in files if os.path.basename(file.path) == "__init__.py"}
    names: dict[str | None, ModuleNames] = {None: ModuleNames(None, None, inits)}
    beside: dict[str | None, ModuleNames] = {}
    for root, package in packages.items():
        installed = {} if package is None else _installed(root, package, texts.get(root, ""), setups.get(root, ""))
        names[root] = ModuleNames(root, package.name if package else None, inits, installed)
        if installed and package is not None:
            beside[root] = ModuleNames(root, package.name, inits)
    return names, beside


def _installed(root: str, package: Package, cmake: str, setup: str) -> dict[str, str]:
    below = installed_modules(cmake, package.name)
    if package.build_type == "ament_python":  # no other runs setup.py
        below = package_folders(setup)
    return {os.path.normpath(os.path.join(root, path)): name for path, name in below.items()}


def read_file(file: SourceFile) -> bytes:
    """The bytes of a manifest or a build file on the disk; raises ``OSError``."""
    with open(file.path, "rb") as stream:
        return stream.read(MAX_BYTES)
