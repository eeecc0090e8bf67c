"""The parameter files that a launch file gives to nodes, and in which ``ros__parameters`` is not where it has to be, or
a list has items of several types.

Source: ``find_parameter_arrays`` and ``parse_value`` of rcl_yaml_param_parser, "Sequence should be of same type".
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.launch.kinds import StartedKind
from archlint.launch.parameter_sources import ParameterFileUse, files_among
from archlint.records import dataclass
from archlint.ros.released_programs import is_without_node
from archlint.syntax.parameter_structure import ROOT, Misplaced, Misplacement
from archlint.syntax.refused_parameters import Refusal, RefusedParameter

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.syntax.parameter_files import ParameterEntry, ParameterFacts, ParameterSection
    from archlint.systems.model import System


@dataclass(frozen=True)
class MisplacedIn:
    """What is wrong with a file at a place; ``user`` is the name of a node that it is given to, ``given`` where: None
    for one that nothing here gives to a node."""

    file: str
    wrong: Misplaced
    user: str | None
    given: Place | None

    @property
    def place(self) -> Place:
        return Place(self.file, *self.wrong.span)


def misplaced_in_files(system: System) -> Iterator[MisplacedIn]:
    """The first such key of each file, which is given to a process as it is: for a component launch_ros reads it, and
    takes one without any ``ros__parameters``."""
    if system.launched is None:
        return
    by_file: dict[str, MisplacedIn] = {}
    for started in system.launched.started:
        for use in _read_by_rcl(started):
            key = _misplaced(system, started, use)
            if key is not None:
                by_file.setdefault(key.file, key)
    yield from by_file.values()


@dataclass(frozen=True)
class MixedList:
    """A list of a file whose items have several ``types``, in the order in which they come."""

    file: str
    name: str
    types: tuple[str, ...]
    place: Place
    user: str | None
    given: Place
    others: tuple[tuple[str, Place], ...] = ()
    """The other lists of the file that are so, too: each has to be mended."""


_TYPES = {bool: "bool", int: "integer", float: "double", str: "string"}


@dataclass(frozen=True)
class NoValue:
    """A parameter of a file whose value rcl takes for none."""

    file: str
    refused: RefusedParameter
    user: str | None
    given: Place


def mixed_lists(system: System) -> Iterator[MixedList]:
    """The first such list of each file that is given to a process as it is: rcl refuses all of the file."""
    for file, user, given, facts in _given_files(system):
        entries = (entry for section in facts.sections for entry in section.entries)
        mixed = [entry for entry in entries if len(_types_of(entry.value)) > 1]
        if mixed:
            (name, place), *others = [(entry.name, Place(file, *entry.span)) for entry in mixed]
            yield MixedList(file, name, _types_of(mixed[0].value), place, user, given, tuple(others))


@dataclass(frozen=True)
class SetTwice:
    """A parameter that stands twice in a section of a file, with two values: the ``last`` one counts."""

    file: str
    name: str
    value: object
    last: object
    place: Place
    last_place: Place
    user: str | None
    given: Place | None
    others: tuple[tuple[str, Place], ...] = ()
    """The other parameters of the file of which the same is so."""


def set_twice(system: System) -> Iterator[SetTwice]:
    """The first such parameter of each file that is given to a process."""
    for file, user, given, facts in _given_files(system):
        yield from set_twice_in(file, user, given, facts)


def set_twice_in(file: str, user: str | None, given: Place | None, facts: ParameterFacts) -> Iterator[SetTwice]:
    """The first such parameter of a file, with the others."""
    doubled = [(entry, last) for section in facts.sections for entry, last in _doubled(section)]
    for entry, last in doubled[:1]:
        place, last_place = Place(file, *entry.span), Place(file, *last.span)
        others = tuple((other.name, Place(file, *other.span)) for other, _ in doubled[1:])
        yield SetTwice(file, entry.name, entry.value, last.value, place, last_place, user, given, others)


def _doubled(section: ParameterSection) -> Iterator[tuple[ParameterEntry, ParameterEntry]]:
    """An entry and the last one of each such parameter: rcl overwrites a value with one of the same type."""
    last = {entry.name: entry for entry in section.entries}
    told: set[str] = set()
    for entry in section.entries:
        other = last[entry.name]
        differs = type(other.value) is type(entry.value) in _TYPES and not _is_same(entry.value, other.value)
        if differs and entry.name not in told:
            told.add(entry.name)
            yield entry, other


def _is_same(first: object, second: object) -> bool:
    """Whether two values are the same for a node: ``.nan``, too, which is not equal to itself."""
    return first == second or (first != first and second != second)


def refused_values(system: System) -> Iterator[NoValue]:
    """The first such value of each file that is given to a process as it is."""
    for file, user, given, facts in _given_files(system):
        if facts.refused is not None and facts.misplaced is None:
            yield NoValue(file, facts.refused, user, given)


def _given_files(system: System) -> Iterator[tuple[str, str | None, Place, ParameterFacts]]:
    """The files that are given to processes as they are, each once: with the name of the first node that gets it, and
    where that is given it."""
    if system.launched is None or system.workspace is None:
        return
    seen: set[str] = set()
    for started in system.launched.started:
        for use in _read_by_rcl(started):
            file = use.reference.source
            if file is not None and file not in seen and not use.changes:
                seen.add(file)
                user = (started.name or started.executable).text
                yield file, user, _given_at(started, use.place), system.workspace.parameters_of(file)


def _read_by_rcl(started: Started) -> Iterable[ParameterFileUse]:
    """The parameter files that a process reads as it starts, if it has a node."""
    if started.kind == StartedKind.COMPONENT or is_without_node(started.package.text, started.executable.text):
        return ()
    return files_among(started.parameters)


def _types_of(value: object) -> tuple[str, ...]:
    """The types of the items of a list, each once; none where some item is of another type."""
    items = value if isinstance(value, list) else []
    if any(type(item) not in _TYPES for item in items):
        return ()
    return tuple(dict.fromkeys(_TYPES[type(item)] for item in items))


def _misplaced(system: System, started: Started, use: ParameterFileUse) -> MisplacedIn | None:
    file = use.reference.source
    if file is None or use.changes or system.workspace is None:
        return None
    wrong = system.workspace.parameters_of(file).misplaced
    user = started.name or started.executable
    return None if wrong is None else MisplacedIn(file, wrong, user.text, _given_at(started, use.place))


def _given_at(started: Started, place: Place) -> Place:
    """Where a process is given a file: in its ``parameters=``, also if what names the file is made further up."""
    parameters = started.places.get("parameters")
    if parameters is None or place.file != parameters.file:
        return place
    inside = parameters.span[:2] <= place.span[:2] and place.span[2:] <= parameters.span[2:]
    return place if inside or not place.file.endswith(".py") else parameters


__all__ = [
    "ROOT",
    "Misplaced",
    "MisplacedIn",
    "Misplacement",
    "MixedList",
    "NoValue",
    "Refusal",
    "SetTwice",
    "misplaced_in_files",
    "mixed_lists",
    "refused_values",
    "set_twice",
    "set_twice_in",
]
