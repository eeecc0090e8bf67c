"""Variables of one method that were to be attributes: another method asks ``self`` for what they hold."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of, targets_of
from archlint.records import dataclass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@dataclass(frozen=True)
class KeptInVariable:
    """A ``method`` that assigns a variable, and where it first does."""

    method: str
    place: Place


def kept_in_variable(workspace: WorkspaceIndex, read: Place, cls: str, name: str) -> KeptInVariable | None:
    """The only method of a class of the file around a read that has a variable of a name; None where several have one,
    or the file has several classes of that name."""
    file_facts = workspace.facts_at(read.file)
    classes = [] if file_facts is None else [code for code in classes_of(file_facts) if code.name == cls]
    if len(classes) != 1:
        return None
    rows: list[KeptInVariable] = []
    for method in methods_of(classes[0]):
        variables = (target for target in targets_of(method.body) if isinstance(target, facts.Name))
        first = next((variable for variable in variables if variable.id == name), None)
        if first is not None:
            rows.append(KeptInVariable(method.name, Place(read.file, *first.span)))
    return rows[0] if len(rows) == 1 else None


__all__ = ["KeptInVariable", "kept_in_variable"]
