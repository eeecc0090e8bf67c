"""Finding packages and files below a path."""

from __future__ import annotations

import fnmatch
import os
import stat
from collections.abc import Iterator, Sequence
from dataclasses import replace

from archlint.workspace import ignore
from archlint.workspace.manifest import read_manifest
from archlint.workspace.model import Package, Problem, SourceFile, Workspace
from archlint.workspace.module_names import module_name

MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE")
SKIPPED = frozenset({"__pycache__", "node_modules", "venv", "site-packages", "__pypackages__"})
COLCON_OUTPUT = frozenset({"build", "install", "log"})

_INTERFACES = (".msg", ".srv", ".action")
_BY_NAME = {
    "package.xml": "package_xml",
    "setup.py": "setup_py",
    "setup.cfg": "setup_cfg",
    "pyproject.toml": "pyproject",
    "CMakeLists.txt": "cmake",
}


class PathNotFound(Exception):
    """A path that was asked for and does not exist."""

    def __init__(self, path: str) -> None:
        super().__init__(path)
        self.path = path


def find(paths: Sequence[str], *, exclude: Sequence[str] = (), working_directory: str | None = None) -> Workspace:
    """All packages and files below ``paths``.  Raises :class:`PathNotFound` for one that does not exist.

    Files named outright are always taken.  The rest of the package that a path lies in is found as context, so
    that imports resolve.
    """
    here = os.path.abspath(working_directory or os.getcwd())
    scan = _Scan(here, exclude)
    roots = []
    for path in paths or ["."]:
        full = os.path.normpath(os.path.join(here, path))
        if not os.path.lexists(full):
            raise PathNotFound(path)
        roots.append(full)
        if os.path.isdir(full):
            scan.folder(full)
        else:
            scan.named_file(full)
    for context in _context_roots(roots):
        scan.context = True
        scan.folder(context)
    return scan.finish(os.path.commonpath(roots) if len(roots) > 1 else roots[0])


def _context_roots(roots: Sequence[str]) -> list[str]:
    """The packages that the paths lie inside of."""
    found = []
    for root in roots:
        folder = root if os.path.isdir(root) else os.path.dirname(root)
        while folder != os.path.dirname(folder):
            if os.path.isfile(os.path.join(folder, "package.xml")):
                if folder != root:
                    found.append(folder)
                break
            if os.path.exists(os.path.join(folder, ".git")):
                break
            folder = os.path.dirname(folder)
    return sorted(set(found))


class _Scan:
    """One walk: a stack of folders, each visited once, whatever the links say."""

    def __init__(self, here: str, exclude: Sequence[str]) -> None:
        self.here = here
        self.exclude = tuple(exclude)
        self.folders: set[tuple[int, int]] = set()
        self.inodes: set[tuple[int, int]] = set()
        self.files: dict[str, SourceFile] = {}
        self.problems: list[Problem] = []
        self.context = False

    def relative(self, path: str) -> str:
        return os.path.relpath(path, self.here).replace(os.sep, "/")

    # ----------------------------------------------------------------------------------------- the walk

    def folder(self, root: str) -> None:
        stack: list[tuple[str, ignore.Ignore | None]] = [(root, ignore.above(root))]
        while stack:
            folder, rules = stack.pop()
            try:
                entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
            except OSError as error:
                self.problems.append(Problem(self.relative(folder), 1, 1, f"cannot list this folder: {error.strerror}"))
                continue
            names = {entry.name for entry in entries}
            if not names.isdisjoint(MARKERS) and folder != root:
                continue
            if self._seen_folder(folder):
                continue
            if ".gitignore" in names:
                rules = ignore.below(rules, folder, os.path.join(folder, ".gitignore"))
            for entry in entries:
                path = entry.path
                if self._is_folder(entry):
                    if not self._skips(entry.name, folder, names, path) and not self._ignored(rules, path, True):
                        stack.append((path, rules))
                else:
                    kind = self._kind(entry.name, path)
                    if kind is not None and not self._ignored(rules, path, False):
                        self._add(path, kind)

    def _seen_folder(self, folder: str) -> bool:
        try:
            status = os.stat(folder)
        except OSError:
            return True
        key = (status.st_dev, status.st_ino)
        if key in self.folders and not self.context:
            return True
        self.folders.add(key)
        return False

    @staticmethod
    def _is_folder(entry: os.DirEntry[str]) -> bool:
        try:
            # A link to a folder is not followed: what it points to is found where it is, or is not ours.
            return entry.is_dir(follow_symlinks=False)
        except OSError:
            return False

    def _skips(self, name: str, folder: str, siblings: set[str], path: str) -> bool:
        if name.startswith(".") or name in SKIPPED:
            return True
        if name.endswith(".egg-info"):
            return True
        if name in COLCON_OUTPUT and "package.xml" not in siblings:
            return _is_colcon_output(path, siblings)
        return False

    def _ignored(self, rules: ignore.Ignore | None, path: str, is_folder: bool) -> bool:
        if self.exclude and self._excluded(path):
            return True
        return rules is not None and rules.ignores(path, is_folder)

    def _excluded(self, path: str) -> bool:
        relative = self.relative(path)
        name = os.path.basename(path)
        return any(
            fnmatch.fnmatchcase(relative, pattern.rstrip("/"))
            or fnmatch.fnmatchcase(name, pattern.rstrip("/"))
            or fnmatch.fnmatchcase(relative, pattern.rstrip("/") + "/*")
            for pattern in self.exclude
        )

    # ------------------------------------------------------------------------------------------ the files

    def named_file(self, path: str) -> None:
        kind = self._kind(os.path.basename(path), path) or "python"
        self._add(path, kind)

    def _kind(self, name: str, path: str) -> str | None:
        """What a file is by its name; files without a suffix are looked into for a Python shebang."""
        if name in _BY_NAME:
            return _BY_NAME[name]
        if name.endswith(".py"):
            return "launch_python" if name.endswith("launch.py") else "python"
        if name.endswith((".launch", "launch.xml")):
            return "launch_xml"
        if name.endswith(("launch.yaml", "launch.yml")):
            return "launch_yaml"
        if name.endswith((".yaml", ".yml")):
            return "parameters"
        if name.endswith(".xml") and os.path.basename(os.path.dirname(path)) == "launch":
            return "launch_xml"
        if name.endswith(_INTERFACES):
            return "interface"
        if "." not in name and _has_python_shebang(path):
            return "python"
        return None

    def _add(self, path: str, kind: str) -> None:
        if path in self.files:
            return
        try:
            status = os.stat(path)
        except OSError as error:
            if kind in ("python", "launch_python"):
                self.problems.append(Problem(self.relative(path), 1, 1, f"cannot read this file: {error.strerror}"))
            return
        key = (status.st_dev, status.st_ino)
        if stat.S_ISREG(status.st_mode) and key in self.inodes and os.path.islink(path):
            return
        self.inodes.add(key)
        self.files[path] = SourceFile(
            path,
            self.relative(path),
            kind,
            None,
            None,
            status.st_size,
            status.st_mtime_ns,
            status.st_ino,
            self.context,
        )

    # ----------------------------------------------------------------------------------------- packages

    def finish(self, root: str) -> Workspace:
        packages = self._packages()
        by_root = {package.root: package for package in packages}
        files = []
        for path in sorted(self.files):
            file = self.files[path]
            package = _package_of(os.path.dirname(path), by_root)
            name = None if package is None else package.name
            module = None
            if file.kind in ("python", "launch_python", "setup_py"):
                module = module_name(path, package)
            files.append(replace(file, package=name, module=module))
        files.sort(key=lambda file: file.relative)
        problems = sorted(self.problems, key=lambda p: (p.file, p.line))
        return Workspace(root, tuple(files), tuple(packages), tuple(problems))

    def _packages(self) -> list[Package]:
        found: list[Package] = []
        for path, file in sorted(self.files.items()):
            if file.kind != "package_xml":
                continue
            folder = os.path.dirname(path)
            try:
                with open(path, "rb") as stream:
                    data = stream.read(1_000_000)
            except OSError as error:
                self.problems.append(Problem(file.relative, 1, 1, f"cannot read this file: {error.strerror}"))
                continue
            package = read_manifest(file, data, folder, self.relative(folder))
            if isinstance(package, Problem):
                self.problems.append(package)
            else:
                found.append(package)
        return sorted(found, key=lambda package: (package.name, package.relative))


def _package_of(folder: str, by_root: dict[str, Package]) -> Package | None:
    while True:
        if folder in by_root:
            return by_root[folder]
        parent = os.path.dirname(folder)
        if parent == folder:
            return None
        folder = parent


def _is_colcon_output(path: str, siblings: set[str]) -> bool:
    """Whether ``build``, ``install`` or ``log`` is colcon's: it says so, or lies beside ``src``."""
    if "src" in siblings or len(COLCON_OUTPUT & siblings) > 1:
        return True
    marks = ("COLCON_IGNORE", ".built_by", ".colcon_install_layout", "setup.bash", "local_setup.bash", "latest")
    return any(os.path.lexists(os.path.join(path, mark)) for mark in marks)


def _has_python_shebang(path: str) -> bool:
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except OSError:
        return False
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            return False
        start = os.read(descriptor, 128)
    except OSError:
        return False
    finally:
        os.close(descriptor)
    return start.startswith(b"#!") and b"python" in start.partition(b"\n")[0]


def python_files(workspace: Workspace) -> Iterator[SourceFile]:
    """The files that hold Python, launch files included."""
    return (file for file in workspace.files if file.kind in ("python", "launch_python", "setup_py"))
