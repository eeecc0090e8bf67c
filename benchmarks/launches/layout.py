"""Lays out what the packages of a checkout install under ``share``, as their ``setup.py`` and CMake files say.

Deliberately none of archlint's own reading: a ``setup.py`` really runs (in the sandbox), and CMake files are read by
a few regular expressions.
"""

from __future__ import annotations

import glob
import os
import re
import shutil
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

LARGEST = 2_000_000
"""Larger files are left empty."""
_SKIPPED = {".git", "build", "install", "log", "node_modules", "__pycache__"}
_TESTS = {"test", "tests"}


@dataclass
class Package:
    name: str
    folder: Path
    setup: bool = False
    cmake: bool = False
    launched: dict[str, Path] = field(default_factory=dict)
    """Launch files of the package by their path in the checkout, and where they are laid out."""


def packages(root: Path) -> list[Package]:
    """The packages for ROS 2 of a checkout, the first of each name."""
    found: dict[str, Package] = {}
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in _SKIPPED)
        if {"COLCON_IGNORE", "AMENT_IGNORE"} & set(files):
            folders.clear()
        elif "package.xml" in files and (package := _package(Path(folder))) is not None:
            found.setdefault(package.name, package)
            folders.clear()
    return [found[name] for name in sorted(found)]


def _package(folder: Path) -> Package | None:
    try:
        root = ElementTree.parse(folder / "package.xml").getroot()
    except (ElementTree.ParseError, OSError, ValueError):
        return None
    name = (root.findtext("name") or "").strip()
    kinds = [one.text or "" for one in root.findall("export/build_type")]
    tools = {
        (one.text or "").strip() for one in root.iter() if one.tag in ("buildtool_depend", "build_depend", "depend")
    }
    if not re.fullmatch(r"[\w.-]+", name) or (
        "catkin" in tools and not any(kind.strip().startswith("ament") for kind in kinds)
    ):
        return None
    cmake = (folder / "CMakeLists.txt").is_file() and not any(kind.strip() == "ament_python" for kind in kinds)
    return Package(name, folder, (folder / "setup.py").is_file(), cmake)


# ------------------------------------------------------------------------------------------------------ CMake

_COMMAND = re.compile(r"(\w+)\s*\(((?:[^()\"]|\"[^\"]*\"|\([^()]*\))*)\)", re.DOTALL)
_WORD = re.compile(r'"([^"]*)"|([^\s"]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")


_FOREACH = re.compile(
    r"\bforeach\s*\(\s*(\w+)\s+(?:IN\s+ITEMS\s+)?([^()]*)\)(.*?)\bendforeach\s*\([^()]*\)", re.S | re.I
)


def _repeated(loop: re.Match[str]) -> str:
    """The commands of a loop for each of its words; of one over lists, as they stand."""
    words = loop[2].split()
    return loop[3] if "LISTS" in words else "".join(loop[3].replace(f"${{{loop[1]}}}", word) for word in words)


def _commands(path: Path, variables: dict[str, str]) -> Iterator[tuple[str, list[str]]]:
    text = _FOREACH.sub(_repeated, re.sub(r"#.*", "", path.read_text("utf-8", "replace")))
    for match in _COMMAND.finditer(text):
        words = [quoted or plain for quoted, plain in _WORD.findall(match[2])]
        for _ in range(3):
            words = [_VARIABLE.sub(lambda found: variables.get(found[1], found[0]), word) for word in words]
        words = [part for word in words for part in word.split(";")]
        name = match[1].lower()
        if name == "project" and words:
            variables["PROJECT_NAME"] = variables["CMAKE_PROJECT_NAME"] = words[0]
        elif name == "set" and words:
            variables[words[0]] = ";".join(words[1:])
        elif name == "file" and words[:1] in (["GLOB"], ["GLOB_RECURSE"]) and len(words) > 2:
            patterns = [word for word in words[2:] if word != "CONFIGURE_DEPENDS"]
            names = [name for one in patterns for name in sorted(glob.glob(str(path.parent / one), recursive=True))]
            variables[words[1]] = ";".join(names)
        yield name, words


def _cmake(package: Package, place: Path, python: Path) -> None:
    variables = {"CMAKE_CURRENT_SOURCE_DIR": str(package.folder), "CMAKE_SOURCE_DIR": str(package.folder)}
    variables |= {
        "CMAKE_INSTALL_PREFIX": "",
        "CMAKE_CURRENT_LIST_DIR": str(package.folder),
        "PROJECT_SOURCE_DIR": str(package.folder),
    }
    for name, words in _commands(package.folder / "CMakeLists.txt", variables):
        if name == "install" and words:
            _install(package, words, place)
        elif name == "ament_auto_package" and "INSTALL_TO_SHARE" in words:
            for word in words[words.index("INSTALL_TO_SHARE") + 1 :]:
                _copy(package.folder / word, place / "share" / package.name / os.path.basename(word.rstrip("/")))
        elif name == "ament_python_install_package" and words:
            where = words[words.index("PACKAGE_DIR") + 1] if "PACKAGE_DIR" in words[:-1] else words[0]
            _copy(package.folder / where, python / words[0])


_ENDS = (
    "DESTINATION",
    "PERMISSIONS",
    "USE_SOURCE_PERMISSIONS",
    "PATTERN",
    "FILES_MATCHING",
    "OPTIONAL",
    "RENAME",
    "COMPONENT",
)
_ENDS += ("REGEX", "CONFIGURATIONS", "FILE_PERMISSIONS", "DIRECTORY_PERMISSIONS", "MESSAGE_NEVER", "EXCLUDE_FROM_ALL")


def _install(package: Package, words: list[str], place: Path) -> None:
    if words[0] not in ("DIRECTORY", "FILES", "PROGRAMS") or "DESTINATION" not in words[:-1]:
        return
    destination = words[words.index("DESTINATION") + 1].lstrip("/")
    end = next(number for number, word in enumerate(words) if word in _ENDS)
    renamed = words[words.index("RENAME") + 1] if "RENAME" in words[:-1] else None
    for word in words[1:end]:
        source = package.folder / word
        name = "" if words[0] == "DIRECTORY" and word.endswith("/") else renamed or os.path.basename(word.rstrip("/"))
        _copy(source, place / destination / name)


# ------------------------------------------------------------------------------------------------------ files


def _copy(source: Path, target: Path) -> None:
    """A file, or a folder with all that is in it; what is large, or leads out, is left empty."""
    if source.is_dir():
        for below in sorted(source.iterdir()):
            if below.name not in (".git", "__pycache__") and not (below.is_symlink() and below.is_dir()):
                _copy(below, target / below.name)
    elif source.is_file() and not target.exists():
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.stat().st_size > LARGEST:
            target.touch()
        else:
            shutil.copyfile(source, target)


def lay_out(package: Package, setup: dict[str, Any] | None, install: Path) -> None:
    """Copy what one package installs to ``install/NAME``, and its Python modules to ``install/python``."""
    place, python = install / package.name, install / "python"
    (place / "share" / package.name).mkdir(parents=True, exist_ok=True)
    _copy(package.folder / "package.xml", place / "share" / package.name / "package.xml")
    if package.cmake:
        _cmake(package, place, python)
    for folder, files in (setup or {}).get("data_files", ()) if not package.cmake else ():
        for file in files:
            _copy(package.folder / file, place / folder.lstrip("/") / os.path.basename(file))
    where = (setup or {}).get("package_dir", {})
    for name in (setup or {}).get("packages", ()):
        source = package.folder / where.get(name, os.path.join(where.get("", ""), *name.split(".")))
        if source.is_dir():
            for file in sorted(source.iterdir()):
                if file.is_file():
                    _copy(file, python.joinpath(*name.split(".")) / file.name)


# ----------------------------------------------------------------------------------------------- launch files

_GENERATE = re.compile(r"^def generate_launch_description\b|import generate_launch_description", re.MULTILINE)


def launch_files(package: Package) -> list[Path]:
    """What can be launched: Python that generates a description, XML and YAML by their first element."""
    found = []
    for folder, folders, files in os.walk(package.folder):
        folders[:] = sorted(name for name in folders if name not in _SKIPPED | _TESTS)
        for name in sorted(files):
            path = Path(folder, name)
            if _is_launch(path) and not re.match(r"(test_.*|.*_test|conftest)$", name.removesuffix(".py")):
                found.append(path)
    return found


def _is_launch(path: Path) -> bool:
    if path.suffix not in (".py", ".xml", ".launch", ".yaml", ".yml") or path.is_symlink():
        return False
    if path.suffix != ".py" and not (path.suffix == ".launch" or "launch" in path.name or path.parent.name == "launch"):
        return False
    text = path.read_text("utf-8", "replace")
    if path.suffix == ".py":
        return bool(_GENERATE.search(text))
    return bool(re.search(r"^\s*<launch\b|^launch\s*:", text, re.MULTILINE))


def place_of(package: Package, path: Path, install: Path) -> Path:
    """Where a launch file is installed; one that is not is put beside the others under its own path."""
    share = install / package.name / "share" / package.name
    relative = path.relative_to(package.folder)
    same = share / relative
    installed = [same] if same.is_file() else sorted(one for one in share.rglob(path.name) if one.is_file())
    text = path.read_bytes()
    for one in installed:
        if one.read_bytes() == text:
            return one
    _copy(path, same)
    return same
