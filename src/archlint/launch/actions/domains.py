"""Which DDS domain a process is started in: nodes of different domains do not see each other.

Source: rcl reads ``ROS_DOMAIN_ID`` from the environment of the process; launch gives it the environment of the
context, or ``env=`` instead of it, with ``additional_env=`` on top.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.launch.objects import LaunchObject

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.launch.run import LaunchRun

VARIABLE = "ROS_DOMAIN_ID"


def domain_of(run: LaunchRun, entity: LaunchObject) -> str | None:
    """The domain of the process that an action starts; None for that of whoever starts the launch file."""
    value = environment_of(run, entity).get(VARIABLE)
    return None if value is None else run.domains.named(value)


def environment_of(run: LaunchRun, entity: LaunchObject) -> dict[str, Value]:
    """What is known of the environment of the process that an action starts."""
    environment = dict(run.launch.environment)
    for name in ("env", "additional_env"):
        for key, value in run.entries(entity.argument(name)):
            variable = run.text_of(key)
            if variable is not None:
                environment[variable] = run.perform(value)
    return environment
