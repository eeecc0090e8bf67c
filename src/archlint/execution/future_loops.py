"""Loops that wait until a future is done: ``while not future.done()``, or ``if future.done(): break`` inside."""

from __future__ import annotations

from itertools import takewhile
from typing import TYPE_CHECKING

from archlint.analysis.reach import same_expression
from archlint.execution.loop_tests import is_only_after_shutdown
from archlint.syntax import facts
from archlint.syntax.control_flow import loop_of
from archlint.syntax.parts import names_in
from archlint.syntax.walk import blocks_of, called_name, parts_of, statements_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from archlint.analysis.source_code import Loop, SourceCode
    from archlint.model import ApiCall

_ORDER = frozenset({"<", "<=", ">", ">="})


def loop_until_done(code: SourceCode, call: ApiCall) -> Loop | None:
    """The loop around ``future.done()`` that ends with the future.  What always leaves its body does not wait.

    A loop that asks inside its body may also end after a while; if it ends for another reason, it is there for more.
    """
    loop, asked = code.loop(call), code.expression(call)
    if loop is None or asked is None or not loop_of(loop).repeats or is_only_after_shutdown(loop):
        return None
    if any(same_expression(part.negated, asked) for part in loop.tests):
        return loop
    if not any(holds and same_expression(test, asked) for test, holds in conditions_to_end(loop)):
        return None
    only_waits = not loop_of(loop).is_left_otherwise and all(map(_is_limit, _other_ends(loop, asked)))
    return loop if only_waits and (loop.tests or _counts(loop)) and _is_about_one(loop, asked) else None


def is_done_before(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop in front of a spin, in the same block, ends only once the future is done that it spins for."""
    statement, future = code.statement(call), _spun_for(code, call)
    if statement is None or not future:
        return False
    block = next((block for block in blocks_of(code.body(call)) if any(part is statement for part in block)), [])
    for part in reversed([*takewhile(lambda part: part is not statement, block)]):
        if isinstance(part, facts.While):
            return _waits_for(part, future)
        if any(target.dotted == future for target in part.assigned):
            return False
    return False


def _spun_for(code: SourceCode, call: ApiCall) -> str:
    """The variable or attribute with the future that a call spins for; rclpy's function has the node before it."""
    arguments = code.arguments(call)
    named = next((each.value for each in arguments if each.keyword == "future"), None)
    in_order = [each.value for each in arguments if each.keyword is None][0 if "Executor" in call.api else 1 :]
    future = named or next(iter(in_order), None)
    return "" if future is None else future.dotted


def _waits_for(loop: facts.While, future: str) -> bool:
    asked = loop.test.negated
    waits = isinstance(asked, facts.Call) and asked.func.dotted == f"{future}.done"
    return waits and not any(part.kind == "break" for part in statements_of(loop.body, facts.Jump))


def awaits_in_each_round(loop: Loop) -> bool:
    """Whether a loop gives its thread back before each further round: others run meanwhile, as with ``await``."""
    rounds = loop_of(loop)
    return rounds.is_in_every_round(*(block for block in rounds.blocks if any(parts_of(block.fact, facts.Await))))


def gives_up(code: SourceCode, call: ApiCall) -> bool:
    """Whether a loop around a future also ends by itself: a clock or a counter, or another way out of its body."""
    loop, asked = loop_until_done(code, call), code.expression(call)
    if loop is None or asked is None:
        return False
    return not loop.tests or loop_of(loop).is_left_otherwise or any(True for _ in _other_ends(loop, asked))


def ends_with_a_future(loop: Loop) -> bool:
    """Whether a loop asks whether something is done, and ends with it."""
    return any(holds and _asks(test) == "done" for test, holds in conditions_to_end(loop))


def conditions_to_end(loop: Loop) -> Iterator[tuple[facts.Expr, bool]]:
    """The conditions that end a loop as soon as they come out so."""
    return (condition for edge in loop_of(loop).endings for condition in edge.sufficient)


def _other_ends(loop: Loop, asked: facts.Call) -> Iterator[facts.Expr]:
    """The conditions that end a loop although the future is not done and ROS is not shut down."""
    for test, holds in conditions_to_end(loop):
        is_done = holds and same_expression(test, asked)
        if not is_done and not (_asks(test) == "ok" and not holds):
            yield test


def _is_limit(end: facts.Expr) -> bool:
    """``time.monotonic() >= deadline``, ``waited > timeout``"""
    match end:
        case facts.Compare(ops=[op]):
            return op in _ORDER
    return False


def _counts(loop: Loop) -> bool:
    return _asks(loop.head) == "range"


def _is_about_one(loop: Loop, asked: facts.Call) -> bool:
    """Whether each round asks the same future."""
    changed = {name for inner in statements_of([loop]) for target in inner.assigned for name in names_in(target)}
    return changed.isdisjoint(names_in(asked) - {"self"})


def _asks(test: facts.Expr) -> str:
    """The last name of the function that a condition is a call of."""
    match test:
        case facts.Call():
            return called_name(test)
    return ""
