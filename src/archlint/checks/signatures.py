"""EXE006: callbacks that cannot be called with what rclpy passes, or that are not there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.blocking import in_distros
from archlint.checks.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.facts import model as facts
from archlint.finding import Finding, Related, Severity
from archlint.workspace.test_code import is_test_file

if TYPE_CHECKING:
    from archlint.program.model import Callback
    from archlint.system.model import System

_PASSED = {
    "subscription": ("the message",),
    "service": ("the request", "the response"),
    "timer": (),
    "guard": (),
    "execute": ("the goal handle",),
    "accepted": ("the goal handle",),
    "cancel": ("the goal handle",),
    "goal": ("the goal request",),
    "feedback": ("the feedback",),
    "done": ("the future",),
    "parameter": ("the parameters",),
}
"""What rclpy calls a callback with."""

_WHAT = {
    "subscription": "the callback of a subscription",
    "service": "a service handler",
    "guard": "the callback of a guard condition",
    "done": "a done callback",
}


@rule("EXE006")
def callback_signature(system: System, options: Options) -> Iterator[Finding]:
    """Callbacks that fail as soon as they are called."""
    yield from one_for_each_place(
        found
        for program in system.programs
        for callback in program.callbacks
        if callback.role in _PASSED and callback.registered is not None
        if not is_test_file(callback.registered.file) and not is_test_file(program.file)
        for found in _wrong(system, callback, options.distros)
    )


def _wrong(system: System, callback: Callback, distros: Sequence[str]) -> Iterator[Finding]:
    assert callback.registered is not None
    what = _WHAT.get(callback.role, f"the {callback.role} callback")
    if callback.missing is not None:
        yield finding(
            "EXE006",
            callback.registered,
            f"{what} is to be '{callback.missing}', and there is no such method",
            help="define it, or name the one that is meant",
            node=node_name(system, callback.node),
            identity=(callback.role, callback.missing),
        )
        return
    function = callback.function
    if function is None or (isinstance(function, facts.Function) and function.decorators and not _plain(function)):
        return
    wrong = [distro for distro in distros if not _fits(function, callback, distro)]
    if not wrong:
        return
    passed = _PASSED[callback.role]
    where = f" {in_distros(wrong)}" if set(wrong) != set(distros) else ""
    found = finding(
        "EXE006",
        callback.registered,
        f"{what} is called with {_and(passed)}{where}, and {callback.name} {_takes(function, callback)}",
        help="rclpy passes " + _and(passed) + _more(callback.role, distros),
        related=[Related(callback.place, f"{callback.name} is defined here")],
        node=node_name(system, callback.node),
        identity=(callback.role, callback.name),
    )
    yield found if not where else replace(found, severity=Severity.WARNING)


def _plain(function: facts.Function) -> bool:
    """Whether the decorators leave the parameters alone."""
    return all(isinstance(d, facts.Name) and d.id in ("staticmethod", "classmethod") for d in function.decorators)


def _fits(function: facts.Function | facts.Lambda, callback: Callback, distro: str) -> bool:
    """Whether a function can be called with what rclpy of ``distro`` passes."""
    counts = [len(_PASSED[callback.role])]
    if callback.role == "subscription" and distro != "humble":
        counts.append(2)
    if callback.role == "timer" and distro not in ("humble", "jazzy") and _wants_timer_info(function):
        counts.append(1)
    return any(_takes_count(function, callback.bound_arguments + count, callback.bound_keywords) for count in counts)


def _takes_count(function: facts.Function | facts.Lambda, count: int, given: frozenset[str]) -> bool:
    positional = [param for param in function.params if param.kind in ("positional_only", "normal")]
    open_ = [param for param in positional if param.name not in given]
    needed = sum(param.default is None for param in open_)
    endless = any(param.kind == "star" for param in function.params)
    return needed <= count and (endless or count <= len(open_))


def _wants_timer_info(function: facts.Function | facts.Lambda) -> bool:
    for param in function.params:
        annotation = param.annotation
        name = annotation.attr if isinstance(annotation, facts.Attribute) else getattr(annotation, "id", None)
        name = annotation.value if isinstance(annotation, facts.Literal) else name
        if isinstance(name, str) and name.rpartition(".")[2] == "TimerInfo":
            return True
    return False


def _takes(function: facts.Function | facts.Lambda, callback: Callback) -> str:
    positional = [param for param in function.params if param.kind in ("positional_only", "normal")]
    names = [p.name for p in positional[callback.bound_arguments :] if p.name not in callback.bound_keywords]
    if len(positional) < callback.bound_arguments:
        return "does not even take self"
    if not names:
        return "takes no argument"
    return f"takes {len(names)} argument{'s' if len(names) > 1 else ''} ({', '.join(names)})"


def _and(parts: Sequence[str]) -> str:
    return " and ".join(parts) if parts else "no argument"


def _more(role: str, distros: Sequence[str]) -> str:
    if role == "subscription" and set(distros) != {"humble"}:
        return "; from jazzy on also its MessageInfo, to a callback with two parameters"
    if role == "timer" and not {"kilted", "lyrical", "rolling"}.isdisjoint(distros):
        return "; from kilted on a TimerInfo, to a parameter annotated with it"
    return ""
