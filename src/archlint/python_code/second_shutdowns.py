"""Programs that shut rclpy down after Ctrl-C, when its signal handler has done so.

Source: ``rclpy.init()`` installs a handler that shuts down every context at SIGINT and SIGTERM, before the spin of the
main thread ends with KeyboardInterrupt.  ``Context.shutdown`` in rclpy/context.py raises RCLError then ("rcl_shutdown
already called"), in humble and jazzy; ``rclpy.try_shutdown()`` does not.  Tried with rclpy of jazzy, and of kilted,
which says nothing.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.endless_constructors import comes_back, endless_classes
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import calls_in, parts_of, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

RAISING = frozenset({"humble", "jazzy"})
"""The distributions whose ``rclpy.shutdown()`` raises an error the second time."""
_SPINS = frozenset({"spin", "spin_once", "spin_until_future_complete"})
INTERRUPT = frozenset({"KeyboardInterrupt", "BaseException"})
OF_SIGNALS = frozenset(
    {"SignalHandlerOptions", "install_signal_handlers", "signal", "signal_handler_options", "uninstall_signal_handlers"}
)
"""Words of a program that has its own way with signals."""
_FAILS = frozenset({"call", "call_async", "publish", "send_goal", "send_goal_async", "wait_for_service"})
"""Calls that raise an error, or wait in vain, once the context is shut down: what stands behind them is not what fails
first."""
_LEAVES = frozenset({"exit", "_exit", "quit", "init"})
"""Calls after which the program does not come further, or has a context again."""


def second_shutdowns(workspace: WorkspaceIndex) -> Iterator[Place]:
    """Every such ``rclpy.shutdown()`` in the files that were asked for, outside of test code."""
    for path in workspace.python_files(mentioning="shutdown"):
        for span in _shutdowns(workspace, path) or ():
            yield Place(path, *span)


@kept_for_each_file
def _shutdowns(code: facts.Facts) -> list[facts.Span]:
    if not OF_SIGNALS.isdisjoint(code.names):
        return []
    threads = targets_of_threads(code)
    functions = [*everything_in(code.body, facts.Function)]
    failing = _failing(functions) | {f"{part.name}.destroy_node()" for part in everything_in(code.body, facts.Class)}
    endless = endless_classes(code)
    spans = [*_in_block(code.body, failing, endless)]
    for function in functions:
        if function.name not in threads:
            spans += _in_block(function.body, failing, endless)
    return [*dict.fromkeys(spans)]


def _failing(functions: Sequence[facts.Function]) -> Set[str]:
    """The names of what raises an error without a context: functions that call something which does so."""
    failing, known = _FAILS, 0
    while len(failing) > known:
        known = len(failing)
        failing = failing.union(each.name for each in functions if _asks_a_context(each.body, failing))
    return failing


def targets_of_threads(code: facts.Facts) -> frozenset[str]:
    """The names of the functions that a file gives to threads: Ctrl-C does not end what these spin."""
    arguments = (argument for call in everything_in(code.body, facts.Call) for argument in call.args)
    return frozenset(argument.value.last_name for argument in arguments if argument.keyword == "target")


def _in_block(block: Sequence[facts.Stmt], failing: Set[str], endless: Set[str]) -> Iterator[facts.Span]:
    """The shutdowns behind the spins of a block and of those inside, but for functions and classes in it.  What calls
    something ``failing`` ends the program before, and so does Ctrl-C in a constructor that is ``endless``."""
    for at, statement in enumerate(block):
        if isinstance(statement, (facts.Function, facts.Class)):
            continue
        if isinstance(statement, facts.Try) and _spins(statement.body) and comes_back(block[:at], endless):
            yield from _behind(statement, block[at + 1 :], failing)
        for inner in statement.blocks:
            yield from _in_block(inner, failing, endless)


def _behind(attempt: facts.Try, after: Sequence[facts.Stmt], failing: Set[str]) -> Iterator[facts.Span]:
    """The first shutdown that a program comes to when Ctrl-C ends the spin in a ``try``."""
    catching = [handler for handler in attempt.handlers if handler.type is None or handler.caught & INTERRUPT]
    goes_on = bool(catching) and not any(leaves(statement) for statement in statements_of(catching[0].body))
    ways = [*(handler.body for handler in catching[:1]), attempt.final, *([after] if goes_on else [])]
    for way in ways:
        span, fails = _first_shutdown(way, failing)
        if span is not None:
            yield span
        if span is not None or fails:
            return


def _first_shutdown(statements: Sequence[facts.Stmt], failing: Set[str]) -> tuple[facts.Span | None, bool]:
    """The first shutdown of some statements, and whether something fails before they come to it."""
    for statement in statements:
        match statement:
            case facts.Expression(value=facts.Call(args=[]) as call) if call.func.dotted == "rclpy.shutdown":
                return call.span, False
        if _asks_a_context([statement], failing):
            return None, True
        if leaves(statement):
            return None, False
    return None, False


def _asks_a_context(block: Sequence[facts.Stmt], failing: Set[str]) -> bool:
    """Whether statements call something ``failing``, unless they ask before whether rclpy is there, or go on after an
    error."""
    for statement in block:
        if isinstance(statement, facts.Try) and statement.handlers:
            continue
        if asks_whether_it_runs(statement):
            continue
        calls = calls_in(statement) if not statement.blocks else ()
        if any(call.func.last_name in failing or _without_object(call) in failing for call in calls):
            return True
        if any(_asks_a_context(inner, failing) for inner in statement.blocks):
            return True
    return False


def _without_object(call: facts.Call) -> str:
    """A call as it is written, if it has no arguments: ``Robot.destroy_node()`` lacks the object that it is for."""
    return "" if call.args else f"{call.func.dotted}()"


def asks_whether_it_runs(statement: facts.Stmt) -> bool:
    """Whether a branch asks for ``rclpy.ok()``."""
    if not isinstance(statement, facts.If):
        return False
    return any(call.func.attribute == "ok" for call in parts_of(statement.test, facts.Call))


def leaves(statement: facts.Base) -> bool:
    """Whether code does not come behind a statement, or what it does there is another matter."""
    if isinstance(statement, (facts.Return, facts.Raise)) or (
        isinstance(statement, facts.Jump) and statement.kind != "pass"
    ):
        return True
    return any(call.func.last_name in _LEAVES for call in calls_in(statement))


def _spins(body: Sequence[facts.Stmt]) -> bool:
    calls = (call for statement in statements_of(body) for call in calls_in(statement))
    return any(call.func.attribute in _SPINS for call in calls)


__all__ = [
    "INTERRUPT",
    "OF_SIGNALS",
    "RAISING",
    "asks_whether_it_runs",
    "leaves",
    "second_shutdowns",
    "targets_of_threads",
]
