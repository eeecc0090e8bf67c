"""Pauses behind a call that opens a device: it starts anew, and takes nothing in meanwhile."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.analysis.order import is_in_branch
from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from archlint.analysis.source_code import SourceCode
    from archlint.execution.sleeps import Stay
    from archlint.model import ApiCall

_SETTLED = 3.0
"""Seconds that a device takes at most: the boot loader of an Arduino waits for one or two, which opening its port
starts."""
_OPENS = re.compile(r"^_*(?:open|connect)$|^_*(?:open|connect|init)\w*_(?:port|serial|device|bus|uart)$|^Serial$")
"""``serial.Serial(…)``, ``self.port.open()``, ``self.open_serial_port()``, ``self._connect()``."""


def lets_settle(code: SourceCode, call: ApiCall, stay: Stay) -> bool:
    """Whether a short sleep, in no loop, follows on opening a device in the same block, to which a callback comes under
    a condition: so it is each time the device is plugged in, and without the pause it would not answer."""
    if (stay.seconds is not None and stay.seconds > _SETTLED) or call.loops:
        return False
    if not any(is_in_branch(code, place) for place in (*(frame.place for frame in call.chain), call.place)):
        return False
    return any(_opens(line) for line in _lines_before(code.body(call), call.place.span))


def _lines_before(body: Sequence[facts.Stmt], span: facts.Span) -> Iterator[facts.Stmt]:
    """The lines of the innermost block that holds a place, as far as they come before it."""
    for number, statement in enumerate(body):
        if covers(statement, span):
            blocks: Sequence[Sequence[facts.Stmt]] = getattr(statement, "blocks", ())
            inside = next((block for block in blocks if any(covers(inner, span) for inner in block)), None)
            yield from body[:number] if inside is None else _lines_before(inside, span)
            return


def _opens(line: facts.Stmt) -> bool:
    if not isinstance(line, (facts.Expression, facts.Assign)):
        return False
    return any(_OPENS.search(called_name(call) or "") for call in calls_in(line))


__all__ = ["lets_settle"]
