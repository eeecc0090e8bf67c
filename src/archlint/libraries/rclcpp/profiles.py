"""Quality of service as C++ builds it: ``rclcpp::QoS(10).best_effort()``, ``rclcpp::SensorDataQoS()``.

What they make is a profile of rclpy's.  Source: ``rclcpp/qos.hpp`` and ``qos.cpp``; each setter changes the profile and
gives it back.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Known, Unknown, Value
from archlint.libraries.rclpy.changed_profiles import copy_of, copy_profile, is_profile
from archlint.libraries.rclpy.presets import BEST_AVAILABLE, DEFAULT, PARAMETERS, ROSOUT, SENSOR_DATA, SYSTEM_DEFAULT
from archlint.libraries.rclpy.profile_parts import OPEN, PRESET, PROFILE
from archlint.ros.qos import CLOCK, Qos

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Method, Plain
    from archlint.libraries.run import Run

_PRESETS = {
    "SensorDataQoS": SENSOR_DATA,
    "ServicesQoS": DEFAULT,
    "ParametersQoS": PARAMETERS,
    "ParameterEventsQoS": PARAMETERS,
    "RosoutQoS": ROSOUT,
    "SystemDefaultsQoS": SYSTEM_DEFAULT,
    "ClockQoS": CLOCK,
    "BestAvailableQoS": BEST_AVAILABLE,
}


def _new(run: Run, site: CallSite, base: Qos | None = None) -> Instance:
    place = run.place(site.expression.span) if site.expression is not None and run.activations else None
    instance = Instance(External(PROFILE), run.store.new_key(), place)
    if base is not None:
        run.store.set(instance.key, PRESET, base)
    return instance


def _keep_last(run: Run, site: CallSite) -> Value:
    profile = _new(run, site)
    run.store.set(profile.key, "history", Known("keep_last"))
    run.store.set(profile.key, "depth", site.args[0] if site.args else Unknown("no depth is given"))
    return profile


def _keep_all(run: Run, site: CallSite) -> Value:
    profile = _new(run, site)
    _keep_everything(run, profile)
    return profile


def _keep_everything(run: Run, profile: Instance) -> None:
    run.store.set(profile.key, "history", Known("keep_all"))
    run.store.set(profile.key, "depth", Known(0))  # whatever it was before: ``QoS::keep_all()`` of rclcpp's qos.cpp


def _profile(run: Run, site: CallSite) -> Value:
    """``QoS(depth)``, ``QoS(KeepLast(depth))``, ``QoS(…, rmw_qos_profile_…)``, ``QoS(other)``, which copies."""
    start = site.args[1] if len(site.args) > 1 else None
    if start is None and site.args and isinstance(site.args[0], Instance) and is_profile(site.args[0]):
        return copy_of(run, site.args[0])
    profile = _new(run, site)
    if start is not None:
        copied = copy_profile(run, start)
        if not isinstance(copied, Instance):
            run.store.set(profile.key, OPEN, True)
            return profile
        profile = copied
    _start_with(run, profile, site.args[0] if site.args else None)
    return profile


def _start_with(run: Run, profile: Instance, given: Value | None) -> None:
    """The history and depth that a constructor is given."""
    if given is None:
        return
    if isinstance(given, Instance) and is_profile(given):
        for name in ("history", "depth"):
            value = run.store.get(given.key, name)
            if value is not None:
                run.store.set(profile.key, name, value)
    elif given.whole_number is not None or not isinstance(given, (Instance, External)):
        run.store.set(profile.key, "depth", given)
    else:
        run.store.set(profile.key, OPEN, True)


def _preset(base: Qos) -> Plain:
    def make(run: Run, site: CallSite) -> Value:
        profile = _new(run, site, base)
        _start_with(run, profile, site.args[0] if site.args else None)
        return profile

    return make


def _initialization(run: Run, site: CallSite) -> Value:
    """``QoSInitialization(history, depth)``."""
    profile = _new(run, site)
    if len(site.args) < 2:
        run.store.set(profile.key, OPEN, True)
        return profile
    run.store.set(profile.key, "history", _spelt(site.args[0]))
    run.store.set(profile.key, "depth", site.args[1])
    return profile


def _from_rmw(run: Run, site: CallSite) -> Value:
    """The history and depth of a profile; its other policies are not taken over."""
    profile = copy_profile(run, site.args[0]) if site.args else Unknown("no profile is given")
    if not isinstance(profile, Instance) or not is_profile(profile):
        return profile
    start, preset = _new(run, site), run.store.get(profile.key, PRESET)
    if preset is not None:
        run.store.set(start.key, "history", Known(preset.history))
        run.store.set(start.key, "depth", Known(preset.depth))
    _start_with(run, start, profile)
    return start


PLAIN: dict[str, Plain] = {
    "rclcpp.QoS": _profile,
    "rclcpp.KeepLast": _keep_last,
    "rclcpp.KeepAll": _keep_all,
    "rclcpp.QoSInitialization": _initialization,
    "rclcpp.QoSInitialization.from_rmw": _from_rmw,
    **{f"rclcpp.{name}": _preset(base) for name, base in _PRESETS.items()},
}


def _sets(name: str, constant: str | None = None) -> Method:
    """A setter: of a constant, or of its argument."""

    def set_policy(run: Run, receiver: Value, site: CallSite) -> Value:
        if not isinstance(receiver, Instance):
            return receiver
        value: Value = Known(constant) if constant is not None else site.args[0] if site.args else Unknown("no policy")
        run.store.set(receiver.key, name, _spelt(value))
        return receiver

    return set_policy


_CAMEL = re.compile(r"(?<=[a-z])(?=[A-Z])")
_OF_RMW = re.compile(r"^RMW_QOS_POLICY_[A-Z]+_")


def _spelt(value: Value) -> Value:
    """``rclcpp::ReliabilityPolicy::BestEffort``, ``RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT`` as rclpy spells them."""
    if isinstance(value, External) and value.path.startswith("rclcpp."):
        word = _OF_RMW.sub("", value.path.rpartition(".")[2])
        return Known(_CAMEL.sub("_", word).lower())
    return value


def _set_keep_last(run: Run, receiver: Value, site: CallSite) -> Value:
    _sets("history", "keep_last")(run, receiver, site)
    return _sets("depth")(run, receiver, site)


def _set_keep_all(run: Run, receiver: Value, site: CallSite) -> Value:
    if isinstance(receiver, Instance):
        _keep_everything(run, receiver)
    return receiver


def _unchanged(run: Run, receiver: Value, site: CallSite) -> Value:
    return receiver


def _endless(name: str) -> Method:
    """A duration: one that is not known, for C++ has many ways to write it."""

    def set_duration(run: Run, receiver: Value, site: CallSite) -> Value:
        if isinstance(receiver, Instance):
            given = site.args[0] if site.args else Unknown("no duration")
            known = isinstance(given, Instance) and given.cls.dotted == "rclpy.duration.Duration"
            run.store.set(receiver.key, name, given if known else Unknown("a duration of C++"))
        return receiver

    return set_duration


METHODS: dict[str, Method] = {
    f"{PROFILE}.{name}": method
    for name, method in {
        "keep_last": _set_keep_last,
        "keep_all": _set_keep_all,
        "reliable": _sets("reliability", "reliable"),
        "best_effort": _sets("reliability", "best_effort"),
        "reliability_best_available": _sets("reliability", "best_available"),
        "transient_local": _sets("durability", "transient_local"),
        "durability_volatile": _sets("durability", "volatile"),
        "durability_best_available": _sets("durability", "best_available"),
        "with_history": _sets("history"),
        "with_reliability": _sets("reliability"),
        "with_durability": _sets("durability"),
        "with_liveliness": _sets("liveliness"),
        "with_deadline": _endless("deadline"),
        "with_lifespan": _endless("lifespan"),
        "liveliness_lease_duration": _endless("liveliness_lease_duration"),
        "avoid_ros_namespace_conventions": _unchanged,
    }.items()
}

__all__ = ["METHODS", "PLAIN"]
