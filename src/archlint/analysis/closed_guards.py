"""Code behind a flag that stays as it is: ``if self.rotate:``, where everything that sets ``self.rotate`` to true is
commented out, or the ``else`` of ``if USE_LIDAR:`` below ``USE_LIDAR = True``."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.analysis.opened_guards import asked_before
from archlint.analysis.own_names import BY_NAME
from archlint.analysis.source_code import code_of
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_facts import outcome
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex

_BY_NAME = BY_NAME | {"setattr"}
_BY_TEXT = frozenset({"exec", "globals", "setattr", "vars"})
"""With one of these a file may give a variable of the module another value."""


def is_switched_off(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a function gets to a place only where an attribute of ``self`` is true that nothing ever makes true, or
    where a constant of the module is not what it is."""
    if workspace is None:
        return False
    if _is_decided_against(workspace, place):
        return True
    flags = _false_flags(workspace, place.file)
    if not flags:
        return False
    asked = {name.removeprefix("self.") for name in asked_before(code_of(workspace).body_at(place), place)}
    mentioning = workspace.code.files_that_mention
    return any(all(file == place.file for file in mentioning(flag)) for flag in sorted(asked & flags))


def _is_decided_against(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether a test on the way to a place has the other outcome, by the constants of the module."""
    constants = _constants(workspace, place.file)
    if not constants:
        return False
    graph = graph_of(code_of(workspace).body_at(place))
    for edge in graph.outcomes(graph.evaluating(place.span)):
        if edge.test is not None and outcome(edge.test, lambda part: constants.get(part.variable)) is (not edge.holds):
            names = {name.id for name in everything_in([edge.test], facts.Name)} & constants.keys()
            return not any(_is_reached_into(workspace, place.file, name) for name in names)
    return False


@kept_for_each_file
def _constants(file_facts: facts.Facts) -> dict[str, bool]:
    return constants_of(file_facts)


def constants_of(file_facts: facts.Facts) -> dict[str, bool]:
    """The variables of a module that one statement of it binds, to ``True`` or ``False``."""
    if any(name.id in _BY_TEXT for name in everything_in(file_facts.body, facts.Name)):
        return {}
    bound = Counter(names_bound(file_facts.body))
    rows: dict[str, bool] = {}
    for statement in file_facts.body:
        match statement:
            case facts.Assign(targets=[facts.Name(id=name)], value=facts.Literal(value=bool(value))):
                if bound[name] == 1:
                    rows[name] = value
    return rows


def _is_reached_into(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether another file may set a variable of a module: ``settings.DEBUG = True``, or a text that names it."""
    for path in workspace.code.files_that_mention(name):
        code = None if path == file else workspace.facts_at(path)
        if code is None:
            continue
        if any(part.attr == name for part in everything_in(code.body, facts.Attribute)):
            return True
        if any(part.value == name for part in everything_in(code.body, facts.Literal)):
            return True
    return False


@kept_for_each_file
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


__all__ = ["constants_of", "is_switched_off"]
