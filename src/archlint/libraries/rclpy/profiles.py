"""Quality of service: profiles as the code builds, shares and changes them.

Presets and defaults are those of rmw's ``qos_profiles.h`` and ``rclpy/qos.py``.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.values import (
    ClassValue,
    External,
    Instance,
    Known,
    OneOf,
    Unknown,
    Value,
    alternatives,
    one_of,
    via,
)
from archlint.libraries.rclpy import names as rclpy_names
from archlint.ros.qos import Qos

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.libraries.tables.api import DefaultQos

PROFILE = "rclpy.qos.QoSProfile"

DEFAULT = Qos()
SENSOR_DATA = Qos(depth=5, reliability="best_effort")
PARAMETERS = Qos(depth=1000)
STATUS = Qos(depth=1, durability="transient_local")
SYSTEM_DEFAULT = Qos("system_default", None, "system_default", "system_default")
BEST_AVAILABLE = Qos(reliability="best_available", durability="best_available", liveliness="best_available")
ROSOUT = Qos(depth=1000, durability="transient_local", lifespan=10.0)

PRESETS: dict[str, Qos] = {
    "sensor_data": SENSOR_DATA,
    "services_default": DEFAULT,
    "parameters": PARAMETERS,
    "parameter_events": PARAMETERS,
    "action_status_default": STATUS,
    "rosout_default": ROSOUT,
    "system_default": SYSTEM_DEFAULT,
    "best_available": BEST_AVAILABLE,
    "default": DEFAULT,
}

_API_DEFAULTS: dict[DefaultQos, Qos] = {
    "": Qos(None, None, None, None),
    "services_default": DEFAULT,
    "default": DEFAULT,
    "1": Qos(depth=1),
    "parameter_events": PARAMETERS,
    "tf": Qos(depth=100),
    "tf_static": Qos(depth=1, durability="transient_local"),
    "tf_static_listener": Qos(depth=100, durability="transient_local"),
}

_UNKNOWN = Qos(None, None, None, None)

_POLICIES = ("history", "reliability", "durability", "liveliness")
_DURATIONS = {"deadline": "deadline", "lifespan": "lifespan", "liveliness_lease_duration": "liveliness_lease"}

_BY_NUMBER: dict[str, dict[int, str]] = {
    "history": {0: "system_default", 1: "keep_last", 2: "keep_all"},
    "reliability": {0: "system_default", 1: "reliable", 2: "best_effort", 4: "best_available"},
    "durability": {0: "system_default", 1: "transient_local", 2: "volatile", 4: "best_available"},
    "liveliness": {0: "system_default", 1: "automatic", 3: "manual_by_topic", 5: "best_available"},
}
_KNOWN_POLICIES = {
    "history": {"system_default", "keep_last", "keep_all"},
    "reliability": {"system_default", "reliable", "best_effort", "best_available"},
    "durability": {"system_default", "transient_local", "volatile", "best_available"},
    "liveliness": {"system_default", "automatic", "manual_by_topic", "best_available"},
}


def make_profile(run: Run, call: ApiUse) -> Value:
    """``QoSProfile(depth=10, reliability=…)``: an object whose attributes can still change."""
    place = run.place(call.expression.span) if call.expression is not None else None
    made = Instance(External(PROFILE), run.store.new_key(), place)
    for name, value in call.arguments.items():
        run.store.set(made.key, name, value)
    run.store.set(made.key, OPEN, call.open)
    return made


def preset_by_key(run: Run, call: ApiUse) -> Value:
    name = call.get("name")
    text = None if name is None else name.text
    if text is not None and text.lower() in PRESETS:
        return External(f"rclpy.qos.QoSPresetProfiles.{text.upper()}.value")
    return Unknown("the preset is chosen at run time")


def make_duration(run: Run, call: ApiUse) -> Value:
    return Instance(External("rclpy.duration.Duration"), run.store.new_key(), None, dict(call.arguments))


def preset(path: str) -> Qos | None:
    """The preset that a name of ``rclpy.qos`` stands for."""
    key = _preset_key(path)
    return PRESETS[key] if key is not None else None


def _preset_key(path: str) -> str | None:
    tail = path.removesuffix(".value").rpartition(".")[2]
    for prefix in ("qos_profile_", ""):
        key = tail.removeprefix(prefix).lower()
        if key in PRESETS and (path.startswith("rclpy.") or tail.startswith("qos_profile_")):
            return key
    return None


OPEN: Field[bool] = Field("more arguments than are known")
"""Whether a profile is made with arguments that are not known."""
PRESET: Field[Qos] = Field("preset")
"""The preset that a profile starts from."""
_CHANGES: Fields[Value] = Fields("policy of a preset", one_of)

_CHANGED = 0
"""The store's key for what a program has changed about the presets, which all its modules share."""


def policy_by_name(path: str, name: object) -> External | None:
    """``ReliabilityPolicy["RELIABLE"]``: a policy by its name; None of what is no enum of rclpy's."""
    return External(f"{path}.{name.upper()}") if path.startswith("rclpy.qos.") and isinstance(name, str) else None


def change_preset(run: Run, target: External, name: str, value: Value) -> None:
    """``qos_profile_sensor_data.reliability = …``: from now on the preset means something else.

    What a module does while it is imported holds in programs that import it and not in others, which the
    store does not tell apart: then the policy is unknown.
    """
    tail = _preset_key(rclpy_names.canonical(target.path))
    if tail is not None and name in (*_POLICIES, *_DURATIONS, "depth"):
        held = value if run.store.depth > 1 else Unknown("a module changes the preset when it is imported")
        run.store.set(_CHANGED, _CHANGES[f"{tail} {name}"], held)


def _changed(run: Run, value: Value) -> Value:
    """A preset that was changed, as a profile of its own; any other value as it is."""
    tail = _preset_key(rclpy_names.canonical(value.dotted)) if value.dotted else None
    changes = {
        name: held
        for name in (*_POLICIES, *_DURATIONS, "depth")
        if tail is not None and (held := run.store.get(_CHANGED, _CHANGES[f"{tail} {name}"])) is not None
    }
    if tail is None or not changes:
        return value
    made = Instance(External(PROFILE), run.store.new_key())
    run.store.set(made.key, PRESET, PRESETS[tail])
    for name, held in changes.items():
        run.store.set(made.key, name, held)
    return made


def resolve(run: Run, value: Value | None, default: DefaultQos, call: ApiUse) -> Qos:
    """The profile that an argument gives, with the API's default where none is given."""
    if value is None or value.is_none:
        found = _UNKNOWN if call.open else _API_DEFAULTS[default]
    else:
        found = _of_value(run, value)
    if call.get("qos_overriding_options") not in (None, Known(None)):
        found = replace(found, overridable=True)
    return found


PROFILE_ALTERNATIVES = 8
"""How many profiles one argument may stand for before only what they share is kept."""


def resolve_all(run: Run, value: Value | None, default: DefaultQos, call: ApiUse) -> list[Qos]:
    """The profiles that an argument may give: several where a branch decides, or one."""
    found: list[Qos] = []
    for option in alternatives(value) if value is not None else ():
        for variant in _variants(run, option):
            profile = resolve(run, variant, default, call)
            if profile not in found:
                found.append(profile)
    return found if 0 < len(found) <= PROFILE_ALTERNATIVES else [resolve(run, value, default, call)]


def _variants(run: Run, value: Value) -> list[Value]:
    """A profile whose policies depend on a branch, as one profile for each choice."""
    value = _changed(run, value)
    if not isinstance(value, Instance) or rclpy_names.canonical(value.cls.dotted) != PROFILE:
        return [value]
    rows: list[dict[str, Value]] = [{}]
    for name in (*_POLICIES, "depth"):
        held = run.store.get(value.key, name)
        if isinstance(held, OneOf):
            rows = [{**row, name: option} for row in rows for option in held.values]
            if len(rows) > PROFILE_ALTERNATIVES:
                return [value]
    if rows == [{}]:
        return [value]
    made: list[Value] = []
    for row in rows:
        variant = _copy_of(run, value)
        for name, option in row.items():
            run.store.set(variant.key, name, option)
        made.append(variant)
    return made


def _of_value(run: Run, value: Value) -> Qos:
    value = _changed(run, value)
    match value:
        case Known(value=bool()):
            return _UNKNOWN
        case Known(value=int(depth), via=parameters):
            return Qos(depth=depth, explicit=frozenset({"depth"}), parameter=",".join(sorted(parameters)) or None)
        case External(path=path):
            return preset(rclpy_names.canonical(path)) or _UNKNOWN
        case Instance(cls=External(path=path)) if rclpy_names.canonical(path) == PROFILE:
            return _of_profile(run, value)
        case Instance(cls=ClassValue()):
            held = value.member_value(run)  # an enum of profiles
            if held is not None:
                return _of_value(run, held)
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
    unknown: set[str] = set()
    # rclpy fills what is not given from the default profile: keep last, 10, reliable, volatile.
    for name in _POLICIES:
        value = run.store.get(profile.key, name)
        if value is not None:
            explicit.add(name)
            parameters |= via(value)
            fields[name] = policy(name, value)
    depth = run.store.get(profile.key, "depth")
    if depth is not None:
        explicit.add("depth")
        parameters |= via(depth)
        number = depth.whole_number
        fields["depth"] = None if isinstance(number, bool) else number
    for name, field in _DURATIONS.items():
        value = run.store.get(profile.key, name)
        if value is not None:
            explicit.add(name)
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


_POLICY_CLASSES = {
    "rclpy.qos.HistoryPolicy": "history",
    "rclpy.qos.ReliabilityPolicy": "reliability",
    "rclpy.qos.DurabilityPolicy": "durability",
    "rclpy.qos.LivelinessPolicy": "liveliness",
}


def policy_number(path: str) -> int | None:
    """The number of a policy's enum member, such as a parameter has it for a default; None for other names."""
    owner, _, member = rclpy_names.canonical(path.removesuffix(".value")).rpartition(".")
    name = _POLICY_CLASSES.get(owner)
    if name is None:
        return None
    wanted = policy(name, External(f"{owner}.{member}"))
    return next((number for number, text in _BY_NUMBER[name].items() if text == wanted), None)


def policy(name: str, value: Value) -> str | None:
    """The policy that an enum member, its number or its short key stands for."""
    match value:
        case External(path=path):
            tail = path.removesuffix(".value").rpartition(".")[2].upper()
            tail = tail.removeprefix(f"RMW_QOS_POLICY_{name.upper()}_").lower()
            return tail if tail in _KNOWN_POLICIES[name] else None
        case Known(value=int(number)):
            return _BY_NUMBER[name].get(number)
        case Known(value=str(text)) if text.lower() in _KNOWN_POLICIES[name]:
            return text.lower()
    return None


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


def copy_profile(run: Run, value: Value) -> Value:
    """A copy of a profile: its own object, or an object made from a preset."""
    value = _changed(run, value)
    if isinstance(value, Instance):
        return _copy_of(run, value)
    known = preset(rclpy_names.canonical(value.dotted)) if value.dotted else None
    if known is None:
        return value
    made = Instance(External(PROFILE), run.store.new_key())
    run.store.set(made.key, PRESET, known)
    return made


def _copy_of(run: Run, value: Instance) -> Instance:
    made = Instance(value.cls, run.store.new_key(), value.place, value.arguments)
    run.store.set(made.key, OPEN, run.store.get(value.key, OPEN) or False)
    copied = run.store.get(value.key, PRESET)
    if copied is not None:
        run.store.set(made.key, PRESET, copied)
    for name in ("depth", *_POLICIES, *_DURATIONS):
        held = run.store.get(value.key, name)
        if held is not None:
            run.store.set(made.key, name, held)
    return made
