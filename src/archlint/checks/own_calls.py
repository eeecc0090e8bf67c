"""What API001 says of calls of the workspace's own functions."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.argument_words import cure_of_keywords, keywords_meant, what_does_not_fit
from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding, Related, Severity
from archlint.model import Misuse
from archlint.python_code.bare_supers import calls_of_bare_super, constructors_without_self
from archlint.python_code.compared_methods import ComparedMethod, compared_methods
from archlint.python_code.dropped_coroutines import DroppedCoroutine, dropped_coroutines
from archlint.python_code.dropped_results import DroppedResult, dropped_results
from archlint.python_code.object_calls import refused_object_calls
from archlint.python_code.own_calls import RefusedOwnCall, refused_own_calls
from archlint.python_code.own_results import WrongLength, wrong_lengths
from archlint.python_code.tested_methods import TestedMethod, tested_methods
from archlint.python_code.uncalled_names import uncalled_names

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System

COMPARED = "compared"
"""The group of findings about a method that is compared with True or False."""
NOT_CALLED = "not called"
"""The group of findings about functions that a line names and does not call."""


def own_call_findings(system: System) -> Iterator[Finding]:
    """The findings about such calls."""
    if system.workspace is not None:
        for call in (*refused_own_calls(system.workspace), *refused_object_calls(system.workspace)):
            yield from unless_uncalled(system, _finding(call))
        for row in wrong_lengths(system.workspace):
            yield from unless_uncalled(system, _wrong_length(row))
        for name, place in uncalled_names(system.workspace):
            yield from unless_uncalled(system, _not_called(name, place))
        for test in compared_methods(system.workspace):
            yield from unless_uncalled(system, _compared(test))
        for tested in tested_methods(system.workspace):
            yield from unless_uncalled(system, _tested(tested))
        for dropped in dropped_coroutines(system.workspace):
            yield from unless_uncalled(system, _dropped(dropped))
        for result in dropped_results(system.workspace):
            yield from unless_uncalled(system, _dropped_result(result))
        for place in calls_of_bare_super(system.workspace):
            yield from unless_uncalled(system, _of_bare_super(place))
        for name, place in constructors_without_self(system.workspace):
            yield from unless_uncalled(system, _without_self(name, place))


def _finding(call: RefusedOwnCall) -> Finding:
    wrong, name = call.misfit, call.name.rpartition(".")[2]
    what = what_does_not_fit(wrong.misuse, wrong.parameters, wrong.takes)
    lacking = _lacking(call)
    if lacking:
        what += f", and {what_does_not_fit(Misuse.MISSING, lacking, 0)}"
    if call.instead:
        what += f", as {call.instead}() is no constructor"
    if call.stray_self:
        what += ", as 'self' takes the first argument"
    return finding(
        "API001",
        call.place,
        f"{name}() fails: {f'it is a method without self, and {what}' if call.lacks_self else what}",
        help=f"define it with self first: def {name}(self, …)" if call.lacks_self else _cure(call),
        related=[Related(call.defined, f"{name}() is defined here")],
        identity=(call.name, str(wrong.misuse), *wrong.parameters),
        group=(call.place.file, call.name, str(call.defined), str(wrong.misuse), *wrong.parameters),
        fails=True,
    )


def _cure(call: RefusedOwnCall) -> str:
    wrong = call.misfit
    if call.stray_self:
        return f"{call.name}() is no method: take 'self' out of its parameters"
    if call.instead:
        return f"rename {call.instead}() to __init__()"
    if wrong.misuse is Misuse.UNKNOWN_KEYWORD and not _lacking(call):
        return cure_of_keywords(wrong.parameters, keywords_meant(wrong.parameters, call.keywords))
    if wrong.misuse is Misuse.MISSING and call.name == "main" and len(call.signature) == 1:
        of_main = call.signature[0]
        if of_main in _WORDS_OF_THE_COMMAND_LINE:
            return f"write main(sys.argv), or give it a default: def main({of_main}=None)"
    itself = {"node", "parent_node", "ros_node"} if call.in_node else set[str]()
    takes = ", ".join("self" if name in itself else name for name in call.signature)
    # The names of parameters are those of the definition: where the call is, there may be no such variables.
    return f"{'write' if itself.issuperset(call.signature) else 'give what it takes:'} {call.name}({takes})"


_WORDS_OF_THE_COMMAND_LINE = frozenset({"args", "argv"})


def _lacking(call: RefusedOwnCall) -> tuple[str, ...]:
    """The parameters that are missing beside unknown keywords, none of which means one of them."""
    meant = keywords_meant(call.misfit.parameters, call.keywords) if call.misfit.missing else {}
    return tuple(name for name in call.misfit.missing if name not in meant.values())


def _compared(test: ComparedMethod) -> Finding:
    name, place, help = test.name, test.place, f"write self.{test.name}()"
    if test.is_called_before:
        help = (
            f"keep what the call of {name}() above returns and compare that, or remove the check: another call may act"
        )
    elif test.takes_arguments:
        help = f"call it with the arguments that are meant, self.{name}(…), or remove the check"
    return finding(
        "API001",
        place,
        f"this line does not call {name}(): the method itself is neither True nor False",
        help=help,
        identity=(COMPARED, name),
        group=(place.file, COMPARED, name),
    )


def _tested(test: TestedMethod) -> Finding:
    name = test.written.rpartition(".")[2]
    if test.called:
        return finding(
            "API001",
            test.place,
            f"{name}() gives a transform or raises a TransformException: this condition asks in vain",
            help="ask can_transform(…), or catch TransformException",
            identity=(COMPARED, test.written),
            group=(test.place.file, COMPARED, name),
        )
    cure = f"write {test.written}({'…' if test.takes_arguments else ''})"
    if test.just_sent:  # no response is there as early as that
        cure = f"go on in a done callback: {test.written.rpartition('.')[0]}.add_done_callback(…)"
    return finding(
        "API001",
        test.place,
        f"this condition does not call {name}(): the function itself is always true",
        help=cure,
        identity=(COMPARED, test.written),
        group=(test.place.file, COMPARED, test.written),
    )


def _dropped(row: DroppedCoroutine) -> Finding:
    name = row.name.rpartition(".")[2]
    cure = (
        f"pass {row.name} itself, or an async function that awaits it"
        if row.in_lambda
        else "await it in an async function"
    )
    return finding(
        "API001",
        row.place,
        f"nothing of {name}() is run: the call makes a coroutine, and nobody awaits that",
        help=f"write await {row.name}(…)" if row.may_await else cure,
        related=[Related(row.defined, f"{name}() is defined here, as async")],
        identity=("coroutine", row.name),
        group=(row.place.file, "coroutine", row.name),
    )


def _dropped_result(row: DroppedResult) -> Finding:
    assigned = f"{row.given} = {row.function}(…)"
    diagnostic = finding(
        "API001",
        row.place,
        f"{row.function}() leaves {row.given} as it is and returns {row.result}: this line throws that away",
        help=f"write {assigned}",
        identity=("dropped result", row.function, row.given),
        group=(row.place.file, "dropped result", row.function),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _not_called(name: str, place: Place) -> Finding:
    diagnostic = finding(
        "API001",
        place,
        f"this line does not call {name}(): without parentheses it does nothing",
        help=f"write {name}()",
        identity=(NOT_CALLED, name),
        group=(place.file, NOT_CALLED),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _wrong_length(row: WrongLength) -> Finding:
    name = row.name.rpartition(".")[2]
    given, wanted = _values(row.given), "one variable" if row.wanted == 1 else f"{row.wanted} variables"
    return finding(
        "API001",
        row.place,
        f"{name}() returns {given}, and there are {wanted} for them: this line raises ValueError",
        help=f"write as many variables as there are values, or take the values of {name}() by their index",
        related=[Related(row.returned, f"{name}() returns them here")],
        identity=("length", row.name),
        group=(row.place.file, "length", row.name),
        fails=True,
    )


def _values(count: int) -> str:
    return "one value" if count == 1 else f"{count} values"


def _of_bare_super(place: Place) -> Finding:
    return finding(
        "API001",
        place,
        "super.__init__() fails: super lacks its parentheses",
        help="write super().__init__(…)",
        identity=("super.__init__",),
        group=(place.file, "super.__init__"),
        fails=True,
    )


def _without_self(name: str, place: Place) -> Finding:
    return finding(
        "API001",
        place,
        f"{name}() fails: 'self' is missing",
        help=f"pass the object first: {name}(self, …)",
        identity=(name, "self"),
        group=(place.file, name, "self"),
        fails=True,
    )


__all__ = ["COMPARED", "NOT_CALLED", "own_call_findings"]
