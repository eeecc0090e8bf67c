"""What is said of mistakes in methods that nothing calls: they fail only once somebody does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.behind_ends import is_behind_an_end
from archlint.analysis.closed_guards import is_switched_off
from archlint.analysis.dropped_callbacks import is_in_a_dropped_callback
from archlint.analysis.idle_helpers import is_idle_helper
from archlint.analysis.kept_defaults import needs_another_default
from archlint.analysis.left_over import unmade_class
from archlint.analysis.reached_code import needed_packages
from archlint.analysis.replaced_methods import is_replaced
from archlint.analysis.uncalled_functions import uncalled_function
from archlint.analysis.uncalled_methods import is_in_trial, uncalled_main, uncalled_method
from archlint.analysis.unmet_choices import is_never_chosen

if TYPE_CHECKING:
    from collections.abc import Iterator

    from archlint.finding import Finding, Place
    from archlint.systems.model import System


def unless_uncalled(system: System, diagnostic: Finding) -> Iterator[Finding]:
    """The same finding; none where the file is a program and nothing calls that method, or only such methods do, and
    none behind a flag that stays false, for a choice that is never made, or for another value of a parameter than the
    default that all calls leave it: it is left over, and nobody meets the mistake.  Nor is anything said of a method
    that a later one replaces, of a callback that its synchronizer never calls, or of a line behind the end of its
    block.
    What a library offers is for others to call, but for what a module without a word of ROS has and no file names."""
    place, workspace = diagnostic.place, system.workspace
    never = any(each(workspace, place) for each in _NEVER_REACHED) or is_in_a_dropped_callback(system, place)
    if not _is_left_in_program(system, place) and not never:
        yield diagnostic


_NEVER_REACHED = (
    is_idle_helper,
    is_replaced,
    is_behind_an_end,
    is_in_trial,
    is_switched_off,
    is_never_chosen,
    needs_another_default,
)
"""What may keep a program from getting to a place."""


def uncalled_in_program(system: System, place: Place) -> str | None:
    """The name of the method of a program, or of a module that only programs of its own package may use, that holds a
    place, where nothing calls it but methods of that kind; ``main`` of a module that nothing starts."""
    if not _is_program(system, place.file):
        return None
    return uncalled_method(system.workspace, place) or uncalled_main(system.workspace, place)


def _is_left_in_program(system: System, place: Place) -> bool:
    """Whether a place is in such a method, in a function that nothing calls, or in a class of which no object is
    made."""
    if uncalled_in_program(system, place) is not None:
        return True
    idle = (uncalled_function, unmade_class)
    return _is_program(system, place.file) and any(each(system.workspace, place) is not None for each in idle)


def _is_program(system: System, file: str) -> bool:
    is_program = any(program.executable and program.file == file for program in system.programs)
    return is_program or is_not_installed(system.workspace, file) or _is_of_programs(system, file)


def _is_of_programs(system: System, file: str) -> bool:
    """Whether a module belongs to a package that installs programs, and no other package here declares that it needs
    that one: it is no library."""
    workspace = system.workspace
    name = None if workspace is None else workspace.package_of(file)
    installs = None if workspace is None or name is None else workspace.installs.get(name)
    if workspace is None or installs is None or not any(each.module for each in installs.executables.values()):
        return False
    return name not in needed_packages(workspace)


__all__ = ["uncalled_in_program", "unless_uncalled"]
