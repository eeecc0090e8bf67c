"""What a package installs where: executables, and the files under ``share``."""

from __future__ import annotations

import fnmatch
import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from archlint.facts.cmake import Argument, Command, parse_cmake
from archlint.finding import Place


@dataclass(frozen=True)
class Executable:
    """One executable of a package.

    A console script has ``module`` and ``function``; an installed script has ``script`` (a shown path); a
    target of CMake has neither: its source is not Python.
    """

    name: str
    package: str
    place: Place
    module: str | None = None
    function: str | None = None
    script: str | None = None


@dataclass(frozen=True)
class InstalledFiles:
    """Files that go to ``destination`` (below the install prefix).  ``source`` is a shown path: a file, a
    pattern, or a folder; of a folder either itself or (``contents``) what is in it is installed."""

    source: str
    destination: str
    folder: bool = False
    contents: bool = False
    rename: str | None = None


@dataclass
class Installs:
    """All that is known of what one package installs.  ``open_executables`` and ``open_files`` are set where
    the build installs more than can be read from it."""

    package: str
    folder: str
    executables: dict[str, Executable] = field(default_factory=dict)
    files: list[InstalledFiles] = field(default_factory=list)
    open_executables: bool = False
    open_files: bool = False
    words: frozenset[str] = frozenset()
    """Every word of the build file: an executable whose name is not even mentioned is not built."""
    generated: frozenset[str] | None = None
    """The words that ``rosidl_generate_interfaces`` is given; None where there is none, or one is not known."""
    build_files: list[str] = field(default_factory=list)

    def add(self, executable: Executable) -> None:
        self.executables.setdefault(executable.name, executable)

    def source_of(self, installed: str, rows: Sequence[InstalledFiles] | None = None) -> Iterator[str]:
        """Shown paths that an installed path (below the prefix) may come from, best first; ``rows`` narrows the
        choice."""
        installed = posixpath.normpath(installed)
        for row in self.files if rows is None else rows:
            destination = posixpath.normpath(row.destination)
            if row.folder:
                base = destination
                if not row.contents:
                    base = posixpath.join(destination, posixpath.basename(row.source))
                if installed == base or installed.startswith(base + "/"):
                    yield posixpath.normpath(posixpath.join(row.source, installed[len(base) + 1 :]))
            elif posixpath.dirname(installed) == destination:
                name = posixpath.basename(installed)
                own = row.rename or posixpath.basename(row.source)
                if fnmatch.fnmatchcase(name, own):
                    source = row.source if row.rename else posixpath.join(posixpath.dirname(row.source), name)
                    if "**" not in row.source:
                        yield posixpath.normpath(source)


# --------------------------------------------------------------------------------------------------- CMake

_KEYWORDS = frozenset(
    [
        "PROGRAMS",
        "FILES",
        "DIRECTORY",
        "TARGETS",
        "DESTINATION",
        "RENAME",
        "PERMISSIONS",
        "CONFIGURATIONS",
        "COMPONENT",
        "OPTIONAL",
        "PATTERN",
        "REGEX",
        "EXCLUDE",
        "USE_SOURCE_PERMISSIONS",
        "FILE_PERMISSIONS",
        "DIRECTORY_PERMISSIONS",
        "FILES_MATCHING",
        "EXPORT",
        "ARCHIVE",
        "LIBRARY",
        "RUNTIME",
        "INCLUDES",
        "TYPE",
        "EXCLUDE_FROM_ALL",
        "MESSAGE_NEVER",
        "CODE",
        "SCRIPT",
    ]
)
_OPEN = frozenset({"include", "add_subdirectory", "foreach", "macro", "function"})
_HERE = re.compile(r"^\$\{(?:CMAKE_CURRENT_(?:SOURCE|LIST)_DIR|(?:CMAKE|PROJECT)_SOURCE_DIR)\}/?")


def read_cmake(installs: Installs, text: str, path: str) -> None:
    """Add what a CMakeLists.txt installs."""
    installs.build_files.append(path)
    installs.words |= frozenset(re.findall(r"[\w.-]+", text))
    for command in parse_cmake(text):
        if command.name in ("install", "catkin_install_python"):
            _install(installs, command, path)
        elif "add_executable" in command.name and command.arguments:
            _target(installs, command.arguments[0], path)
        elif command.name == "ament_auto_package":
            texts = command.texts
            at = texts.index("INSTALL_TO_SHARE") if "INSTALL_TO_SHARE" in texts else len(texts)
            for name in texts[at + 1 :]:
                source = posixpath.join(installs.folder, _HERE.sub("", name))
                installs.files.append(InstalledFiles(source, f"share/{installs.package}", folder=True))
        elif command.name in _OPEN:
            installs.open_executables = True
            installs.open_files = installs.open_files or command.name != "include"
        elif command.name == "rosidl_generate_interfaces":
            known = not any(argument.open for argument in command.arguments)
            installs.generated = frozenset(command.texts) if known and installs.generated is None else None
        elif command.name == "ament_python_install_package":
            installs.open_executables |= "SCRIPTS_DESTINATION" in command.texts
        arguments = command.texts
        if "EXECUTABLE" in arguments[:-1]:
            _target(installs, command.arguments[arguments.index("EXECUTABLE") + 1], path)


def _target(installs: Installs, argument: Argument, path: str) -> None:
    if argument.open:
        installs.open_executables = True
        return
    installs.add(Executable(argument.text, installs.package, _place(argument, path)))


def _place(argument: Argument, path: str) -> Place:
    end = argument.column + len(argument.text) + (2 if argument.quoted else 0)
    return Place(path, argument.line, argument.column, argument.line, end)


def _install(installs: Installs, command: Command, path: str) -> None:
    texts = command.texts
    groups: dict[str, list[Argument]] = {}
    current = ""
    for argument in command.arguments:
        if argument.text in _KEYWORDS and not argument.quoted:
            current = argument.text
            groups.setdefault(current, [])
        else:
            groups.setdefault(current, []).append(argument)
    where = groups.get("DESTINATION") or []
    destination = _destination(where[0].text) if where else None
    if "TARGETS" in groups or "CODE" in groups or "SCRIPT" in groups:
        return
    if destination is None or "$" in destination:
        installs.open_executables = installs.open_files = True
        return
    program_folder = destination in (f"lib/{installs.package}", "${CATKIN_PACKAGE_BIN_DESTINATION}")
    for kind in ("PROGRAMS", "FILES", "DIRECTORY"):
        for argument in groups.get(kind, []):
            source = _HERE.sub("", argument.text)
            if "$" in source:
                installs.open_executables |= program_folder
                installs.open_files |= not program_folder
                continue
            shown = posixpath.normpath(posixpath.join(installs.folder, source)) if source else installs.folder
            rename = groups.get("RENAME")
            if kind == "DIRECTORY":
                contents = argument.text.endswith("/") or not source
                installs.files.append(InstalledFiles(shown, destination, folder=True, contents=contents))
                installs.open_executables |= program_folder
            elif program_folder and "*" not in source:
                name = rename[0].text if rename else posixpath.basename(source)
                installs.add(Executable(name, installs.package, _place(argument, path), script=shown))
            elif program_folder:
                installs.files.append(InstalledFiles(shown, destination))
                installs.open_executables = True
            else:
                own = rename[0].text if rename else None
                installs.files.append(InstalledFiles(shown, destination, rename=own))
    if not texts:
        installs.open_files = True


def _destination(text: str) -> str:
    text = re.sub(r"^\$\{(?:CMAKE_INSTALL_PREFIX)\}/?", "", text)
    text = text.replace("${CMAKE_INSTALL_LIBDIR}", "lib").replace("${CMAKE_INSTALL_DATADIR}", "share")
    text = text.replace("${CMAKE_INSTALL_DATAROOTDIR}", "share").replace("${CMAKE_INSTALL_BINDIR}", "bin")
    return posixpath.normpath(text) if text else "."
