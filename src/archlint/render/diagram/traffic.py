"""How often something is sent over a topic, and with which quality of service, in few words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.model import EntityKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from archlint.ros.qos import Qos
    from archlint.systems.nodes import Endpoint

_MOST_RATES = 3


def traffic_words(ends: Sequence[Endpoint], rates: Mapping[int, float]) -> list[str]:
    """A line on a topic with these ends: its rates, and the QoS that all who publish offer; nothing where neither is
    known.  ``rates`` are :func:`archlint.systems.rates.rates`."""
    publishers = [end for end in ends if end.kind == EntityKind.PUBLISHER]
    known = sorted({rates[id(end.creation)] for end in publishers if id(end.creation) in rates})
    words = [" and ".join(f"{rate:.3g}" for rate in known) + " Hz"] if 0 < len(known) <= _MOST_RATES else []
    words += [word for word in _agreed(publishers or ends) if word not in _USUAL]
    return [" · ".join(words)] if words else []


def qos_offered(ends: Sequence[Endpoint]) -> Sequence[str]:
    """What all who publish a topic with these ends offer; nothing where they differ, or where it is not known."""
    return _agreed([end for end in ends if end.kind == EntityKind.PUBLISHER])


def qos_of_users(offered: Sequence[str], users: Sequence[Endpoint]) -> list[str]:
    """What subscriptions ask for, as far as it is not what is offered anyway."""
    asked = [word for word in _agreed(users) if word not in offered]
    return [" · ".join(asked)] if offered and asked else []


def _agreed(ends: Sequence[Endpoint]) -> list[str]:
    profiles = {tuple(_qos_words(end.qos)) if end.qos is not None else () for end in ends}
    return [*profiles.pop()] if len(profiles) == 1 else []


def _qos_words(qos: Qos) -> list[str]:
    words = [policy.replace("_", " ") for policy in (qos.reliability, qos.durability) if policy in _TOLD]
    if qos.history == "keep_all":
        words.append("keep all")
    elif qos.history == "keep_last" and qos.depth is not None:
        words.append(f"queue {qos.depth}")
    return words


_USUAL = ("reliable", "volatile")
"""The defaults of ROS, which are not worth a word."""
_TOLD = ("reliable", "best_effort", "volatile", "transient_local")

__all__ = ["qos_of_users", "qos_offered", "traffic_words"]
