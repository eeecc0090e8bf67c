"""What code does with an object that it makes and keeps: whether it only reads attributes of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.finding import Place
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.model import Blueprint
    from archlint.systems.model import WorkspaceIndex


def read_off(workspace: WorkspaceIndex | None, node: Blueprint) -> list[str]:
    """The attributes that the file which makes a node reads, sorted, where it does nothing else with the node:
    ``self.detector = Detector()``, and then only ``self.detector.model``."""
    file_facts = None if workspace is None or node.made_at is None else workspace.facts_at(node.made_at.file)
    if workspace is None or file_facts is None or node.made_at is None:
        return []
    attributes = list(everything_in(file_facts.body, facts.Attribute))
    called = {Itself[facts.Base](call.func) for call in everything_in(file_facts.body, facts.Call)}
    of_it = [part for part in attributes if _makes(part.value, node.made_at)]
    passed_on = [part for part in of_it if Itself[facts.Base](part) not in called]
    if passed_on:
        return [part.attr for part in passed_on]  # of ``Detector().on_image``
    kept = [
        assignment.targets
        for assignment in everything_in(file_facts.body, facts.Assign)
        if _makes(assignment.value, node.made_at)
    ]
    target = kept[0][0] if kept and len(kept[0]) == 1 else None
    if not isinstance(target, facts.Attribute):
        return []
    uses = [attribute for attribute in attributes if attribute.attr == target.attr and attribute != target]
    reads = [attribute for attribute in attributes if attribute.value.attribute == target.attr]
    stored = (assigned for statement in everything_in(file_facts.body) for assigned in statement.assigned)
    changed = any(part in reads for assigned in stored for part in everything_in(assigned, facts.Attribute))
    read = {attribute.attr for attribute in reads}
    if changed or not read or len(reads) < len(uses) or not all(_is_attribute(workspace, node, name) for name in read):
        return []
    return sorted(read)


def _makes(value: facts.Expr, place: Place) -> bool:
    return isinstance(value, facts.Call) and Place.of(place.file, value.span) == place


def _is_attribute(workspace: WorkspaceIndex, node: Blueprint, name: str) -> bool:
    """Whether the node's class sets an attribute of this name on itself: a method is not one."""
    for own in node.classes:
        file_facts = workspace.facts_at(own.place.file)
        classes = everything_in([] if file_facts is None else file_facts.body, facts.Class)
        for cls in (candidate for candidate in classes if candidate.name == own.name.rpartition(".")[2]):
            targets = (target for assignment in everything_in(cls, facts.Assign) for target in assignment.targets)
            if any(target.dotted == f"self.{name}" for target in targets):
                return True
    return False
