"""Whether whoever asks for a service says how long its handler takes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, takewhile
from typing import TYPE_CHECKING

from archlint.execution.loop_times import clock_tests
from archlint.syntax import facts
from archlint.syntax.parts import names_in
from archlint.syntax.walk import statements_of

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import ApiCall


def lasts_as_requested(code: SourceCode, call: ApiCall) -> bool:
    """Whether a handler's request says how long a call of it takes, perhaps as an argument of a method::

    time.sleep(request.seconds)
    ...
    deadline = time.monotonic() + request.timeout
    while time.monotonic() < deadline:
        time.sleep(0.1)
    """
    requested = _names_of_request(code, call)
    loops = [loop for loop in code.loops(call) if loop.tests]
    if not loops:
        return not requested.isdisjoint(names_in(code.expression(call)))
    return all(not requested.isdisjoint(names_in(clock_tests(loop))) for loop in loops)


def _names_of_request(code: SourceCode, call: ApiCall) -> set[str]:
    """The variables, in the function that holds a call, that a handler's request decides."""
    function, bound = code.definition(call.context), call.context.bound_arguments
    known = set() if function is None else {param.name for param in function.params[bound : bound + 1]}
    places = [*(frame.place for frame in call.chain), call.place]
    for caller, inside in pairwise(places):
        known = set(_passed_on(code, caller, inside, _with_derived(code, caller, known)))
    return _with_derived(code, call.place, known)


def _with_derived(code: SourceCode, place: Place, known: set[str]) -> set[str]:
    """Variables of the function around a place, with those that it makes of them."""
    known = set(known)
    for assignment in statements_of(code.body_at(place), facts.Assign):
        if not known.isdisjoint(names_in(assignment.value)):
            known |= {target.variable for target in assignment.targets} - {""}
    return known


def _passed_on(code: SourceCode, caller: Place, inside: Place, known: set[str]) -> Iterator[str]:
    """The parameters of the function around ``inside``, which ``caller`` calls, that some variables decide."""
    call, callee = code.call_at(caller), code.function_at(inside)
    if call is None or callee is None:
        return
    names = [param.name for param in callee.params if param.kind in ("positional_only", "normal")]
    if isinstance(call.func, facts.Attribute) and names[:1] in (["self"], ["cls"]):
        names = names[1:]
    positional = list(takewhile(lambda argument: not argument.star and not argument.keyword, call.args))
    given = {argument.keyword: argument.value for argument in call.args if argument.keyword}
    given |= {name: argument.value for name, argument in zip(names, positional, strict=False)}
    yield from (name for name, value in given.items() if not known.isdisjoint(names_in(value)))
