"""MSG001: fields that a message does not have."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint import suggestions
from archlint.analysis.completeness import enclosing_class
from archlint.analysis.pinned import knows_interfaces_of
from archlint.analysis.source_code import source_code
from archlint.checks.dropped_messages import dropped_message_findings
from archlint.checks.folding import folds, package_around, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.checks.wrong_keywords import outcome_of_keyword
from archlint.finding import Related
from archlint.model import NAMED
from archlint.python_code.handed_functions import handed_elsewhere
from archlint.suggestions import listed, nearest

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.model import FieldUse, Passed
    from archlint.systems.model import System, WorkspaceIndex

_SHOWN = 12
"""How many names a help line lists."""
_IN_ROS_1 = {"secs": "sec", "nsecs": "nanosec", "nsec": "nanosec"}
"""What the fields of times and durations were called."""
_WRAPPERS = {"FeedbackMessage": "message with the feedback", "GetResultResponse": "answer with the result"}


@rule("MSG001", scope=Scope.CODE, by_program=True, in_use=True)
def unknown_field(system: System, options: Options) -> Iterator[Finding]:
    """Fields that no message which the code can hold at that place has."""
    uses: dict[Place, list[FieldUse]] = {}
    for program in system.programs:
        for use in (use for use in program.field_uses if _is_judged(system.workspace, use)):
            uses.setdefault(use.place, []).append(use)
    callers: dict[Place, set[Place | None]] = {}
    for program in system.programs:
        for function, calls in program.callers.items():
            callers.setdefault(function, set()).update(calls)
    reported: set[Place] = set()
    keyword = outcome_of_keyword(system.workspace, options.distros)
    for place in sorted(uses):
        missing = sorted(
            (use for use in uses[place] if use.exists is False), key=lambda use: (use.type, use.section_name)
        )
        wrong = _wrongly_passed(uses[place], missing, callers)
        if wrong:
            yield from (
                _passed_to(system, use, hop, keyword) for use, hop in wrong if use.certain and hop.call not in reported
            )
            reported.update(hop.call for _, hop in wrong)
            continue
        if _may_be_of_another_caller(system, missing):
            continue
        if len(missing) == len(uses[place]):
            yield from unless_uncalled(system, _unknown_field(system, missing[0], keyword))
            continue
        certain = [use for use in missing if use.delivered is not None and use.delivered.place not in reported]
        if certain:  # once for each that delivers: the first use ends the callback
            reported.update(use.delivered.place for use in certain if use.delivered is not None)
            yield _of_one_type(system, certain[0], uses[place], keyword)
    yield from dropped_message_findings(system)


def _is_judged(workspace: WorkspaceIndex | None, use: FieldUse) -> bool:
    return knows_interfaces_of(workspace, use.type.partition("/")[0])


def _may_be_of_another_caller(system: System, missing: Sequence[FieldUse]) -> bool:
    """Whether a callback is given a message that lacks a field, and its function to others, too, such as a signal of
    Qt, which may call it with what has the field."""
    if system.workspace is None or not any(use.delivered is not None for use in missing):
        return False
    place = missing[0].place
    function = source_code(system).function_at(place)
    return function is not None and function.name in (handed_elsewhere(system.workspace, place.file) or ())


def _wrongly_passed(
    uses: Sequence[FieldUse], missing: Sequence[FieldUse], callers: dict[Place, set[Place | None]]
) -> list[tuple[FieldUse, Passed]]:
    """The uses that are not at fault, for the function is called with something else, too (or may be): each with the
    call that passes what lacks the field, one a call."""
    right = [use for use in uses if use.exists is not False]
    shared = {hop.call for use in right for hop in use.passed}
    calls = {hop.call for use in missing for hop in use.passed}
    by_call: dict[Place, tuple[FieldUse, Passed]] = {}
    for use in missing:
        if right:
            hops = [hop for hop in use.passed if hop.call not in shared]
        else:
            hops = [hop for hop in reversed(use.passed) if callers.get(hop.function, set()) - calls]
        if hops:
            by_call.setdefault(hops[0].call, (use, hops[0]))
    return [by_call[call] for call in sorted(by_call)]


def _passed_to(system: System, use: FieldUse, hop: Passed, keyword: str) -> Finding:
    """The finding for a call that passes a message to a function which works with others."""
    fields = listed(use.fields, shown=_SHOWN)
    return replace(
        _unknown_field(system, use, keyword),
        place=hop.call,
        group=(),
        message=f"{hop.helper}() is called with {_message_of(use)}, which has no {_kind(use)} '{use.name}'",
        help=f"{_consequence([use.access], keyword, 'this call raises {} when it runs')}; the fields are {fields}",
        related=(Related(use.place, f"'{use.name}' is used here"),),
    )


def _of_one_type(system: System, use: FieldUse, others: Sequence[FieldUse], keyword: str) -> Finding:
    """The finding for a callback that several subscriptions or the like share, of which not all messages have the
    field."""
    diagnostic = _unknown_field(system, use, keyword)
    assert use.delivered is not None
    having = sorted({other.delivered.place for other in others if other.exists and other.delivered is not None})
    word, name = NAMED.get(use.delivered.kind, ""), use.delivered.name.text
    by = f"a {word}" if name is None else f"the {word} '{name}'"
    return replace(
        diagnostic,
        group=(),
        message=f"{diagnostic.message}, and {by} passes such messages to this code",
        help="use a separate callback for each type, or check isinstance() first",
        related=(
            Related(use.delivered.place, f"this passes {use.delivered.type}"),
            *(Related(place, "what this passes has the field") for place in having if place != use.delivered.place),
        ),
    )


def _message_of(use: FieldUse) -> str:
    """The message that lacks the field, in words."""
    if not use.section_name:
        return use.type
    return f"the {_WRAPPERS.get(use.section_name, use.section_name.lower())} of {use.type}"


def _kind(use: FieldUse) -> str:
    return "constant" if use.access == "constant" else "field"


def _unknown_field(system: System, use: FieldUse, keyword: str) -> Finding:
    of, what = _message_of(use), _kind(use)
    inside, near = _meant(use)
    hint = _did_you_mean({use.name: near}, inside)
    owner = enclosing_class(system.workspace, use.place) or ""
    fields = listed(use.fields, shown=_SHOWN)
    of_other_version = use.section_name and not inside and not near
    owners = (*package_around(system.workspace, use.place.file), use.type)
    cause = owners if of_other_version else (use.place.file, owner, of, what, inside, fields, keyword)
    return finding(
        "MSG001",
        use.place,
        f"{of} has no {what} '{use.name}'{hint}",
        help=_help_for_line(use.access, keyword, what, fields),
        node=None if use.node is None else use.node.name.text,
        identity=(use.type, use.section_name, use.name, use.access),
        group=cause,
        meant=near,
    )


def _help_for_line(access: str, keyword: str, what: str, fields: str) -> str:
    return f"{_consequence([access], keyword, 'this line raises {} when it runs')}; the {what}s are {fields}"


def _consequence(accesses: Iterable[str], keyword: str, lines: str) -> str:
    """What comes of it; ``keyword`` says that of keywords of constructors, and ``lines`` where attributes are used."""
    keywords = {access == "keyword" for access in accesses}
    if len(keywords) > 1:
        return f"an attribute raises AttributeError, and {keyword}"
    return keyword if True in keywords else lines.format("AttributeError")


def _meant(use: FieldUse) -> tuple[str, str]:
    """What was perhaps meant: the field whose own message has the name, which fields with one cause agree in, or a name
    that is near; empty where there is none."""
    renamed = _IN_ROS_1.get(use.name)
    if renamed in use.fields:
        return "", renamed
    if use.inside is not None and use.access != "keyword" and _is_wrapped(use, use.inside):
        return use.inside, ""
    return "", nearest(use.name, use.fields) or ""


def _is_wrapped(use: FieldUse, inside: str) -> bool:
    """Whether a field holds what a message is about: one of many may have a field of that name that means another
    thing.  ``header`` means the same everywhere."""
    return inside.split(".")[0] == "header" or len(use.fields) <= _FEW


_FEW = 6


def _did_you_mean(meant: Mapping[str, str], inside: str) -> str:
    """The words for what was perhaps meant by each of some names, all of them ``inside`` a field if that is given."""
    if inside:
        [first, *others] = meant
        those = f"those of '{inside}'" if others else f"'{inside}.{first}'"
        return suggestions.meant(those)
    hints = [f"'{near}'" + (f" for '{name}'" if len(meant) > 1 else "") for name, near in meant.items() if near]
    last = " and ".join(part for part in (", ".join(hints[:-1]), *hints[-1:]) if part)
    return suggestions.meant(last)


@folds("MSG001")
def of_one_cause(findings: Sequence[Finding]) -> Finding:
    """The finding for all fields that one class takes for those of a message: at the first, the others related."""
    first = findings[0]
    if len(first.group) == len(("kind", "package", "interface")):
        kind, name, _ = first.group
        where = f"in the package '{name}'" if kind == "package" else "here"
        return with_others(findings, f"another use of it {where} is", f"more uses of it {where} are", "wrong, too")
    _, owner, of, what, inside, listed, keyword = first.group
    meant = {diagnostic.identity[2]: diagnostic.meant for diagnostic in findings}
    names = list(meant)
    shown = [f"'{name}'" for name in names]
    where = f"used at {len(findings)} places" + (f" of {owner}" if owner else " of this file")
    several = f"s {', '.join(shown[:-1])} and {shown[-1]}" if len(names) > 1 else f" {shown[0]}"
    accesses = [diagnostic.identity[3] for diagnostic in findings]
    help = f"{_consequence(accesses, keyword, 'these lines raise {} when they run')}; the {what}s are {listed}"
    # Otherwise nothing calls the method, and it is better deleted.
    is_own = first.help == _help_for_line(accesses[0], keyword, what, listed)
    return replace(
        first,
        message=f"{of} has no {what}{several}, {where}{_did_you_mean(meant, inside)}",
        help=help if is_own else first.help,
        related=tuple(
            Related(diagnostic.place, f"'{diagnostic.identity[2]}' is used here") for diagnostic in findings[1:]
        ),
        identity=(*first.identity[:2], *names),
    )
