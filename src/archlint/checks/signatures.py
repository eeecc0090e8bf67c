"""EXE006: callbacks that cannot be called with what rclpy passes, or that are not there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import named_distros
from archlint.analysis.reach import node_name, one_for_each_place
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.execution.blocking import in_distros
from archlint.finding import Finding, Place, Related, Severity
from archlint.model import Role
from archlint.python_code.given_to_libraries import may_get_more
from archlint.python_code.signatures import Signature, annotations_are_texts, signature_of
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model import Callback
    from archlint.systems.model import System

_PASSED = {
    Role.SUBSCRIPTION: ("the message",),
    Role.SERVICE: ("the request", "the response"),
    Role.TIMER: (),
    Role.GUARD: (),
    Role.EXECUTE: ("the goal handle",),
    Role.ACCEPTED: ("the goal handle",),
    Role.CANCEL: ("the goal handle",),
    Role.GOAL: ("the goal request",),
    Role.FEEDBACK: ("the feedback",),
    Role.DONE: ("the future",),
    Role.PARAMETER: ("the parameters",),
}
"""What rclpy calls a callback with; a task, with what it is given."""

_BY_COUNT = frozenset({Role.FILTER, Role.TASK})
"""Roles of callbacks of which each is called with as many arguments as the code around says."""

_WHAT = {
    Role.SUBSCRIPTION: "the callback of a subscription",
    Role.SERVICE: "a service handler",
    Role.GUARD: "the callback of a guard condition",
    Role.DONE: "a done callback",
    Role.TASK: "a task of the executor",
    Role.FILTER: "the callback of a message filter",
}


@rule("EXE006", scope=Scope.CODE, by_program=True)
def callback_signature(system: System, options: Options) -> Iterator[Finding]:
    """Callbacks that fail as soon as they are called; those of a class that fail alike are one finding."""
    is_test = system.roles.is_test
    alike: dict[tuple[object, ...], dict[tuple[Place, Place], _Wrong]] = {}
    for program in system.programs:
        for callback in program.callbacks:
            place = callback.registered
            if not _is_judged(callback) or place is None or any(map(is_test, (place.file, program.file))):
                continue
            wrong = _wrong(system, callback, options.distros)
            if wrong is not None:
                alike.setdefault(wrong.alike, {}).setdefault((place, callback.place), wrong)
    yield from one_for_each_place(
        _finding(system, [group[places] for places in sorted(group)], options.distros) for group in alike.values()
    )


def _is_judged(callback: Callback) -> bool:
    if callback.role in _BY_COUNT:
        return callback.given_count is not None
    return callback.role in _PASSED


def _passed(callback: Callback) -> Sequence[str]:
    """What a callback is called with, in words."""
    if not callback.given_count:
        return _PASSED.get(callback.role, ())
    return ("1 argument",) if callback.given_count == 1 else (f"{callback.given_count} arguments",)


@dataclass(frozen=True)
class _Wrong:
    """A callback that cannot be called: ``takes`` says what it takes, None where there is no such method; in
    ``distros`` only, where these are not all."""

    callback: Callback
    takes: str | None
    distros: tuple[str, ...] = ()
    arguments: int = 0

    @property
    def alike(self) -> tuple[object, ...]:
        """What those have in common that have one cause: they are put right in one and the same way."""
        node, registered = self.callback.node, self.callback.registered
        owner = (node.place if node is not None else None, registered.file if registered is not None else "")
        if self.takes is None:
            return (*owner, "missing")
        return (*owner, self.callback.role, self.distros, self.arguments, self.callback.given_count)


def _wrong(system: System, callback: Callback, distros: Sequence[str]) -> _Wrong | None:
    if callback.missing is not None:
        at, workspace = callback.registered, system.workspace
        return None if at and workspace and may_get_more(workspace, at) else _Wrong(callback, None)
    signature = signature_of(system, callback)
    if signature is None:
        return None
    wrong = tuple(distro for distro in distros if not _fits(system, signature, callback, distro))
    # What fails in some fails there at once, so the code is for the others, unless CI or a container says otherwise.
    if not wrong or (wrong != tuple(distros) and named_distros(system.workspace).isdisjoint(wrong)):
        return None
    return _Wrong(callback, _takes(signature), wrong, signature.open_count)


def _finding(system: System, wrongs: Sequence[_Wrong], distros: Sequence[str]) -> Finding:
    first, *others = wrongs
    return _missing(system, first, others) if first.takes is None else _misfit(system, first, others, distros)


def _missing(system: System, first: _Wrong, others: Sequence[_Wrong]) -> Finding:
    callback = first.callback
    assert callback.registered is not None
    names = sorted({repr(other.callback.missing) for other in others} - {repr(callback.missing)})
    nor = f"; nor is there {' or '.join(names)}" if names else ""
    return finding(
        "EXE006",
        callback.registered,
        f"{_what(callback)} is '{callback.missing}', but there is no such method{nor}",
        help="define the method, or correct its name",
        related=[Related(_place(other), f"'{other.callback.missing}' is registered here") for other in others],
        node=node_name(system, callback.node),
        identity=(callback.role, callback.missing or ""),
    )


def _misfit(system: System, first: _Wrong, others: Sequence[_Wrong], distros: Sequence[str]) -> Finding:
    callback, passed = first.callback, _and(_passed(first.callback))
    some = set(first.distros) != set(distros)
    where = f" {in_distros(first.distros)}" if some else ""
    names = list(dict.fromkeys(other.callback.name for other in others if other.callback.name != callback.name))
    so = f"; so does {names[0]}" if len(names) == 1 else f"; so do {len(names)} others of its class" if names else ""
    diagnostic = finding(
        "EXE006",
        _place(first),
        f"{_what(callback)} is called with {passed}{where}, and {callback.name} {first.takes}{so}",
        help=_what_is_passed(callback, passed) + _more(callback.role, distros),
        related=[
            Related(callback.place, f"{callback.name} is defined here")
            if _place(first) != callback.place
            else Related(_registered(first), "it is registered here"),
            *(_further(first, other) for other in others),
        ],
        node=node_name(system, callback.node),
        identity=(callback.role, callback.name),
    )
    return replace(diagnostic, severity=Severity.WARNING) if some else diagnostic


def _further(first: _Wrong, other: _Wrong) -> Related:
    """A wrapper registers several callbacks in one line: then their definitions say more."""
    if _place(first) == _place(other):
        return Related(other.callback.place, f"{other.callback.name}, which is also registered there, is defined here")
    return Related(_place(other), f"{other.callback.name} is registered here")


def _what(callback: Callback) -> str:
    return _WHAT.get(callback.role, f"the {callback.role} callback")


def _place(wrong: _Wrong) -> Place:
    """Where a callback is registered; for a lambda that a wrapper passes on, where the wrapper is called."""
    site, callback = _registered(wrong), wrong.callback
    inside = site.file == callback.place.file and site.line <= callback.place.line <= site.end_line
    return callback.place if callback.function is not None and callback.function.is_lambda and not inside else site


def _registered(wrong: _Wrong) -> Place:
    assert wrong.callback.registered is not None
    return wrong.callback.registered


def _fits(system: System, signature: Signature, callback: Callback, distro: str) -> bool:
    """Whether a function can be called with what rclpy of ``distro`` passes."""
    counts = [len(_PASSED.get(callback.role, ())) if callback.given_count is None else callback.given_count]
    if callback.role == Role.SUBSCRIPTION and distro != "humble":
        counts.append(2)
    if callback.role == Role.TIMER and distro not in ("humble", "jazzy") and signature.wants_timer_info:
        # rclpy compares what the annotation is: a text is none, and with the import all of them are texts.
        if annotations_are_texts(system, callback):
            return signature.takes(0)
        counts.append(1)
    return any(map(signature.takes, counts))


def _takes(signature: Signature) -> str:
    if signature.lacks_self:
        return "does not take self"
    names, by_name = signature.names, signature.needed_by_name
    needs = f" and needs {' and '.join(f'{name}=…' for name in by_name)} by name" if by_name else ""
    if not names:
        return f"takes no argument{needs}"
    return f"takes {len(names)} argument{'s' if len(names) > 1 else ''} ({', '.join(names)}){needs}"


def _and(parts: Sequence[str]) -> str:
    return " and ".join(parts) if parts else "no argument"


def _what_is_passed(callback: Callback, passed: str) -> str:
    if callback.role == Role.TASK:
        return "give create_task() the arguments after the callback: create_task(callback, argument)"
    if callback.role == Role.FILTER:
        return "message_filters passes a message of each filter, then what follows the callback in registerCallback()"
    return f"rclpy passes {passed}"


def _more(role: Role, distros: Sequence[str]) -> str:
    if role == Role.SUBSCRIPTION and set(distros) != {"humble"}:
        return "; from jazzy on also its MessageInfo, to a callback with two parameters"
    if role == Role.TIMER and not {"kilted", "lyrical", "rolling"}.isdisjoint(distros):
        return "; from kilted on a TimerInfo, to a parameter annotated with it"
    return ""
