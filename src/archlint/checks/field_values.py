"""MSG003: values that a field of a message does not take."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import is_for_humble
from archlint.analysis.reach import judged_notes
from archlint.checks.field_operations import operations_on_fields
from archlint.checks.folding import folds, with_others
from archlint.checks.published import is_told_where_it_is_sent
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Related
from archlint.model import ValueEffect, WrongValue
from archlint.python_code.byte_fields import ByteCompared, bytes_compared

if TYPE_CHECKING:
    from archlint.finding import Finding
    from archlint.systems.model import System

_CHECKED = "humble"
"""The one distribution whose messages check what they are given."""
_COMES_OF_IT = {
    ValueEffect.SET: "this line fails",
    ValueEffect.SENT: "sending it fails",
    ValueEffect.CHANGED: "something else is sent",
    ValueEffect.FALSE: "False is sent",
    ValueEffect.CRASH: "the process crashes when it is sent",
}


@rule("MSG003", scope=Scope.CODE, by_program=True)
def field_value_type(system: System, options: Options) -> Iterator[Finding]:
    """Values of a kind that their field does not take."""
    noted = judged_notes(system, lambda program: program.wrong_values)
    values = {(value.place, value.name): value for value in noted}
    for key in sorted(values):
        consequence = _consequence(system, values[key], options.distros)
        if consequence and not is_told_where_it_is_sent(system, values[key]):
            yield from unless_uncalled(system, _finding(values[key], consequence))
    for row in bytes_compared(system):
        yield from unless_uncalled(system, _compared(row))
    yield from operations_on_fields(system)


def _consequence(system: System, value: WrongValue, distros: Sequence[str]) -> str:
    """What comes of it, in words; empty where it works in a distribution that the workspace may be meant for."""
    checked, others = _CHECKED in distros and value.checked, any(distro != _CHECKED for distro in distros)
    if value.effect is ValueEffect.NONE:
        works = others and not is_for_humble(system.workspace)
        return f"this line raises AssertionError{f' on {_CHECKED}' if others else ''}" if checked and not works else ""
    asserted = checked and not others
    if asserted or value.effect is ValueEffect.SET:
        return "this line raises AssertionError" if asserted and value.name else "this line fails"
    return _COMES_OF_IT[value.effect] + (f" (on {_CHECKED} this line raises AssertionError)" if checked else "")


def _finding(value: WrongValue, consequence: str) -> Finding:
    of = f"{value.type}.{value.section_name}" if value.section_name else value.type
    subject = f"'{value.name}' of {of}" if value.name else of
    return finding(
        "MSG003",
        value.place,
        f"{subject} takes {value.wanted}, not {value.given}: {consequence}",
        help=value.cure,
        related=[] if value.called_at is None else [Related(value.called_at, "this call gives it the value")],
        node=None if value.node is None else value.node.name.text,
        identity=(value.type, value.section_name, value.name, value.wanted),
        group=(value.place.file, of, value.wanted, consequence),
    )


def _compared(row: ByteCompared) -> Finding:
    use = row.use
    of = f"{use.type}.{use.section_name}" if use.section_name else use.type
    comes = "this line raises TypeError" if row.fails else f"it never equals {row.number}"
    return finding(
        "MSG003",
        row.place,
        f"'{use.name}' of {of} is a byte, which Python has as bytes of length one: {comes}",
        help=f"compare it with a constant of the message, or {use.name}[0] with the number",
        node=None if use.node is None else use.node.name.text,
        identity=(use.type, use.section_name, use.name, "compared"),
        group=(row.place.file, of, use.name, comes.rstrip("0123456789")),
    )


def _by_consequence(findings: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    """The findings of a type by what comes of them; those of one line, ``r, g, b = (0, 0, 1)``, are one edit."""
    of_line: dict[int, str] = {}
    rows: dict[str, list[Finding]] = {}
    for told in findings:
        consequence = of_line.setdefault(told.place.line, told.group[-1])
        rows.setdefault(consequence, []).append(told)
    return rows.values()


@folds("MSG003", common=3, rows=_by_consequence)
def of_one_message(findings: Sequence[Finding]) -> Finding:
    """The first of a file for all that give fields of one type the same wrong kind of value: whoever writes ``0`` for
    ``0.0`` does so for x, y and z."""
    first, *others = findings
    same_line = [other for other in others if other.place.line == first.place.line]
    lines = {other.place.line: other for other in reversed(others) if other not in same_line}
    rows = [first, *(lines[line] for line in sorted(lines))]
    told = with_others(rows, "another line does", "more lines do", "the same") if lines else first
    return replace(told, related=(*(Related(other.place, other.message) for other in same_line), *told.related))
