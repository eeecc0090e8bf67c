"""MSG003: values that a field of a message does not take."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.pinned import distros_to_judge, is_for_humble, is_for_humble_alone, knows_interfaces_of
from archlint.analysis.reach import judged_notes
from archlint.analysis.source_code import source_code
from archlint.checks.field_operations import operations_on_fields
from archlint.checks.folding import folds, with_others
from archlint.checks.published import is_told_where_it_is_sent
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Related
from archlint.model import ValueEffect, WrongValue
from archlint.python_code.byte_fields import ByteCompared, bytes_compared
from archlint.python_code.next_uses import is_straight_behind
from archlint.python_code.unsent_messages import is_never_sent

if TYPE_CHECKING:
    from archlint.finding import Finding, Place
    from archlint.systems.model import System

_CHECKED = "humble"
"""The one distribution whose messages check what they are given."""
_RAISES = "this line raises AssertionError"
_BEHIND = "behind "
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
    known = (value for value in noted if knows_interfaces_of(system.workspace, value.type.partition("/")[0]))
    values = {(value.place, value.name): value for value in known}
    distros = distros_to_judge(system.workspace, options.distros)
    where = f" on {_CHECKED}" if len(options.distros) > 1 else ""
    failing: list[Place] = []
    for key in sorted(values):
        value, consequence = values[key], _consequence(system, values[key], distros, where)
        if consequence and not is_told_where_it_is_sent(system, value):
            code = source_code(system)
            first = next((place for place in failing if is_straight_behind(code, place, value.place)), None)
            if first is None and (value.effect is ValueEffect.SET or (value.checked and {*distros} == {_CHECKED})):
                failing.append(value.place)
            yield from unless_uncalled(system, _finding(value, consequence, first))
    for row in bytes_compared(system):
        yield from unless_uncalled(system, _compared(row))
    yield from operations_on_fields(system)


def _consequence(system: System, value: WrongValue, distros: Sequence[str], where: str) -> str:
    """What comes of it, in words; empty where it works in a distribution that the workspace may be meant for.
    ``where`` says that only one of several distributions checks a field."""
    checked, others = _CHECKED in distros and value.checked, any(distro != _CHECKED for distro in distros)
    unsent = value.effect is not ValueEffect.SET and is_never_sent(system.workspace, value.place)
    if value.effect is ValueEffect.NONE or unsent:
        needed = is_for_humble_alone if unsent else is_for_humble
        works = others and not needed(system.workspace)
        return f"{_RAISES}{where}" if checked and not works else ""
    asserted = checked and not others
    if asserted or value.effect is ValueEffect.SET:
        return f"{_RAISES}{where}" if asserted and value.name else "this line fails"
    return _COMES_OF_IT[value.effect] + (f" (on {_CHECKED} {_RAISES})" if checked else "")


def _finding(value: WrongValue, consequence: str, first: Place | None) -> Finding:
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
        group=(value.place.file, of, value.wanted, *_after(first), consequence),
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


def _after(first: Place | None) -> tuple[str, ...]:
    return () if first is None else (f"{_BEHIND}{first.line}:{first.column}",)


def _rows(findings: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    """The findings of a file by type and by what comes of them; but those that stand behind a line which raises an
    exception are one with it, for no run comes to them before it is mended."""
    groups: dict[tuple[str, ...], list[Finding]] = {}
    for told in findings:
        groups.setdefault(told.group[:3], []).append(told)
    rows = [list(row) for group in groups.values() for row in _by_consequence(group)]
    leading = {_after(told.place): row for row in rows for told in row}
    for row in rows:
        for told in list(row):
            first = leading.get(told.group[3:4])
            if first is not None and first is not row:
                row.remove(told)
                first.append(told)
    return [sorted(row, key=lambda told: told.sort_key) for row in rows if row]


def _by_consequence(findings: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    """The findings of a type by what comes of them; those of one line, ``r, g, b = (0, 0, 1)``, are one edit."""
    of_line: dict[int, str] = {}
    rows: dict[str, list[Finding]] = {}
    for told in findings:
        consequence = of_line.setdefault(told.place.line, told.group[-1])
        rows.setdefault(consequence, []).append(told)
    return rows.values()


_WRONG_TOO = ("another line behind it is", "more lines behind it are", "wrong, too")


@folds("MSG003", common=1, rows=_rows)
def of_one_message(findings: Sequence[Finding]) -> Finding:
    """The first of a file for all that give fields of one type the same wrong kind of value: whoever writes ``0`` for
    ``0.0`` does so for x, y and z."""
    first, *others = findings
    same_line = [other for other in others if other.place.line == first.place.line]
    lines = {other.place.line: other for other in reversed(others) if other not in same_line}
    rows = [first, *(lines[line] for line in sorted(lines))]
    alike = len({each.group[:3] for each in rows}) == 1
    words = ("another line does", "more lines do", "the same") if alike else _WRONG_TOO
    told = with_others(rows, *words) if lines else first
    return replace(told, related=(*(Related(other.place, other.message) for other in same_line), *told.related))
