"""Code that is made for an answer which does not come: a branch that only a limit would ever lead to."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.flow_facts import conditions_of
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import is_none, statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall

_ASKS = frozenset({"result", "done"})
"""What a future is asked whether its answer is there."""


def expects_no_answer(code: SourceCode, call: ApiCall) -> bool:
    """Whether the function around a spin asks afterwards whether the answer has come::

    rclpy.spin_until_future_complete(self, future)
    if future.result() is None:
    """
    futures = {given.value.dotted for given in code.arguments(call) if given.value.dotted}
    answers = set(futures)
    for assignment in statements_of(code.body(call), facts.Assign):
        if _asked(assignment.value) in futures and isinstance(assignment.value, facts.Call):
            answers.update(target.dotted for target in assignment.targets if target.dotted)
    body = code.body(call)
    tests = [choice.test for choice in everything_in(body, facts.If)]
    tests += [loop.test for loop in everything_in(body, facts.While)]
    later = (test for test in tests if getattr(test, "span", call.place.span)[:2] > call.place.span[:2])
    return any(not answers.isdisjoint(_of_test(test)) for test in later)


def _asked(value: facts.Expr) -> str:
    """The future of ``future.result()``; the variable itself."""
    if isinstance(value, facts.Call):
        return value.func.value.dotted if isinstance(value.func, facts.Attribute) and value.func.attr in _ASKS else ""
    return value.dotted


def _of_test(test: facts.Expr) -> Iterator[str]:
    """What a condition asks whether it is there."""
    for condition in conditions_of(test):
        match condition:
            case facts.Compare(left=left, comparators=[other]) if is_none(other):
                yield _asked(left)
            case _:
                yield _asked(condition)


__all__ = ["expects_no_answer"]
