"""What becomes of a wait inside a callback, as data: one row a form of waiting, executor and callback group.

The answer to a request is an entity of the client's callback group.  It can be taken only while a thread of
the executor is free and that group is not held; a mutually exclusive group is held from a callback's start
until it has ended, also across ``await``.  The rows were gained by running rclpy's own executors of all
supported distributions, and they differ only where a row says so; ``benchmarks/executors`` tries them again on
jazzy and kilted.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Final, Literal

from archlint.records import dataclass
from archlint.ros.distros import DISTROS
from archlint.string_enum import StringEnum

CALL: Final = "call"
"""The thread stands still until the answer is there: ``call``, ``send_goal``, a loop, an event."""
LIMITED_CALL: Final = "call with a limit"
"""The same with a limit that the code sets itself: an event's, or a clock in a loop."""
TIMED_CALL: Final = "call with timeout_sec"
"""``Client.call(request, timeout_sec=…)``."""
AWAIT: Final = "await"
"""The callback is put aside until the answer is there; the thread is free meanwhile."""
SPIN: Final = "spin"
"""The callback spins its node, on the executor that is running."""
LIMITED_SPIN: Final = "spin with a limit"
STEAL: Final = "spin on another executor"
"""The callback spins its node on an executor that does not run it."""
LIMITED_STEAL: Final = "spin on another executor with a limit"
RATE: Final = "rate"
"""``Rate.sleep()``: the rate's timer has a group of its own."""
RESULT: Final = "result at once"
"""``future.result()`` straight after ``call_async()``."""

ONE: Final = "one thread"
POOL_OF_ONE: Final = "a pool of one thread"
"""``MultiThreadedExecutor(num_threads=1)``: whoever spins it, that one thread runs the callbacks."""
SEVERAL: Final = "several threads"
NOBODY: Final = "nobody seen to spin it"
ANY: Final = "executor not known"

SAME: Final = "same group"
OTHER: Final = "other group"
REENTRANT: Final = "reentrant group"
UNCLEAR: Final = "group not known"

Form = Literal[
    "call",
    "call with a limit",
    "call with timeout_sec",
    "await",
    "spin",
    "spin with a limit",
    "spin on another executor",
    "spin on another executor with a limit",
    "rate",
    "result at once",
]
"""How a callback waits."""
Threads = Literal[
    "one thread", "a pool of one thread", "several threads", "nobody seen to spin it", "executor not known"
]
"""How many threads run a node's callbacks."""
Relation = Literal["same group", "other group", "reentrant group", "group not known"]
"""How the group of the client is to that of the callback which waits."""


class Outcome(StringEnum):
    """What becomes of a wait, in words that follow "…: "."""

    FINE = "works"
    HANGS = "deadlocks"
    TIMES_OUT = "always times out"
    TIMES_OUT_OR_CLASHES = "times out or raises ValueError"
    SOMETIMES_HANGS = "sometimes deadlocks or raises ValueError"
    SOMETIMES_TIMES_OUT = "sometimes times out or raises ValueError"
    HANGS_OR_RAISES = "sometimes deadlocks or raises RCLError or ValueError"
    TIMES_OUT_OR_RAISES = "sometimes times out or raises RCLError or ValueError"
    NO_SUCH_ARGUMENT = "raises TypeError (call() has no timeout_sec)"
    GIVES_NONE = "always times out and returns None"
    RAISES_TIMEOUT = "always times out and raises TimeoutError"
    RAISES_NESTED = "raises 'Executor is already spinning'"
    STRANDS = "takes the node away from its executor, so none of its callbacks runs again"
    NONE_AT_ONCE = "returns None, because the response has not arrived yet"
    UNKNOWN = "may deadlock"


_WITH_AN_ACTION_CLIENT = {
    Outcome.SOMETIMES_HANGS: Outcome.HANGS_OR_RAISES,
    Outcome.SOMETIMES_TIMES_OUT: Outcome.TIMES_OUT_OR_RAISES,
}
"""What several threads that spin one executor do to a node with an action client.

The client notes its place in the wait set, once; another thread's wait set may be shorter, and rcl then finds
that the number "is out of bounds".
"""

NESTED_SINCE = {"jazzy": "7.1.9", "kilted": "9.1.5"}
"""The rclpy that first refuses a nested spin: before, these distributions let it in, as humble does."""

_Cell = tuple[Form, Threads, Relation]
Outcomes = Mapping[str, Outcome]
"""The outcome in each distribution."""


def _everywhere(outcome: Outcome) -> dict[str, Outcome]:
    return dict.fromkeys(DISTROS, outcome)


def _humble_and_later(humble: Outcome, later: Outcome) -> dict[str, Outcome]:
    return {distro: humble if distro == "humble" else later for distro in DISTROS}


_TIMED = {
    distro: {"humble": Outcome.NO_SUCH_ARGUMENT, "jazzy": Outcome.GIVES_NONE}.get(distro, Outcome.RAISES_TIMEOUT)
    for distro in DISTROS
}
_TIMED_FINE = _humble_and_later(Outcome.NO_SUCH_ARGUMENT, Outcome.FINE)

_GROUPS: tuple[Relation, ...] = (SAME, OTHER, REENTRANT, UNCLEAR)
_CONCURRENT: tuple[Relation, ...] = (OTHER, REENTRANT)
_THREADS: tuple[Threads, ...] = (ONE, SEVERAL, NOBODY, ANY)


def _stuck(form: Form, outcomes: Outcomes, fine: Outcomes) -> dict[_Cell, Outcomes]:
    """The rows of a form that keeps its thread: it needs a second thread and a group apart."""
    unknown = _everywhere(Outcome.UNKNOWN)
    return {
        **{(form, ONE, group): outcomes for group in _GROUPS},
        **{(form, threads, SAME): outcomes for threads in _THREADS},
        **{(form, SEVERAL, group): fine for group in _CONCURRENT},
        **{(form, threads, group): unknown for threads in (NOBODY, ANY) for group in _CONCURRENT},
        **{(form, threads, UNCLEAR): unknown for threads in (SEVERAL, NOBODY, ANY)},
    }


def _nested(form: Form, stuck: Outcome, stuck_of_several: Outcome, sometimes: Outcome) -> dict[_Cell, Outcomes]:
    """The rows of a spin of the running executor: humble lets it in, and one thread works where the group is free.

    Several threads then spin one executor at a time.  One of them takes the wake-up that was meant for the other, or
    too few threads of the pool are left, or both are in its generator of ready callbacks, which Python refuses.
    """
    by_group = {SAME: stuck, **dict.fromkeys(_CONCURRENT, Outcome.FINE), UNCLEAR: Outcome.UNKNOWN}
    threaded = {**by_group, SAME: stuck_of_several, **dict.fromkeys(_CONCURRENT, sometimes)}
    of_threads = {**dict.fromkeys(_THREADS, by_group), SEVERAL: threaded, POOL_OF_ONE: dict.fromkeys(_GROUPS, stuck)}
    return {
        (form, threads, group): _humble_and_later(outcome, Outcome.RAISES_NESTED)
        for threads, outcomes in of_threads.items()
        for group, outcome in outcomes.items()
    }


MATRIX: dict[_Cell, Outcomes] = {
    **_stuck(CALL, _everywhere(Outcome.HANGS), _everywhere(Outcome.FINE)),
    **_stuck(LIMITED_CALL, _everywhere(Outcome.TIMES_OUT), _everywhere(Outcome.FINE)),
    **_stuck(TIMED_CALL, _TIMED, _TIMED_FINE),
    **{(AWAIT, threads, SAME): _everywhere(Outcome.HANGS) for threads in _THREADS},
    **{(AWAIT, threads, group): _everywhere(Outcome.FINE) for threads in _THREADS for group in _CONCURRENT},
    **{(AWAIT, threads, UNCLEAR): _everywhere(Outcome.UNKNOWN) for threads in _THREADS},
    **_nested(SPIN, Outcome.HANGS, Outcome.HANGS, Outcome.SOMETIMES_HANGS),
    **_nested(LIMITED_SPIN, Outcome.TIMES_OUT, Outcome.TIMES_OUT_OR_CLASHES, Outcome.SOMETIMES_TIMES_OUT),
    # Another executor takes the node along, and serves it while the callback spins; afterwards nobody does.
    **{(STEAL, threads, SAME): _everywhere(Outcome.HANGS) for threads in _THREADS},
    **{
        (STEAL, threads, group): _everywhere(Outcome.STRANDS)
        for threads in _THREADS
        for group in (*_CONCURRENT, UNCLEAR)
    },
    **{(LIMITED_STEAL, threads, group): _everywhere(Outcome.STRANDS) for threads in _THREADS for group in _GROUPS},
    **{(RATE, ONE, group): _everywhere(Outcome.HANGS) for group in _GROUPS},
    **{(RATE, SEVERAL, group): _everywhere(Outcome.FINE) for group in _GROUPS},
    **{(RATE, threads, group): _everywhere(Outcome.UNKNOWN) for threads in (NOBODY, ANY) for group in _GROUPS},
    **{(RESULT, threads, group): _everywhere(Outcome.NONE_AT_ONCE) for threads in _THREADS for group in _GROUPS},
}
"""By form of waiting, threads of the executor, and how the client's group relates to the callback's.

What runs in no group (an action's execute callback, done callbacks, executor tasks) holds none: :data:`OTHER`.
"""


@dataclass(frozen=True)
class Verdict:
    """What becomes of a wait, in each of the distributions asked for, and why in words that follow "…: "."""

    outcomes: Outcomes
    why: str
    before: Outcome | None = None
    """What the first releases of the distributions of :data:`NESTED_SINCE` do, where that is something else."""
    kept_since: tuple[str, str] | None = None
    """A distribution, and the rclpy from which on the call no longer loses its node there."""
    goes_round: bool = False
    """Whether it is a loop of spins, all of which have a timeout: nothing stands still, but the loop never ends."""
    limited: bool = False
    """Whether a timeout ends the wait: at worst it passes in vain."""

    @property
    def safe(self) -> bool:
        """Proved to end well; a distribution that does not know ``timeout_sec`` is another matter."""
        outcomes = set(self.outcomes.values())
        return Outcome.FINE in outcomes and outcomes <= {Outcome.FINE, Outcome.NO_SUCH_ARGUMENT}

    @property
    def unknown(self) -> bool:
        """Nothing is proved, for better or for worse."""
        outcomes = set(self.outcomes.values())
        return Outcome.UNKNOWN in outcomes and outcomes <= {Outcome.UNKNOWN, Outcome.NO_SUCH_ARGUMENT}

    def with_an_action_client(self) -> Verdict:
        """The same for a node that has an action client."""
        outcomes = {distro: _WITH_AN_ACTION_CLIENT.get(outcome, outcome) for distro, outcome in self.outcomes.items()}
        before = None if self.before is None else _WITH_AN_ACTION_CLIENT.get(self.before, self.before)
        return replace(self, outcomes=outcomes, before=before)

    def stranding_before(self, distro: str, release: str) -> Verdict:
        """The same where the call, once it returns, has lost the node in the first releases of a distribution."""
        return replace(self, kept_since=(distro, release)) if distro in self.outcomes else self

    @property
    def words(self) -> str:
        """``deadlocks``; where the distributions and their releases differ, which does what."""
        words = outcome_words(self.outcomes) + self._before_words() + self._lost_words()
        if self.limited:
            words = words.replace(Outcome.UNKNOWN, "may time out")
        return words.replace(Outcome.HANGS, "never ends") if self.goes_round else words

    def _lost_words(self) -> str:
        if self.kept_since is None:
            return ""
        distro, release = self.kept_since
        return f"; in {distro} before rclpy {release} it {Outcome.STRANDS}"

    def _before_words(self) -> str:
        if self.before is None:
            return ""
        if len(self.outcomes) == 1:
            return f" ({self.before} before rclpy {NESTED_SINCE[next(iter(self.outcomes))]})"
        releases = [
            f"{outcome} before rclpy {since}" for outcome, since in NESTED_SINCE.items() if outcome in self.outcomes
        ]
        return f" ({self.before} in {' and '.join(releases)})"


def look_up(form: Form, threads: Threads, relation: Relation, why: str, distros: Sequence[str] = DISTROS) -> Verdict:
    """The verdict of the matrix for some distributions."""
    row = MATRIX[form, threads, relation]
    outcomes = {distro: row[distro] for distro in distros}
    if set(outcomes.values()) == {Outcome.NO_SUCH_ARGUMENT}:
        why = "humble does not have this argument"
    changed = any(outcomes.get(distro) == Outcome.RAISES_NESTED for distro in NESTED_SINCE)
    return Verdict(outcomes, why, row["humble"] if changed else None)


def outcome_words(outcomes: Outcomes) -> str:
    """The outcomes of all distributions in a phrase: ``deadlocks in humble and raises … from jazzy on``."""
    by_outcome: dict[Outcome, list[str]] = {}
    for distro in DISTROS:
        if distro in outcomes:
            by_outcome.setdefault(outcomes[distro], []).append(distro)
    if len(by_outcome) == 1:
        return str(next(iter(by_outcome)))
    *first, last = (f"{outcome} {in_distros(where)}" for outcome, where in by_outcome.items())
    return f"{', '.join(first)} and {last}"


def in_distros(distros: Iterable[str]) -> str:
    """``in humble``, ``from kilted on``, ``up to jazzy``; nothing for all of them."""
    where = [distro for distro in DISTROS if distro in set(distros)]
    if len(where) == len(DISTROS):
        return ""
    if len(where) > 1 and where == list(DISTROS[-len(where) :]):
        return f"from {where[0]} on"
    if len(where) > 1 and where == list(DISTROS[: len(where)]):
        return f"up to {where[-1]}"
    return "in " + " and ".join(where)
