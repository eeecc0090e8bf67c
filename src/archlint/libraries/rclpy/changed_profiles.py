"""Profiles that code changes or copies."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.fields import Fields
from archlint.interpreter.values import (
    External,
    Instance,
    Unknown,
    Value,
    one_of,
)
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.rclpy.presets import PRESETS, preset, preset_key
from archlint.libraries.rclpy.profile_parts import DURATIONS, OPEN, POLICIES, PRESET, PROFILE

if TYPE_CHECKING:
    from archlint.libraries.run import Run
_CHANGES: Fields[Value] = Fields("policy of a preset", one_of)

_CHANGED = 0
"""The store's key for what a program has changed about the presets, which all its modules share."""


def change_preset(run: Run, target: External, name: str, value: Value) -> None:
    """``qos_profile_sensor_data.reliability = …``: from now on the preset means something else.

    What a module does while it is imported holds in programs that import it and not in others, which the
    store does not distinguish: then the policy is unknown.
    """
    tail = preset_key(rclpy_names.canonical(target.path))
    if tail is not None and name in (*POLICIES, *DURATIONS, "depth"):
        policy = value if run.store.depth > 1 else Unknown("a module changes the preset when it is imported")
        run.store.set(_CHANGED, _CHANGES[f"{tail} {name}"], policy)


def as_changed(run: Run, value: Value) -> Value:
    """A preset that was changed, as a profile of its own; any other value as it is."""
    tail = preset_key(rclpy_names.canonical(value.dotted)) if value.dotted else None
    changes = {
        name: policy
        for name in (*POLICIES, *DURATIONS, "depth")
        if tail is not None and (policy := run.store.get(_CHANGED, _CHANGES[f"{tail} {name}"])) is not None
    }
    if tail is None or not changes:
        return value
    instance = Instance(External(PROFILE), run.store.new_key())
    run.store.set(instance.key, PRESET, PRESETS[tail])
    for name, policy in changes.items():
        run.store.set(instance.key, name, policy)
    return instance


def copy_profile(run: Run, value: Value) -> Value:
    """A copy of a profile: its own object, or an object made from a preset."""
    value = as_changed(run, value)
    if isinstance(value, Instance):
        return copy_of(run, value)
    known = preset(rclpy_names.canonical(value.dotted)) if value.dotted else None
    if known is None:
        return value
    instance = Instance(External(PROFILE), run.store.new_key())
    run.store.set(instance.key, PRESET, known)
    return instance


def is_profile(value: Instance) -> bool:
    """Whether an object is a profile of QoS, under whichever name its class is imported."""
    return rclpy_names.canonical(value.cls.dotted) == PROFILE


def copy_of(run: Run, value: Instance) -> Instance:
    instance = Instance(value.cls, run.store.new_key(), value.place, value.arguments)
    run.store.set(instance.key, OPEN, run.store.get(value.key, OPEN) or False)
    copied = run.store.get(value.key, PRESET)
    if copied is not None:
        run.store.set(instance.key, PRESET, copied)
    for name in ("depth", *POLICIES, *DURATIONS):
        policy = run.store.get(value.key, name)
        if policy is not None:
            run.store.set(instance.key, name, policy)
    return instance
