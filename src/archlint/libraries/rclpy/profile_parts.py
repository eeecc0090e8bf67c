"""What the run keeps of a profile."""

from __future__ import annotations

from typing import Final

from archlint.interpreter.fields import Field
from archlint.ros.qos import BoundName, PolicyName, Qos

PROFILE = "rclpy.qos.QoSProfile"

POLICIES: Final[tuple[PolicyName, ...]] = ("history", "reliability", "durability", "liveliness")
DURATIONS: Final[dict[str, BoundName]] = {
    "deadline": "deadline",
    "lifespan": "lifespan",
    "liveliness_lease_duration": "liveliness_lease",
}


OPEN: Field[bool] = Field("more arguments than are known")
"""Whether a profile is made with arguments that are not known."""
PRESET: Field[Qos] = Field("preset")
"""The preset that a profile starts from."""
