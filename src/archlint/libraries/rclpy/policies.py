"""The policies of a profile, and the durations in it."""

from __future__ import annotations

from archlint.interpreter.values import (
    External,
    Instance,
    Known,
    Value,
)
from archlint.libraries.rclpy import names as rclpy_names
from archlint.ros.qos import PolicyName, PolicyValue

_BY_NUMBER: dict[PolicyName, dict[int, PolicyValue]] = {
    "history": {0: "system_default", 1: "keep_last", 2: "keep_all"},
    "reliability": {0: "system_default", 1: "reliable", 2: "best_effort", 4: "best_available"},
    "durability": {0: "system_default", 1: "transient_local", 2: "volatile", 4: "best_available"},
    "liveliness": {0: "system_default", 1: "automatic", 3: "manual_by_topic", 5: "best_available"},
}
_BY_WORD: dict[PolicyName, dict[str, PolicyValue]] = {
    name: {value: value for value in by_number.values()} for name, by_number in _BY_NUMBER.items()
}
_NUMBER_OF_UNKNOWN: dict[PolicyName, int] = {"history": 3, "reliability": 3, "durability": 3, "liveliness": 4}
"""``HistoryPolicy.UNKNOWN`` is no policy, but as any member of these enums it is a number."""


def policy_by_name(path: str, name: object) -> External | None:
    """``ReliabilityPolicy["RELIABLE"]``: a policy by its name; None of what is no enum of rclpy's."""
    return External(f"{path}.{name.upper()}") if path.startswith("rclpy.qos.") and isinstance(name, str) else None


_POLICY_CLASSES: dict[str, PolicyName] = {
    "rclpy.qos.HistoryPolicy": "history",
    "rclpy.qos.ReliabilityPolicy": "reliability",
    "rclpy.qos.DurabilityPolicy": "durability",
    "rclpy.qos.LivelinessPolicy": "liveliness",
}


def policy_number(path: str) -> int | None:
    """The number of a policy's enum member, such as a parameter has it for a default; None for other names."""
    owner, _, member = rclpy_names.canonical(path.removesuffix(".value")).rpartition(".")
    name = _POLICY_CLASSES.get(owner)
    if owner == "rclcpp":  # RMW_QOS_POLICY_RELIABILITY_RELIABLE
        name = next((each for each in _BY_NUMBER if member.startswith(f"RMW_QOS_POLICY_{each.upper()}_")), None)
    if name is None:
        return None
    word = _word(name, path)
    if word == "unknown":
        return _NUMBER_OF_UNKNOWN[name]
    return next((number for number, text in _BY_NUMBER[name].items() if text == word), None)


def policy(name: PolicyName, value: Value) -> PolicyValue | None:
    """The policy that an enum member, its number or its short key stands for."""
    match value:
        case External(path=path):
            return _BY_WORD[name].get(_word(name, path))
        case Known(value=int(number)):
            return _BY_NUMBER[name].get(number)
        case Known(value=str(text)):
            return _BY_WORD[name].get(text.lower())
    return None


def _word(name: PolicyName, path: str) -> str:
    """What an enum member is called, without what older releases put before it."""
    member = path.removesuffix(".value").rpartition(".")[2].upper()
    return member.removeprefix(f"RMW_QOS_POLICY_{name.upper()}_").lower()


_ENDLESS = 9223372036.0
"""Seconds of ``RMW_DURATION_INFINITE``, the most that a duration holds."""


def duration_seconds(value: Value) -> float | None:
    """Seconds of a ``Duration``, 0 for an endless one, which is no bound either; None where unknown."""
    match value:
        case External("rclpy.duration.Infinite"):
            return 0.0
        case Instance(cls=External(), arguments=given):
            total = 0.0
            for name, scale in (("seconds", 1.0), ("nanoseconds", 1e-9)):
                number = given[name].constant if name in given else 0.0
                if not isinstance(number, (int, float)):
                    return None
                total += number * scale
            return 0.0 if total >= _ENDLESS else total
    return None
