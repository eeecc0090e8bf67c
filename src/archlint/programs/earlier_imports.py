"""Modules that were imported by what is known from an earlier run: they run once somebody needs them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module, ModuleIndex


ImportNow = Callable[[Iterable[str]], None]
"""Imports the modules with these paths, as far as that is known and has not been done."""


class KnowsImports(Protocol):
    """Which modules were imported by what is known."""

    def first_of(self, path: str) -> str | None: ...

    def all_first(self) -> list[str]: ...


class EarlierImports:
    """Imports modules of an index as the program would have that is not followed again; ``import_module`` does it."""

    def __init__(self, index: ModuleIndex, import_module: Callable[[Module], object]) -> None:
        self._index = index
        self._import_module = import_module
        self._kept: KnowsImports | None = None

    def of(self, kept: KnowsImports) -> None:
        """From now on, import what ``kept`` says."""
        self._kept = kept
        self._index.import_earlier = self.before
        self._index.import_all_earlier = lambda: self.now(kept.all_first())

    def before(self, module: Module) -> None:
        """Import a module if its import is known and did not run."""
        self.now([module.file.path])

    def now(self, paths: Iterable[str]) -> None:
        """Import the modules with these paths."""
        for path in paths:
            first = None if self._kept is None else self._kept.first_of(path)
            if first is not None:
                self._import_aside(first)

    def _import_aside(self, path: str) -> None:
        """What the import does beside filling the module is known."""
        file = self._index.importable.at(path)
        module = None if file is None else self._index.module(file)
        if module is not None:
            with self._index.aside():
                self._import_module(module)


__all__ = ["EarlierImports", "ImportNow"]
