"""Rows of calls that hand a callback over, but for those that create what calls it."""

from __future__ import annotations

from archlint.libraries.tables.api import Api
from archlint.model import Role

ROWS = (
    *(
        Api(
            f"message_filters.{filter_}.registerCallback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", Role.FILTER),),
        )
        for filter_ in ("TimeSynchronizer", "ApproximateTimeSynchronizer", "Subscriber", "Cache")
    ),
    *(
        Api(
            f"rclpy.node.Node.add_{when}_set_parameters_callback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", Role.PARAMETER),),
        )
        for when in ("on", "post", "pre")
    ),
    *(
        Api(
            f"rclpy.parameter_event_handler.ParameterEventHandler.{name}",
            parameters,
            effect="callbacks",
            callbacks=(("callback", Role.EVENT),),
        )
        for name, parameters in (
            ("add_parameter_callback", "parameter_name node_name callback"),
            ("add_parameter_event_callback", "callback"),
        )
    ),
    Api(
        "rclpy.task.Future.add_done_callback",
        "callback",
        effect="callbacks",
        callbacks=(("callback", Role.DONE),),
        watched=True,
    ),
)

__all__ = ["ROWS"]
