"""How long a call keeps its thread, as far as that is known."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from archlint.analysis.reach import argument
from archlint.execution.bounds import most
from archlint.libraries import tables
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import names_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall
    from archlint.model.given import Given

SLEEP = "time.sleep"
_INPUT = "builtins.input"
_WAITS = {
    "rclpy.client.Client.wait_for_service": "timeout_sec",
    "rclpy.action.client.ActionClient.wait_for_server": "timeout_sec",
    "rclpy.parameter_client.AsyncParameterClient.wait_for_services": "timeout_sec",
    "rclpy.node.Node.wait_for_node": "timeout",
}
_WAIT_FOR_MESSAGE = "rclpy.wait_for_message.wait_for_message"

_IO_CALLS = frozenset(row.path for row in tables.ROWS if row.waits_for_io)
_LOCKS = ("fcntl.flock", "fcntl.lockf")
_NETWORK = ("urllib.", "requests.", "socket.")


StayKind = Literal["sleep", "discovery", "network", "process", "message", "lock", "keyboard"]
"""What a call that keeps its thread waits for."""


@dataclass(frozen=True)
class Stay:
    """A call that keeps its thread.

    ``seconds`` is None where that is not known.
    """

    kind: StayKind
    seconds: float | None
    words: str


def stay_of(code: SourceCode, call: ApiCall) -> Stay | None:
    """How a call keeps its thread, if it is one that does."""
    if call.api == SLEEP:
        seconds = longest(argument(call, "seconds"))
        cap = _cap(code, call) if seconds is None else None
        if cap is not None:
            return Stay("sleep", cap, f"sleeps for up to {cap:.3g} s")
        return Stay("sleep", seconds, "sleeps" if seconds is None else f"sleeps for {seconds:.3g} s")
    if call.api in _WAITS:
        limit = longest(argument(call, _WAITS[call.api]))
        function = call.api.rpartition(".")[2]
        words = f"waits in {function}()" + (f" for up to {limit:g} s" if limit is not None else "")
        return Stay("discovery", limit, words)
    if call.api == _WAIT_FOR_MESSAGE:
        return Stay("message", longest(argument(call, "time_to_wait")), "waits for a message")
    if call.api == _INPUT:
        return Stay("keyboard", None, "waits for keyboard input")
    if call.api in _LOCKS:
        return Stay("lock", None, f"waits for a file lock in {call.api}()") if _waits_for_lock(code, call) else None
    if call.api in _IO_CALLS:
        name = call.api.rpartition(".")[2] if call.api.startswith("urllib.") else call.api
        if call.api.startswith(_NETWORK):
            return Stay("network", None, f"waits for the network in {name}()")
        limit = _limit_of_process(code, call)
        end = "" if limit is None else f" for up to {limit:g} s"
        return Stay("process", limit, f"waits for a process in {name}(){end}")
    return None


def _cap(code: SourceCode, call: ApiCall) -> float | None:
    """The seconds that a sleep never goes beyond, whatever it is asked for: ``time.sleep(min(request.a, 5.0))``."""
    function, arguments = code.function(call.context), code.arguments(call)
    if call.chain or not arguments or function is None:
        return None
    given = arguments[0]
    return None if given.star or given.keyword else most(given.value, code.body(call), function.params)


def _waits_for_lock(code: SourceCode, call: ApiCall) -> bool:
    """Whether a lock is asked for by name, and nothing says to come back at once if somebody else has it."""
    names = {name for given in code.arguments(call) for name in names_in(given.value)}
    return not names.isdisjoint({"LOCK_EX", "LOCK_SH"}) and names.isdisjoint({"LOCK_NB", "LOCK_UN"})


def _limit_of_process(code: SourceCode, call: ApiCall) -> float | None:
    """The ``timeout`` that a call gives a process: a number in the code, or one that is known."""
    literal = next((given.value for given in code.arguments(call) if given.keyword == "timeout"), None)
    if isinstance(literal, facts.Literal) and isinstance(literal.value, (int, float)):
        return float(literal.value)
    return longest(argument(call, "timeout"))


def longest(value: Given | None) -> float | None:
    """The longest time that a value may stand for in seconds, None where that is not known."""
    if value is None:
        return None
    times = [option.seconds for option in value.alternatives]
    known = [seconds for seconds in times if seconds is not None]
    return max(known) if len(known) == len(times) else None
