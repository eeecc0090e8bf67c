"""Quality of service of both sides, as the JSON of a graph has it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from archlint.comparing.graphs import KINDS, EndKind
from archlint.ros.qos import Qos, Verdict, compatible

_Data = Mapping[str, Any] | None
_POLICIES = ("history", "depth", "reliability", "durability", "deadline_s", "lifespan_s", "liveliness", "lease_s")
_STRENGTHS = {"reliability": ("best_effort", "reliable"), "durability": ("volatile", "transient_local")}


def profile(data: _Data) -> Qos:
    """The profile; what is not known is None, which no verdict is given on."""
    known = data or {}
    return Qos(
        history=known.get("history"),
        depth=known.get("depth"),
        reliability=known.get("reliability"),
        durability=known.get("durability"),
        deadline=known.get("deadline_s"),
        lifespan=known.get("lifespan_s"),
        liveliness=known.get("liveliness", "system_default"),
        liveliness_lease=known.get("lease_s"),
    )


def mismatch(kind: EndKind, own: _Data, other: _Data) -> str:
    """Why an end of a kind does not connect to one at the other side; empty where it does, or may."""
    offer, request = (own, other) if KINDS[kind].provides else (other, own)
    errors = [verdict for verdict in compatible(profile(offer), profile(request)) if verdict.level == "error"]
    return "; ".join(map(_words, errors))


def _words(verdict: Verdict) -> str:
    policy = verdict.policy.replace("_", " ")
    return f"{policy} {_value(verdict.offered)} is offered and {_value(verdict.requested)} requested"


def _value(value: object) -> str:
    return "none" if value is None else f"{value:g} s" if type(value) is float else str(value)


def differing(before: _Data, after: _Data) -> tuple[str, str]:
    """The policies in which two profiles differ, in words for each; empty where one of them is not known."""
    if before is None or after is None:
        return "", ""
    names = [name for name in _POLICIES if before.get(name) != after.get(name)]
    return _listed(before, names), _listed(after, names)


def _listed(data: Mapping[str, Any], names: list[str]) -> str:
    return ", ".join(f"{name.removesuffix('_s')} {_policy(data.get(name))}" for name in names)


def _policy(value: object) -> str:
    return "not set" if value is None else f"{value:g} s" if type(value) is float else str(value)


def is_weaker(kind: EndKind, before: _Data, after: _Data) -> bool:
    """Whether an end offers less than before, or asks for more."""
    old, new = before or {}, after or {}
    provides = KINDS[kind].provides
    for policy, (weak, strong) in _STRENGTHS.items():
        stronger, weaker = (old, new) if provides else (new, old)
        if stronger.get(policy) == strong and weaker.get(policy) == weak:
            return True
    was, now = old.get("deadline_s"), new.get("deadline_s")
    if was == now:
        return False
    longer, shorter = (now, was) if provides else (was, now)
    return shorter is not None and (longer is None or longer > shorter)
