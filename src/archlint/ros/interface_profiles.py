"""QoS in the words of ``interface.yaml``, as ros-tooling/rosgraph and jig read it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from archlint.ros.qos import Qos


def profile_of(qos: Qos) -> dict[str, Any] | None:
    """A profile, where the format has words for what it says."""
    history = "ALL" if qos.history == "keep_all" else qos.depth if qos.history == "keep_last" else None
    if not history or qos.reliability not in ("reliable", "best_effort") or qos.unknown_durations:
        return None
    profile: dict[str, Any] = {"history": history, "reliability": qos.reliability.upper()}
    if qos.durability in ("volatile", "transient_local"):
        profile["durability"] = qos.durability.upper()
    elif qos.durability != "system_default":
        return None
    bounds = (("deadline_ms", qos.deadline), ("lifespan_ms", qos.lifespan), ("lease_duration_ms", qos.liveliness_lease))
    profile |= {name: round(seconds * 1000) for name, seconds in bounds if seconds}
    if qos.liveliness in ("automatic", "manual_by_topic"):
        profile["liveliness"] = qos.liveliness.upper()
    return profile


__all__ = ["profile_of"]
