"""Rows of calls that hand a callback over, but for those that create what calls it."""

from __future__ import annotations

from archlint.libraries.tables.api import Api

ROWS = (
    *(
        Api(
            f"message_filters.{filter_}.registerCallback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", "filter"),),
        )
        for filter_ in ("TimeSynchronizer", "ApproximateTimeSynchronizer", "Subscriber", "Cache")
    ),
    *(
        Api(
            f"rclpy.node.Node.add_{when}_set_parameters_callback",
            "callback",
            effect="callbacks",
            callbacks=(("callback", "parameter"),),
        )
        for when in ("on", "post", "pre")
    ),
    Api(
        "rclpy.task.Future.add_done_callback",
        "callback",
        effect="callbacks",
        callbacks=(("callback", "done"),),
        watched=True,
    ),
)

__all__ = ["ROWS"]
