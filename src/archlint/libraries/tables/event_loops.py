"""What needs the event loop of asyncio.  These are no rows: what code passes to them is followed as for any other call
that is not known here."""

from __future__ import annotations

from archlint.libraries.tables.api import Api

SLEEP = "asyncio.sleep"
LIMITS = "asyncio.wait_for"
STARTS = "asyncio.create_task"
"""Starts a coroutine, and is not awaited."""

NEED_A_LOOP = {
    api.path: api
    for api in (
        Api(SLEEP, "delay result", watched=True),
        Api(STARTS, "coro * name context", watched=True),
        *(
            Api(f"asyncio.{name}", watched=True)
            for name in (
                *("gather", "wait", "wait_for", "to_thread", "open_connection", "open_unix_connection"),
                *("start_server", "create_subprocess_exec", "create_subprocess_shell"),
            )
        ),
    )
}

__all__ = ["LIMITS", "NEED_A_LOOP", "SLEEP", "STARTS"]
