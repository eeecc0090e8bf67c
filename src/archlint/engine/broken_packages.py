"""Packages of Python whose ``__init__.py`` does not compile: Python runs it before any module in them."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile


def broken_packages(files: Sequence[SourceFile], facts: FactsOfFiles) -> Iterator[SourceFile]:
    """The ``__init__.py`` that nobody has read and that do not compile, of packages from which something is imported.

    ``import motors.left`` leads to ``motors/left.py``, and ends at the first mistake of ``motors/__init__.py``.
    """
    read = [file for file in files if facts.was_read(file) and not facts.is_ros1(file)]
    unread = {file.path: file for file in files if _is_init(file) and not facts.was_read(file)}
    inside: dict[str, list[SourceFile]] = {}
    for module in read:
        for path in _packages_around(module):
            if path in unread:
                inside.setdefault(path, []).append(module)
    for path in sorted(inside):
        understood = facts.facts_of(unread[path])
        is_broken = understood is not None and bool(understood.problems) and not facts.is_ros1(unread[path])
        if is_broken and _is_imported(inside[path], read, facts):
            yield unread[path]


def _is_init(file: SourceFile) -> bool:
    return os.path.basename(file.path) == "__init__.py"


def _packages_around(module: SourceFile) -> Iterator[str]:
    """Where the ``__init__.py`` of the packages are that Python goes through to a module, by its dotted name."""
    folder = os.path.dirname(module.path)
    for _ in range((module.module or "").count(".") + 1):
        yield os.path.join(folder, "__init__.py")
        folder = os.path.dirname(folder)


def _is_imported(modules: Iterable[SourceFile], files: Sequence[SourceFile], facts: FactsOfFiles) -> bool:
    importers = [file for file in files if not file.context]
    return any(facts.imports_of(file, module) for module in modules for file in importers if file is not module)


__all__ = ["broken_packages"]
