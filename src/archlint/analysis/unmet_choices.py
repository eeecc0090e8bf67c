"""Code for a choice that its file never makes: the branch for ``'slow'``, where ``self.mode`` is set to ``'fast'``
alone, or for a state that no member of the file's enum has as its value."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.own_names import BY_NAME
from archlint.analysis.source_code import code_of
from archlint.analysis.uncalled_methods import is_called_elsewhere
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in, once_for

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex

_BY_NAME = BY_NAME | {"setattr"}
_Choices = frozenset[str]
"""The texts that something may be."""


def is_never_chosen(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a function gets to a place only where something is a text that it never is."""
    file_facts = None if workspace is None else workspace.facts_at(place.file)
    if workspace is None or file_facts is None or _sets_by_name(file_facts):
        return False
    code = code_of(workspace)
    body, function = code.body_at(place), code.function_at(place)
    graph = graph_of(body)
    for edge in graph.outcomes(graph.evaluating(place.span)):
        for asked, text in _equal(edge.test) if edge.test is not None and edge.holds else ():
            choices = _choices_of(workspace, place.file, file_facts, function, asked)
            if choices is not None and text not in choices:
                return True
    return False


@once_for
def _sets_by_name(file_facts: facts.Facts) -> bool:
    return any(name.id in _BY_NAME for name in everything_in(file_facts.body, facts.Name))


def _equal(test: facts.Expr) -> Iterator[tuple[facts.Expr, str]]:
    """What must be which text for a condition to hold."""
    match test:
        case facts.Compare(left=left, ops=["=="], comparators=[facts.Literal(value=str(text))]):
            yield left, text
        case facts.Boolean(op="and", values=values):
            for value in values:
                yield from _equal(value)


def _choices_of(
    workspace: WorkspaceIndex,
    file: str,
    file_facts: facts.Facts,
    function: facts.Function | None,
    asked: facts.Expr,
) -> _Choices | None:
    """The texts that an expression of a function may be; None where that is not known."""
    match asked:
        case facts.Attribute(value=facts.Name(id="self"), attr=name):
            return _choices_of_attribute(workspace, file, file_facts, name)
        case facts.Attribute(attr="value"):
            return _values_of_enum(workspace, file, file_facts)
        case facts.Subscript(value=facts.Attribute(attr="value"), index=facts.Slice() as part):
            values = _values_of_enum(workspace, file, file_facts)
            return None if values is None else _parts(values, part)
        case facts.Name(id=name) if function is not None:
            return _choices_of_parameter(workspace, file, file_facts, function, name)
    return None


def _choices_of_attribute(workspace: WorkspaceIndex, file: str, file_facts: facts.Facts, name: str) -> _Choices | None:
    """The texts that a file assigns to an attribute, where that is all that anything does to it."""
    others = (other for other in workspace.code.files_that_mention(name) if other != file)
    if any(_may_assign(workspace, other, file, name) for other in others):
        return None
    return _assigned(file_facts).get(name)


def _may_assign(workspace: WorkspaceIndex, other: str, file: str, name: str) -> bool:
    """Whether another file may set an attribute of an object of a module: it has a word for the module, or sets it of
    something else than ``self``."""
    other_facts = workspace.facts_at(other)
    if other_facts is None or workspace.code.mentions(other, _module(file)):
        return True
    targets = (target for part in everything_in(other_facts.body) for target in part.assigned)
    attributes = (each for target in targets for each in everything_in([target], facts.Attribute))
    return any(each.attr == name and each.value.variable != "self" for each in attributes)


def _module(file: str) -> str:
    return posixpath.basename(file).removesuffix(".py")


@once_for
def _assigned(file_facts: facts.Facts) -> dict[str, _Choices]:
    """The attributes that a file assigns constants and nothing else, with the texts among these."""
    choices: dict[str, set[str]] = {}
    other: set[str] = set()
    for part in everything_in(file_facts.body):
        value = part.value if isinstance(part, facts.Assign) else None
        plain = isinstance(value, facts.Literal)
        texts = {value.value} if isinstance(value, facts.Literal) and isinstance(value.value, str) else set[str]()
        for target in part.assigned:
            if plain and isinstance(target, facts.Attribute):
                choices.setdefault(target.attr, set()).update(texts)
            else:
                other.update(each.attr for each in everything_in([target], facts.Attribute))
    return {name: frozenset(known) for name, known in choices.items() if name not in other}


def _choices_of_parameter(
    workspace: WorkspaceIndex, file: str, file_facts: facts.Facts, function: facts.Function, name: str
) -> _Choices | None:
    """The texts that all calls of a method, in its file alone, give for a parameter that nothing assigns."""
    names = [param.name for param in function.params]
    assigned = (target for part in everything_in(function.body) for target in part.assigned)
    if names[:1] != ["self"] or name not in names[1:] or any(target.variable == name for target in assigned):
        return None
    methods = [each for each in everything_in(file_facts.body, facts.Function) if each.name == function.name]
    mentions = [each for each in everything_in(file_facts.body, facts.Attribute) if each.attr == function.name]
    calls = [call for call in everything_in(file_facts.body, facts.Call) if call.func.last_name == function.name]
    if len(methods) != 1 or not calls or len(mentions) != len(calls):
        return None
    if is_called_elsewhere(workspace, file, function.name):
        return None
    choices: set[str] = set()
    for call in calls:
        given = _given(call, names.index(name) - 1, name)
        texts = None if given is None else _texts_of(workspace, file, file_facts, given)
        if texts is None:
            return None
        choices |= texts
    return frozenset(choices)


def _given(call: facts.Call, position: int, name: str) -> facts.Expr | None:
    """What a call gives for a parameter."""
    if any(argument.star for argument in call.args):
        return None
    by_name = [argument.value for argument in call.args if argument.keyword == name]
    in_order = [argument.value for argument in call.args if not argument.keyword]
    return next(iter(by_name or in_order[position : position + 1]), None)


def _texts_of(workspace: WorkspaceIndex, file: str, file_facts: facts.Facts, given: facts.Expr) -> _Choices | None:
    match given:
        case facts.Literal(value=str(text)):
            return frozenset({text})
        case facts.Attribute(value=facts.Name(id="self"), attr=attr):
            return _choices_of_attribute(workspace, file, file_facts, attr)
    return None


def _values_of_enum(workspace: WorkspaceIndex, file: str, file_facts: facts.Facts) -> _Choices | None:
    """The values of the one enum of a program that no other file imports anything of, where all are texts."""
    if any(other != file for other in workspace.code.files_that_mention(_module(file))):
        return None
    enums = [
        cls
        for cls in everything_in(file_facts.body, facts.Class)
        if any(base.value.last_name in ("Enum", "StrEnum") for base in cls.bases)
    ]
    if len(enums) != 1:
        return None
    members = [each.value for each in enums[0].body if isinstance(each, facts.Assign)]
    texts = [value.value for value in members if isinstance(value, facts.Literal) and isinstance(value.value, str)]
    return frozenset(texts) if len(texts) == len(members) == len(enums[0].body) else None


def _parts(values: _Choices, part: facts.Slice) -> _Choices | None:
    """The same slice of each text; None where its ends are not written as numbers."""
    ends: list[int | None] = []
    for end in (part.lower, part.upper, part.step):
        match end:
            case None:
                ends.append(None)
            case facts.Literal(value=int(number)):
                ends.append(number)
            case facts.Unary(op="-", operand=facts.Literal(value=int(number))):
                ends.append(-number)
            case _:
                return None
    return frozenset(value[slice(*ends)] for value in values)


__all__ = ["is_never_chosen"]
