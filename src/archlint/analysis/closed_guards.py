"""Code behind a flag that stays false: ``if self.rotate:``, where everything that sets ``self.rotate`` to true is
commented out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.analysis.opened_guards import asked_before
from archlint.analysis.own_names import BY_NAME
from archlint.analysis.source_code import code_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex

_BY_NAME = BY_NAME | {"setattr"}


def is_switched_off(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a function gets to a place only where an attribute of ``self`` is true that nothing ever makes true."""
    if workspace is None:
        return False
    file_facts = workspace.facts_at(place.file)
    flags = frozenset() if file_facts is None else _false_flags(file_facts)
    if not flags:
        return False
    asked = {name.removeprefix("self.") for name in asked_before(code_of(workspace).body_at(place), place)}
    mentioning = workspace.code.files_that_mention
    return any(all(file == place.file for file in mentioning(flag)) for flag in sorted(asked & flags))


@once_for
def _false_flags(file_facts: facts.Facts) -> frozenset[str]:
    """The attributes of ``self`` that a file assigns ``False`` and nothing else."""
    if any(name.id in _BY_NAME for name in everything_in(file_facts.body, facts.Name)):
        return frozenset()
    false, other = set[str](), set[str]()
    for assignment in everything_in(file_facts.body, facts.Assign):
        plain = isinstance(assignment.value, facts.Literal) and assignment.value.value is False
        for target in assignment.targets:
            names = {part.attr for part in everything_in([target], facts.Attribute)}
            (false if plain and target.attribute else other).update(names)
    changed = {part.attr for each in everything_in(file_facts.body, facts.Augmented) for part in _attributes(each)}
    looped = {part.attr for each in everything_in(file_facts.body, facts.For) for part in _attributes(each)}
    return frozenset(false - other - changed - looped)


def _attributes(statement: facts.Augmented | facts.For) -> list[facts.Attribute]:
    return list(everything_in([statement.target], facts.Attribute))


__all__ = ["is_switched_off"]
