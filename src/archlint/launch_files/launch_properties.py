"""Properties of launch's actions that code assigns and that nobody can.

Source: ``Action.condition`` in launch/action.py has no setter in launch 0.10.10 (foxy), 1.0.7 (humble), 2.0.4 (iron),
3.4.3 (jazzy) and 3.7.1 (rolling), nor in any class that derives from it in launch and launch_ros.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.launch_files.launch_code import names_from_launch
from archlint.launch_files.launch_descriptions import ACTIONS
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_READ_ONLY = frozenset({"condition"})


@dataclass(frozen=True)
class ActionOverwritten:
    """``action.condition = …``, where the variable holds an action of launch that the function makes."""

    place: Place
    action: str
    name: str


def overwritten_actions(workspace: WorkspaceIndex) -> Iterator[ActionOverwritten]:
    """Every such assignment in the launch files, but for those that are test code."""
    for file, _ in workspace.code.asked_for():
        path = file.relative
        if file.kind == "launch_python" and not workspace.roles.is_test(path):
            for span, action, name in _of_file(workspace, path) or ():
                yield ActionOverwritten(Place.of(path, span), action, name)


@once_for_each_file
def _of_file(file_facts: facts.Facts) -> list[tuple[facts.Span, str, str]]:
    classes = names_from_launch(file_facts.body)
    functions = list(everything_in(file_facts.body, facts.Function))
    return [row for function in functions for row in _of_function(function, classes)]


def _of_function(function: facts.Function, classes: dict[str, str]) -> Iterator[tuple[facts.Span, str, str]]:
    taken = {parameter.name for parameter in function.params}
    forgiven = {
        id(inner)
        for attempt in statements_of(function.body, facts.Try)
        for inner in statements_of([attempt], facts.Assign)
    }
    for assign in statements_of(function.body, facts.Assign):
        match assign.targets:
            case [facts.Attribute(value=facts.Name(id=variable), attr=name, span=span)] if name in _READ_ONLY:
                action = _held(function.body, variable, classes)
                if action is not None and variable not in taken and id(assign) not in forgiven:
                    yield span, action, name


def _held(body: Sequence[facts.Stmt], variable: str, classes: dict[str, str]) -> str | None:
    """The action that a variable holds, whatever sets it; None for anything else."""
    held: set[str] = set()
    for statement in statements_of(body):
        for target in statement.assigned:
            if any(name.id == variable for name in everything_in(target, facts.Name)) and target.variable != variable:
                if not isinstance(target, facts.Attribute):
                    return None  # ``one, other = …``
            elif target.variable == variable:
                value = statement.value if isinstance(statement, facts.Assign) else None
                func = value.func if isinstance(value, facts.Call) else None
                held.add(classes.get(func.variable, "") if func is not None else "")
    return held.pop() if len(held) == 1 and held <= ACTIONS else None


__all__ = ["ActionOverwritten", "overwritten_actions"]
