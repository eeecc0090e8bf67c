"""PRM002: limits of joints that MoveIt reads as doubles."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from archlint.finding import Finding

LIMITS = """\
default_velocity_scaling_factor: 1
joint_limits:
  elbow:
    has_velocity_limits: {has}
    max_velocity: {speed}
    max_acceleration: 0
"""
ASSISTANT = {".setup_assistant": "moveit_setup_assistant_config:\n  urdf: {package: robot}\n"}
Findings = Callable[..., list[Finding]]


def test_an_integer_that_is_read(findings: Findings):
    (told,) = findings("PRM002", **ASSISTANT, **{"config/joint_limits.yaml": LIMITS.format(has="true", speed="3")})
    assert told.message == "MoveIt declares 'elbow.max_velocity' as double, and this sets 3, of type integer"
    assert (told.place.file, told.place.line) == ("config/joint_limits.yaml", 5)


def test_the_ends_of_a_range_are_always_read(findings: Findings):
    limits = LIMITS.format(has="false", speed="3") + "    max_position: 2\n    min_position: -2\n"
    (told,) = findings("PRM002", **ASSISTANT, **{"config/joint_limits.yaml": limits})
    assert told.message.startswith("MoveIt declares 'elbow.max_position' as double, and this sets 2, of type integer; ")


@pytest.mark.parametrize(
    ("has", "speed"), [("true", "3.0"), ("false", "3"), ("true", "!degrees 180"), ("true", "3\n  - wrong")]
)
def test_what_is_right_or_not_read(findings: Findings, has: str, speed: str):
    limits = LIMITS.format(has=has, speed=speed)
    assert findings("PRM002", **ASSISTANT, **{"config/joint_limits.yaml": limits}) == []


@pytest.mark.parametrize(
    ("path", "more"), [("config/joint_limits.yaml", {}), ("config/arm/joint_limits.yaml", ASSISTANT)]
)
def test_a_file_for_something_else(findings: Findings, path: str, more: dict[str, str]):
    assert findings("PRM002", **more, **{path: LIMITS.format(has="true", speed="3")}) == []
