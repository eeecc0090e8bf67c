"""The profiles that rclpy offers by name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    External,
    Unknown,
    Value,
)
from archlint.ros.qos import Qos

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run
    from archlint.libraries.tables.api import DefaultQos

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

API_DEFAULTS: dict[DefaultQos, Qos] = {
    "": Qos(None, None, None, None),
    "services_default": DEFAULT,
    "default": DEFAULT,
    "1": Qos(depth=1),
    "parameter_events": PARAMETERS,
    "tf": Qos(depth=100),
    "tf_static": Qos(depth=1, durability="transient_local"),
    "tf_static_listener": Qos(depth=100, durability="transient_local"),
}


def preset_by_key(run: Run, call: ApiUse) -> Value:
    name = call.get("name")
    text = None if name is None else name.text
    if text is not None and text.lower() in PRESETS:
        return External(f"rclpy.qos.QoSPresetProfiles.{text.upper()}.value")
    return Unknown("the preset is chosen at run time")


def preset(path: str) -> Qos | None:
    """The preset that a name of ``rclpy.qos`` stands for."""
    key = preset_key(path)
    return PRESETS[key] if key is not None else None


def preset_key(path: str) -> str | None:
    tail = path.removesuffix(".value").rpartition(".")[2]
    for prefix in ("qos_profile_", ""):
        key = tail.removeprefix(prefix).lower()
        if key in PRESETS and (path.startswith("rclpy.") or tail.startswith("qos_profile_")):
            return key
    return None
