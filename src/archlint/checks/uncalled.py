"""What is said of mistakes in methods that nothing calls: they fail only once somebody does."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.left_over import is_named_nowhere
from archlint.analysis.uncalled_methods import uncalled_method
from archlint.finding import Severity

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.systems.model import System


def mild_if_uncalled(system: System, diagnostic: Finding) -> Finding:
    """The same finding; as information where the file is a program and nothing calls that method, or only such methods
    do, with the advice to delete one that nothing calls.  What a library offers is for others to call."""
    name = uncalled_in_program(system, diagnostic.place)
    if name is None or system.workspace is None:
        return diagnostic
    mild = replace(diagnostic, severity=Severity.INFO)
    if not is_named_nowhere(system.workspace, diagnostic.place.file, name):
        return mild  # whoever deletes it breaks its callers
    return replace(mild, help=f"delete {name}(), which nothing calls")


def uncalled_in_program(system: System, place: Place) -> str | None:
    """The name of the method of a program that holds a place, where nothing calls it but methods of that kind."""
    is_program = any(program.executable and program.file == place.file for program in system.programs)
    return uncalled_method(system.workspace, place) if is_program else None


__all__ = ["mild_if_uncalled", "uncalled_in_program"]
