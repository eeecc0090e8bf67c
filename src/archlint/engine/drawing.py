"""Drawing a system, with what there is to say of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.checks.launch_notices import argument_notices
from archlint.engine.drawn import Drawn
from archlint.observed.words import comparison_notices, comparison_words
from archlint.render import FORMATS, FormatName, render

if TYPE_CHECKING:
    from collections.abc import Sequence

    from archlint.finding import Finding
    from archlint.render.view import View
    from archlint.systems.model import System


def drawn(system: System, format: FormatName, color: bool, view: View, findings: Sequence[Finding]) -> Drawn:
    """Raises :class:`archlint.render.errors.CannotDraw` and :class:`archlint.render.selection.NothingOfThatName`."""
    output = render(format, system, color, view, findings)
    data, text = (output, "") if isinstance(output, bytes) else (b"", output)
    compared = None if FORMATS[format].says_differences else system.compared
    return Drawn(
        text,
        data,
        [*argument_notices(system)],
        [*comparison_words(compared)],
        [*comparison_notices(compared)],
        faults_of(system),
    )


def faults_of(system: System) -> list[str]:
    """Where archlint itself failed while it read what the system is made of."""
    faults = system.workspace.faults.by_place() if system.workspace is not None else []
    return [
        f"{fault.place.file}:{fault.place.line}:{fault.place.column}: {fault.what} failed with {fault.message}"
        for fault in faults
    ]


__all__ = ["drawn", "faults_of"]
