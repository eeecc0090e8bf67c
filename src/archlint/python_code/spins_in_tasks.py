"""Spins without an end in coroutines that asyncio runs beside others: it has one thread, which they never give back."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.annotations import imported_as
from archlint.python_code.class_chains import targets_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MAKE_TASKS = frozenset({"create_task", "ensure_future"})
_RUN_SEVERAL = frozenset({"gather", "wait"})
_EXECUTORS = frozenset({"MultiThreadedExecutor", "SingleThreadedExecutor"})


@dataclass(frozen=True)
class SpinInTask:
    """Such a spin, the ``async`` function that it is in, and where asyncio gets that."""

    place: Place
    function: str
    task: Place


def spins_in_tasks(workspace: WorkspaceIndex) -> Iterator[SpinInTask]:
    """Every such spin in the files that were asked for, outside of test code."""
    for path in workspace.python_files(mentioning="asyncio"):
        for span, function, task in _rows(workspace, path) or ():
            yield SpinInTask(Place(path, *span), function, Place(path, *task))


@kept_for_each_file
def _rows(code: facts.Facts) -> list[tuple[facts.Span, str, facts.Span]]:
    functions = [*everything_in(code.body, facts.Function)]
    times = Counter(function.name for function in functions)
    tasks = _tasks(code)
    executors = _executors(code)
    rows = []
    for function in functions:
        if not function.is_async or times[function.name] > 1 or function.name not in tasks:
            continue
        for call in parts_of(function.body, facts.Call):
            if _spins(code, call, executors):
                rows.append((call.span, function.name, tasks[function.name]))
    return rows


def _tasks(code: facts.Facts) -> dict[str, facts.Span]:
    """The functions whose coroutines become tasks, and where: beside other ones, or beside what makes them."""
    tasks: dict[str, facts.Span] = {}
    for call in everything_in(code.body, facts.Call):
        name = call.func.last_name
        coroutines = [argument.value for argument in call.args if isinstance(argument.value, facts.Call)]
        if name in _MAKE_TASKS or (name in _RUN_SEVERAL and len(call.args) > 1 and _is_of_asyncio(code, call)):
            tasks |= {coroutine.func.last_name: coroutine.span for coroutine in coroutines}
    return tasks


def _is_of_asyncio(code: facts.Facts, call: facts.Call) -> bool:
    return (imported_as(code, call.func.dotted) or "").startswith("asyncio.")


def _executors(code: facts.Facts) -> frozenset[str]:
    """The variables and attributes that hold executors of rclpy and nothing else."""
    makings = Counter(
        target.last_name
        for statement in everything_in(code.body, facts.Assign)
        if isinstance(statement.value, facts.Call) and statement.value.func.last_name in _EXECUTORS
        for target in statement.targets
    )
    times = Counter(getattr(target, "last_name", "") for target in targets_of(code.body))
    return frozenset(name for name, count in makings.items() if name and times[name] == count)


def _spins(code: facts.Facts, call: facts.Call, executors: frozenset[str]) -> bool:
    match call.func:
        case facts.Attribute(value=owner, attr="spin") if not call.args and owner.last_name in executors:
            return True
    return imported_as(code, call.func.dotted) == "rclpy.spin"


__all__ = ["SpinInTask", "spins_in_tasks"]
