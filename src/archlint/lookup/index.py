"""Everything that the files of a workspace mention, by place and by what is mentioned: made once for a run."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from archlint.connections.delivery import undelivered_on
from archlint.lookup.ends import mentions_of_ends
from archlint.lookup.mentions import Mention, Subject
from archlint.lookup.moved import Moves
from archlint.lookup.starts import mentions_of_entries, mentions_of_starts
from archlint.lookup.texts import TextOf, Texts, contains
from archlint.lookup.types_named import mentions_of_fields, mentions_of_imports
from archlint.lookup.values import mentions_of_parameters
from archlint.model import EntityKind
from archlint.ros import standard_interfaces
from archlint.systems.model import System, WorkspaceIndex
from archlint.systems.nodes import key_of
from archlint.systems.rates import rates

if TYPE_CHECKING:
    from archlint.place import Place

_LAUNCHED, _INCLUDED, _OPEN = range(3)
PROVIDERS = frozenset({EntityKind.PUBLISHER, EntityKind.SERVICE, EntityKind.ACTION_SERVER})


class Index:
    """What one run knows of names.  ``systems`` are those of one workspace, the open one first, as
    :func:`archlint.engine.loading.systems_of` makes them; ``text_of`` gives the texts that the run has read.

    An editor may have changed a text since: what is on lines that have changed is then mentioned nowhere."""

    def __init__(self, systems: Sequence[System], text_of: TextOf) -> None:
        self.systems = [(system, rank) for each in systems for system, rank in _ranked(each)]
        self.workspace = next((s.workspace for s in systems if s.workspace is not None), WorkspaceIndex())
        self.texts = Texts(text_of)
        """The texts that the run has read."""
        self.kept: dict[object, object] = {}
        """What answers work out once (:func:`archlint.analysis.kept.once`)."""
        mentions = list(mentions_of_entries(self.workspace))
        mentions += mentions_of_fields(self.workspace, self.texts)
        mentions += mentions_of_imports(self.workspace, self.texts)
        for system, rank in self.systems:
            mentions += mentions_of_ends(system, rank)
            mentions += mentions_of_parameters(system, rank, self.workspace, self.texts)
            mentions += mentions_of_starts(system, rank, self.workspace)
        self._by_file: dict[str, list[Mention]] = {}
        self._by_subject: dict[Subject, list[Mention]] = {}
        best: dict[object, int] = {}
        for mention in mentions:
            key = (mention.place, mention.role, mention.subject.kind)
            best[key] = min(mention.rank, best.get(key, mention.rank))
        for mention in sorted(mentions, key=lambda each: each.sort_key):
            self.texts.lines(mention.place.file)  # now, as long as they are those of the run
            self._by_file.setdefault(mention.place.file, []).append(mention)
            if mention.rank == best[mention.place, mention.role, mention.subject.kind]:
                self._by_subject.setdefault(mention.subject, []).append(mention)

    def of(self, subject: Subject) -> list[Mention]:
        """Where a subject is mentioned, in the order of files and lines: not where the same text means another one in
        systems that count more."""
        return self._by_subject.get(subject, [])

    def in_file(self, file: str) -> list[Mention]:
        """What a file mentions, by its shown path, in the order of its lines."""
        return self._by_file.get(file, [])

    def subjects(self) -> Iterable[Subject]:
        """All that is mentioned anywhere."""
        return self._by_subject

    def at(self, texts: Texts, file: str, line: int, column: int) -> list[Mention]:
        """What is mentioned at a position: by the smallest place around it, in the systems that count most there.

        The position is one of the texts as they are now, the places of the mentions are those of the run."""
        before = Moves(self.texts, texts).line_before(file, line)
        if before is None:
            return []
        around = [mention for mention in self.in_file(file) if contains(mention.place, before, column)]
        names = [mention for mention in around if mention.role != "call"]
        calls = [m for m in around if m.role == "call" and self.texts.is_callee(m.place, before, column)]
        nearest = min((_size(mention.place) for mention in names or calls), default=None)
        here = [mention for mention in names or calls if _size(mention.place) == nearest]
        best = min((mention.rank for mention in here), default=_OPEN)
        return [mention for mention in here if mention.rank == best]

    def ends_of(self, subject: Subject) -> tuple[list[Mention], list[Mention]]:
        """The publishers or servers of a name and its subscriptions or clients, one mention for each end of a node.

        What the code alone says of a node does not count where a launch file starts it under its final name."""
        calls = [mention for mention in self.of(subject) if mention.role == "call" and mention.end is not None]
        launched = self.workspace.started_by_launch
        unique: dict[object, Mention] = {}
        for mention in sorted(calls, key=lambda each: each.rank):
            node, end = mention.node, mention.end
            if node is None or end is None:
                continue
            is_started = node.blueprint is not None and key_of(node.blueprint) in launched
            if mention.rank < _OPEN or not is_started:
                unique.setdefault((node.name, mention.place, end.kind), mention)
        rows = sorted(unique.values(), key=lambda each: each.sort_key)
        providers = [row for row in rows if row.end is not None and row.end.kind in PROVIDERS]
        users = [row for row in rows if row.end is not None and row.end.kind not in PROVIDERS]
        return providers, users

    @cached_property
    def rates(self) -> dict[int, float]:
        """Messages a second by ``id`` of the publisher's creation."""
        return {key: rate for system, _ in self.systems for key, rate in rates(system).items()}

    def undelivered(self, subject: Subject) -> list[str]:
        """Why publishers and subscriptions of a topic do not connect: their quality of service does not fit."""
        reasons: dict[str, None] = {}
        for system in self._by_topic.get(subject.name, []) if subject.kind == "topic" else ():
            for pair in undelivered_on(system, system.topics[subject.name]):
                reasons[pair.reason] = None
        return sorted(reasons)

    @cached_property
    def _by_topic(self) -> dict[str, list[System]]:
        """The systems that have each topic."""
        systems: dict[str, list[System]] = {}
        for system, _ in self.systems:
            for name in system.topics:
                systems.setdefault(name, []).append(system)
        return systems

    def definition_text(self, interface: str) -> str | None:
        """The text of an interface file of the workspace, or that of a standard interface."""
        table = self.workspace.interfaces
        source = None if table is None else table.file(interface)
        if source is not None:
            return self.workspace.tree.text(source.relative)
        standard = standard_interfaces.table().interfaces.get(interface)
        return None if standard is None else standard.text


def _ranked(system: System) -> list[tuple[System, int]]:
    """A system and its alternatives, each with how much it counts."""
    rank = _OPEN if system.name is None else _INCLUDED if system.is_included else _LAUNCHED
    return [(system, rank), *((other, rank) for _, other in system.alternatives)]


def _size(place: Place) -> tuple[int, int]:
    return place.end_line - place.line, place.end_column - place.column


__all__ = ["PROVIDERS", "Index"]
