"""Pauses that a callback makes on purpose: for the answer of a device, or where nothing has arrived yet."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import covers
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import is_none, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_SENDS = frozenset({"write", "sendall", "send"})
_RECEIVES = re.compile(r"read\w*|recv\w*|in_waiting|inWaiting")


def is_for_an_answer(code: SourceCode, call: ApiCall) -> bool:
    """Whether a sleep is in a function, but in no loop, that writes to a device before and reads what it answers
    afterwards: ``self.port.write(b'AT')`` … ``self.port.read(10)``."""
    body = code.body(call)
    uses = [(part.value.dotted, part.attr, part.span[0]) for part in everything_in(body, facts.Attribute)]
    sent = {device for device, name, line in uses if name in _SENDS and line < call.place.line}
    heard = {device for device, name, line in uses if _RECEIVES.fullmatch(name) and line > call.place.line}
    return not call.loops and not sent.isdisjoint(heard - {None, ""})


def is_for_what_has_not_arrived(code: SourceCode, call: ApiCall) -> bool:
    """Whether a sleep is in a branch that is left by ``return`` at its end, for the case that nothing has arrived yet:
    ``if self.scan is None: …``."""
    for check in statements_of(code.body(call), facts.If):
        block = check.body
        if block and isinstance(block[-1], facts.Return) and any(covers(line, call.place.span) for line in block):
            return _asks_for_nothing(check.test)
    return False


def _asks_for_nothing(test: facts.Expr) -> bool:
    match test:
        case facts.Compare(ops=["is"], comparators=[other]):
            return is_none(other)
        case facts.Boolean(values=values):
            return all(map(_asks_for_nothing, values))
    return False


__all__ = ["is_for_an_answer", "is_for_what_has_not_arrived"]
