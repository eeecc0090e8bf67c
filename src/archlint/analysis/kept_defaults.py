"""Code for another value of a parameter than its default, which no call gives: ``if attention:``, where the function is
``def layer(size, attention=False)`` and nobody in the workspace says ``attention=True``."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.analysis.source_code import code_of
from archlint.syntax import facts
from archlint.syntax.comparisons import COMPARISONS
from archlint.syntax.control_flow import graph_of
from archlint.syntax.flow_facts import covers, outcome
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex


_SAME = {"is": True, "==": True, "is not": False, "!=": False}


def needs_another_default(workspace: WorkspaceIndex | None, place: Place) -> bool:
    """Whether a function gets to a place only where a parameter has another value than its default, and nobody gives
    it one."""
    function = None if workspace is None else code_of(workspace).function_at(place)
    defaults = {} if function is None else _defaults(function)
    if workspace is None or function is None or not defaults:
        return False
    return any(
        outcome(test, lambda part: truth_of_constants(part, defaults)) is (not holds)
        and not any(_is_given(workspace, place.file, function, name) for name in _asked(test, defaults))
        for test, holds in _tests(code_of(workspace).body_at(place), place)
    )


def _defaults(function: facts.Function) -> dict[str, facts.Literal]:
    """The parameters with a constant as their default to which the function assigns nothing."""
    assigned = {target.variable for part in everything_in(function.body) for target in part.assigned}
    return {
        param.name: param.default
        for param in function.params
        if isinstance(param.default, facts.Literal) and param.name not in assigned
    }


def _tests(body: Sequence[facts.Stmt], place: Place) -> Iterator[tuple[facts.Expr, bool]]:
    """What has been asked on every way to a place, with how it has come out: ``if``, and ``x if test else y``."""
    graph = graph_of(body)
    blocks = graph.evaluating(place.span)
    for edge in graph.outcomes(blocks):
        if edge.test is not None:
            yield edge.test, edge.holds
    for block in blocks[:1]:
        for choice in everything_in(() if block.fact is None else (block.fact,), facts.Conditional):
            if covers(choice.body, place.span) or covers(choice.orelse, place.span):
                yield choice.test, covers(choice.body, place.span)


def truth_of_constants(part: facts.Expr, defaults: Mapping[str, facts.Literal]) -> bool | None:
    """Whether a part of a condition holds where names, or attributes such as ``self.delay``, have their defaults."""
    if part.dotted in defaults:
        return bool(defaults[part.dotted].value)
    match part:
        case facts.Compare(left=left, ops=[op], comparators=[facts.Literal(value=other)]):
            value = defaults[left.dotted].value if left.dotted in defaults else Ellipsis
            if value is Ellipsis:
                return None
            if other is None or value is None:
                return {"is": value is other, "==": value is other, "is not": value is not other}.get(op)
            if isinstance(value, bool) and isinstance(other, bool) and op in _SAME:
                return (value is other) is _SAME[op]
            if isinstance(value, str) and isinstance(other, str) and op in ("==", "!="):
                return (value == other) is _SAME[op]
            if isinstance(value, (int, float)) and isinstance(other, (int, float)) and op in COMPARISONS:
                return COMPARISONS[op](value, other)
    return None


def _asked(test: facts.Expr, defaults: dict[str, facts.Literal]) -> list[str]:
    return sorted({name.id for name in everything_in([test], facts.Name)} & defaults.keys())


def _is_given(workspace: WorkspaceIndex, file: str, function: facts.Function, name: str) -> bool:
    """Whether somebody may give a parameter a value: a call that says its name, or that gives so many arguments."""
    keywords, texts, derived = _words(workspace)
    called = _called_as(workspace, file, function)
    if called is None or name in keywords or name in texts or called in derived:
        return True
    names = [param.name for param in function.params if param.kind in ("positional_only", "normal")]
    bound = names[:1] in (["self"], ["cls"])
    if name not in names:
        return False
    position = names.index(name) - bound
    paths = workspace.code.files_that_mention(called)
    if not any(_is_used(workspace, path, called, function if path == file else None) for path in paths):
        return True  # by whoever has this package as a library
    calls = (call for path in paths for call in _calls(workspace, path, called))
    return any(any(given.star for given in call.args) or len(call.args) > position for call in calls)


def _is_used(workspace: WorkspaceIndex, path: str, name: str, function: facts.Function | None) -> bool:
    """Whether a file has a word for something, other than inside of the function itself."""
    code = workspace.facts_at(path)
    body = () if code is None else code.body
    uses: list[facts.Name | facts.Attribute] = [*everything_in(body, facts.Name)]
    uses += everything_in(body, facts.Attribute)
    return any(use.last_name == name and (function is None or not covers(function, use.span)) for use in uses)


def _called_as(workspace: WorkspaceIndex, file: str, function: facts.Function) -> str | None:
    """What those write who call a function: of a constructor the name of its class."""
    if function.name != "__init__":
        return function.name
    code = workspace.facts_at(file)
    classes = () if code is None else everything_in(code.body, facts.Class)
    return next((cls.name for cls in classes if any(part is function for part in cls.body)), None)


def _calls(workspace: WorkspaceIndex, path: str, name: str) -> Iterator[facts.Call]:
    """The calls of what has a name, and those that make another callable of it, ``partial(name, …)``."""
    code = workspace.facts_at(path)
    for call in () if code is None else everything_in(code.body, facts.Call):
        if call.func.last_name == name:
            yield call
        elif called_name(call) == "partial" and call.args and call.args[0].value.last_name == name:
            yield facts.Call(call.func, call.args[1:], call.span)


@once
def _words(workspace: WorkspaceIndex) -> tuple[frozenset[str], frozenset[str], frozenset[str]]:
    """All keywords of calls in the workspace, the keys of dicts, which ``**`` makes keywords, and the classes that
    others derive from."""
    rows = [row for file, _ in workspace.code.asked_for() if (row := _words_of(workspace, file.relative)) is not None]
    keywords, keys, bases = (frozenset[str]().union(*(row[at] for row in rows)) for at in range(3))
    return keywords, keys, bases


@kept_for_each_file
def _words_of(code: facts.Facts) -> tuple[frozenset[str], frozenset[str], frozenset[str]]:
    keywords = {given.keyword for call in everything_in(code.body, facts.Call) for given in call.args if given.keyword}
    literals = (literal.text for literal in everything_in(code.body, facts.Literal))
    texts = {text for text in literals if text is not None and text.isidentifier()}
    bases = {base.value.last_name for cls in everything_in(code.body, facts.Class) for base in cls.bases}
    return frozenset(keywords), frozenset(texts), frozenset(bases)


__all__ = ["needs_another_default", "truth_of_constants"]
