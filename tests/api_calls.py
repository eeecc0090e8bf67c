"""A call of an API in a piece of Python, as linking would note it."""

from __future__ import annotations

import textwrap

from archlint.analysis.source_code import SourceCode
from archlint.finding import Place
from archlint.model import ApiCall, Callback, Frame, FunctionRef, Role
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.python.lowering import lower
from archlint.syntax.walk import called_name, calls_in

FILE = "robot/node.py"


def call_in(text: str, name: str, *through: str) -> tuple[SourceCode, ApiCall]:
    """The call of a function by its name, with all loops around it; ``through`` are the names of the calls that lead
    from the first function of the text to the one that it is in."""
    found = lower(textwrap.dedent(text))
    calls = list(everything_in(found.body, facts.Call))
    [written] = [call for call in calls if called_name(call) == name]
    loops = [
        loop
        for kind in (facts.While, facts.For)
        for loop in everything_in(found.body, kind)
        if any(call is written for call in calls_in(loop.body))
    ]
    places = tuple(sorted(_place(loop) for loop in loops))
    function = next(iter(everything_in(found.body, facts.Function)), None)
    ref = None if function is None else FunctionRef(function.name, Place.of(FILE, function.name_span))
    context = Callback(Role.TIMER, "tick", Place(FILE, 1, 1, 1, 1), ref, file=FILE)
    hops = [call for each in through for call in calls if called_name(call) == each]
    chain = tuple(Frame("", called_name(hop), _place(hop)) for hop in hops)
    call = ApiCall("an.api", _place(written), context, chain, {}, {}, file=FILE, loops=places, enclosing_loops=places)
    call.limits = (None,) * len(places)
    return SourceCode(lambda file: found if file == FILE else None), call


def _place(fact: facts.Base) -> Place:
    return Place.of(FILE, fact.span)
