"""Loops that spin to the end in each round: ``while not node.stopped: executor.spin()``, ``for node in nodes:
rclpy.spin(node)``.

Source: ``Executor.spin`` in rclpy/executors.py returns when the context is shut down or the executor is, and
``rclpy.spin`` goes on for as long; what a callback raises passes both.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.reach import calls_of
from archlint.analysis.source_code import source_code
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, targets_in
from archlint.syntax.walk import called_name, calls_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall, Program
    from archlint.systems.model import System

_SPINS = ("rclpy.spin", "rclpy.executors.Executor.spin")
_ENDS_ROS = frozenset({"shutdown", "try_shutdown"})
_LEAVES = frozenset({"exit", "_exit", "quit", "kill", "SystemExit", "KeyboardInterrupt", "ExternalShutdownException"})


@dataclass(frozen=True)
class DeafLoop:
    """A loop that asks for ``asked`` once, or, where that is empty, that spins the first of several nodes alone: the
    spin in it returns only when ROS is shut down."""

    call: ApiCall
    loop: Place
    asked: str


def deaf_loops(system: System) -> Iterator[DeafLoop]:
    """Every such loop outside of test code whose spin nothing that is seen ends before."""
    code = source_code(system)
    for program, call in calls_of(system, _SPINS):
        loop = code.loop(call)
        if isinstance(loop, facts.For) and _spins_each(loop, call):
            yield DeafLoop(call, Place.of(call.file, getattr(loop.target, "span", loop.span)), "")
        if not isinstance(loop, facts.While) or _is_tried_again(loop, call):
            continue
        asked = [name for name in _asked(loop.test) if not _is_set_in(loop, name)]
        if asked and not _ends_otherwise(code, program, call, asked[0].rpartition(".")[2]):
            yield DeafLoop(call, Place.of(call.file, getattr(loop.test, "span", loop.span)), asked[0])


def _asked(test: facts.Expr) -> list[str]:
    """The attributes and variables for which a test asks, as they are written, but for whether ROS runs."""
    left_out = {Itself(part) for call in calls_in(test) if called_name(call) == "ok" for part in everything_in([call])}
    left_out |= {Itself[facts.Base](call.func) for call in calls_in(test)}
    left_out |= {
        Itself[facts.Base](part.value)
        for part in everything_in([test], facts.Attribute)
        if Itself[facts.Base](part) not in left_out
    }
    asked = (part for part in everything_in([test]) if Itself(part) not in left_out)
    return [part.dotted for part in asked if isinstance(part, (facts.Name, facts.Attribute)) and part.dotted]


def _spins_each(loop: facts.For, call: ApiCall) -> bool:
    """Whether a loop over nodes or executors spins each in its round, with nothing that ends the loop after the first,
    catches what ends the spin, or changes threads."""
    names = {name.id for name in everything_in([loop.target], facts.Name)}
    ends = any(isinstance(part, (facts.Return, facts.Raise, facts.Try)) for part in everything_in(loop.body))
    if ends or any(jump.kind == "break" for jump in everything_in(loop.body, facts.Jump)):
        return False
    if isinstance(loop.iterable, facts.Sequence) and len(loop.iterable.elements) < 2:
        return False
    for statement in loop.body:
        match statement:
            case facts.Expression(value=facts.Call(func=facts.Attribute(value=owner), args=given) as spin):
                if spin.span == call.place.span:
                    return any(part.variable in names for part in (owner, *(argument.value for argument in given)))
    return False


def _is_set_in(loop: facts.While, name: str) -> bool:
    """Whether the loop itself changes what it asks for."""
    targets = (target for part in everything_in(loop.body) for each in part.assigned for target in targets_in(each))
    return any(target.dotted == name for target in targets if isinstance(target, (facts.Name, facts.Attribute)))


def _is_tried_again(loop: facts.While, call: ApiCall) -> bool:
    """Whether the loop goes on after what a callback has raised: then it asks again."""
    tries = everything_in(loop.body, facts.Try)
    return any(inner.span == call.place.span for attempt in tries for inner in calls_in(attempt.body))


def _ends_otherwise(code: SourceCode, program: Program, call: ApiCall, name: str) -> bool:
    """Whether another function, in the file or in those of the program's nodes, shuts ROS or an executor down, or
    leaves the program where it sets what the loop asks for."""
    own = code.function_at(call.place)
    files = {call.file, *(cls.place.file for node in program.nodes for cls in node.classes)}
    for file in sorted(files):
        file_facts = code.facts_at(file)
        if file_facts is None:
            return True
        for function in everything_in(file_facts.body, facts.Function):
            names = {called_name(inner) for inner in calls_in(function.body)} if function is not own else set()
            if not names.isdisjoint(_ENDS_ROS):
                return True
            if not names.isdisjoint(_LEAVES) and function.name != "__init__" and _sets(function, name):
                return True
    return False


def _sets(function: facts.Function, name: str) -> bool:
    targets = (target for part in everything_in(function.body) for target in part.assigned)
    called = (inner.func for inner in calls_in(function.body))
    return any(part.last_name == name for part in targets) or any(
        isinstance(func, facts.Attribute) and func.value.last_name == name for func in called
    )


__all__ = ["DeafLoop", "deaf_loops"]
