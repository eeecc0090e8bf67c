"""What a package installs: executables, and files under ``share``."""

from __future__ import annotations

import fnmatch
import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING, Literal

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place


@dataclass(frozen=True)
class Executable:
    """One executable of a package.

    A console script has ``module`` and ``function``; an installed script has ``script`` (a shown path); a
    target of CMake has the ``sources`` that it is built of, as shown paths, or is made for a ``plugin``: the class of a
    component.  One that is ``wrong`` is not installed, for the reason that
    is said there, but was meant to be.
    """

    name: str
    package: str
    place: Place
    module: str | None = None
    function: str | None = None
    script: str | None = None
    wrong: str = ""
    sources: tuple[str, ...] = ()
    plugin: str = ""


@dataclass(frozen=True)
class Astray:
    """Where a program that CMake builds comes to instead of ``lib/<package>``: a folder below the prefix, empty where
    nothing installs it, and the place that says so."""

    folder: str
    place: Place | None


MARKERS = "share/ament_index/resource_index/packages"
"""Where the index of packages has a file for each, below the prefix."""


@dataclass(frozen=True)
class InstalledFiles:
    """Files that go to ``destination`` (below the install prefix).  ``source`` is a shown path: a file, a
    pattern, or a folder; of a folder either itself or (``contents``) what is in it is installed."""

    source: str
    destination: str
    folder: bool = False
    contents: bool = False
    rename: str | None = None
    place: Place | None = field(default=None, compare=False)
    """Where a setup.py names the source."""


@dataclass(frozen=True)
class NeededSource:
    """A file or folder without which a CMake command that always runs stops the build: its shown path."""

    path: str
    command: str
    place: Place
    folder: bool = False
    of_tests: bool = False
    """Whether the build asks for it unless the tests are left out."""
    part: bool = False
    """Whether it is a CMake file that the build goes on with: without it more of the build is not known."""
    line: int = 0
    """Where its command begins."""


@dataclass(frozen=True)
class NameInCMake:
    """A target that a ``command`` is given and that none has made; or a ``package`` that none has found, with the
    ``target`` that it is given for."""

    name: str
    command: str
    place: Place
    package: bool = False
    target: str = ""


@dataclass(frozen=True)
class MisspeltCommand:
    """A command of CMake that nothing defines, and the one that was ``meant``."""

    name: str
    meant: str
    place: Place


Refusal = Literal[
    "two signatures",
    "made twice",
    "types made twice",
    "two packages of Python",
    "no destination",
    "no target",
    "no option",
    "no package of Python",
]


@dataclass(frozen=True)
class RefusedCommand:
    """A ``command`` that CMake stops at: what is wrong with ``name``, one of its arguments; ``before`` is the place of
    the command that this one does not go with."""

    kind: Refusal
    name: str
    command: str
    place: Place
    before: Place | None = None


@dataclass(frozen=True)
class CalledCommand:
    """A command of CMake that a ``package`` defines which ``find_package()`` has to find."""

    name: str
    package: str
    place: Place


@dataclass(frozen=True)
class LeftLibrary:
    """A shared library that nothing installs, made at a ``place``; ``needed_by`` is installed and needs it."""

    name: str
    needed_by: str
    place: Place


@dataclass(frozen=True)
class BuiltTarget:
    """A program or library that CMake commands make of ``sources`` (shown paths); ``place`` is where they say what it
    depends on, or else where it is made."""

    name: str
    sources: tuple[str, ...]
    place: Place
    given: frozenset[str]
    """The packages, targets and libraries of the system that commands may give it, by their names."""
    open: bool = False
    """Whether it may be given more, or is made in one of several cases."""


@dataclass(frozen=True)
class AbsentFolder:
    """A folder in which ``package_dir=``, written at ``place``, puts packages, and that is not there: setuptools stops.
    ``unneeded`` is true where the packages are found without it."""

    path: str
    place: Place
    unneeded: bool


@dataclass(frozen=True)
class FoundPackage:
    """A package without which the build stops at a ``find_package(… REQUIRED)``: one that always runs, or that runs
    unless the tests are left out (``of_tests``)."""

    name: str
    place: Place
    of_tests: bool = False


@dataclass(frozen=True)
class PythonCode:
    """The modules that a ``setup.py`` installs: all that lie in some ``folders`` themselves, and single ``modules``,
    by their shown paths.  ``place`` is that of ``packages=``; ``searched`` is true where ``find_packages()`` finds the
    folders."""

    folders: frozenset[str]
    modules: frozenset[str]
    place: Place
    searched: bool = False
    absent: AbsentFolder | None = None
    listed_in_vain: tuple[str, ...] = ()
    """The packages whose folders are not there: setuptools stops at the first."""
    root: str = ""
    """The folder in which ``package_dir={'': …}`` puts what stands in no package; empty where nothing says so."""

    def has(self, path: str) -> bool:
        """Whether a file of Python, by its shown path, is installed."""
        return path in self.modules or (posixpath.dirname(path) or ".") in self.folders


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
    """Every word of the CMake files, but for their comments."""
    mentioned: frozenset[str] = frozenset()
    """What CMake commands that are not known here are given: each may be the name of an executable, or a folder that
    the command installs."""
    too_deep: dict[str, str] = field(default_factory=dict)
    """Programs by name that come to a folder inside ``lib/<package>``, where ``ros2 run`` finds them and launch does
    not: that folder."""
    astray: dict[str, Astray] = field(default_factory=dict)
    """Programs by name that CMake builds and that ``ros2 run`` and launch do not find."""
    generated: frozenset[str] | None = None
    """The words that ``rosidl_generate_interfaces`` is given; None where there is none, or one is not known."""
    generated_at: Place | None = None
    """Where the last such command names the packages that its interfaces depend on, or else its target."""
    build_files: list[str] = field(default_factory=list)
    python: PythonCode | None = None
    """The Python code that a setup.py installs; None where there is none, or it may install more than is known."""
    data_files_at: Place | None = None
    """Where the ``data_files=`` of a setup.py is written, or else its call of ``setup()``; None where there is none."""

    needed: list[NeededSource] = field(default_factory=list)
    """What the CMake files install or generate from, in any case."""
    sources: frozenset[str] = frozenset()
    """The C++ sources that the CMake files build in any case, by their shown paths."""
    required: list[FoundPackage] = field(default_factory=list)
    """The packages that the CMake files ask for."""
    names_of_nothing: list[NameInCMake] = field(default_factory=list)
    """What CMake commands name and none of them has made or found."""
    targets: frozenset[str] = frozenset()
    """The targets that the CMake files make."""
    unset_variables: list[NameInCMake] = field(default_factory=list)
    """Variables that the CMake files read and do not set, with almost the name of ``PROJECT_NAME``."""
    misspelt: list[MisspeltCommand] = field(default_factory=list)
    """Commands that the CMake files call and that nothing defines."""
    refused: list[RefusedCommand] = field(default_factory=list)
    """Commands that CMake stops at as they are written."""
    called: list[CalledCommand] = field(default_factory=list)
    """Commands of packages that have to be found, where all of the build is read."""
    left_libraries: list[LeftLibrary] = field(default_factory=list)
    """Shared libraries that nothing installs, where all of the build is read."""
    unregistered_at: Place | None = None
    """The last command of the CMakeLists.txt, where nothing in the build enters the package into the index."""
    unbrought_at: Place | None = None
    """Where the CMakeLists.txt calls ``ament_package()``, where nothing in the build brings that command."""
    looked_for: frozenset[str] = frozenset()
    """The packages that the CMake files look for, in any case or not."""
    built: list[BuiltTarget] = field(default_factory=list)
    """The targets that are made of sources, where all that makes them is read."""
    generates_nothing: bool = False
    """True where no command of the build can generate interfaces."""

    def add(self, executable: Executable) -> None:
        """Add an executable.  One that is there counts, but for the sources that only one of several branches has."""
        known = self.executables.setdefault(executable.name, executable)
        if known.sources != executable.sources and known.sources and executable.sources:
            shared = tuple(source for source in known.sources if source in executable.sources)
            self.executables[known.name] = replace(known, sources=shared)

    def is_indexed_as(self, name: str) -> bool:
        """Whether the build enters the prefix into the index of packages under a name, the manifest's or another one:
        ``ros2 run`` and launch find it there."""
        rows = (row for row in self.files if posixpath.normpath(row.destination) == MARKERS)
        return any((row.rename or posixpath.basename(row.source)) == name for row in rows)

    def may_install(self, file: str) -> bool:
        """Whether a CMake command that is not known here is given a file, by its path below the package's folder, or a
        folder that it is in."""
        parts = posixpath.normpath(file).split("/")
        around = ("/".join(parts[:end]) for end in range(1, len(parts) + 1))
        return not {word.rstrip("/") for word in self.mentioned}.isdisjoint(around)

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

    def places_of(self, source: str) -> Iterator[str]:
        """Where a shown path is installed, below the prefix; nowhere for what is not."""
        source = posixpath.normpath(source)
        for row in self.files:
            own = posixpath.normpath(row.source)
            if row.folder:
                below = "" if row.contents else posixpath.basename(own)
                if source.startswith(own + "/"):
                    yield posixpath.normpath(posixpath.join(row.destination, below, source[len(own) + 1 :]))
            elif fnmatch.fnmatchcase(source, own) and ("**" in own or source.count("/") == own.count("/")):
                yield posixpath.normpath(posixpath.join(row.destination, row.rename or posixpath.basename(source)))
