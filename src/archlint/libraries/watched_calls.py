"""The calls of libraries that checks want to see, each once a place and context."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import Value
from archlint.libraries.api_use import argument_places
from archlint.libraries.givens import given_by
from archlint.libraries.python import clocks
from archlint.libraries.rclpy import cleaning_up, message_contents, nodes, parameters, transform_frames
from archlint.libraries.tables import Api
from archlint.libraries.values import MessageValue, creations_of
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.libraries.run import Run

Bound = dict[str, Value]
"""The arguments of a call by the names of the parameters."""
_SENT = ("request", "goal")
"""The parameters that take what is sent to a server."""


def note(run: Run, api: Api, receiver: Value | None, bound: Bound, expression: facts.Call) -> None:
    """Note a call where the code that makes it is known."""
    if not run.activations:
        return
    on = creations_of(receiver)
    key = _key(run, api, on, bound, expression)
    known = run.noted.watched.get(key)
    frames = transform_frames.frames_of(run, api.path, bound)
    if known is not None:
        known.frames += [pair for pair in frames if pair not in known.frames]
        _meet_again(run, known, on, bound)
        _sent_again(run, known, bound)
        return
    call = _new(run, api, receiver, bound, expression)
    call.frames += dict.fromkeys(frames)
    run.noted.watched[key] = call
    run.program.calls.append(call)


def _key(
    run: Run, api: Api, on: tuple[model.Creation, ...], bound: Bound, expression: facts.Call
) -> tuple[object, ...]:
    """What two calls have in common that are one for the checks."""
    key: tuple[object, ...] = (api.path, run.place(expression.span), id(run.context))
    if api.path == "rclpy.publisher.Publisher.publish" and len(on) == 1:
        key = (*key, id(on[0]))  # what is published where, for each publisher that a loop or a helper serves
    if api.path == "rclpy.timer.Timer.cancel":
        key = (*key, *(id(creation) for creation in on))  # which timers end here, whichever was there at first
    if api.path in parameters.BY_NAME:
        key = (*key, bound.get("name"))  # what a helper reads, for each name that it is given
    return key


def _meet_again(run: Run, known: model.ApiCall, on: tuple[model.Creation, ...], bound: Bound) -> None:
    """A call that was noted before: in another round of a loop, in another branch, or on another way."""
    if known.cleaning and not cleaning_up.is_cleaning_up(run):
        known.cleaning, known.chain, known.branch_arms = False, run.chain(), tuple(run.branch_arms)
    if known.creation is None and len(on) == 1:
        known.creation = on[0]
    known.conditional = known.conditional and bool(run.branch_arms)
    chain = run.chain()
    if chain != known.chain and any(limit is not None for limit in known.limits):
        known.limits = tuple(map(_longer, known.limits, _limits_of_loops(run)))
    is_other_way = chain != known.chain and tuple(run.branch_arms) == known.branch_arms
    if known.enclosing_loops and not is_other_way:
        return  # as in most rounds of a loop; finding the loops around takes long
    enclosing_loops = run.enclosing_loops()
    known.enclosing_loops = known.enclosing_loops or enclosing_loops
    if is_other_way and all((chain, enclosing_loops) != other[:2] for other in known.call_chains):
        known.call_chains.append((chain, enclosing_loops, on or creations_of(bound.get("future"))))


def _new(run: Run, api: Api, receiver: Value | None, bound: Bound, expression: facts.Call) -> model.ApiCall:
    activation = run.activation
    on = creations_of(receiver)
    first = on[0] if len(on) == 1 else None
    return model.ApiCall(
        api.path,
        run.place(expression.span),
        run.context,
        run.chain(),
        {name: _given(run, name, value) for name, value in bound.items()},
        argument_places(run, api, expression),
        None if receiver is None else given_by(receiver, run.program.process),
        first,
        first.node if first is not None else nodes.known_node(run, receiver),
        activation.qualified,
        activation.module.path,
        tuple(activation.place(loop.span) for loop in run.loops_of(activation)),
        bool(run.branch_arms),
        False,
        any(frame.tries for frame in run.activations),
        run.enclosing_loops(),
        tuple(run.branch_arms),
        _limits_of_loops(run),
        cleaning_up.is_cleaning_up(run),
    )


def _given(run: Run, name: str, value: Value) -> model.given.Given:
    if name in _SENT and isinstance(value, MessageValue):
        content = message_contents.content_of(run, value)
        return model.given.Message(value.type, value.section_name, content)
    return given_by(value, run.program.process)


def _sent_again(run: Run, known: model.ApiCall, bound: Bound) -> None:
    """What a request carries that is not always the same."""
    for name in _SENT:
        before = known.arguments.get(name)
        if isinstance(before, model.given.Message) and name in bound:
            now = _given(run, name, bound[name])
            content = now.content if isinstance(now, model.given.Message) else None
            known.arguments[name] = replace(before, content=message_contents.both(before.content, content))


def _limits_of_loops(run: Run) -> tuple[float | None, ...]:
    return tuple(clocks.limit_of(run, loop) for loop in run.loops_of(run.activation))


def _longer(limit: float | None, other: float | None) -> float | None:
    """The limit of a loop that runs with either of two."""
    return None if limit is None or other is None else max(limit, other)


__all__ = ["note"]
