"""Which differences between a case's graph and its run are failures, and how many entities were compared."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from tests_ros.cases import Case, Ready
from tests_ros.comparing import compare
from tests_ros.running import Observed

NOT_REACHED = {
    "branches.py": {62: "chance decides whether its method ends before"},
    "lazy_endpoints.py": {
        23: "nobody publishes what it waits for",
        34: "nobody calls the service",
        40: "nobody calls the service",
        50: "nothing calls the method",
        53: "nothing calls the method",
    },
    "parameters.py": {80: "main makes no such node", 81: "main makes no such node"},
    "patterns.py": {36: "nobody publishes what it waits for"},
    "wrappers.py": {34: "nobody publishes what it waits for"},
    "broken_system": {
        18: "the control's constructor waits for a service that is nowhere",
        19: "the sensor's constructor waits for a service that is nowhere",
    },
    "problem_1_service_not_available": {16: "its constructor waits for a service that is nowhere"},
}
"""Lines of entities that are read from the source, and that the run does not come to; all others must exist."""


@dataclass
class Counted:
    """Over all cases of a test run."""

    runs: int = 0
    left_open: int = 0
    differences: int = 0
    entities: Counter[str] = field(default_factory=Counter)


counted = Counted()


def problems(case: Case, ready: Ready, observed: Observed) -> list[str]:
    """What is not as archlint says, a sentence each."""
    comparison = compare(ready.nodes, observed)
    return comparison.differences + [
        f"{what} is in the graph, and its line never ran" for what in _late(case, comparison.never_ran)
    ]


def count(case: Case, ready: Ready, observed: Observed) -> None:
    comparison = compare(ready.nodes, observed)
    counted.runs += 1
    counted.left_open += comparison.left_open
    counted.differences += len(problems(case, ready, observed))
    counted.entities += comparison.compared


def _late(case: Case, never_ran: list[str]) -> list[str]:
    allowed = NOT_REACHED.get(case.name, {})
    return [what for what in never_ran if int(what.split(" ")[0].rpartition(":")[2]) not in allowed]
