"""The programs and launches of a workspace, kept from one run to the next."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Mapping
from dataclasses import astuple, fields, is_dataclass
from typing import TYPE_CHECKING

from archlint.engine.own_code import own_code
from archlint.programs.kept import KeptPrograms
from archlint.programs.kept_launches import KeptLaunches
from archlint.programs.kept_table import InMemory, Table, write
from archlint.records import dataclass
from archlint.workspace.test_code import FileRoles

if TYPE_CHECKING:
    from archlint.interpreter.modules import ModuleIndex
    from archlint.programs.earlier_imports import ImportNow
    from archlint.programs.kept_table import Known
    from archlint.syntax.cache import NullStore, Store
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.installed import Installs
    from archlint.workspace.model import SourceFile, Workspace
    from archlint.workspace.tree import SourceTree

ResultsInMemory = dict[str, InMemory]
"""What the runs of one process have followed, by the key under which it would be stored."""

_MAKES_INTERFACES = "rosidl_generate_interfaces"


@dataclass
class ProgramCache:
    """Opens and saves what is known of the programs of one workspace."""

    store: Store | NullStore
    workspace: Workspace
    facts: FactsOfFiles
    tree: SourceTree
    code: list[tuple[str, int, int]] | None = None
    """That of the archlint that asks (:func:`own_code`), where another process follows the programs."""
    memory: ResultsInMemory | None = None

    def __post_init__(self) -> None:
        self._by_path = {file.path: file for file in self.workspace.files}
        self._roles = FileRoles.of(file.relative for file in self.workspace.files)
        name = [str(self.tree.base), self.workspace.root, self.workspace.complete_folders]
        self._key = hashlib.sha256(repr(name).encode()).hexdigest()
        self._opened: dict[str, KeptPrograms | KeptLaunches] = {}
        """By the keys under which they are stored."""
        self.lasts = self.store.lasts

    def open(
        self,
        index: ModuleIndex,
        import_now: ImportNow,
        words: Mapping[str, Collection[str]],
        *generated: object,
    ) -> KeptPrograms:
        """What is known so far.  ``words`` are those of each package's CMakeLists.txt, ``generated`` what is known
        beside of the interfaces that packages make."""
        making = {
            name: sorted(package_words)
            for name, package_words in sorted(words.items())
            if _MAKES_INTERFACES in package_words
        }
        surroundings = _digest([self.code or own_code(), making, generated, self._interfaces()])
        known, shares = self._known(self._key, surroundings), self.memory is not None
        kept = KeptPrograms(index, self._fingerprint, surroundings, import_now, known, lasts=self.lasts, shares=shares)
        self._opened[self._key] = kept
        return kept

    def open_launches(
        self,
        index: ModuleIndex,
        import_now: ImportNow,
        installs: Mapping[str, Installs],
        *beside: object,
    ) -> KeptLaunches:
        """What is known of launches.  They depend on which files there are and on what is installed of them, and on
        what is given ``beside``."""
        installed = [_plain(install) for _, install in sorted(installs.items())]
        surroundings = _digest([self.code or own_code(), index.importable.digest, installed, beside])
        key = f"launches-{self._key}"
        known, shares = self._known(key, surroundings), self.memory is not None
        kept = KeptLaunches(
            index, self._fingerprint, surroundings, import_now, known, self.tree.ask, self.lasts, shares
        )
        self._opened[key] = kept
        return kept

    def _known(self, key: str, surroundings: str) -> Known:
        known = None if self.memory is None else self.memory.get(key)
        if known is not None and known.surroundings == surroundings:
            return known
        return Table(self.store.get_programs(key), surroundings)

    def save(self) -> None:
        """Keep what is known now for the next run."""
        for key, kept in self._opened.items():
            self.facts.note_read(kept.read_by())
            is_news = kept.changed and self.facts.lasting
            if not self.lasts or not (is_news or (self.memory is not None and key not in self.memory)):
                continue
            known = kept.all_known()
            if self.memory is not None:
                self.memory[key] = known
            if is_news and self.store.takes_programs:
                self.store.put_programs(key, write(known))

    def _interfaces(self) -> list[tuple[str, str | None, str | None]]:
        files = (file for file in self.workspace.files if file.kind == "interface")
        return [(file.relative, file.package, self.tree.text(file.relative)) for file in files]

    def _fingerprint(self, path: str) -> str | None:
        file = self._by_path.get(path)
        digest = None if file is None else self.facts.meaning(file)
        return None if file is None or digest is None else self._print(file, digest)

    def _print(self, file: SourceFile, digest: str) -> str:
        links = [astuple(link) for link in file.links]
        decisive: list[object] = [digest, file.relative, file.kind, file.package, file.module, links]
        decisive.append(self._roles.is_test(file.relative))
        return hashlib.sha256(repr(decisive).encode()).hexdigest()[:24]


def _digest(decisive: object) -> str:
    return hashlib.sha256(repr(decisive).encode()).hexdigest()


def _plain(value: object) -> object:
    """What is known of what a package installs, or a part of it, in an order that is the same in every process: sets
    have another one in each."""
    match value:
        case frozenset():
            return sorted(value)
        case list() | tuple():
            return [_plain(item) for item in value]
        case dict():
            return [(key, _plain(item)) for key, item in value.items()]
    if not is_dataclass(value):
        return value
    return [type(value).__name__, *(_plain(getattr(value, row.name)) for row in fields(value))]


__all__ = ["ProgramCache", "ResultsInMemory"]
