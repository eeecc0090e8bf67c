"""The processes that a launch file starts, and which of them are one that is met twice."""

from __future__ import annotations

from dataclasses import field

from archlint.branches import BranchArms, ChoiceOfVisit
from archlint.finding import Place
from archlint.launch.kinds import StartedKind
from archlint.launch.parameter_sources import Parameters
from archlint.model import Text
from archlint.records import dataclass


@dataclass(frozen=True)
class Remap:
    """``source:=target`` of one node, or of a group (``SetRemap``)."""

    source: Text
    target: Text
    place: Place
    group: bool = False


@dataclass(frozen=True)
class Bridged:
    """A topic that a bridge to a simulator publishes in ROS, subscribes to, or both."""

    name: str
    type: str
    publishes: bool
    subscribes: bool


@dataclass(eq=False)
class Started:
    """A process (or a component of one) that a launch file starts.

    ``name`` and ``namespace`` are what the
    launch file gives; None leaves the code's own.  A ``dormant`` one is started under other arguments only.
    ``arguments`` is its command line, None for a word that is not known; of one that is not ``knows_all_arguments`` not
    even the number of words is.  A ``bare`` one is started by that command line alone.
    """

    kind: StartedKind
    package: Text
    executable: Text
    place: Place
    file: str
    name: Text | None = None
    namespace: Text | None = None
    remaps: list[Remap] = field(default_factory=list)
    parameters: Parameters = field(default_factory=list)
    arguments: list[str | None] = field(default_factory=list)
    ros_arguments: list[str | None] = field(default_factory=list)
    knows_all_arguments: bool = True
    bare: bool = False
    branch_arms: BranchArms = frozenset()
    dormant: bool = False
    lifecycle: bool = False
    places: dict[str, Place] = field(default_factory=dict)
    container: Text | None = None
    includes: tuple[Place, ...] = ()
    """The includes that lead to the file it is in, outermost first; for one that a helper makes, the helper's call."""
    bridged: tuple[Bridged, ...] | None = None
    """What the file says that a bridge reads; None where there is none, or it is not known."""
    bridge_file: str | None = None
    """That file, where it is in the workspace."""
    without_namespace: bool = False
    """Whether a timer or an event starts it, when the group around it has ended, and with it the group's namespace."""
    domain: str | None = None
    """The ``ROS_DOMAIN_ID`` that the launch file starts it with, ``?`` and a number for one that is not known; None
    where it sets none."""
    visited: tuple[tuple[int, int], ...] = ()
    """The actions that lead to it, itself included, each with the number of its visit."""
    after: frozenset[int] = frozenset()
    """The actions whose processes have ended when this one starts (``OnProcessExit``)."""

    @property
    def action(self) -> int | None:
        """The action that it is started by."""
        return self.visited[-1][0] if self.visited else None

    @property
    def may_read_arguments_for_ros(self) -> bool:
        """Whether words of its command line are arguments of ROS, such as a file of parameters, or may be."""
        words = self.arguments
        return bool(self.ros_arguments) or not self.knows_all_arguments or None in words or "--ros-args" in words


class StartedProcesses:
    """The processes that a launch has started so far, in ``processes``."""

    def __init__(self, processes: list[Started]) -> None:
        self._processes = processes
        self._in_handler: dict[object, bool] = {}
        """What has been started, and whether an event handler does that."""
        self._first: dict[object, Started] = {}
        self._by_place: dict[Place, list[Started]] = {}

    def start(
        self, started: Started, in_handler: bool, includes: tuple[Place, ...], visiting: tuple[tuple[int, int], ...]
    ) -> None:
        """Note a process.  What an event handler starts at a place that starts it otherwise, too, is the same
        process, started again; and an action that is met again is started once."""
        process = (
            *(started.place, started.kind, started.package, started.executable, started.name, started.namespace),
            tuple(started.arguments),
        )
        known = process in self._in_handler and not self._drop_dormant(process, started)
        self._in_handler[process] = self._in_handler.get(process, False) or in_handler
        if known and self._in_handler[process]:
            if (first := self._first.get(process)) is not None:
                first.after &= started.after
            return
        started.includes, started.visited = includes, visiting
        again = [other for other in self._by_place.setdefault(started.place, []) if _is_same_action(other, started)]
        if any(_merge(other, started) for other in again):
            return
        for other in again:
            branch = ChoiceOfVisit(len(self._processes))
            other.branch_arms |= {(branch, 0)}
            started.branch_arms |= {(branch, 1)}
        self._by_place[started.place].append(started)
        self._processes.append(started)
        self._first.setdefault(process, started)

    def _drop_dormant(self, process: object, started: Started) -> bool:
        """Forget a process that its first handler does not start, where another one does."""
        first = self._first.get(process)
        if first is None or not first.dormant or started.dormant:
            return False
        del self._first[process]
        for processes in (self._processes, self._by_place[first.place]):
            processes[:] = [other for other in processes if other is not first]
        return True


def _is_same_action(process: Started, other: Started) -> bool:
    """Whether two processes come from one action that was met twice, as in both arms of an ``if`` that nothing
    decides.  Launch refuses to execute such an action a second time: one of them is started.

    Source: launch 3.x, ``ExecuteLocal.execute`` raises RuntimeError ("executed more than once").
    """
    visits = dict(process.visited)
    return any(visits.get(action, visit) != visit for action, visit in other.visited)


def _merge(process: Started, other: Started) -> bool:
    """Make one process of what is met twice and started alike, under what both visits have in common; False where
    it is not alike, or where no visit covers the other and they do not exclude each other."""
    if (
        not process.branch_arms <= other.branch_arms
        and not other.branch_arms <= process.branch_arms
        and not _opposite(process.branch_arms, other.branch_arms)
    ):
        return False
    if any(getattr(process, name) != getattr(other, name) for name in _ALIKE):
        return False
    process.branch_arms &= other.branch_arms
    process.after &= other.after
    process.dormant = process.dormant and other.dormant
    return True


_ALIKE = (
    "kind",
    "package",
    "executable",
    "name",
    "namespace",
    "remaps",
    "parameters",
    "arguments",
    "ros_arguments",
    "container",
    "includes",
    "domain",
)


def _opposite(arms: BranchArms, other: BranchArms) -> bool:
    """Whether two sets of branches are the two sides of one condition, and otherwise the same."""
    return [branch for branch, _ in arms - other] == [branch for branch, _ in other - arms] != []
