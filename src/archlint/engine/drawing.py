"""Drawing a system, with what there is to say of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.checks.launch_notices import argument_notices
from archlint.engine.drawn import Drawn
from archlint.observed.words import comparison_notices, comparison_words
from archlint.render import FORMATS, FormatName, render

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

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
        [*argument_notices(system), *_group_notices(system, view)],
        [*comparison_words(compared)],
        [*comparison_notices(compared)],
        faults_of(system),
    )


def _group_notices(system: System, view: View) -> Iterator[str]:
    """Why there are no frames though they were asked for."""
    if view.group == "launch" and system.nodes and not any(node.launched_by for node in system.nodes):
        yield "--group launch draws no frame: only with --launch FILE is it known which launch file starts a node"
    if (
        view.group == "namespace"
        and system.nodes
        and not any((node.name or "").rpartition("/")[0] for node in system.nodes)
    ):
        yield "--group namespace draws no frame: no node is in a namespace"


def faults_of(system: System) -> list[str]:
    """Where archlint itself failed while it read what the system is made of."""
    faults = system.workspace.faults.by_place() if system.workspace is not None else []
    return [
        f"{fault.place.file}:{fault.place.line}:{fault.place.column}: {fault.what} failed with {fault.message}"
        for fault in faults
    ]


__all__ = ["drawn", "faults_of"]
