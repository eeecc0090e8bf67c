"""QOS004: profiles that contradict themselves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import EntityKind

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.ros.qos import Qos
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint


@rule("QOS004", scope=Scope.AS_LAUNCHED)
def qos_contradiction(system: System, options: Options) -> Iterator[Finding]:
    """Profiles whose parts do not go together, one finding a profile, at the first create call that uses it."""
    profiles: dict[tuple[Place, str], dict[Place, Endpoint]] = {}
    creations, helpers = _Creations(), _sound_somewhere(system)
    for end in sorted(system.endpoints, key=lambda end: end.place):
        given = creations.profiles(end)
        for qos in given:
            contradiction = _contradiction(qos)
            if contradiction is not None and not _may_be_sound(given, qos):
                place = _caller(end) if qos.place is None and end.place in helpers else end.place
                profiles.setdefault((qos.place or place, contradiction), {}).setdefault(place, end)
    for (written, contradiction), uses in profiles.items():
        (place, end), *others = uses.items()
        related = [Related(written, "the profile is defined here")] if written != place else []
        if place != end.place and place == _caller(end):
            related.append(Related(end.place, "this call creates the endpoint with it"))
        yield finding(
            "QOS004",
            place,
            contradiction,
            help="use keep_all without a depth, or keep_last with a depth of at least 1",
            related=[*related, *(Related(other, "it is used here, too") for other, _ in others)],
            node=end.node.name,
            identity=(end.kind, end.name or "", contradiction),
            group=(contradiction,),
        )


def _sound_somewhere(system: System) -> frozenset[Place]:
    """The create calls to which somebody passes a profile that is right: those of helpers, where it is the caller's."""
    return frozenset(
        end.place
        for end in system.endpoints
        if end.qos is not None and end.qos.depth and _contradiction(end.qos) is None
    )


def _caller(end: Endpoint) -> Place:
    """Where the helper is called that creates an endpoint."""
    return end.creation.chain[-1].place if end.creation.chain else end.place


@folds("QOS004", across_systems=True)
def _of_one_habit(findings: Sequence[Finding]) -> Finding:
    """The finding for all profiles of a workspace that are wrong in the same way: one was copied from the other."""
    return with_others(findings, "another profile does", "more profiles do", "the same", "the same again")


class _Creations:
    """The profiles that create calls are given, by the node class and the place."""

    def __init__(self) -> None:
        self._known: dict[int, dict[tuple[Place, EntityKind], list[Qos | None]]] = {}

    def profiles(self, end: Endpoint) -> list[Qos]:
        """Those that the create call of a topic's endpoint may be given: several where a branch decides."""
        if end.kind not in (EntityKind.PUBLISHER, EntityKind.SUBSCRIBER):
            return []
        given = [end.qos, *self._at(end)]
        return [qos for qos in dict.fromkeys(given) if qos is not None]

    def _at(self, end: Endpoint) -> list[Qos | None]:
        blueprint = end.node.blueprint
        if blueprint is None:
            return [end.creation.qos]
        by_place = self._known.get(id(blueprint))
        if by_place is None:
            by_place = self._known[id(blueprint)] = {}
            for creation in blueprint.creations:
                by_place.setdefault((creation.place, creation.kind), []).append(creation.qos)
        return by_place.get((end.place, end.kind), [])


def _may_be_sound(profiles: Sequence[Qos], qos: Qos) -> bool:
    """Whether one profile is filled in in several ways, by a function that makes a policy of a text say, and nobody
    knows which of them is taken: one is sound."""
    return any(profile.place == qos.place and _contradiction(profile) is None for profile in profiles)


def _contradiction(qos: Qos) -> str | None:
    if qos.history == "keep_all" and qos.depth and "depth" in qos.explicit:
        return f"the profile has history keep_all and a depth of {qos.depth}, which has no effect"
    if qos.history == "keep_last" and qos.depth == 0:
        return "the profile has history keep_last with depth 0: what that means depends on the middleware"
    return None
