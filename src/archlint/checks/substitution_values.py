"""LCH006: substitutions that the code of a launch file takes for their values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_other_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place
from archlint.launch_files.substitution_values import Misuse, Misused, misused_substitutions

if TYPE_CHECKING:
    from archlint.launch.mistakes import NotAPath
    from archlint.systems.model import System


@rule("LCH006", scope=Scope.SYSTEM, in_use=True)
def substitution_as_value(system: System, options: Options) -> Iterator[Finding]:
    """Substitutions that are added, formatted, tested, compared, or joined as paths."""
    for joined in system.launched.joined if system.launched is not None else ():
        yield _not_a_path(joined)
    for file, misused in misused_substitutions(system):
        message, help = _said(misused)
        yield finding(
            "LCH006",
            Place(file, *misused.span),
            message,
            help=help,
            identity=(misused.kind, misused.what),
            group=(file, misused.kind),
        )


def _said(misused: Misused) -> tuple[str, str]:
    what = misused.what
    match misused.kind:
        case Misuse.ADDED:
            effect = "which is not a string until launch performs it: the launch stops here with a TypeError"
            return f"'+' has a {what} as an operand, {effect}", _list_with(what)
        case Misuse.FORMATTED:
            return f"this makes a string of the {what} itself, not of the value that launch gives it later", _list_with(
                what
            )
        case Misuse.CONVERTED:
            help = "do so in an OpaqueFunction, with the text of perform(context)"
            if misused.is_given:
                help = "give the action the substitution itself: launch makes its value of it"
            return f"{misused.operator}() is called with a {what}, which has no value until launch performs it", help
        case Misuse.INDEX:
            effect = "which has no value until launch performs it: the launch stops here"
            return (
                f"[…] looks up a {what}, {effect}",
                "look it up in an OpaqueFunction, with the text of perform(context)",
            )
        case Misuse.COMPARED:
            result = "false" if misused.operator in ("==", "in") else "true"
            instead = "EqualsSubstitution" if misused.operator in ("==", "in") else "NotEqualsSubstitution"
            use = f"{instead}(…, …)" if misused.is_given else f"IfCondition({instead}(…, …))"
            if misused.combined:
                use = f"{misused.combined.capitalize()}Substitution({instead}(…, …), …)"
            if misused.chooses:
                use = f"""PythonExpression(["'…' if '", …, "' {misused.operator} '…' else '…'"])"""
            return f"a {what} has no value yet, so that this is always {result}", f"use {use}"
        case Misuse.COMBINED:
            instead = f"{misused.operator.capitalize()}Substitution(…, …)"
            return f"a {what} has no value yet: '{misused.operator}' takes it for true", f"use {instead}"
        case Misuse.TEXT_TESTED:
            text = f"the text of the launch argument '{what}' is tested: any text is true, and so is 'false'"
            return text, "compare it: ….perform(context).lower() == 'true'"
    help = "give the action condition=IfCondition(…)"
    if misused.chooses:
        help = """use PythonExpression(["… if '", …, "' == 'true' else …"])"""
    return f"a {what} has no value yet, so that this test takes it for true", help


def _list_with(what: str) -> str:
    return f"write a list, ['…', {what}(…)]: launch joins the values of its items"


def _not_a_path(joined: NotAPath) -> Finding:
    what, until = f"a {joined.substitution}", " until launch performs it"
    if not joined.substitution:
        what, until, instead = "a tuple", "", "remove the comma at the end of the line that makes the tuple"
    elif joined.package is None:
        instead = "use PathJoinSubstitution([…]) instead of os.path.join()"
    else:
        instead = f"use get_package_share_directory('{joined.package}'), which returns a path"
    return finding(
        "LCH006",
        joined.place,
        f"os.path.join() is called with {what}, which is not a string{until}: the launch stops here with a TypeError",
        help=instead,
        identity=("os.path.join", joined.substitution),
        group=(joined.place.file, "os.path.join", "" if joined.substitution else "tuple"),
    )


@folds("LCH006", across_systems=True)
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for what a file does wrong in the same way at several places."""
    return with_other_places(findings, "here, too")
