"""LCH012: controllers that are spawned and of which the controller manager knows nothing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.spawned_controllers import UnknownController, unknown_controllers
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System

_STARTED = "the controller manager is started here"
_NONE = "none has a type"
"""The group of what is spawned where the controller manager gets no type at all: the cause is one file."""
_IN_SIMULATOR = "the controller manager in the simulator gets its file here"


@rule("LCH012", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_controller(system: System, options: Options) -> Iterator[Finding]:
    """Spawned controllers that none of the controller manager's parameters gives a type."""
    for spawned in unknown_controllers(system):
        near = nearest(spawned.name, spawned.known)
        place = spawned.named_at or spawned.place
        spawns = [] if spawned.named_at is None else [Related(spawned.place, "the controllers are spawned here")]
        yield finding(
            "LCH012",
            place,
            f"the controller manager gets no type of a controller '{spawned.name}', so that spawning it fails"
            + (meant(f"'{near}'") if near is not None else ""),
            help=_help(spawned, near),
            related=[*spawns, Related(spawned.manager, _IN_SIMULATOR if spawned.simulated else _STARTED)],
            identity=(spawned.name,),
            group=(place.file, spawned.name if spawned.known else _NONE),
            meant=near or "",
        )


def _help(spawned: UnknownController, near: str | None) -> str:
    if near is not None:
        return f"write '{near}'"
    if not spawned.known:
        return f"write `{spawned.name}: {{type: …}}` into the section of the controller manager"
    return f"spawn one that it knows: {listed(spawned.known)}"


@folds("LCH012")
def _of_one_controller(findings: Sequence[Finding]) -> Finding:
    """One finding for a controller of a file, however many spawners name it, and for all where none has a type."""
    if _NONE in findings[0].group:
        return with_places(findings, "what is spawned here has no type, either")
    return with_places(findings, "it is spawned here, too")


__all__ = ["unknown_controller"]
