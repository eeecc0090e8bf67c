"""``perform()`` as the code of a launch file calls it: with the launch context, or with something that is none."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from archlint.interpreter.refusals import is_certain
from archlint.interpreter.values import DictValue, Known, ListValue, Unknown, Value
from archlint.launch.mistakes import WithoutContext
from archlint.launch.objects import argument, class_name, kind_of, made_by_base
from archlint.launch.tables import LaunchClass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun


def perform_method(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``substitution.perform(context)``."""
    asked = made_by_base(run, receiver) or receiver  # a class of the workspace asks its base
    given = site.values
    wrong = _not_a_context(given[0] if given else None)
    if wrong is not None and kind_of(asked) is not LaunchClass.TEXT_SUBSTITUTION:  # which does not look at the context
        _note(run, site.expression, asked, wrong)
        return Unknown("perform() without the launch context")
    if not _is_new_context(given, site.expression):
        return run.perform(asked)
    if kind_of(asked) == LaunchClass.LAUNCH_CONFIGURATION and argument(asked, "default") is None:
        _note(run, site.expression, asked, "")
        return Unknown("a launch configuration in a context of its own")
    with _empty_context(run):
        return run.perform(asked)


def is_without_context(run: LaunchRun, tested: Value | None, site: CallSite) -> bool:
    """Whether ``IfCondition(LaunchConfiguration(…)).evaluate()`` is given what is no context, as is noted."""
    wrong = _not_a_context(site.values[0] if site.values else None)
    if wrong is None or tested is None or kind_of(tested) is not LaunchClass.LAUNCH_CONFIGURATION:
        return False
    _note(run, site.expression, tested, wrong)
    return True


def _note(run: LaunchRun, e: facts.Call | None, asked: Value, given: str) -> None:
    if e is not None and stops_the_launch(run):
        run.note_without_context(WithoutContext(class_name(asked), given, run.place(e.span)))


def stops_the_launch(run: LaunchRun) -> bool:
    """Whether the launch certainly comes to the expression that is evaluated, and stops there if that raises."""
    return is_certain(run) and not run.is_conditional and not any(activation.tries for activation in run.activations)


def _not_a_context(value: Value | None) -> str | None:
    """What a value is called that is no launch context; None where it may be one."""
    match value:
        case DictValue():
            return "a dict"
        case ListValue():
            return "a list"
        case Known(value=None):
            return "None"
        case Known():
            return "something else"
    return None


def _is_new_context(given: list[Value], e: facts.Call | None) -> bool:
    """Whether ``perform(LaunchContext())`` makes the context that it is given: no launch argument has a value there."""
    is_context = kind_of(given[0] if given else None) == LaunchClass.LAUNCH_CONTEXT
    return is_context and e is not None and bool(e.args) and isinstance(e.args[0].value, facts.Call)


@contextmanager
def _empty_context(run: LaunchRun) -> Iterator[None]:
    kept, run.launch.configurations = run.launch.configurations, {}
    try:
        with run.perhaps():
            yield
    finally:
        run.launch.configurations = kept
