"""Which names a Python file binds at its top level, and which of them its star imports bring."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.bindings import given_by
from archlint.syntax.interfaces import INTERFACE_KINDS
from archlint.syntax.parts import Itself, everything_in, once_for, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MAKES_NAMES = frozenset({"__builtins__", "exec", "execfile", "globals", "locals", "vars"})
"""What code may bind any name with."""
_DEPTH = 8
"""How many star imports are followed."""


@dataclass(frozen=True)
class Starred:
    """The names that star imports bring; ``classes`` says that those of interfaces are among them that are not known,
    all of which begin with a capital letter."""

    names: frozenset[str] = frozenset()
    classes: bool = False

    def has(self, name: str) -> bool:
        """Whether a name may be among them."""
        return name in self.names or (self.classes and name[:1].isupper())


def may_make_names(code: facts.Facts) -> bool:
    """Whether a file may bind any name, with ``exec()`` say."""
    return bool(makers_of_names(code))


@once_for
def makers_of_names(code: facts.Facts) -> list[facts.Expr]:
    """Where a file uses what may bind any name."""
    return [] if _MAKES_NAMES.isdisjoint(code.names) else makers_in(code.body)


def makers_in(body: Sequence[facts.Base]) -> list[facts.Expr]:
    """The uses of what may bind any name: not of a method that is called like that, as ``exec()`` of Qt, nor
    ``vars(arguments)``, which looks at an object."""
    of_objects = {
        Itself[facts.Expr](call.func)
        for call in everything_in(body, facts.Call)
        if call.func.variable == "vars" and call.args
    }
    names = (name for name in everything_in(body, facts.Name) if name.id in _MAKES_NAMES)
    asked = (part for part in everything_in(body, facts.Attribute) if part.attr in _MAKES_NAMES)
    of_builtins = (part for part in asked if part.value.variable == "builtins")
    return [*(name for name in names if Itself[facts.Expr](name) not in of_objects), *of_builtins]


def starred(workspace: WorkspaceIndex, file: str, code: facts.Facts, depth: int = _DEPTH) -> Starred | None:
    """What the star imports of a file bring; None where that is not known."""
    names: set[str] = set()
    classes = False
    for statement in stars(code) if _has_stars(workspace, file) else ():
        imported = workspace.code.imported(file, statement.module, statement.level)
        path = workspace.code.path_of_import(file, statement.module, statement.level)
        if imported is None or path is None:
            package, _, kind = statement.module.rpartition(".")
            if statement.level or kind not in INTERFACE_KINDS:
                return None
            own = None if workspace.interfaces is None else workspace.interfaces.all_of_package(package, kind)
            names |= own or frozenset()
            classes |= own is None
            continue
        further = starred(workspace, path, imported, depth - 1) if depth > 0 else None
        if further is None:
            return None
        names |= further.names | (_own_names(workspace, path) or frozenset())
        classes |= further.classes
    return Starred(frozenset(names), classes)


def offers(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether a file may have a name at its top level; true where that cannot be told."""
    code = workspace.facts_at(file)
    own = _own_names(workspace, file)
    if code is None or own is None or may_make_names(code) or "__getattr__" in own:
        return True
    if any(not problem.partly for problem in code.problems):
        return True  # LNT002 says what keeps Python from reading it
    brought = starred(workspace, file, code)
    return brought is None or brought.has(name) or name in own


@once_for
def stars(code: facts.Facts) -> list[facts.ImportFrom]:
    """The star imports of a file."""
    imports = everything_in(code.body, facts.ImportFrom)
    return [statement for statement in imports if any(name == "*" for name, _ in statement.names)]


@once_for
def own_names(code: facts.Facts) -> frozenset[str]:
    """What a file binds at its top level, but for star imports; rather too much than too little."""
    declared = (name for part in everything_in(code.body, facts.Global) for name in part.names)
    return frozenset((*declared, *bound_in(code.body), *(code.exports or ())))


@kept_for_each_file
def _has_stars(code: facts.Facts) -> bool:
    return bool(stars(code))


@kept_for_each_file
def _own_names(code: facts.Facts) -> frozenset[str]:
    return own_names(code)


def bound_in(body: Sequence[facts.Base]) -> Iterator[str]:
    """The names that a body binds in its own scope."""
    for part in parts_of(body):
        if not isinstance(part, (facts.Generator, facts.Param)):
            yield from given_by(part)


__all__ = [
    "Starred",
    "bound_in",
    "makers_in",
    "makers_of_names",
    "may_make_names",
    "offers",
    "own_names",
    "starred",
    "stars",
]
