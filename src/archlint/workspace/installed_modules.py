"""Which files and folders a package installs as Python packages, and under which names.

A CMakeLists.txt does so with ``ament_python_install_package``, or by copying them to where Python looks
(``install(DIRECTORY scripts/ DESTINATION ${PYTHON_INSTALL_DIR}/${PROJECT_NAME})``).  Nothing is run: what is not
written out is left out.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence

from archlint.workspace.cmake_run import run_alone, without_source

_INSTALL = "ament_python_install_package"
_SITE = re.compile(
    r"(?:^|/)(?:\$\{PYTHON_INSTALL_DIR\}|\$\{\w*SITE(?:LIB|ARCH)\w*\}|lib/(?=[^/]*python)[^/]*/(?:site|dist)-packages)(?:/|$)",
    re.IGNORECASE,
)
"""Where Python looks for what is installed: CMake has it in a variable, or it is written out."""
_KINDS = frozenset({"DIRECTORY", "FILES", "PROGRAMS"})
_ENDS_SOURCES = frozenset(
    {"COMPONENT", "CONFIGURATIONS", "DESTINATION", "DIRECTORY_PERMISSIONS", "EXCLUDE_FROM_ALL", "FILES_MATCHING"}
    | {"FILE_PERMISSIONS", "MESSAGE_NEVER", "OPTIONAL", "PATTERN", "PERMISSIONS", "REGEX", "RENAME", "TYPE"}
    | {"USE_SOURCE_PERMISSIONS"}
)


def installed_modules(text: str, package: str) -> dict[str, str]:
    """Folder or file, relative to that of the CMakeLists.txt, to the dotted name under which it is imported.

    ``package`` replaces ``${PROJECT_NAME}`` in a file that does not say ``project``.  What takes variables that
    the file does not set to plain words is left out, and so is what other files install.
    """
    if not any(word in text for word in (_INSTALL, "PYTHON_INSTALL_DIR", "SITELIB", "SITEARCH", "-packages")):
        return {}
    modules: dict[str, str] = {}
    for command in (step.command for step in run_alone(text, package).steps):
        words = [without_source(word) for word in command.texts]
        if command.name == _INSTALL and words:
            modules.update(_python_package(words))
        elif command.name == "install" and "DESTINATION" in words[:-1]:
            modules.update(_copied(words))
    return modules


def _python_package(words: Sequence[str]) -> Iterator[tuple[str, str]]:
    """``ament_python_install_package(name PACKAGE_DIR folder)``."""
    folder = words[words.index("PACKAGE_DIR") + 1] if "PACKAGE_DIR" in words[:-1] else words[0]
    if words[0].isidentifier() and "$" not in folder:
        yield posixpath.normpath(folder.strip("/")), words[0]


def _copied(words: Sequence[str]) -> Iterator[tuple[str, str]]:
    """``install(DIRECTORY … DESTINATION …)`` and ``install(FILES … DESTINATION …)``."""
    destination = words[words.index("DESTINATION") + 1]
    site = _SITE.search(destination)
    kind = words[0]
    if site is None or kind not in _KINDS or "RENAME" in words:
        return
    below = [part for part in destination[site.end() :].split("/") if part]
    for source in _sources(words[1:]):
        path = posixpath.normpath(source)
        parts = [*below, *_own_parts(source, is_folder=kind == "DIRECTORY")]
        if path != "." and parts and all(part.isidentifier() for part in parts):
            yield path, ".".join(parts)


def _sources(words: Sequence[str]) -> Iterator[str]:
    for word in words:
        if word in _ENDS_SOURCES:
            return
        if "$" not in word:
            yield word


def _own_parts(source: str, is_folder: bool) -> list[str]:
    """What a source itself adds to the name: nothing where only what a folder holds is copied."""
    name = posixpath.basename(source)
    if is_folder:
        return [name] if name else []
    stem, suffix = posixpath.splitext(name)
    if suffix != ".py":
        return [name]
    return [] if stem == "__init__" else [stem]
