"""Which names and files of a launch come from its launch arguments, so that whoever starts it may choose others.

A launch does not keep where a text came from: ``perform()`` gives plain texts, which code splits and joins.  What is
the default of an argument, or a word of it (``robots:=front,rear``), is taken to be that argument's.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.launch.kinds import FileStatus
from archlint.launch.parameter_sources import files_among
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from archlint.launch.model import Launched
    from archlint.launch.started import Started
    from archlint.model import ParameterDeclaration
    from archlint.systems.model import WorkspaceIndex
    from archlint.systems.overrides import Setting

_BETWEEN = re.compile(r"[,;\s]+")


def name_is_chosen(launched: Launched, started: Started) -> bool:
    """Whether the name that a launch file gives a node may come from an argument."""
    return started.name is not None and (started.name.text or "") in _words(launched)


def namespace_is_chosen(launched: Launched, started: Started) -> bool:
    """Whether a part of the namespace of a node may come from an argument; of none at all, where one is given and an
    argument is empty by default."""
    if started.namespace is None:
        return False
    parts = (started.namespace.text or "").strip("/").split("/")
    return not _words(launched).isdisjoint(parts)


def executable_is_chosen(launched: Launched, started: Started) -> bool:
    """Whether an argument may choose the executable that a launch file starts: a default is it, or ends it
    (``f'planner_{version}'``)."""
    name = started.executable.text or ""
    return any(word and (name == word or name.endswith(f"_{word}")) for word in _words(launched))


def program_is_chosen(launched: Launched, started: Started) -> bool:
    """Whether arguments choose both the package and the executable that a launch file starts."""
    return (started.package.text or "") in _words(launched) and executable_is_chosen(launched, started)


def executable_is_picked(workspace: WorkspaceIndex, started: Started) -> bool:
    """Whether a launch file picks the executable out of several that it lists, by a switch that people change there:
    ``executable=DRIVERS[driver]``, ``executable='real' if REAL else 'fake'``."""
    spans = _picked_executables(workspace, started.place.file) or ()
    return any(_is_inside(Place.of(started.place.file, span), started.place) for span in spans)


def _is_inside(inner: Place, outer: Place) -> bool:
    return outer.span[:2] <= inner.span[:2] and inner.span[2:] <= outer.span[2:]


@once_for_each_file
def _picked_executables(file_facts: facts.Facts) -> list[tuple[int, int, int, int]]:
    return [
        argument.value.span
        for call in everything_in(file_facts.body, facts.Call)
        for argument in call.args
        if argument.keyword == "executable" and isinstance(argument.value, (facts.Subscript, facts.Conditional))
    ]


def _words(launched: Launched) -> frozenset[str]:
    defaults = [argument.default.text for argument in launched.declared if argument.default is not None]
    return frozenset(word.strip("/") for text in defaults if text is not None for word in _BETWEEN.split(text))


def may_get_any_file(launched: Launched, started: Started) -> bool:
    """Whether a node gets a parameter file that is not known, or that is the default of an argument: another file may
    be given there."""
    if any(parameter.is_open and parameter.sets_anything for parameter in started.parameters):
        return True
    defaults = {argument.default.text for argument in launched.declared if argument.default is not None}
    references = [use.reference for use in files_among(started.parameters)]
    return any(reference.status == FileStatus.UNKNOWN or reference.written in defaults for reference in references)


def has_another_choice(
    name: str, declared: Mapping[str, Sequence[ParameterDeclaration]], settings: Sequence[Setting]
) -> bool:
    """Whether a node would declare a parameter if another one had another value: of ``devices.a.ip``, where ``a`` is
    such a value, ``devices.b.ip`` differs in that part alone."""
    parts = name.split(".")
    for known, rows in declared.items():
        chosen_by = rows[0].name.parameter if rows[0].name.resolution == "parameter" else None
        others = known.split(".")
        if chosen_by is None or len(others) != len(parts):
            continue
        values = {str(row.default) for row in declared.get(chosen_by, ())}
        values |= {str(setting.value) for setting in settings if setting.name == chosen_by}
        differing = [other for part, other in zip(parts, others, strict=True) if part != other]
        if len(differing) == 1 and differing[0] in values:
            return True
    return False
