"""LCH007: substitutions in XML and YAML launch files that launch refuses, or does not see."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch_files.malformed_substitutions import Malformed, MalformedText, malformed_substitutions
from archlint.launch_files.robot_trees import Stop, stops_at_calls
from archlint.launch_files.unknown_xacro_commands import KNOWN_TO_XACRO, UnknownToXacro, unknown_to_xacro
from archlint.launch_files.unperformed_substitutions import unperformed_substitutions
from archlint.suggestions import meant, nearest

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH007", scope=Scope.LAUNCH_FILE, in_use=True)
def malformed_substitution(system: System, options: Options) -> Iterator[Finding]:
    """``${var x}``, ``(find-pkg-share robot)``, and ``$(…)`` that launch cannot parse."""
    for file, malformed in malformed_substitutions(system):
        message, help = _said(malformed)
        yield finding(
            "LCH007",
            Place(file, *malformed.span),
            message,
            help=help,
            identity=(malformed.kind, malformed.written),
            group=(file,),
        )
    yield from map(_of_description, unknown_to_xacro(system))
    yield from map(_of_call, stops_at_calls(system))
    for text in unperformed_substitutions(system):
        yield finding(
            "LCH007",
            text.place,
            f"launch does not perform '{text.written}' in this file: the parameter '{text.name}' is set to that text",
            help=_ASK_FOR_IT if text.given.file.endswith(".py") else 'write <param from="…" allow_substs="true"/>',
            related=[Related(text.given, "the file is given to a node here")],
            identity=(text.name, text.written),
            group=(text.place.file,),
        )


def _of_call(row: Stop) -> Finding:
    """The finding for a call of a macro at which xacro stops."""
    near = nearest(row.parameter or row.macro, row.known) or ""
    if not row.parameter:
        wrong = f"there is no macro '{row.macro}'{meant(near and repr(near))}"
        help = f"write <xacro:{near}>" if near else "define it, or include the file that does, in front of this"
    elif row.is_given:
        wrong = f"the macro '{row.macro}' has no parameter '{row.parameter}'{meant(near and repr(near))}"
        help = f"write '{near}'" if near else "remove it, or add it to the params of the macro"
    else:
        wrong = f"the macro '{row.macro}' is not given its parameter '{row.parameter}'"
        help = f"give it here, or a default in the params of the macro: {row.parameter}:=…"
    end = row.column + len(row.macro) + len("<xacro:")
    return finding(
        "LCH007",
        Place(row.file, row.line, row.column, row.line, end),
        f"{wrong}: xacro stops here, and the robot has no description",
        help=help,
        identity=("xacro", row.macro, row.parameter),
        group=(row.file, "xacro"),
    )


def _of_description(row: UnknownToXacro) -> Finding:
    """The finding for what xacro stops at, as a warning where it may not come to that."""
    if row.closing:
        wrong, help = f"nothing closes '{row.written}'", f"add the '{row.closing}'"
    elif row.meant:
        wrong, help = f"xacro knows no '{row.written}'", f"write '{row.meant}'"
    else:
        wrong, help = f"xacro knows no '{row.written}'", f"write one of those that it knows: {KNOWN_TO_XACRO}"
    stops = "where xacro comes to this, it stops" if row.perhaps else "xacro stops here"
    told = finding(
        "LCH007",
        row.place,
        f"{wrong}: {stops}, and the robot has no description",
        help=help,
        identity=("xacro", row.written),
        group=(row.place.file, "xacro"),
    )
    return replace(told, severity=Severity.WARNING) if row.perhaps else told


_ASK_FOR_IT = "write ParameterFile(…, allow_substs=True) where the file is given to a node"


def _said(malformed: MalformedText) -> tuple[str, str]:
    written, meant = f"'{malformed.written}'", malformed.meant
    match malformed.kind:
        case Malformed.BRACE | Malformed.NO_DOLLAR:
            return f"{written} is no substitution: launch takes it as it stands", f"write '{meant}'"
        case Malformed.NOT_CLOSED:
            return f"{written} has no closing parenthesis: {_REFUSED}", "add the ')'"
        case Malformed.NO_NAME:
            return f"no name of a substitution follows '$(' in {written}: {_REFUSED}", "write '$(var name)', or '\\$('"
        case Malformed.UNKNOWN:
            name = malformed.written[2:].partition(" ")[0].rstrip(")")
            return f"there is no substitution '{name}': {_REFUSED}", f"write '$({meant} …)'"
    return f"{written} has too few words, or too many: {_REFUSED}", meant


_REFUSED = "launch refuses this file"


@folds("LCH007")
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for a file: launch stops at the first."""
    return with_places(findings)
