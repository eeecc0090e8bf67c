"""Quality of service: the profiles that ROS ships, and which of them talk to each other.

Sources: rmw ``qos_profiles.h``, rcl_action ``default_qos.h`` and rclpy ``qos.py`` for the presets;
``rmw_dds_common`` ``qos.cpp`` for compatibility.  Policies are spelled as in rmw, in lower case.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, Literal

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place


History = Literal["system_default", "keep_last", "keep_all", "unknown"]
Reliability = Literal["system_default", "reliable", "best_effort", "unknown", "best_available"]
Durability = Literal["system_default", "transient_local", "volatile", "unknown", "best_available"]
Liveliness = Literal["system_default", "automatic", "manual_by_node", "manual_by_topic", "unknown", "best_available"]
PolicyName = Literal["history", "reliability", "durability", "liveliness"]
"""A policy that has words for values."""
PolicyValue = History | Reliability | Durability | Liveliness
BoundName = Literal["deadline", "lifespan", "liveliness_lease"]
"""A policy that is a duration."""
FieldName = PolicyName | BoundName | Literal["depth"]
"""A field of a profile that holds a policy."""
DurationPolicy = Literal["deadline", "liveliness_lease"]
"""A duration that an offer and a request must agree on."""
StrengthPolicy = Literal["reliability", "durability", "liveliness"]
"""A policy of two strengths."""
Level = Literal["error", "warning"]


@dataclass(frozen=True)
class Qos:
    """A quality-of-service profile.  Values are lower case as in rmw (``keep_last``, ``best_effort``,
    ``transient_local``, ``system_default``, ``best_available`` …); None is what could not be resolved.
    Durations are in seconds, None where the default (infinite) stands.  ``explicit`` names the policies that
    the code set itself."""

    history: History | None = "keep_last"
    depth: int | None = 10
    reliability: Reliability | None = "reliable"
    durability: Durability | None = "volatile"
    deadline: float | None = None
    lifespan: float | None = None
    liveliness: Liveliness | None = "system_default"
    liveliness_lease: float | None = None
    explicit: frozenset[str] = frozenset()
    unknown_durations: frozenset[BoundName] = frozenset()
    parameter: str | None = None
    """The parameter that decides (part of) the profile, if one does."""
    place: Place | None = None
    """Where the profile is written."""
    overridable: bool = False
    """True where the code passes ``qos_overriding_options``: parameters may change the profile."""

    @property
    def known(self) -> bool:
        """True where history, depth, reliability and durability are all resolved."""
        return None not in (self.history, self.reliability, self.durability) and (
            self.depth is not None or self.history != "keep_last"
        )


DEFAULT = Qos()
SENSOR_DATA = Qos(depth=5, reliability="best_effort")
PARAMETERS = Qos(depth=1000)
ROSOUT = Qos(depth=1000, durability="transient_local", lifespan=10.0)
CLOCK = Qos(depth=1, reliability="best_effort")
ACTION_STATUS = Qos(depth=1, durability="transient_local")

PRESETS: dict[str, Qos] = {
    "qos_profile_default": DEFAULT,
    "qos_profile_sensor_data": SENSOR_DATA,
    "qos_profile_services_default": DEFAULT,
    "qos_profile_parameters": PARAMETERS,
    "qos_profile_parameter_events": PARAMETERS,
    "qos_profile_action_status_default": ACTION_STATUS,
    "qos_profile_rosout_default": ROSOUT,
    "qos_profile_system_default": Qos(
        history="system_default", depth=0, reliability="system_default", durability="system_default"
    ),
    "qos_profile_best_available": Qos(
        reliability="best_available", durability="best_available", liveliness="best_available"
    ),
}
"""By the name that ``rclpy.qos`` exports; ``QoSPresetProfiles`` has the same ones under shorter names."""

PRESET_MEMBERS = {
    "UNKNOWN": None,
    "DEFAULT": "qos_profile_default",
    "SYSTEM_DEFAULT": "qos_profile_system_default",
    "SENSOR_DATA": "qos_profile_sensor_data",
    "SERVICES_DEFAULT": "qos_profile_services_default",
    "PARAMETERS": "qos_profile_parameters",
    "PARAMETER_EVENTS": "qos_profile_parameter_events",
    "ACTION_STATUS_DEFAULT": "qos_profile_action_status_default",
    "BEST_AVAILABLE": "qos_profile_best_available",
    "ROSOUT_DEFAULT": "qos_profile_rosout_default",
}
"""Members of ``QoSPresetProfiles`` and the profiles they stand for."""


@dataclass(frozen=True)
class Verdict:
    """One policy on which an offer and a request do not agree.

    ``level`` is ``error`` where they never connect, ``warning`` where that depends on the middleware.
    Durations are in seconds, None where nothing is set.
    """

    policy: DurationPolicy | StrengthPolicy
    level: Level
    offered: PolicyValue | float | None
    requested: PolicyValue | float | None


@dataclass(frozen=True)
class _Rule:
    """A policy of two strengths: a weak offer does not serve a strong request."""

    policy: StrengthPolicy
    weak: PolicyValue
    strong: PolicyValue


_RULES = (
    _Rule("reliability", "best_effort", "reliable"),
    _Rule("durability", "volatile", "transient_local"),
    _Rule("liveliness", "automatic", "manual_by_topic"),
)
_UNDECIDED: Final = ("system_default", "unknown")
"""What the middleware decides."""
_DURATIONS: Final[tuple[DurationPolicy, ...]] = ("deadline", "liveliness_lease")
_TIMES = (*_DURATIONS, "lifespan")


def compatible(offered: Qos, requested: Qos) -> list[Verdict]:
    """What keeps a subscription that requests ``requested`` from a publisher that offers ``offered``.

    History, depth and lifespan never do.  Warnings are given only where there is no error, and liveliness is
    passed over where neither side sets it: its default is left to the middleware in every profile.  What the
    code does not say (None) yields no verdict.
    """
    verdicts = [verdict for rule in _RULES if (verdict := _policy_verdict(rule, offered, requested))]
    verdicts += [verdict for policy in _DURATIONS if (verdict := _duration_verdict(policy, offered, requested))]
    errors = [verdict for verdict in verdicts if verdict.level == "error"]
    return errors or verdicts


def _policy_verdict(rule: _Rule, offered: Qos, requested: Qos) -> Verdict | None:
    offer: PolicyValue | None = getattr(offered, rule.policy)
    request: PolicyValue | None = getattr(requested, rule.policy)
    if offer is None or request is None:
        return None
    if offer == rule.weak and request == rule.strong:
        return Verdict(rule.policy, "error", offer, request)
    if offer in _UNDECIDED and request in _UNDECIDED:
        undecided = rule.policy != "liveliness"
    else:
        undecided = (offer in _UNDECIDED and request == rule.strong) or (offer == rule.weak and request in _UNDECIDED)
    return Verdict(rule.policy, "warning", offer, request) if undecided else None


def _duration_verdict(policy: DurationPolicy, offered: Qos, requested: Qos) -> Verdict | None:
    if policy in offered.unknown_durations or policy in requested.unknown_durations:
        return None
    offer: float | None = getattr(offered, policy)
    request: float | None = getattr(requested, policy)
    # Nothing set, or zero, means that the offer promises no bound and the request asks for none.
    if not request or (offer and request >= offer):
        return None
    return Verdict(policy, "error", offer, request)


def allowed(qos: Qos, policy: FieldName, values: tuple[str | float, ...]) -> bool | None:
    """Whether a policy of a profile has one of the values; None where only the middleware or run time knows.

    Durations are in seconds; one that is not set, or 0, is no bound at all.
    """
    if policy in qos.unknown_durations:
        return None
    given: str | float | None = getattr(qos, policy)
    if policy in _TIMES:
        return (given or 0) in values
    if given is None or given in (*_UNDECIDED, "best_available"):
        return None
    if policy == "depth" and qos.history != "keep_last":
        return None
    return given in values
