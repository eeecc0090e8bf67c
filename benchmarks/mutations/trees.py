"""The packages of a checkout, and small workspaces made of copies of them."""

from __future__ import annotations

import os
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from .python_source import PythonSource

SKIPPED = {".git", "build", "install", "log", "node_modules", "__pycache__", ".archlint_cache"}
TEXTS = {
    ".py",
    ".xml",
    ".yaml",
    ".yml",
    ".launch",
    ".cfg",
    ".txt",
    ".msg",
    ".srv",
    ".action",
    ".toml",
    ".rviz",
    "",
}
LARGEST = 300_000
"""Larger files are copied empty, as are those of other kinds: that they are there is what counts."""
_QUOTED = re.compile(r"[\"'(/ ]([a-z][a-z0-9_]+)(?=[\"')/ ])")


@dataclass
class Package:
    """One package; ``files`` are paths relative to the checkout, with ``/``."""

    name: str
    folder: str
    root: Path
    files: list[str] = field(default_factory=list)
    needs: set[str] = field(default_factory=set)

    def text(self, file: str) -> bytes:
        return (self.root / file).read_bytes()

    @property
    def manifest(self) -> str:
        return f"{self.folder}/package.xml".lstrip("/")

    @cached_property
    def python(self) -> list[PythonSource]:
        """What can be parsed and is no test, no build and no launch file."""
        return [one for file in self.files if file.endswith(".py") and (one := self._parsed(file)) is not None]

    @property
    def code(self) -> list[PythonSource]:
        return [one for one in self.python if not one.is_launch and not one.file.endswith("setup.py")]

    @property
    def launch_python(self) -> list[PythonSource]:
        return [one for one in self.python if one.is_launch]

    @property
    def launch_xml(self) -> list[str]:
        return [f for f in self.files if "launch" in f and f.endswith((".xml", ".launch")) and f != self.manifest]

    def _parsed(self, file: str) -> PythonSource | None:
        parts = file.split("/")
        if any(part in ("test", "tests") for part in parts) or parts[-1].startswith(("test_", "conftest")):
            return None
        return PythonSource.of(file, self.text(file))


def packages(root: Path) -> dict[str, Package]:
    """The packages of a checkout by name; of two with one name the first counts."""
    found: dict[str, Package] = {}
    manifests: dict[str, Package] = {}
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(one for one in folders if one not in SKIPPED and not (Path(folder) / one).is_symlink())
        if "COLCON_IGNORE" in names:
            folders.clear()
            continue
        relative = Path(folder).relative_to(root).as_posix()
        relative = "" if relative == "." else relative
        owner = _read_manifest(root, relative) if "package.xml" in names else _owner(relative, manifests)
        if owner is None:
            continue
        if "package.xml" in names:
            found.setdefault(owner.name, owner)
            manifests[relative] = owner
        prefix = f"{relative}/" if relative else ""
        owner.files.extend(f"{prefix}{name}" for name in sorted(names) if (Path(folder) / name).is_file())
    for package in found.values():
        package.needs &= found.keys()
    return dict(sorted(found.items()))


def _owner(relative: str, manifests: dict[str, Package]) -> Package | None:
    folder = relative
    while folder not in manifests and folder:
        folder = folder.rpartition("/")[0]
    return manifests.get(folder)


def _read_manifest(root: Path, relative: str) -> Package | None:
    try:
        document = ElementTree.parse(root / relative / "package.xml").getroot()
    except (ElementTree.ParseError, OSError):
        return None
    name = (document.findtext("name") or "").strip()
    needs = {(one.text or "").strip() for one in document if one.tag.endswith("depend")}
    return Package(name, relative, root, needs=needs) if name else None


def closure(package: Package, every: dict[str, Package]) -> list[Package]:
    """A package with all that it needs of its checkout, be it that a launch file alone says so."""
    found: dict[str, Package] = {}
    waiting = [package]
    while waiting:
        one = waiting.pop()
        if one.name not in found:
            found[one.name] = one
            waiting.extend(every[name] for name in sorted(one.needs | set(_launched(one, every))))
    return sorted(found.values(), key=lambda one: one.name)


def _launched(package: Package, every: dict[str, Package]) -> Iterator[str]:
    for file in package.files:
        if "launch" in file and file.endswith((".py", ".xml", ".launch")):
            words = set(_QUOTED.findall(package.text(file).decode("utf-8", "replace")))
            yield from sorted(words & every.keys())


def copied(parts: list[Package], target: Path) -> None:
    """Write copies of packages below a folder, at the paths that they have in their checkout."""
    for package in parts:
        for file in package.files:
            source, to = package.root / file, target / file
            to.parent.mkdir(parents=True, exist_ok=True)
            whole = source.suffix in TEXTS and source.stat().st_size <= LARGEST
            to.write_bytes(source.read_bytes() if whole else b"")
