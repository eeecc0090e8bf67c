"""Path resolution: which file of the workspace a path in a launch file means, and whether it is installed."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from archlint.interpreter.values import Known, Unknown, Value, reason
from archlint.launch.kinds import FileKind, FileStatus
from archlint.launch.named_files import FileReference

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.workspace.installed import Installs
    from archlint.workspace.owners import FileOwners
    from archlint.workspace.tree import Tree

_SHARE = re.compile(r"^\$\(find-pkg-share ([\w.-]+)\)(.*)$", re.DOTALL)
_SHARE_IN_PREFIX = re.compile(r"^\$\(find-pkg-prefix ([\w.-]+)\)/share/\1(?=/|$)")
_TO_WORKSPACE = "../../"
"""The way from the prefix of a package to the workspace.  Source: colcon-core installs each package to ``install/NAME``
unless it is told ``--merge-install``."""


class LaunchPaths:
    """Paths as launch files have them, which run from where they are installed."""

    def __init__(self, installs: Mapping[str, Installs], tree: Tree, owners: FileOwners) -> None:
        self._installs = installs
        self._tree = tree
        self._owners = owners

    def has(self, package: str) -> bool:
        """Whether a package is one of the workspace."""
        return package in self._installs

    def text(self, reference: FileReference) -> str | None:
        """The text of a file that a launch file names; None for one that is not here."""
        return None if reference.source is None else self._tree.text(reference.source)

    def resolve(
        self,
        kind: FileKind,
        path: Value,
        place: Place,
        launch_file: str,
        asked: frozenset[str] | set[str],
        conditional: bool,
    ) -> FileReference:
        """What ``launch_file`` means by a path; ``asked`` are the paths of which its code asks if they are there."""
        match path:
            case Known(value=value, origin=origin) if str(value):
                written = str(value)
            case _:
                return FileReference(kind, None, None, FileStatus.UNKNOWN, None, place, reason(path), conditional)
        shared = _SHARE.match(_SHARE_IN_PREFIX.sub(r"$(find-pkg-share \1)", written))
        if shared is not None:
            package, rest = shared[1], posixpath.normpath(shared[2].lstrip("/") or ".")
            source, status = self._in_package(package, rest)
        elif written.startswith("$(workspace)/"):
            package = self._owners.package_of(launch_file)
            source, status = self._beside(written.removeprefix("$(workspace)/"), package, launch_file)
        else:
            return FileReference(
                kind, written, None, FileStatus.EXTERNAL, None, place, "a path of the machine", conditional, origin
            )
        optional = conditional and posixpath.normpath(written) in asked
        return FileReference(kind, written, source, status, package, place, None, conditional, origin, optional)

    def _in_package(self, package: str, rest: str) -> tuple[str | None, FileStatus]:
        installs = self._installs.get(package)
        if installs is None:
            return None, FileStatus.EXTERNAL
        if rest == ".":  # every build makes the share folder, whatever else it installs
            return installs.folder, FileStatus.INSTALLED
        below_prefix = posixpath.normpath(f"share/{package}/{rest}")
        if below_prefix.startswith(_TO_WORKSPACE):
            return self._in_workspace(below_prefix.removeprefix(_TO_WORKSPACE), installs)
        for source in installs.source_of(f"share/{package}/{rest}"):
            if self._tree.is_file(source) or self._tree.is_folder(source):
                return source, FileStatus.INSTALLED
        direct = posixpath.normpath(posixpath.join(installs.folder, rest))
        if self._tree.is_file(direct) or self._tree.is_folder(direct):
            return (
                direct,
                FileStatus.INSTALLED if installs.open_files or not installs.build_files else FileStatus.NOT_INSTALLED,
            )
        # Another command of CMake may make it: xacro_add_files() makes urdf/robot.urdf of urdf/robot.urdf.xacro.
        may_be_made = installs.open_files or not installs.build_files or installs.may_install(rest)
        return None, FileStatus.UNKNOWN if may_be_made else FileStatus.MISSING

    def _in_workspace(self, path: str, installs: Installs) -> tuple[str | None, FileStatus]:
        """A path from the workspace on.  Only a file that is there can tell which of the folders above the package that
        is: it may lie outside of the repository."""
        folder = installs.folder
        while folder not in (".", "", "/"):
            folder = posixpath.dirname(folder)
            source = posixpath.normpath(posixpath.join(folder, path))
            if self._tree.is_file(source):
                return source, FileStatus.INSTALLED
        return None, FileStatus.UNKNOWN

    def _beside(self, source: str, package: str | None, launch_file: str) -> tuple[str | None, FileStatus]:
        """A path that starts at the launch file itself."""
        source = posixpath.normpath(source)
        if self._tree.is_file(source):
            return source, FileStatus.INSTALLED
        installs = self._installs.get(package or "")
        if installs is None:
            return None, FileStatus.UNKNOWN
        # The launch file runs from where it is installed: the same way from there.
        relative = posixpath.relpath(source, posixpath.dirname(launch_file) or ".")
        for place in (*installs.places_of(launch_file), self._beside_manifest(launch_file, installs)):
            path, status = self._from_prefix(
                posixpath.normpath(posixpath.join(posixpath.dirname(place), relative)), installs
            )
            if path is not None:
                return path, status
        return None, FileStatus.UNKNOWN if installs.open_files else FileStatus.MISSING

    @staticmethod
    def _beside_manifest(path: str, installs: Installs) -> str:
        """A file as if the folders of its package were installed as they are."""
        own = path if installs.folder == "." else path[len(installs.folder) + 1 :]
        return f"share/{installs.package}/{own}"

    def _from_prefix(self, path: str, installs: Installs) -> tuple[str | None, FileStatus]:
        """What is at a path from the prefix of a package on."""
        if path.startswith(_TO_WORKSPACE):
            return self._in_workspace(path.removeprefix(_TO_WORKSPACE), installs)
        share, _, below = path.partition("/")
        package, _, rest = below.partition("/")
        return self._in_package(package, rest or ".") if share == "share" and package else (None, FileStatus.MISSING)

    def names_in(self, package: str, folder: str) -> list[str] | None:
        """The names of the files that a package installs in a folder of its share, sorted; None where that is not
        known."""
        below = self._below(package, folder)
        return None if below is None else sorted(path for path in below if "/" not in path)

    def entries_in(self, folder: str) -> list[str] | None:
        """The names of all that is installed in the folder of a path, sorted; None where that is not known."""
        shared = _SHARE.match(folder)
        below = None if shared is None else self._below(shared[1], posixpath.normpath(shared[2].lstrip("/") or "."))
        return None if not below else sorted({path.partition("/")[0] for path in below})

    def _below(self, package: str, folder: str) -> set[str] | None:
        """The paths of the files that are installed below a folder of a package's share."""
        installs = self._installs.get(package)
        if installs is None or installs.open_files or not installs.build_files:
            return None
        there = f"share/{package}/" if folder == "." else f"share/{package}/{folder}/"
        places = (place for path in self._tree.files_below(installs.folder) for place in installs.places_of(path))
        return {place.removeprefix(there) for place in places if place.startswith(there)}

    def launch_file_named(self, package: str, name: str) -> Value:
        """The path of the launch file that ``ros2 launch`` finds: it walks the whole share folder of the package and
        goes by the name of the file alone; where two have it, it starts neither."""
        share = f"share/{package}/"
        installs = self._installs.get(package)
        if installs is None:
            return Known(f"$(find-pkg-share {package})/launch/{name}")
        sources = [path for path in self._tree.files_below(installs.folder) if posixpath.basename(path) == name]
        there = {place for path in sources for place in installs.places_of(path) if place.startswith(share)}
        if len(there) > 1:
            return Unknown(f"{package} installs several files {name}")
        if not there and len(sources) == 1:  # not installed, or in a way that is not known
            there = {share + posixpath.relpath(sources[0], installs.folder)}
        return Known(f"$(find-pkg-share {package})/" + (there.pop().removeprefix(share) if there else f"launch/{name}"))
