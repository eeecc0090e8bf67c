"""What starts a program: an executable of a package."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.interpreter.modules import Module
    from archlint.workspace.model import SourceFile


@dataclass(frozen=True)
class EntryPoint:
    """An executable of a package: ``module:function``, or a script (``function`` is None)."""

    executable: str
    package: str | None
    module: str
    function: str | None
    file: SourceFile | None = None
    others: tuple[SourceFile, ...] = ()
    """The sources of C++ that the executable is built of, besides ``file``."""


Entry: TypeAlias = "tuple[EntryPoint, Module]"
"""An entry point, and the module that it starts."""


__all__ = ["Entry", "EntryPoint"]
