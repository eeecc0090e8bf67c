"""Runs cells under the rclpy of a distribution, and says in a word what became of each."""

from __future__ import annotations

import json
import subprocess
import tempfile
import threading
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path

from tests_ros.environments import Environment
from tests_ros.running import domain_of_its_own, kill

from benchmarks.executors.cells import LIMIT_S, PERIOD_S, Cell, program

HERE = Path(__file__).parent
ENOUGH = 4
"""So many answers show that a wait works, where nothing but the wait itself is at stake."""

Said = list[tuple[float, str]]

WORKS = "works"
HANGS = "hangs"
NOTHING = "times out"
STRANDS = "strands"
STOPS = "stops"
SOME = "answers some"


def outcome(said: Said, cell: Cell) -> str:
    """What a program's words mean: ``works``, ``hangs``, ``times out``, ``raises X``, and

    ``strands``: the wait ended, and the callback never ran again; ``stops``: some waits were answered, then one hung.
    """
    words = Counter(word for _, word in said)
    raised = next((word for _, word in said if word.startswith("raised ")), None)
    if raised:
        return f"raises {raised.split()[1].rstrip(':')}"
    asked, ended = words["asks"], words["answered"] + words["nothing"]
    if not asked:
        return "never ran" if not words["ended"] else "ends"
    if not ended:
        return HANGS
    went_on = limit(cell) - said[-1][0]
    quiet = went_on > LIMIT_S + 5 * PERIOD_S + cell.latency and words["answered"] < enough(cell)
    if quiet:
        return STRANDS if ended >= asked else STOPS
    if not words["answered"]:
        return NOTHING
    return WORKS if not words["nothing"] else SOME


def observe(environment: Environment, cells: Iterable[Cell], jobs: int, runs: int = 1) -> Iterator[tuple[Cell, Said]]:
    """Runs each cell ``runs`` times, ``jobs`` at a time; what each run says, as it comes."""
    by_name = {cell.name: cell for cell in cells}
    tasks = [task(cell, run) for run in range(runs) for cell in by_name.values()]
    for name, said in run_programs(environment, tasks, jobs):
        yield by_name[name], said


def run_programs(
    environment: Environment, tasks: Iterable[Mapping[str, object]], jobs: int, prefixes: Sequence[Path] = ()
) -> Iterator[tuple[str, Said]]:
    """Runs the programs of ``tasks`` (see ``driver.py``), with the installed ``prefixes`` in view."""
    with ExitStack() as stack:
        domains = [str(stack.enter_context(domain_of_its_own())) for _ in range(jobs)]
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        process = subprocess.Popen(
            [environment.python, HERE / "driver.py", *domains],
            env=environment.variables(list(prefixes), 0, folder),
            cwd=folder,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )
        stack.callback(kill, process)
        lines = [json.dumps(task) for task in tasks]
        assert process.stdin is not None and process.stdout is not None
        stdin = process.stdin

        def feed() -> None:
            with stdin:
                stdin.write("\n".join(lines) + "\n")

        threading.Thread(target=feed, daemon=True).start()
        for line in process.stdout:
            answer = json.loads(line)
            yield answer["name"], answer["said"]


def task(cell: Cell, run: int) -> dict[str, object]:
    return {
        "name": cell.name,
        "source": program(cell),
        "needs": needs(cell),
        "latency": cell.latency,
        "program_first": run % 2 == 0,
        "enough": enough(cell),
        "limit": limit(cell),
    }


def enough(cell: Cell) -> int:
    """After how many answers a program is ended; never where something may come of many waits, or afterwards."""
    lasting = cell.wait.startswith("spin") or cell.latency or "reentrant" in cell.groups
    return 10_000 if lasting else ENOUGH


def limit(cell: Cell) -> float:
    """How long a program goes on after its first word, in seconds."""
    return 3.0 + 2 * cell.latency


def needs(cell: Cell) -> list[str]:
    """What the other end has to do, in the words of ``other_end.py``."""
    found = {
        "service": ["ask"],
        "subscription": ["publish"],
        "execute": ["send_goals"],
        "goal": ["send_goals"],
        "accepted": ["send_goals"],
        "parameter": ["set_parameter"],
        "feedback": ["serve_goals"],
    }.get(cell.handler, [])
    if "message" in cell.wait:
        found = [*found, "publish"]
    if "goal" in cell.wait:
        found = [*found, "serve_goals"]
    return sorted(set(found))
