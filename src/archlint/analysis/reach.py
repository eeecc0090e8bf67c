"""What callbacks and programs reach: the calls that wait, and the way that leads to them.

Shared by the rules; worked out once for each system.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Literal, TypeVar

from archlint.analysis.kept import once
from archlint.finding import Finding, Related
from archlint.model import (
    Creation,
    EntityKind,
    Role,
)
from archlint.model.given import Constant
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.finding import Place
    from archlint.model import AbsentRead, ApiCall, Blueprint, MistakenFuture, Program, RefusedCall, WrongValue
    from archlint.model.given import Given
    from archlint.systems.model import System


@once
def judged_calls(system: System) -> list[tuple[Program, ApiCall]]:
    """Every call that is recorded outside of test code, in the order of the source."""
    judged = [
        (program, call)
        for program in system.programs
        if not system.roles.is_test(program.file)
        for call in program.calls
        if not system.roles.is_test(call.place.file)
    ]
    return sorted(judged, key=_in_source)


def _in_source(row: tuple[Program, ApiCall]) -> tuple[object, ...]:
    _, call = row
    return call.place.file, call.place.span, call.api, len(call.chain)


@once
def calls_at_start(system: System) -> frozenset[Place]:
    """The calls that programs come to while they start, too."""
    return frozenset(
        call.place
        for program in system.programs
        for call in program.calls
        if call.context.role in (Role.INIT, Role.MAIN)
    )


_Noted = TypeVar("_Noted", "AbsentRead", "RefusedCall", "WrongValue", "MistakenFuture")


def judged_notes(system: System, notes: Callable[[Program], Iterable[_Noted]]) -> Iterator[_Noted]:
    """What programs note while they are followed, outside of test code."""
    is_test = system.roles.is_test
    return (
        note
        for program in system.programs
        if not is_test(program.file)
        for note in notes(program)
        if not is_test(note.place.file)
    )


def calls_of(system: System, apis: Iterable[str]) -> Iterator[tuple[Program, ApiCall]]:
    """The calls of some APIs, outside of test code."""
    wanted = frozenset(apis)
    return (row for row in judged_calls(system) if row[1].api in wanted)


@once
def _names_of_blueprints(system: System) -> dict[int, str]:
    return {id(blueprint): node.name for node in system.nodes for blueprint in node.blueprints if node.name is not None}


def node_name(system: System, blueprint: Blueprint | None) -> str | None:
    """The name in the system of the node that a blueprint became."""
    return None if blueprint is None else _names_of_blueprints(system).get(id(blueprint))


# -------------------------------------------------------------------------------------------- arguments


def argument(call: ApiCall, name: str) -> Given | None:
    """What a call gives for a parameter of the API, None where it gives nothing."""
    return call.arguments.get(name)


def all_arguments_seen(code: SourceCode, call: ApiCall) -> bool:
    """False where ``*`` or ``**`` may pass more than can be seen."""
    return not any(given.star for given in code.arguments(call))


def is_given_a_literal(code: SourceCode, call: ApiCall) -> bool:
    """Whether all that a call is given is a literal."""
    arguments = code.arguments(call)
    return len(arguments) == 1 and arguments[0].value.truth is not None


def waits_for_ever(code: SourceCode, call: ApiCall, parameter: str, *, negative: bool = True) -> bool:
    """Whether a call sets no limit: the timeout is missing, None or (where that means the same) below zero.

    A limit that cannot be known is taken for one.  So is the default of a function that nothing here calls:
    its callers decide.
    """
    value = argument(call, parameter)
    if value is None:
        return all_arguments_seen(code, call)
    return all(_no_limit(option, call, negative) for option in value.alternatives)


def _no_limit(value: Given, call: ApiCall, negative: bool) -> bool:
    if not isinstance(value, Constant) or value.parameters:
        return False
    if value.origin_kind == "argument_default" and (not call.chain or call.context.role == Role.METHOD):
        return False
    if value.value is None:
        return True
    return negative and isinstance(value.value, (int, float)) and value.value < 0


def has_limit(call: ApiCall, parameter: str) -> bool:
    """Whether a call is given a timeout that is known to end the wait."""
    value = argument(call, parameter)
    return value is not None and all(
        isinstance(option, Constant) and isinstance(option.value, (int, float)) and option.value >= 0
        for option in value.alternatives
    )


# ------------------------------------------------------------------------------------- what is waited for


def creations_of(value: Given | None) -> tuple[Creation, ...]:
    """The clients that a value (a client, a goal handle, the future of an answer) belongs to."""
    return () if value is None else value.creations


def blueprints_of(call: ApiCall) -> Sequence[Blueprint | None]:
    """The nodes of a call: that of what runs, or else those of what it is made on."""
    if call.context.node is not None:
        return [call.context.node]
    return [creation.node for creation in creations_of(call.receiver)] or [call.node]


AskedKind = Literal["service", "action"]
"""What a client may wait for."""


def endpoint_words(creation: Creation | None, kind: AskedKind = "service") -> str:
    """``the service 'enable_motor'``, as far as it is known; ``kind`` says what it is where nothing else does."""
    if creation is None:
        return f"a{'n' if kind == 'action' else ''} {kind}"
    what = "action" if creation.kind in (EntityKind.ACTION_CLIENT, EntityKind.ACTION_SERVER) else "service"
    if creation.name.text is None or creation.name.resolution == "unknown":
        return f"a{'n' if what == 'action' else ''} {what}"
    if creation.name.resolution == "partial":
        return f"a{'n' if what == 'action' else ''} {what} called '{creation.name.text.replace('*', '…')}'"
    return f"the {what} '{creation.name.text}'"


@once
def names_at(system: System) -> dict[Place, frozenset[str | None]]:
    """The names under which programs create something at a place: one for each object of a class, say."""
    names: dict[Place, set[str | None]] = {}
    for creation in (creation for program in system.programs for node in program.nodes for creation in node.creations):
        names.setdefault(creation.place, set()).add(creation.name.text)
    return {place: frozenset(texts) for place, texts in names.items()}


# ------------------------------------------------------------------------------------- related places


def related_chain(call: ApiCall) -> Iterator[Related]:
    """Each hop of the calls that lead from what runs to ``call``."""
    for frame in call.chain:
        yield Related(frame.place, f"{frame.caller} calls {frame.callee} here")


def related_creation(creation: Creation | None) -> Iterator[Related]:
    """Where the client is created."""
    if creation is not None:
        yield Related(creation.place, "the client is created here")


# --------------------------------------------------------------------------------------- one a place


def one_for_each_place(findings: Iterable[Finding]) -> Iterator[Finding]:
    """The same line of code, reached by several programs, is one finding: the most severe, then the one with
    the shortest way to it."""
    best: dict[tuple[object, ...], Finding] = {}
    for finding in findings:
        key = (finding.code, finding.place)
        known = best.get(key)
        if known is None or _weight(finding) < _weight(known):
            best[key] = finding
    yield from (best[key] for key in sorted(best, key=lambda key: best[key].sort_key))


def _weight(finding: Finding) -> tuple[object, ...]:
    related = tuple((related.place, related.message) for related in finding.related)
    return (-finding.severity, len(related), finding.message, related)


def same_expression(expression: facts.Expr | None, other: facts.Expr | None) -> bool:
    """Whether two facts are the same piece of source."""
    return expression is not None and other is not None and getattr(expression, "span", 1) == getattr(other, "span", 2)
