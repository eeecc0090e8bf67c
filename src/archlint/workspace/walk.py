"""The walk over folders.  It runs on every start: no pathlib, and one ``stat`` for each file that is kept."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable, Iterator, Set
from dataclasses import replace

from archlint.records import dataclass
from archlint.workspace.around import is_below
from archlint.workspace.ignore import Ignores, clones_in, ignores_above, pattern_files
from archlint.workspace.kinds import has_python_shebang, kind_of, may_be_script
from archlint.workspace.model import PYTHON_KINDS, Link, Problem, SourceFile, SourceKind
from archlint.workspace.pruning import is_pruned_by_content, is_pruned_by_name
from archlint.workspace.submodules import submodule_of
from archlint.workspace.tracked import Tracked

CLONES_DEPTH = 2
"""How many folders below an ignored ``src`` clones are looked for: ``src/<organisation>/<repository>``."""


@dataclass(frozen=True, slots=True)
class _Folder:
    path: str
    shown: str
    real: str
    """The path without symbolic links: by it folders and files are distinguished."""
    ignores: Ignores
    context: bool
    siblings: Set[str] | None = None
    """The names beside it; None for a folder that was asked for."""

    @property
    def name(self) -> str:
        return os.path.basename(self.path)

    def inner(self, path: str, ignores: Ignores, siblings: Set[str]) -> _Folder:
        """A folder below this one."""
        below = path[len(self.path.rstrip(os.sep)) :]
        real = self.real.rstrip(os.sep) + below
        return _Folder(path, self.shown_below(below[1:]), real, ignores, self.context, siblings)

    def shown_below(self, below: str) -> str:
        if os.sep != "/":
            below = below.replace(os.sep, "/")
        return below if self.shown == "." else f"{self.shown.rstrip('/')}/{below}"


class Walk:
    """Collects the files below folders, each once however many links lead to it.

    ``excluded`` says of a path from the working directory whether the configuration leaves it out.  What is
    asked for by name (:meth:`add_file`, the folder given to :meth:`add_folder`) is taken all the same.
    """

    def __init__(self, working_directory: str, excluded: Callable[[str], bool] | None = None) -> None:
        self.files: dict[str, SourceFile] = {}
        """What was found, by real path."""
        self.problems: dict[str, Problem] = {}
        self.looked_at: list[str] = []
        """What beside the files decides what is found, see :attr:`Workspace.looked_at`."""
        self.inside: list[str] = []
        """The real paths of what was asked for, and of the repository: see :attr:`Workspace.inside`."""
        self.ignored_packages: list[str] = []
        """Packages in ``src`` that git ignores, as shown."""
        self._packages: dict[str, bool] = {}
        """Of folders elsewhere whether they lie in a package."""
        self._working_directory = working_directory
        self._excluded = excluded
        self._visited: set[str] = set()
        self._tracked: set[Tracked] = set()
        self._links: list[tuple[os.DirEntry[str], _Folder, bool]] = []
        """Symbolic links, with the folder that each lies in and whether that is a Python package."""

    def add_file(self, path: str) -> None:
        """Take one file, whatever is said about it elsewhere.  Raises ``OSError`` where there is none."""
        folder, name = os.path.split(path)
        in_package = os.path.lexists(os.path.join(folder, "__init__.py"))
        kind = kind_of(name, os.path.basename(folder), in_package)
        status = os.stat(path)
        if kind is None and name.endswith(".xml"):
            kind = "launch_xml"
        elif name.endswith(".launch") and stat.S_ISREG(status.st_mode) and has_python_shebang(path):
            kind = "launch_python"
        elif kind is None and stat.S_ISREG(status.st_mode) and has_python_shebang(path):
            kind = "python"
        self.looked_at.append(path)
        if kind is not None:
            self.inside.append(os.path.realpath(path))
            self._keep(self.inside[-1], path, self.shown(path), kind, status, False)

    def add_folder(self, path: str, context: bool = False) -> None:
        """Take all files below a folder."""
        top = _Folder(path, self.shown(path), os.path.realpath(path), ignores_above(path), context)
        self.inside.append(top.real)
        self._walk([top])
        while self._links:
            # Last and sorted: a file goes by its own path, else by the same link on every run.
            links = sorted(self._links, key=lambda link: link[0].path)
            self._links = []
            self._walk([folder for link in links for folder in self._follow(*link, top.real)])
        self.looked_at += sorted(tracked.index for tracked in self._tracked if tracked.is_read)

    def shown(self, path: str) -> str:
        """An absolute path as seen from the working directory, with ``/``."""
        try:
            return os.path.relpath(path, self._working_directory).replace(os.sep, "/")
        except ValueError:  # another drive
            return path.replace(os.sep, "/")

    def _walk(self, folders: list[_Folder]) -> None:
        stack = folders[::-1]
        while stack:
            folder = stack.pop()
            if folder.real not in self._visited:
                self._visited.add(folder.real)
                stack.extend(self._list(folder))

    def _list(self, folder: _Folder) -> Iterator[_Folder]:
        """Keep the files of a folder; yields the folders in it."""
        self.looked_at.append(folder.path)
        try:
            with os.scandir(folder.path) as listing:
                entries = {entry.name: entry for entry in listing}
        except OSError as error:
            if not folder.context:
                self._problem(folder.shown, f"cannot be listed: {error.strerror}")
            return
        names = entries.keys()
        if folder.siblings is not None and is_pruned_by_content(folder.name, names, folder.siblings):
            return
        self.looked_at += pattern_files(folder.path, names)
        ignores = folder.ignores.entering(folder.path, names)
        if ignores.tracked is not None:
            self._tracked.add(ignores.tracked)
        here = _Folder(folder.path, folder.shown, folder.real, ignores, folder.context)
        folder_name, in_package = folder.name, "__init__.py" in names
        for name, entry in entries.items():
            if entry.is_symlink():
                self._links.append((entry, here, in_package))
            elif not entry.is_dir(follow_symlinks=False):
                self._entry(entry, here, kind_of(name, folder_name, in_package))
            elif not is_pruned_by_name(name) and not self._is_excluded(here.shown_below(name)):
                inside = ignores.inside(entry.path)
                if inside is not None:
                    yield here.inner(entry.path, inside, names)
                    continue
                depth = _clones_depth(name, folder_name)
                clones, packages = clones_in(entry.path, depth, self.looked_at)
                if depth:
                    self.ignored_packages += [here.inner(package, ignores, names).shown for package in packages]
                for clone in clones:
                    yield here.inner(clone, ignores, names)

    def _entry(self, entry: os.DirEntry[str], folder: _Folder, kind: SourceKind | None) -> None:
        """Keep a file if it is of use and not left out."""
        name = entry.name
        if name.startswith(".") or (kind is None and "." in name):
            return
        shown = folder.shown_below(name)
        if self._is_excluded(shown) or folder.ignores.ignored(entry.path):
            return
        if kind is None:
            self.looked_at.append(entry.path)
        try:
            status = entry.stat()
        except OSError as error:
            stray = kind == "cpp" and not self._is_in_package(os.path.dirname(entry.path))  # of a firmware, say
            if kind is not None and not folder.context and not stray and (why := _why_unreadable(entry, error)):
                self._problem(shown, *why)
            return
        if kind is None:
            if not _is_python_script(entry, folder.name, status):
                return
            kind = "python"
        elif kind == "launch_xml" and name.endswith(".launch") and has_python_shebang(entry.path):
            kind = "launch_python"
        real = os.path.realpath(entry.path) if entry.is_symlink() else os.path.join(folder.real, name)
        self._keep(real, entry.path, shown, kind, status, folder.context)

    def _follow(self, link: os.DirEntry[str], folder: _Folder, in_package: bool, top: str) -> Iterator[_Folder]:
        """Keep the file that a link leads to; yields the folder that it leads to.

        A link to a folder around ``top`` leads out of what was asked for, in the worst case to ``/``.
        """
        self.looked_at.append(link.path)
        try:
            is_folder = link.is_dir()
        except OSError:  # a link to itself
            is_folder = False
        if not is_folder:
            self._entry(link, folder, kind_of(link.name, folder.name, in_package))
            return
        real = os.path.realpath(link.path)
        leads_out = (top + os.sep).startswith(real.rstrip(os.sep) + os.sep)
        shown = folder.shown_below(link.name)
        if leads_out or is_pruned_by_name(link.name) or self._is_excluded(shown):
            return
        if not folder.ignores.ignored(link.path):
            yield _Folder(link.path, shown, real, folder.ignores, folder.context, frozenset())

    def _keep(self, real: str, path: str, shown: str, kind: SourceKind, status: os.stat_result, context: bool) -> None:
        known = self.files.get(real)
        if known is not None:
            linked = path != known.path and os.path.islink(path) and not os.path.islink(known.path)
            if linked and known.kind in PYTHON_KINDS and all(path != link.path for link in known.links):
                self.files[real] = replace(known, links=(*known.links, Link(path)))
            return
        if kind not in PYTHON_KINDS and self._is_foreign(real):
            if not context and os.path.islink(path):
                self._problem(shown, "is a symbolic link that leads out of the repository, so it is not read", _NAME_IT)
            return
        if not stat.S_ISREG(status.st_mode):
            if not context:
                self._problem(shown, "is not a regular file")
            return
        file = SourceFile(
            path,
            shown,
            kind,
            None,
            None,
            status.st_size,
            status.st_mtime_ns,
            status.st_ino,
            context,
            status.st_ctime_ns,
        )
        self.files[real] = file

    def _is_foreign(self, real: str) -> bool:
        """Whether a file lies outside of the repository, and in no package there."""
        inside = any(is_below(real, folder) for folder in self.inside)
        return not inside and not self._is_in_package(os.path.dirname(real))

    def _is_in_package(self, folder: str) -> bool:
        """Whether a folder that a link leads to belongs to a package: colcon follows such links."""
        known = self._packages.get(folder)
        if known is None:
            manifest = os.path.join(folder, "package.xml")
            self.looked_at.append(manifest)
            above = os.path.dirname(folder)
            known = os.path.isfile(manifest) or (above != folder and self._is_in_package(above))
            self._packages[folder] = known
        return known

    def _is_excluded(self, shown: str) -> bool:
        return self._excluded is not None and self._excluded(shown)

    def _problem(self, shown: str, message: str, help: str | None = None, leads_out: bool = False) -> None:
        self.problems.setdefault(shown, Problem(shown, 1, 1, message, help, leads_out))


_BROKEN_LINK = "is a broken symbolic link"
_NAME_IT = "to have it read, name the file that it leads to on the command line, too"


def _clones_depth(name: str, around: str) -> int:
    return CLONES_DEPTH if name == "src" else CLONES_DEPTH - 1 if around == "src" else 0


def _is_python_script(entry: os.DirEntry[str], folder_name: str, status: os.stat_result) -> bool:
    return (
        stat.S_ISREG(status.st_mode)
        and may_be_script(entry.name, folder_name, status.st_mode)
        and has_python_shebang(entry.path)
    )


_OF_CATKIN = "/catkin/cmake/toplevel.cmake"
"""What catkin links into the source folder of each workspace: of ROS 1, and with nothing of the workspace in it."""


def _leads_into_nothing(link: str) -> bool:
    """Whether a symbolic link leads into an empty folder.  Git keeps none: it is that of a submodule which no
    ``.gitmodules`` names any more, or of something that is to be fetched, and the link is right once it is filled."""
    try:
        folder = os.path.dirname(os.path.normpath(os.path.join(os.path.dirname(link), os.readlink(link))))
        return folder != os.path.dirname(link) and not os.listdir(folder)
    except OSError:
        return False


def _broken_link(link: str) -> tuple[str, None, bool]:
    """What to say of a link to nothing: those that one computer alone has a folder for lead below what is not there."""
    target = os.path.normpath(os.readlink(link))
    if not os.path.isabs(target):
        return _BROKEN_LINK, None, False
    while not os.path.lexists(os.path.dirname(target)):
        target = os.path.dirname(target)
    return f"{_BROKEN_LINK}: there is no '{target}' here", None, True


def _why_unreadable(entry: os.DirEntry[str], error: OSError) -> tuple[str, str | None, bool] | None:
    """What to say of a file whose status cannot be had, what brings it, and whether it is a link out of the workspace;
    None for one that has just been removed."""
    if error.errno == errno.ENOENT:
        submodule = submodule_of(entry.path) if entry.is_symlink() else None
        if submodule is not None:
            message = f"is a symbolic link into the git submodule '{submodule}', which is not checked out"
            return message, "git submodule update --init", False
        if entry.is_symlink() and (os.readlink(entry.path).endswith(_OF_CATKIN) or _leads_into_nothing(entry.path)):
            return None
        return _broken_link(entry.path) if entry.is_symlink() else None
    if error.errno == errno.ELOOP:
        return "is a symbolic link that leads back to itself", None, False
    return f"cannot be read: {error.strerror}", None, False
