"""What finding yields: packages and files, sorted, with what could not be read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Literal

from archlint.records import dataclass

SourceKind = Literal[
    "python",
    "launch_python",
    "launch_xml",
    "launch_yaml",
    "parameters",
    "interface",
    "declaration",
    "package_xml",
    "setup_py",
    "setup_cfg",
    "pyproject",
    "cmake",
    "cpp",
    "parameter_library",
]
"""What a file is taken for."""
PYTHON_KINDS: tuple[SourceKind, ...] = ("python", "launch_python", "setup_py")
CODE_KINDS: tuple[SourceKind, ...] = ("python", "launch_python")
"""Python that nodes and launches run."""
COMPILED_KINDS: tuple[SourceKind, ...] = (*PYTHON_KINDS, "cpp", "parameter_library")
"""What is lowered to facts."""
LAUNCH_TEXT_KINDS: tuple[SourceKind, ...] = ("launch_xml", "launch_yaml")

DependencyKind = Literal[
    "depend", "build", "build_export", "buildtool", "buildtool_export", "exec", "run", "test", "doc"
]
"""The tag of a dependency without ``_depend``; ``depend`` itself stays."""

BuildType = Literal["ament_cmake", "ament_python", "catkin", "cmake", "other"]
"""The ``<build_type>`` of a manifest; ``other`` is one that none of the rules knows."""


@dataclass(frozen=True, slots=True)
class Problem:
    """Why a file or folder could not be used; lines and columns start at 1."""

    file: str
    line: int
    column: int
    message: str
    help: str | None = None
    """What brings the file, where that is known; it is no fault of the workspace then."""
    leads_out: bool = False
    """Whether it is a link by an absolute path, to something that is not there."""


@dataclass(frozen=True, slots=True)
class Link:
    """A symbolic link to a file of the workspace: the package that it lies in, and the name that it gives a module."""

    path: str
    package: str | None = None
    module: str | None = None


@dataclass(frozen=True, slots=True)
class SourceFile:
    """A file that matters.

    ``relative`` is the path from the working directory with ``/``; ``module`` the dotted name under which Python
    imports the file, None where no import statement can.  A ``context`` file was not asked for: it is read so that
    imports resolve, and nothing is reported for it.
    """

    path: str
    relative: str
    kind: SourceKind
    package: str | None
    module: str | None
    size: int = 0
    mtime_ns: int = 0
    inode: int = 0
    context: bool = False
    ctime_ns: int = 0
    links: tuple[Link, ...] = ()
    """The other names that a Python file has in this workspace."""

    @property
    def modules(self) -> list[str]:
        """All its dotted names; those of a parameter library are what is generated from it."""
        return [module for module in (self.module, *(link.module for link in self.links)) if module is not None]

    @property
    def stamp(self) -> tuple[int, int, int, int]:
        """What is different once the file has changed.

        The time of the status change is in it because tools that set the other time back cannot set this one.
        """
        return (self.mtime_ns, self.ctime_ns, self.size, self.inode)


@dataclass(frozen=True, slots=True)
class Dependency:
    """One dependency of a package."""

    name: str
    kind: DependencyKind
    condition: str | None = None
    line: int = 1


_AT_RUN_TIME: frozenset[DependencyKind] = frozenset(
    {"depend", "exec", "build_export", "buildtool_export", "run", "build"}
)


@dataclass(frozen=True, slots=True)
class Package:
    """A package by its package.xml.  ``build_type`` is ``catkin`` where the manifest names none, ``format``
    (of the manifest, REP 127, 140 and 149) is 1 where it says nothing."""

    name: str
    root: str
    relative: str
    build_type: BuildType
    is_interface_package: bool
    dependencies: tuple[Dependency, ...]
    manifest: SourceFile
    name_line: int = 1
    format: int = 1
    ros1: bool = False
    """Whether it is built by catkin alone, the build system of ROS 1."""
    catkin_code: bool = False
    """Whether its CMakeLists.txt says so: its Python is then of ROS 1, too, whatever it imports by now."""
    in_export: Mapping[str, int] = field(default_factory=dict, compare=False)
    """The dependencies that its manifest has inside ``<export>``, where nothing reads them, each with its line."""
    people: frozenset[str] = frozenset()
    """The names and addresses of those who maintain it and have written it, in small letters."""
    addresses: tuple[str, ...] = ()
    """The pages that its manifest names: of the project, its repository, its issues."""
    version: str = ""
    """As its manifest says it; ``ros2 pkg create`` writes 0.0.0."""

    def runtime_dependencies(self) -> frozenset[str]:
        """Names this package needs to run, or to build and run (``depend``)."""
        return frozenset(d.name for d in self.dependencies if d.kind in _AT_RUN_TIME)


@dataclass(frozen=True, slots=True)
class Workspace:
    """All that was found below the paths that were asked for."""

    root: str
    files: tuple[SourceFile, ...]
    packages: tuple[Package, ...]
    problems: tuple[Problem, ...] = field(default=())
    complete_folders: tuple[str, ...] = ()
    """The folders of which all files were looked for, as absolute paths."""
    idle_exclusions: tuple[str, ...] = ()
    """Patterns to leave out files by that left out none."""

    beside: tuple[str, ...] = ()
    """The folders, by shown paths, of packages of other workspaces that stand side by side with this one."""
    inside: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """The real paths of the repository and of what was asked for: of a file that a link leads to elsewhere no text is
    shown, and it is not changed.  Empty where nothing is read from the disk."""

    def of_kind(self, *kinds: SourceKind) -> list[SourceFile]:
        return [file for file in self.files if file.kind in kinds]

    def package(self, name: str | None) -> Package | None:
        return next((package for package in self.packages if package.name == name), None)

    looked_at: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """What beside the files decides what is found: folders, links, pattern files of git, what was passed over."""
    ignored_packages: tuple[str, ...] = field(default=(), compare=False)
    """The folders, by shown paths, of packages in ``src`` that git ignores and that are therefore not read."""
