"""From a workspace on the disk to shards, one for each package and one for what lies in none."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.analysis.pinned import BUILT_FILES, PINNING_FILES, PINNING_FOLDERS
from archlint.disk import read_regular, walk
from archlint.engine.facts_file import CodeRow, FileRow, ProblemRow, Shard
from archlint.engine.facts_folder import FactsError
from archlint.records import dataclass
from archlint.workspace.around import is_below
from archlint.workspace.model import COMPILED_KINDS
from archlint.workspace.pruning import is_pruned_by_content, is_pruned_by_name
from archlint.workspace.snapshot import TOO_LARGE, Entry
from archlint.workspace.tree import TEXT_LIMIT, decoded

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile, Workspace

OTHER_BYTES = 1_000_000
"""Of a larger file that archlint does not read as a rule only the name is written down."""
_BULK = (".dae", ".stl", ".obj", ".ply", ".pcd", ".csv", ".svg", ".ipynb")
"""Of these, too: meshes, clouds, measurements, pictures."""


def shards_of(
    workspace: Workspace, facts: FactsOfFiles, paths: Sequence[str], base: Path, prefix: str = "", whole: bool = False
) -> dict[str, Shard]:
    """The shards of what ``paths`` lead to, or of the ``whole`` workspace, by the folders that they are about.

    Paths become relative to ``base``, below ``prefix``.  Raises :class:`FactsError` for what does not lie there.
    """
    asked = [file for file in workspace.files if whole or not file.context]
    owners = _Owners(workspace, base)
    packages = {owner for file in asked if (owner := owners.of(file.path)) != ""}
    files = [file for file in workspace.files if whole or not file.context or owners.of(file.path) in packages]
    collecting = _Collecting(base, Path(workspace.root), {file.path for file in files})
    collecting.add_pinning()  # first: of what a build left behind only names are written down otherwise
    asked_folders = [os.path.abspath(path) for path in paths if os.path.isdir(path)]
    for folder in (*asked_folders, *sorted(os.path.join(base, package) for package in packages)):
        collecting.add_folder(folder)
    for path in (*(file.path for file in files), *(link.path for file in files for link in file.links)):
        collecting.add(path)
    naming = _Naming(base, prefix)
    shards: dict[str, Shard] = {}
    encoded = _encoded(files, facts)

    def shard(path: str) -> Shard:
        owner = owners.of(path)
        about = naming.of(os.path.join(base, owner)) if owner else naming.of(str(base))
        return shards.setdefault(about if owner else "", Shard([], {}, {}, [], [], []))

    for file in files:
        links = sorted({naming.of(link.path) for link in file.links if link.path != file.path})
        row = FileRow(naming.of(file.path), file.kind, file.size, file.context, links)
        shard(file.path).files.append(row)
        if file.path in encoded:
            shard(file.path).code[row.path] = encoded[file.path]
    for path, entry in sorted(collecting.collected().items()):
        shard(path).entries[naming.of(path)] = naming.entry(entry)
    for path in sorted(collecting.empty):
        shard(os.path.join(path, "")).folders.append(naming.of(path))
    for folder in asked_folders:
        shard(os.path.join(folder, "")).complete.append(naming.of(folder))
    read = {file.relative for file in workspace.files}
    for problem in workspace.problems:
        if problem.file not in read:  # those of manifests are found again
            path = os.path.join(base, problem.file)
            row_of_problem = ProblemRow(naming.of(path), problem.line, problem.column, problem.message, problem.help)
            shard(path).problems.append(row_of_problem)
    return shards


def _encoded(files: Iterable[SourceFile], facts: FactsOfFiles) -> dict[str, CodeRow]:
    compiled = [file for file in files if file.kind in COMPILED_KINDS]
    rows = zip(compiled, facts.encoded(compiled), strict=True)
    return {file.path: CodeRow(screened, payload) for file, (screened, payload) in rows}


class _Owners:
    """Which package's folder, relative to ``base``, a path lies in; empty for none."""

    def __init__(self, workspace: Workspace, base: Path) -> None:
        self._roots = {package.root: os.path.relpath(package.root, base) for package in workspace.packages}

    def of(self, path: str) -> str:
        folder = os.path.dirname(path)
        while folder not in self._roots:
            if folder == os.path.dirname(folder):
                return ""
            folder = os.path.dirname(folder)
        return self._roots[folder]


@dataclass(frozen=True)
class _Naming:
    """What paths are called in shards."""

    base: Path
    prefix: str

    def of(self, path: str) -> str:
        below = os.path.relpath(path, self.base).replace(os.sep, "/")
        if below == ".." or below.startswith("../"):
            raise FactsError(f"{path} is outside of the working directory: give the facts from a folder around it")
        return below if not self.prefix else self.prefix if below == "." else f"{self.prefix}/{below}"

    def entry(self, entry: Entry) -> Entry:
        if not entry.link:
            return entry
        end = "/" if entry.leads_to_folder else ""
        return Entry(link=self.of(entry.link) + end)


@dataclass
class _Collecting:
    """Writes down what lies in folders."""

    base: Path
    root: Path
    """Nothing outside of it, and of ``base``, is looked at."""
    read: set[str]
    """The files that archlint reads, whatever they are."""
    entries: dict[str, Entry] = field(default_factory=dict)
    empty: set[str] = field(default_factory=set)
    _done: set[str] = field(default_factory=set)
    _inside: dict[str, bool] = field(default_factory=dict)

    def collected(self) -> dict[str, Entry]:
        """What lies there; a link through which files are read counts as the folder that it leads to."""
        folders = {folder for path in self.read for folder in map(str, Path(path).parents)}
        return {path: entry for path, entry in self.entries.items() if path not in folders}

    def add_folder(self, top: str) -> None:
        bare: set[str] = set()
        """Folders of which only the names are written down."""
        for folder, folders, names in walk(top):
            folders[:] = sorted(name for name in folders if not name.startswith((".", "__pycache__")))
            if folder in self._done:
                continue
            self._done.add(folder)
            links = [name for name in folders if os.path.islink(os.path.join(folder, name))]
            siblings = frozenset((*folders, *names))
            for name in folders:
                path = os.path.join(folder, name)
                if folder in bare or is_pruned_by_name(name) or is_pruned_by_content(name, _names(path), siblings):
                    bare.add(path)
            for name in sorted((*names, *links)):
                self.add(os.path.join(folder, name), folder in bare)
            if not names and not folders:
                self.empty.add(folder)

    def add_pinning(self) -> None:
        """The files at the top of the workspace that say which distribution it is for."""
        for name in PINNING_FOLDERS:
            folder = self.base / name
            if folder.is_dir() and self._is_inside(str(folder)):
                self.add_folder(str(folder))
        for name in (*PINNING_FILES, *BUILT_FILES):
            if os.path.isfile(self.base / name):
                self.add(str(self.base / name))

    def add(self, path: str, is_bare: bool = False) -> None:
        if path in self.entries or not (path in self.read or self._is_inside(path)):
            return
        is_link = os.path.islink(path) and path not in self.read
        entry = self._link(path) if is_link else self._file(path, is_bare)
        if entry is not None:
            self.entries[path] = entry

    def _is_inside(self, path: str) -> bool:
        folder = os.path.dirname(path)
        if folder not in self._inside:
            real = os.path.realpath(folder)
            self._inside[folder] = all(is_below(real, os.path.realpath(around)) for around in (self.base, self.root))
        return self._inside[folder]

    def _link(self, path: str) -> Entry | None:
        """A link; None for one that leads to a folder elsewhere."""
        real = os.path.realpath(path)
        base = os.path.realpath(self.base)
        is_folder = os.path.isdir(path)
        if not os.path.exists(path) or not is_below(real, base) or not is_below(real, os.path.realpath(self.root)):
            return None if is_folder else Entry(link="")
        return Entry(link=str(self.base / os.path.relpath(real, base)) + "/" * is_folder)

    def _file(self, path: str, is_bare: bool) -> Entry:
        if not os.path.isfile(path):
            return Entry(link="")
        if path not in self.read and (is_bare or path.lower().endswith(_BULK) or _is_private(path)):
            return Entry()
        try:
            data = read_regular(path, TEXT_LIMIT if path in self.read else OTHER_BYTES)
        except OSError as error:
            is_too_large = error.errno == errno.EFBIG
            return Entry() if is_too_large and path not in self.read else Entry(errno=error.errno or TOO_LARGE)
        return Entry(data if path in self.read else _text_of(data))


def _text_of(data: bytes) -> bytes:
    """The bytes of a text; of anything else those up to the first that is in none."""
    try:
        decoded(data)
    except UnicodeDecodeError as error:
        return data[: error.start + 1]
    return data


def _is_private(path: str) -> bool:
    """Whether a file may hold what is nobody else's business, such as ``.env``."""
    name = os.path.basename(path)
    return name.startswith(".") and name not in PINNING_FILES


def _names(folder: str) -> frozenset[str]:
    try:
        return frozenset(os.listdir(folder))
    except OSError:
        return frozenset()


__all__ = ["shards_of"]
