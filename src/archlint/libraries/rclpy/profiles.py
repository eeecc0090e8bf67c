"""Quality of service: profiles as the code builds, shares and changes them.

Presets and defaults are those of rmw's ``qos_profiles.h`` and ``rclpy/qos.py``.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.interpreter.values import (
    ClassValue,
    External,
    Instance,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    via,
)
from archlint.libraries.rclpy import names as rclpy_names
from archlint.libraries.rclpy.changed_profiles import as_changed, copy_of
from archlint.libraries.rclpy.policies import duration_seconds, policy, policy_number
from archlint.libraries.rclpy.presets import API_DEFAULTS, DEFAULT, preset
from archlint.libraries.rclpy.profile_parts import DURATIONS, OPEN, POLICIES, PRESET, PROFILE
from archlint.ros.qos import BoundName, Qos

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.libraries.tables.api import DefaultQos

_UNKNOWN = Qos(None, None, None, None)


def make_profile(run: Run, call: ApiUse) -> Value:
    """``QoSProfile(depth=10, reliability=…)``: an object whose attributes can still change."""
    place = run.place(call.expression.span) if call.expression is not None else None
    instance = Instance(External(PROFILE), run.store.new_key(), place)
    for name, value in call.arguments.items():
        run.store.set(instance.key, name, value)
    run.store.set(instance.key, OPEN, call.open)
    return instance


def make_duration(run: Run, call: ApiUse) -> Value:
    return Instance(External("rclpy.duration.Duration"), run.store.new_key(), None, dict(call.arguments))


def resolve(run: Run, value: Value | None, default: DefaultQos, call: ApiUse) -> Qos:
    """The profile that an argument gives, with the API's default where none is given."""
    if value is None or value.is_none:
        qos = _UNKNOWN if call.open else API_DEFAULTS[default]
    else:
        qos = _of_value(run, value)
    if call.get("qos_overriding_options") not in (None, Known(None)):
        qos = replace(qos, overridable=True)
    return qos


PROFILE_ALTERNATIVES = 8
"""How many profiles one argument may stand for before only what they share is kept."""


def resolve_all(run: Run, value: Value | None, default: DefaultQos, call: ApiUse) -> list[Qos]:
    """The profiles that an argument may give: several where a branch decides, or one."""
    profiles: list[Qos] = []
    for option in alternatives(value) if value is not None else ():
        for variant in _variants(run, option):
            profile = resolve(run, variant, default, call)
            if profile not in profiles:
                profiles.append(profile)
    return profiles if 0 < len(profiles) <= PROFILE_ALTERNATIVES else [resolve(run, value, default, call)]


def _variants(run: Run, value: Value) -> list[Value]:
    """A profile whose policies depend on a branch, as one profile for each choice."""
    value = as_changed(run, value)
    if not isinstance(value, Instance) or rclpy_names.canonical(value.cls.dotted) != PROFILE:
        return [value]
    rows: list[dict[str, Value]] = [{}]
    for name in (*POLICIES, "depth"):
        setting = run.store.get(value.key, name)
        if isinstance(setting, OneOf):
            rows = [{**row, name: option} for row in rows for option in setting.values]
            if len(rows) > PROFILE_ALTERNATIVES:
                return [value]
    if rows == [{}]:
        return [value]
    values: list[Value] = []
    for row in rows:
        variant = copy_of(run, value)
        for name, option in row.items():
            run.store.set(variant.key, name, option)
        values.append(variant)
    return values


def _of_value(run: Run, value: Value) -> Qos:
    value = as_changed(run, value)
    match value:
        case Known(value=bool()):
            return _UNKNOWN
        case Known(value=int(depth), via=parameters):
            return Qos(depth=depth, explicit=frozenset({"depth"}), parameter=",".join(sorted(parameters)) or None)
        case External(path=path):
            number = policy_number(path)
            if number is not None:
                return Qos(depth=number, explicit=frozenset({"depth"}))
            return preset(rclpy_names.canonical(path)) or _UNKNOWN
        case Instance(cls=External(path=path)) if rclpy_names.canonical(path) == PROFILE:
            return _of_profile(run, value)
        case Instance(cls=ClassValue()):
            member = value.member_value(run)  # an enum of profiles
            if member is not None:
                return _of_value(run, member)
        case OneOf(values=options):
            return _common([_of_value(run, option) for option in options])
        case Unknown(parameter=str(parameter)):
            return replace(_UNKNOWN, parameter=parameter)
    return _UNKNOWN


def _common(profiles: list[Qos]) -> Qos:
    """What several possible profiles agree in."""
    first = profiles[0]

    def same(name: str) -> Any:
        values = {getattr(profile, name) for profile in profiles}
        return values.pop() if len(values) == 1 else None

    return replace(
        first,
        history=same("history"),
        depth=same("depth"),
        reliability=same("reliability"),
        durability=same("durability"),
        liveliness=same("liveliness"),
        explicit=frozenset.intersection(*(profile.explicit for profile in profiles)),
        unknown_durations=frozenset({"deadline", "lifespan", "liveliness_lease"})
        if len({(p.deadline, p.lifespan, p.liveliness_lease) for p in profiles}) > 1
        else first.unknown_durations,
    )


def _of_profile(run: Run, profile: Instance) -> Qos:
    if run.store.get(profile.key, OPEN):
        return _UNKNOWN
    copied = run.store.get(profile.key, PRESET)
    base = copied or DEFAULT
    explicit: set[str] = set(base.explicit)
    fields: dict[str, object] = {}
    parameters: set[str] = set()
    unknown: set[BoundName] = set()
    # rclpy fills what is not given from the default profile: keep last, 10, reliable, volatile.
    for name in POLICIES:
        value = run.store.get(profile.key, name)
        if value is not None:
            explicit.add(name)
            parameters |= via(value)
            fields[name] = policy(name, value)
    depth = run.store.get(profile.key, "depth")
    if depth is not None:
        explicit.add("depth")
        parameters |= via(depth)
        fields["depth"] = _depth(depth)
    for duration, field in DURATIONS.items():
        value = run.store.get(profile.key, duration)
        if value is not None:
            explicit.add(duration)
            seconds = duration_seconds(value)
            if seconds is None:
                unknown.add(field)
            else:
                fields[field] = seconds or None
    result = replace(
        base,
        explicit=frozenset(explicit),
        unknown_durations=frozenset(unknown),
        parameter=",".join(sorted(parameters)) or None,
        place=profile.place,
    )
    return replace(result, **fields)  # type: ignore[arg-type]


def _depth(value: Value) -> int | None:
    """The number that a depth is; a policy given in its place is one, too."""
    number = policy_number(value.path) if isinstance(value, External) else value.whole_number
    return None if isinstance(number, bool) else number
