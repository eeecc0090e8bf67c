"""The systems that a command's options ask for: of all code, and of launch files."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.cli import console, exits
from archlint.cli.exits import UsageError
from archlint.cli.options import (
    add_configuration,
    add_facts,
    add_launch,
    add_paths,
    add_running,
    add_scheduler,
    add_talking,
    pool_of,
)
from archlint.cli.progress import Progress
from archlint.cli.requests import request_of
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.systems.model import System


@dataclass(frozen=True)
class AskedSystems:
    """The systems of a run, and what it has to say beside them."""

    systems: Sequence[System]
    settings: Settings
    progress: Progress

    @property
    def opened(self) -> list[System]:
        """Those of all code, one for each workspace; none where a launch file was named."""
        return [system for system in self.systems if system.name is None]

    @property
    def launched(self) -> list[System]:
        return [system for system in self.systems if system.name is not None]

    def end(self, status: int) -> int:
        """Say what there is to say at the end; returns the exit status, that of a failed run where a part is missing by
        a fault of archlint's."""
        from archlint.engine.drawing import faults_of  # a wrong option needs none of it

        self.progress.note_costs()
        faults = dict.fromkeys(fault for system in self.systems for fault in faults_of(system))
        return exits.FAILED if console.note_faults(faults) else status


def add_asking(parser: argparse.ArgumentParser) -> None:
    """The options that say what is read and how, but for the paths."""
    add_launch(parser)
    add_facts(parser)
    add_configuration(parser)
    add_running(parser)
    add_scheduler(parser)
    add_talking(parser)


def asked_systems(arguments: argparse.Namespace) -> AskedSystems:
    """Analyse what the options of :func:`add_asking` ask for.  Raises :class:`UsageError`."""
    from archlint.engine.pipeline import NothingToDo, asked_for  # as above

    request = request_of(arguments)
    progress = Progress(sys.stderr, arguments.quiet, arguments.verbose)
    try:
        with pool_of(arguments) as pool, progress as monitor:
            systems = asked_for(replace(request, monitor=monitor, pool=pool))
    except NothingToDo as error:
        raise UsageError(str(error)) from None
    return AskedSystems(systems, request.settings, progress)


__all__ = ["AskedSystems", "add_asking", "add_paths", "asked_systems"]
