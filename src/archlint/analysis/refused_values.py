"""Values of parameters that the code itself refuses: ``if self.time and self.speed: raise ValueError(…)``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.kept import once_for_each_file
from archlint.syntax import facts
from archlint.syntax.flow_facts import conditions_of, covers
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


def raises_by_truth(workspace: WorkspaceIndex | None, read: Place) -> int | None:
    """The line of an ``if`` that raises an exception by whether a value is zero which is read at a place."""
    rows = None if workspace is None else _asked(workspace, read.file)
    for value, line in rows or ():
        if covers(value, read.span):
            return line
    return None


@once_for_each_file
def _asked(file_facts: facts.Facts) -> list[tuple[facts.Base, int]]:
    """What variables are assigned whose truth an ``if`` asks that raises an exception, with its line."""
    tests: dict[str, int] = {}
    for choice in everything_in(file_facts.body, facts.If):
        if any(isinstance(statement, facts.Raise) for block in choice.blocks for statement in block):
            for condition in conditions_of(choice.test):
                tests.setdefault(condition.dotted, choice.span[0])
    return [
        (assignment, tests[target.dotted])
        for assignment in everything_in(file_facts.body, facts.Assign)
        for target in assignment.targets
        if target.dotted and target.dotted in tests
    ]


__all__ = ["raises_by_truth"]
