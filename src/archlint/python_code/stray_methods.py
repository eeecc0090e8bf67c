"""Methods that stand outside of every class, where a lost indentation or a paste has left them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class StrayMethod:
    """A function of a module that calls ``super()`` without arguments: Python then has no class to look above."""

    name: str
    definition: Place
    call: Place

    def holds(self, place: Place) -> bool:
        """Whether a place is in it."""
        first, last = self.definition.line, self.definition.end_line
        return place.file == self.definition.file and first <= place.line <= last


@once
def stray_methods(workspace: WorkspaceIndex) -> tuple[StrayMethod, ...]:
    """Every such function in the files that were asked for.

    Source: CPython, ``super_init_without_args`` raises "RuntimeError: super(): __class__ cell not found".
    """
    return tuple(
        StrayMethod(function.name, Place(file.relative, *function.span), Place(file.relative, *call.span))
        for file, file_facts in workspace.code.judged()
        if file.kind == "python" and "super" in file_facts.names and not workspace.roles.is_test(file.relative)
        for function in file_facts.body
        if isinstance(function, facts.Function) and (call := _super_of(function)) is not None
    )


def _super_of(function: facts.Function) -> facts.Call | None:
    """The first ``super()`` in a function; None where there is a class or a function in it that may be meant."""
    parts = [*everything_in(function.body)]
    if any(isinstance(part, (facts.Class, facts.Function)) for part in parts):
        return None
    calls = (part for part in parts if isinstance(part, facts.Call) and not part.args)
    return next((call for call in calls if isinstance(call.func, facts.Name) and call.func.id == "super"), None)


__all__ = ["StrayMethod", "stray_methods"]
