"""Loops that wait for what a thread of the same object sets at once: they end a moment after the program has started.

::

    def __init__(self):
        self.loop = None
        threading.Thread(target=self.serve).start()

    def serve(self):
        self.loop = asyncio.new_event_loop()
        ...
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.misspelt_constructor import CONSTRUCTOR
from archlint.syntax.parts import everything_in, parts_of
from archlint.syntax.walk import called_name, given_to, is_none

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall


def waits_for_its_thread(code: SourceCode, call: ApiCall) -> bool:
    """Whether a sleep is in a loop that ends once an attribute is set, and a thread that the constructor starts sets it
    before it does anything that may take long."""
    loop, file_facts = code.loop(call), code.facts_at(call.file)
    awaited = _awaited(loop.test) if isinstance(loop, facts.While) else ""
    if not awaited or file_facts is None:
        return False
    functions = list(everything_in(file_facts.body, facts.Function))
    targets = {name for each in functions if each.name == CONSTRUCTOR for name in _started(each)}
    if not any(each.name in targets and _sets_at_once(each, awaited) for each in functions):
        return False
    taken_back = (
        assignment
        for each in functions
        if each.name != CONSTRUCTOR
        for assignment in everything_in(each.body, facts.Assign)
        if is_none(assignment.value)
    )
    return not any(target.dotted == awaited for assignment in taken_back for target in assignment.targets)


def is_after_a_join(code: SourceCode, call: ApiCall) -> bool:
    """Whether a sleep is in a loop that never goes round: it asks whether a thread is alive for which the line before
    has waited without a limit."""
    loop = code.loop(call)
    asked = [_asked_thread(test) for test in loop.tests] if isinstance(loop, facts.While) else []
    blocks = [code.body(call), *(block for part in parts_of(code.body(call), facts.Statement) for block in part.blocks)]
    return any(
        statement is loop and any(_joined(before) in asked for before in block[:at])
        for block in blocks
        for at, statement in enumerate(block)
        if any(asked)
    )


def _asked_thread(test: facts.Expr) -> str | None:
    match test:
        case facts.Call(func=facts.Attribute(value=thread, attr="is_alive" | "isAlive"), args=[]):
            return thread.dotted or None
    return None


def _joined(statement: facts.Stmt) -> str:
    match statement:
        case facts.Expression(value=facts.Call(func=facts.Attribute(value=thread, attr="join"), args=[])):
            return thread.dotted
    return ""


def _awaited(test: facts.Expr) -> str:
    """``self.loop`` of ``self.loop is None`` and of ``not self.loop``."""
    match test:
        case facts.Compare(left=facts.Attribute() as left, ops=["is"] | ["=="], comparators=[other]) if is_none(other):
            return left.dotted
        case facts.Unary(op="not", operand=facts.Attribute() as operand):
            return operand.dotted
    return ""


def _started(constructor: facts.Function) -> Iterator[str]:
    """The methods that a constructor makes threads of."""
    for call in everything_in(constructor.body, facts.Call):
        target = given_to(call, "target", 1) if called_name(call) == "Thread" else None
        if target is not None and target.dotted.startswith("self."):
            yield target.attribute


def _sets_at_once(function: facts.Function, attribute: str) -> bool:
    """Whether a function assigns an attribute something before any loop, branch or ``with``."""
    for statement in function.body:
        if isinstance(statement, facts.Assign) and not is_none(statement.value):
            if any(target.dotted == attribute for target in statement.targets):
                return True
        elif not isinstance(statement, (facts.Assign, facts.Expression, facts.Function)):
            return False
    return False


__all__ = ["is_after_a_join", "waits_for_its_thread"]
