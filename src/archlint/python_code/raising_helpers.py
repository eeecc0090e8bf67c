"""Calls that never come back: of a function of the workspace whose every path raises, such as ``self.fail(text)``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.python_code.class_chains import Chain, ClassInFile, chain_of, classes_of, files_with, methods_of
from archlint.syntax import facts
from archlint.syntax.control_flow import graph_of
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DEPTH = 3
"""Through how many helpers that call each other it is looked."""

NeverReturns = Callable[[facts.Base], bool]
"""Whether a statement ends in an exception, since it calls a helper that always raises."""


def never_returns(
    workspace: WorkspaceIndex | None, file: str, function: facts.Function, depth: int = _DEPTH
) -> NeverReturns:
    """What ends a path through a function of a file because a helper raises."""
    if workspace is None or depth == 0:
        return lambda fact: False
    known: dict[str, bool] = {}

    def ends(fact: facts.Base) -> bool:
        match fact:
            case facts.Expression(value=facts.Call(func=called)) | facts.Assign(value=facts.Call(func=called)):
                name = called.dotted
                if name not in known:
                    helpers = list(_meant(workspace, file, function, name))
                    known[name] = bool(helpers) and all(
                        _always_raises(workspace, *helper, depth - 1) for helper in helpers
                    )
                return known[name]
        return False

    return ends


def _always_raises(workspace: WorkspaceIndex, file: str, helper: facts.Function, depth: int) -> bool:
    """Whether a call of a function certainly raises, other than to say that a subclass has to define it."""
    if helper.decorators or helper.is_async or helper.is_generator or _is_abstract(helper):
        return False
    ends_path = never_returns(workspace, file, helper, depth)
    ends = graph_of(helper.body).ends(True, lambda alive, fact: alive and not ends_path(fact))
    return True not in ends.falls and not any(True in states for _, states in ends.returns)


def is_caught_inside(
    workspace: WorkspaceIndex, file: str, function: facts.Function, attempt: facts.Try, handler: facts.Handler
) -> bool:
    """Whether all that an attempt does is to call one function of the workspace, or more, that catch themselves what a
    handler is for, and go on: nothing of it is left for the handler."""
    calls = [call for statement in attempt.body for call in everything_in([statement], facts.Call)]
    plain = not any(everything_in(attempt.body, facts.Subscript)) and not any(everything_in(attempt.body, facts.Await))
    return plain and bool(calls) and all(_catches(workspace, file, function, call, handler.caught) for call in calls)


def _catches(
    workspace: WorkspaceIndex, file: str, function: facts.Function, call: facts.Call, errors: frozenset[str]
) -> bool:
    """Whether a call runs only functions of which all but the docstring is tried, and whose handlers for some errors
    return something."""
    helpers = [helper for _, helper in _meant(workspace, file, function, call.func.dotted)]
    return bool(helpers) and all(_is_tried(helper, errors) for helper in helpers)


def _is_tried(helper: facts.Function, errors: frozenset[str]) -> bool:
    match [each for each in helper.body if not _is_text(each)]:
        case [facts.Try(handlers=handlers), *rest] if not (helper.decorators or helper.is_async or helper.is_generator):
            own = [each for each in handlers if each.type is None or each.caught & _ANYTHING or errors <= each.caught]
            return bool(own) and all(map(_returns_something, own)) and all(map(_is_return, rest))
    return False


def _returns_something(handler: facts.Handler) -> bool:
    """Whether a handler ends in ``return``, and does nothing before but to say so: a value that is None may be the next
    thing to fail."""
    *before, last = handler.body
    says = all(isinstance(each, facts.Expression) and not _raises_again([each]) for each in before)
    return says and _is_return(last) and not _raises_again(handler.body)


def _is_return(statement: facts.Base) -> bool:
    value = statement.value if isinstance(statement, facts.Return) else None
    return value is not None and not any(everything_in([value], facts.Call)) and not _is_none(value)


def _is_none(value: facts.Expr) -> bool:
    return isinstance(value, facts.Literal) and value.value is None


def _raises_again(body: Sequence[facts.Base]) -> bool:
    return any(everything_in(body, facts.Raise))


def _is_text(statement: facts.Base) -> bool:
    return isinstance(statement, facts.Expression) and isinstance(statement.value, facts.Literal)


_ANYTHING = frozenset({"BaseException", "Exception"})


def _is_abstract(helper: facts.Function) -> bool:
    raised = (statement.value for statement in statements_of(helper.body, facts.Raise) if statement.value is not None)
    return any("NotImplementedError" in (part.id for part in everything_in(value, facts.Name)) for value in raised)


def _meant(
    workspace: WorkspaceIndex, file: str, function: facts.Function, called: str
) -> Iterator[tuple[str, facts.Function]]:
    """The functions that a call by name may run: several where classes that derive from its own define it, too."""
    file_facts = workspace.facts_at(file)
    owner, _, name = called.rpartition(".")
    if file_facts is None or "." in owner or not name:
        return
    if not owner:
        bound = [statement for statement in file_facts.body if name in _bound_by(statement)]
        if len(bound) == 1 and isinstance(bound[0], facts.Function):
            yield file, bound[0]
    elif function.params and owner == function.params[0].name:
        own = next((cls for cls in classes_of(file_facts) if any(m is function for m in methods_of(cls))), None)
        if own is not None:
            yield from _methods_named(workspace, ClassInFile(file, own), name)


def _bound_by(statement: facts.Stmt) -> list[str]:
    match statement:
        case facts.Function(name=name) | facts.Class(name=name):
            return [name]
        case facts.ImportFrom(names=names):
            return [bound for _, bound in names]
    return [target.variable for target in statement.assigned if target.variable]


def _methods_named(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> Iterator[tuple[str, facts.Function]]:
    """The method of that name of a class, and those of the classes that derive from it."""
    own = _in_chain(chain_of(workspace, cls), name)
    if own is None:
        return
    yield own
    for file in files_with(workspace, name):
        file_facts = workspace.facts_at(file)
        for other in classes_of(file_facts) if file_facts is not None else ():
            chain = chain_of(workspace, ClassInFile(file, other))
            method = _in_chain(chain, name) if other is not cls.code and chain.has(cls) else None
            if method is not None:
                yield method


def _in_chain(chain: Chain, name: str) -> tuple[str, facts.Function] | None:
    for cls in chain.own:
        for method in methods_of(cls.code):
            if method.name == name:
                return cls.file, method
    return None


__all__ = ["NeverReturns", "is_caught_inside", "never_returns"]
