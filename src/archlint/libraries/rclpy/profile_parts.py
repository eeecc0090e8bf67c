"""What the run keeps of a profile."""

from __future__ import annotations

from archlint.interpreter.fields import Field
from archlint.ros.qos import Qos

PROFILE = "rclpy.qos.QoSProfile"

POLICIES = ("history", "reliability", "durability", "liveliness")
DURATIONS = {"deadline": "deadline", "lifespan": "lifespan", "liveliness_lease_duration": "liveliness_lease"}


OPEN: Field[bool] = Field("more arguments than are known")
"""Whether a profile is made with arguments that are not known."""
PRESET: Field[Qos] = Field("preset")
"""The preset that a profile starts from."""
