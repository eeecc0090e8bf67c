"""What is followed: an executable, a script, a module by itself, a class or a function that nothing runs."""

from __future__ import annotations

from typing import ClassVar

from archlint.records import dataclass


@dataclass(frozen=True)
class ProgramKey:
    """Identifies a program in a workspace.  ``file`` is the shown path of the module that it starts in."""

    verb: ClassVar[str] = ""
    """What is said in front of the program's name."""

    file: str

    @property
    def text(self) -> str:
        """By which the program is kept from one run to the next: the same in each of them."""
        return repr(self)


@dataclass(frozen=True)
class EntryKey(ProgramKey):
    """An executable, with what it is started with."""

    package: str | None
    executable: str
    function: str | None
    """What of the module is called; None for a script."""
    overrides: tuple[object, ...] | None
    """Parameters and names from outside, as in :attr:`archlint.model.Overrides.key`; None without any."""
    words: tuple[str | None, ...] | None
    """Its command line, None for words that are not known; None as a whole where nothing is known of it."""
    others: tuple[str, ...] = ()
    """The shown paths of the other sources of C++ that it is built of."""


@dataclass(frozen=True)
class ScriptKey(ProgramKey):
    """A file that is run as ``python file``."""


@dataclass(frozen=True)
class ModuleKey(ProgramKey):
    """The import of a module."""

    verb: ClassVar[str] = "import "


@dataclass(frozen=True)
class DefinitionKey(ProgramKey):
    """A class or function, by the variable of the module that holds it, that no other program runs."""

    variable: str


@dataclass(frozen=True)
class LaunchKey(ProgramKey):
    """A launch of a file, with its arguments in the order in which they are given."""

    arguments: tuple[tuple[str, str], ...]


__all__ = ["DefinitionKey", "EntryKey", "LaunchKey", "ModuleKey", "ProgramKey", "ScriptKey"]
