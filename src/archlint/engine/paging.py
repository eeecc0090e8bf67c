"""All that the HTML page shows: the system of all nodes, those of the launch files, and what is found in them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.launch_notices import argument_notices
from archlint.engine.drawing import faults_of
from archlint.engine.drawn import Drawn
from archlint.engine.findings import judged_in_parts
from archlint.engine.loading import as_asked_for, combined
from archlint.observed.words import comparison_notices, comparison_words
from archlint.render.page.document import page_text
from archlint.render.page.model import PageContents, PageSystem
from archlint.render.partial import part_of
from archlint.render.selection import NothingOfThatName
from archlint.syntax.python.deep_stack import call_with_deep_stack
from archlint.systems.implicit import with_implicit

if TYPE_CHECKING:
    from archlint.engine.inputs import Inputs
    from archlint.render.page.model import SourceLink
    from archlint.render.view import View
    from archlint.syntax.files import FactsOfFiles
    from archlint.systems.model import System

MOST = 60
"""Systems of launch files that one page has; each of them is laid out and makes the file larger."""


def page(inputs: Inputs, facts: FactsOfFiles, view: View, link: SourceLink | None) -> Drawn:
    """Raises :class:`archlint.engine.request.NothingToDo` and :class:`archlint.render.selection.NothingOfThatName`."""
    loaded: list[list[System]] = []
    judged = call_with_deep_stack(lambda: judged_in_parts(inputs, facts, loaded=loaded))
    first, *others = _systems(inputs, loaded)
    distro = inputs.request.settings.distro
    shown = [_seen(first, view, distro), *_where_there(others, view, distro)]
    compared = first.system.compared
    return Drawn(
        page_text(PageContents(shown, judged.findings, link, view.group, view.collapse)),
        b"",
        [*argument_notices(first.system)],
        [*comparison_words(compared)],
        [*comparison_notices(compared)],
        faults_of(first.system),
    )


def _seen(shown: PageSystem, view: View, distro: str | None) -> PageSystem:
    """What a view leaves of a system.  Raises :class:`archlint.render.selection.NothingOfThatName`."""
    system = with_implicit(shown.system, distro) if view.everything else shown.system
    return replace(shown, system=part_of(system, view) if view.selects else system)


def _where_there(systems: list[PageSystem], view: View, distro: str | None) -> Iterator[PageSystem]:
    for shown in systems:
        try:
            yield _seen(shown, view, distro)
        except NothingOfThatName:  # another launch file may start it
            continue


def _systems(inputs: Inputs, loaded: list[list[System]]) -> Iterator[PageSystem]:
    """The system that other formats show, then those of launch files, each with the arguments that decide it."""
    request, workspace = inputs.request, inputs.workspace
    opened = combined([as_asked_for(request, systems[0], workspace) for systems in loaded])
    yield PageSystem(replace(opened, alternatives=()))
    launched = sorted(
        (system for systems in loaded for system in systems if system.name is not None),
        key=lambda system: system.name or "",
    )
    alternatives = [other for system in launched for other in _alternatives(system, system.name == opened.name)]
    yield from alternatives[:MOST]


def _alternatives(system: System, is_shown: bool) -> Iterator[PageSystem]:
    if not is_shown:
        yield PageSystem(system)
    decided = system.defaults_decide  # the first alternative is the system itself
    yield from (PageSystem(other, arguments) for arguments, other in system.alternatives[1 if decided else 0 :])


__all__ = ["page"]
