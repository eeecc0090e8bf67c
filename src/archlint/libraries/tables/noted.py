"""What rules want to see of calls that have no row: what code passes to them is followed as for any other call that is
not known here."""

from __future__ import annotations

from archlint.libraries.tables.api import Api
from archlint.libraries.tables.event_loops import NEED_A_LOOP

SYNCHRONIZERS = {
    api.path: api
    for api in (
        Api("message_filters.TimeSynchronizer", "fs queue_size", watched=True),
        Api("message_filters.ApproximateTimeSynchronizer", "fs queue_size slop allow_headerless", watched=True),
    )
}

TIMES = {"rclpy.time.Time": Api("rclpy.time.Time", "* seconds nanoseconds clock_type")}

NOTED = NEED_A_LOOP | SYNCHRONIZERS | TIMES

__all__ = ["NOTED", "SYNCHRONIZERS"]
