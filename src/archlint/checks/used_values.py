"""What API001 and API002 say of values that code uses as what they are not: None for an object, a number for a text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.absent_imports import OF_MODULE
from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding, Related, Severity
from archlint.python_code.array_truths import ArrayTruth, array_truths
from archlint.python_code.called_modules import CalledModule, called_modules
from archlint.python_code.called_values import CalledValue, called_values
from archlint.python_code.empty_lists import ItemOfNothing, items_of_nothing
from archlint.python_code.entered_nothing import EnteredNothing, entered_nothing
from archlint.python_code.failed_results import FailedResult, failed_results
from archlint.python_code.formatted_texts import WrongCount, wrong_counts
from archlint.python_code.hidden_messages import HiddenMessage, hidden_messages
from archlint.python_code.misused_kinds import Misuse, MisusedKind, misused_kinds
from archlint.python_code.parameter_values import WrongParameter, wrong_parameters
from archlint.python_code.plain_kinds import Kind
from archlint.python_code.plain_results import LookedIntoResult, looked_into_results
from archlint.python_code.refused_defaults import RefusedDefault, refused_defaults
from archlint.python_code.text_sums import TextSum, text_sums
from archlint.python_code.used_nothing import Use, UsedNothing, uses_of_nothing

if TYPE_CHECKING:
    from archlint.systems.model import System

NOTHING = "returns nothing"
"""The group of findings about one function that returns nothing."""
TEXT = "text"
"""The group of findings about texts that are added to what is none."""
PLAIN = "plain"
"""The group of findings about a value that is taken for another one."""
TRUTH = "truth"
_OUTCOME = {
    Use.FAILS: "this line raises TypeError",
    Use.LOOKS_INTO: "this line raises AttributeError",
    Use.TESTS: "this condition never holds",
    Use.TESTS_NOT: "this condition always holds",
    Use.KEEPS: "that is what this line keeps",
}


def used_value_findings(system: System) -> Iterator[Finding]:
    """The findings about such code."""
    if system.workspace is not None:
        for row in uses_of_nothing(system.workspace):
            yield from unless_uncalled(system, _nothing(row))
        for failed in failed_results(system.workspace):
            yield from unless_uncalled(system, _failed(failed))
        for sum_ in text_sums(system):
            yield from unless_uncalled(system, _text(sum_))
        for count in wrong_counts(system.workspace):
            yield from unless_uncalled(system, _count(count))
        for parameter in wrong_parameters(system.workspace):
            yield from unless_uncalled(system, _parameter(parameter))
        for called in called_values(system.workspace):
            yield from unless_uncalled(system, _called(called))
        for module in called_modules(system.workspace):
            yield from unless_uncalled(system, _called_module(module))
        for default in refused_defaults(system.workspace):
            yield from unless_uncalled(system, _default(default))
        for hidden in hidden_messages(system.workspace):
            yield from unless_uncalled(system, _hidden(hidden))
        for truth in array_truths(system.workspace):
            yield from unless_uncalled(system, _truth(truth))
        for entered in entered_nothing(system.workspace):
            yield from unless_uncalled(system, _entered(entered))
        for item in items_of_nothing(system.workspace):
            yield from unless_uncalled(system, _item(item))
        for misused in misused_kinds(system.workspace):
            if misused.misuse is not Misuse.LOOKS_INTO:
                yield from unless_uncalled(system, _misused(misused, "API001"))


def misused_kind_findings(system: System) -> Iterator[Finding]:
    """The findings about attributes of plain values: API002."""
    for row in () if system.workspace is None else misused_kinds(system.workspace):
        if row.misuse is Misuse.LOOKS_INTO:
            yield from unless_uncalled(system, _misused(row, "API002"))
    for result in () if system.workspace is None else looked_into_results(system.workspace):
        yield from unless_uncalled(system, _looked_into(result))


def _looked_into(row: LookedIntoResult) -> Finding:
    return finding(
        "API002",
        row.place,
        f"{row.name}() returns {row.kind}: it has no '{row.attribute}', and this line fails with an AttributeError",
        help=f"use the result of {row.name}() as {row.kind}, or let it return an object",
        related=[Related(row.returned, f"this is what {row.name}() returns")],
        identity=(row.name, row.attribute, "result"),
        group=(OF_MODULE, PLAIN, row.place.file, row.name, row.kind),
        fails=True,
    )


def _misused(row: MisusedKind, code: str) -> Finding:
    is_none = row.kind is Kind.NONE
    told = f"nothing but None is assigned to {row.what}" if is_none else f"{row.what} is {row.kind}"
    outcome = {
        Misuse.LOOKS_INTO: f"it has no '{row.name}', and this line fails with an AttributeError",
        Misuse.CALLS: "calling it fails with a TypeError",
        Misuse.TAKES_ITEM: "taking an item of it fails with a TypeError",
    }
    return finding(
        code,
        row.place,
        f"{told}: {outcome[row.misuse]}",
        help=f"assign {row.what} a value first" if is_none else f"use {row.what} as {row.kind}",
        related=[Related(row.assigned, f"this is what {row.what} gets")],
        identity=(row.what, row.misuse, row.name),
        group=(OF_MODULE if code == "API002" else row.place.file, PLAIN, row.place.file, row.what, row.kind),
        fails=True,
    )


def _called_module(row: CalledModule) -> Finding:
    own = row.file.rpartition("/")[2].removesuffix(".py") or row.name
    which = f"the module {row.file}" if row.file else "a module of Python"
    return finding(
        "API001",
        row.place,
        f"'{row.name}' is {which}, and "
        + ("the build of the package stops as it is called" if row.builds else "calling it fails with a TypeError"),
        help=f"call what is in it: {row.name}.{own}(…)"
        if row.has_own
        else f"call what is in it, as {row.name}.NAME(…)",
        identity=("called", row.name, row.file),
        group=(row.place.file, "called module", row.name),
        fails=True,
    )


def _called(row: CalledValue) -> Finding:
    outcome = "and the build of the package stops" if row.builds else "as it is called"
    return finding(
        "API001",
        row.place,
        f"{row.kind} stands before these parentheses: this line raises TypeError, {outcome}",
        help=f"write a comma behind {row.kind}"
        if row.among
        else f"write the operator that is missing behind {row.kind}",
        identity=("called", row.kind),
        group=(row.place.file, "called", row.kind),
        fails=True,
    )


def _nothing(row: UsedNothing) -> Finding:
    name = row.name.rpartition(".")[2]
    own = row.defined is not None
    diagnostic = finding(
        "API001",
        row.place,
        f"{name if own else row.name}() returns None: {_OUTCOME[row.use]}",
        help=f"let {name}() return a value" if own else "write the call on a line of its own: it changes the list",
        related=[] if row.defined is None else [Related(row.defined, f"{name}() is defined here, and returns nothing")],
        identity=(NOTHING, row.name, row.use),
        group=(row.place.file, NOTHING, row.name),
    )
    tests = row.use in (Use.TESTS, Use.TESTS_NOT)
    return replace(diagnostic, severity=Severity.WARNING) if tests else diagnostic


def _failed(row: FailedResult) -> Finding:
    name = row.name.rpartition(".")[2]
    diagnostic = finding(
        "API001",
        row.place,
        f"{name}() returns None where it catches {row.caught}: then {_OUTCOME[row.use]}",
        help=f"give the result of {row.name}() to a variable first, and go on only if it is not None",
        related=[Related(row.returned, f"{name}() returns None behind this except")],
        identity=(NOTHING, row.name, row.caught),
        group=(row.place.file, NOTHING, row.name, row.caught),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _entered(row: EnteredNothing) -> Finding:
    return finding(
        "API001",
        row.place,
        f"__enter__() of {row.cls} returns None: {row.variable} is None here, and using it fails with an "
        "AttributeError",
        help="let __enter__() end with `return self`",
        related=[
            Related(row.used, f"{row.variable} is used here"),
            Related(row.defined, "__enter__() is defined here, and returns nothing"),
        ],
        identity=("entered", row.variable),
        group=(row.place.file, "entered", row.cls),
    )


def _count(row: WrongCount) -> Finding:
    places = "one place" if row.places == 1 else f"{row.places or 'no'} places"
    values = "one value" if row.values == 1 else f"{row.values or 'no'} values"
    what = f"{places} for {values}"
    cure = "write as many places as there are values"
    if row.name:
        what, cure = f"a place for '{row.name}', which no argument is called", f"give it: {row.name}=…"
    return finding(
        "API001",
        row.place,
        f"the text has {what}: this line raises {row.error}",
        help=cure,
        identity=("places", row.error, row.name),
        group=(row.place.file, "places"),
        fails=True,
    )


def _parameter(row: WrongParameter) -> Finding:
    return finding(
        "API001",
        row.place,
        f"Parameter() fails with a ValueError: {row.value} is no value of the type {row.type}",
        help=f"give a value of the type {row.type}, or the type of the value",
        identity=("Parameter", row.type),
        group=(row.place.file, "Parameter", row.type),
        fails=True,
    )


def _default(row: RefusedDefault) -> Finding:
    if row.describes:
        return _description(row)
    cure = "write all of them alike: 1.0 beside 0.5" if row.mixed else "declare a parameter for each value in it"
    return finding(
        "API001",
        row.place,
        f"declare_parameter() fails with a TypeError: no parameter can be {row.value}",
        help=cure,
        identity=("declare_parameter", row.value),
        group=(row.place.file, "declare_parameter", row.value),
        fails=True,
    )


def _description(row: RefusedDefault) -> Finding:
    return finding(
        "API001",
        row.place,
        f"declare_parameter() fails with a TypeError: its descriptor is a ParameterDescriptor, and not {row.value}",
        help="write `from rcl_interfaces.msg import ParameterDescriptor` above, and give it "
        f"ParameterDescriptor({row.describes})",
        identity=("declare_parameter", "descriptor"),
        group=(row.place.file, "declare_parameter", "descriptor"),
        fails=True,
    )


def _hidden(row: HiddenMessage) -> Finding:
    return finding(
        "API001",
        row.place,
        f"{row.call}() fails: '{row.parameter}' gets {row.name} of {row.module}, which hides that of {row.interface}",
        help=f"import one of the two under another name: from {row.interface} import {row.name} as {row.name}Message",
        related=[Related(row.hiding, "this import hides the other"), Related(row.hidden, "this one is hidden")],
        identity=(row.name, row.module),
        group=(row.place.file, "hidden", row.name),
        fails=True,
    )


def _truth(row: ArrayTruth) -> Finding:
    if row.comparison:
        return _compared_truth(row)
    asked = (
        "comparing it with None compares each element"
        if row.compared
        else "of many elements, it is neither true nor false"
    )
    there = f"{row.what} is {'' if row.negated else 'not '}None"
    cure = f"write {there}" if row.or_none or row.compared else f"ask what you mean: {row.what}.any(), .all() or .size"
    return finding(
        "API001",
        row.place,
        f"{row.what} is an array of numpy: {asked}, and this line fails with a ValueError",
        help=cure,
        related=[Related(row.assigned, f"this is what {row.what} gets")],
        identity=(TRUTH, row.what),
        group=(row.place.file, PLAIN, row.what, TRUTH),
    )


def _compared_truth(row: ArrayTruth) -> Finding:
    mask = {"and": "&", "or": "|"}.get(row.joined, "")
    cure = f"ask what you mean: .any() or .all() of what {row.what} {row.comparison} … gives"
    return finding(
        "API001",
        row.place,
        f"{row.what} is an array of numpy: '{row.comparison}' compares each element, of which many are neither true "
        "nor false, and this line fails with a ValueError",
        help=f"put each comparison in parentheses, and join them by {mask}" if mask else cure,
        related=[Related(row.assigned, f"this is what {row.what} gets")],
        identity=(TRUTH, row.what),
        group=(row.place.file, PLAIN, row.what, TRUTH),
    )


def _item(row: ItemOfNothing) -> Finding:
    return finding(
        "API001",
        row.place,
        f"the list {row.name} is still empty: an item of it is an IndexError",
        help=f"write {row.name}.append(…), or make the list as long as it has to be",
        related=[Related(row.empty_at, "it is made here")],
        identity=("item", row.name),
        group=(row.place.file, "item", row.name, str(row.place.line)),
    )


def _text(row: TextSum) -> Finding:
    added = f"{row.added} is {row.kind}" if row.added else f"this adds a text and {row.kind}"
    told = f"{added}, and '+' with a text raises TypeError" if row.added else f"{added}, which raises TypeError"
    return finding(
        "API001",
        row.place,
        told,
        help=f"convert it: str({row.added or '…'}), or write an f-string",
        identity=(TEXT, row.added, row.kind),
        group=(row.place.file, TEXT),
    )


__all__ = ["NOTHING", "PLAIN", "TEXT", "misused_kind_findings", "used_value_findings"]
