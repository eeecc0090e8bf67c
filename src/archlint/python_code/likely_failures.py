"""What of a ``try`` can be expected to fail: most calls, but not those that only read a clock or join a path."""

from __future__ import annotations

from collections.abc import Collection
from itertools import chain

from archlint.python_code.block_bindings import after
from archlint.syntax import facts
from archlint.syntax.flow_blocks import Block
from archlint.syntax.parts import parts_of

_HARDLY_FAIL = frozenset(
    {
        *("datetime.datetime.now", "datetime.now", "time.monotonic", "time.perf_counter", "time.time"),
        *("os.getcwd", "os.getpid", "os.path.abspath", "os.path.basename", "os.path.dirname", "os.path.exists"),
        *("os.path.expanduser", "os.path.isdir", "os.path.isfile", "os.path.join", "os.path.realpath"),
        *("Path", "pathlib.Path", "print", "repr", "socket", "socket.socket", "str", "threading.Event"),
        *("threading.Lock", "threading.Thread"),
    }
)
"""Functions and classes that no ``except`` is written for: what is done with their results is what fails."""
_HARDLY_FAIL_WITHOUT_ARGUMENTS = frozenset({"absolute", "get_clock", "get_logger", "now", "resolve", "to_msg"})
"""Methods of which the same is true: those of a path do not ask whether it exists, since Python 3.6."""


def failing_before(assigning: Collection[Block], tried: Collection[Block]) -> int | None:
    """The line of a ``try`` that can fail before some of its blocks have assigned a variable: theirs, if it can; None
    where nothing is likely to, or only what stands behind."""
    later = after(assigning)
    last = [part for block in assigning for part in _what_may_fail(block)]
    first = [part for block in tried if block not in later and block not in assigning for part in _what_may_fail(block)]
    behind = (part for block in tried if block in later and block not in assigning for part in _what_may_fail(block))
    if all(_makes_an_empty_one(part) for part in chain(first, last)) and any(behind):
        return None
    lines = [part.span[0] for part in last or first]
    return max(lines, default=None)


def _what_may_fail(block: Block) -> list[facts.Call | facts.Subscript | facts.Await]:
    parts = () if block.fact is None else parts_of(block.fact)
    kinds = (facts.Call, facts.Subscript, facts.Await)
    return [part for part in parts if isinstance(part, kinds) and not _hardly_fails(part)]


def _hardly_fails(part: facts.Base) -> bool:
    if not isinstance(part, facts.Call):
        return False
    return part.func.dotted in _HARDLY_FAIL or (not part.args and part.func.last_name in _HARDLY_FAIL_WITHOUT_ARGUMENTS)


def _makes_an_empty_one(part: facts.Base) -> bool:
    """Whether a call makes an object without saying anything of it, such as a message."""
    return isinstance(part, facts.Call) and not part.args and part.func.last_name[:1].isupper()


__all__ = ["failing_before"]
