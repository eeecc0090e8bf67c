"""LCH008: what stops a launch: undefined names, what is no condition, list or launch description, and the like."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_other_places, with_others
from archlint.checks.launch_arguments import told_as_left_out
from archlint.checks.no_actions import no_actions_told
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.texts_as_yaml import description_in_itself, misused_command, text_as_yaml
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch_files.argument_defaults import has_another_default
from archlint.launch_files.foreign_launch_files import ForeignLaunchFile, foreign_launch_files
from archlint.launch_files.launch_descriptions import misnamed_functions, wrong_descriptions
from archlint.launch_files.misused_commands import descriptions_in_themselves, misused_commands
from archlint.launch_files.texts_as_yaml import texts_as_yaml
from archlint.launch_files.wrong_launch_descriptions import Wrong, WrongDescription
from archlint.python_code.how_imported import import_of
from archlint.python_code.undefined_beside import undefined_beside
from archlint.python_code.undefined_names import names_bound_in
from archlint.suggestions import listed, meant, nearest

if TYPE_CHECKING:
    from archlint.launch.mistakes import (
        AbsentKey,
        IdleGroup,
        MissingArguments,
        NotAChoice,
        RefusedExpression,
        RefusedValue,
        WithoutContext,
    )
    from archlint.systems.model import System


@rule("LCH008", scope=Scope.SYSTEM)
def launch_description(system: System, options: Options) -> Iterator[Finding]:
    """Names that nothing defines, a ``condition=`` that has no ``evaluate`` for launch to call, and substitutions that
    are performed where no launch context is."""
    for place, name in sorted(system.launched.undefined.items() if system.launched is not None else ()):
        yield _undefined(system, place, name)
    for mistake in system.launched.mistakes if system.launched is not None else ():
        wrap = "launch.Condition(predicate=…)" if mistake.callable else "IfCondition(…)"
        yield finding(
            "LCH008",
            mistake.place,
            f"condition= of this {mistake.action} is {mistake.what}, which is not a Condition",
            help=f"launch stops with an AttributeError at this action: write condition={wrap}",
            identity=(mistake.action, mistake.what),
            group=(mistake.place.file, mistake.what),
        )
    for failing in system.launched.without_context if system.launched is not None else ():
        yield _without_context(failing)
    for refused_text in system.launched.expressions if system.launched is not None else ():
        yield _refused_expression(refused_text)
    for absent in system.launched.absent_keys if system.launched is not None else ():
        yield _absent_key(absent)
    for refused in system.launched.refused if system.launched is not None else ():
        yield _refused(refused)
    if system.launched is not None:
        yield from no_actions_told(system.launched)
    for incomplete in system.launched.incomplete if system.launched is not None else ():
        yield _incomplete(incomplete)
    for group in system.launched.idle_groups if system.launched is not None else ():
        yield _idle(group)
    for no_choice in system.launched.no_choices if system.launched is not None else ():
        yield _no_choice(no_choice)
    yield from map(_foreign, foreign_launch_files(system))
    descriptions = [*wrong_descriptions(system)]
    left_out = told_as_left_out(system) if any(wrong.argument for _, wrong in descriptions) else set()
    for file, wrong in descriptions:
        if (file, wrong.argument) not in left_out:  # LCH003 tells it, where the argument is read
            yield _of_declaration(system, file, wrong)
    if system.launched is None and system.workspace is not None:
        for file, wrong in misnamed_functions(system.workspace):
            yield _of_description(file, wrong)
        yield from map(text_as_yaml, texts_as_yaml(system.workspace))
        yield from map(misused_command, misused_commands(system.workspace))
        yield from (description_in_itself(*row) for row in descriptions_in_themselves(system.workspace))


def _undefined(system: System, place: Place, name: str) -> Finding:
    known = frozenset[str]() if system.workspace is None else names_bound_in(system.workspace, place.file)
    alike = [other for other in known if other.isupper() == name.isupper()]  # 'RATE' is no slip for 'rate'
    statement = "" if system.workspace is None else import_of(system.workspace, name, in_launch_file=True)
    near = nearest(name, alike) if len(name) >= _SHORT and not statement else None
    beside = [] if system.workspace is None else undefined_beside(system.workspace, place)
    more = "" if not beside else f"; nor {'is' if len(beside) == 1 else 'are'} {listed([read.name for read in beside])}"
    return finding(
        "LCH008",
        place,
        f"'{name}' is not defined: this launch file stops with a NameError before it starts anything"
        + (meant(f"'{near}'" if near is not None else "") or more),
        help=f"write '{near}'"
        if near is not None
        else f"write `{statement}`"
        if statement
        else f"define or import '{name}', or put it in quotes if it is meant as a string",
        related=[Related(read.place, f"'{read.name}' is not defined, either") for read in beside],
        identity=(place.file, name),
        meant=near or "",
    )


_SHORT = 4
"""Names of fewer letters resemble too many others."""


def _absent_key(absent: AbsentKey) -> Finding:
    near = nearest(absent.key, absent.known)
    return finding(
        "LCH008",
        absent.place,
        f"{absent.file} has no '{absent.key}' here: this launch file stops with a KeyError"
        + meant(f"'{near}'" if near is not None else ""),
        help=f"write '{near}'" if near is not None else _what_is_there(absent),
        identity=(absent.file, absent.key),
        group=(absent.place.file, _ABSENT, absent.file),
        meant=near or "",
    )


_ABSENT = "absent keys"


def _refused_expression(refused: RefusedExpression) -> Finding:
    """The finding for the text of a launch argument that stands in an expression as if it were Python."""
    is_truth = refused.name in ("true", "false")
    return finding(
        "LCH008",
        refused.place,
        f"Python knows no '{refused.name}': the expression `{refused.text}` stops this launch with a NameError",
        help="put quotes around the substitution, so that Python sees a text"
        + (f", and compare that: \"'…' == '{refused.name}'\"" if is_truth else ""),
        identity=(refused.place.file, refused.name),
        group=(refused.place.file, "expression", refused.name),
    )


def _what_is_there(absent: AbsentKey) -> str:
    if not absent.known:
        return f"add '{absent.key}' to the file"
    return f"add '{absent.key}' to the file, or take what is there: {listed(absent.known)}"


def _refused(value: RefusedValue) -> Finding:
    if value.pairs:
        message = "launch_arguments= is a dict, of which launch sees the keys alone: it stops at this include"
        help = "add .items(), or write a list of pairs, [('name', 'value')]"
    elif value.as_parameter:
        message = f"the parameter '{value.parameter}' is {value.what}, which none can be: launch stops with a TypeError"
        help = "leave it out, or give it a value" if value.what == "None" else "write str(…) around the path"
    else:
        holds = "contains" if value.in_list else "is"
        of = "the launch argument" if value.argument else f"{value.parameter}= of this {value.action}"
        named = f"{of} '{value.parameter}'" if value.argument else of
        message = f"{named} {holds} {value.what}, which is no string: launch stops with a TypeError"
        help = f"write {_as_string(value.what)}"
    return finding(
        "LCH008",
        value.place,
        message,
        help=help,
        identity=(value.action, value.parameter, value.what),
        group=(value.place.file, value.action, "pairs" if value.pairs else "value"),
    )


def _incomplete(call: MissingArguments) -> Finding:
    if call.of_element:
        wanted = " and ".join(f"'{name}'" for name in call.names)
        message = f"this {call.action} lacks {wanted}, without which launch rejects this file"
        file, identity = call.place.file, (call.action, *call.names)
        return finding("LCH008", call.place, message, help=f"add {wanted}", identity=identity, group=(file, *identity))
    names = " and ".join(f"{name}=" for name in call.names)
    return finding(
        "LCH008",
        call.place,
        f"this {call.action} lacks {names}, which it cannot do without: launch stops with a TypeError",
        help=f"add {names}",
        identity=(call.action, *call.names),
        group=(call.place.file, call.action, *call.names),
    )


def _idle(group: IdleGroup) -> Finding:
    shown = listed(group.settings)
    diagnostic = finding(
        "LCH008",
        group.place,
        f"nothing is in this group that {shown} could be for: what it sets ends with the group",
        help="put the actions that it is for into the group, or write "
        + ("scoped=False" if group.place.file.endswith(".py") else 'scoped="false"'),
        identity=group.settings,
        group=(group.place.file, "idle group"),
    )
    return replace(diagnostic, severity=Severity.WARNING)


def _no_choice(row: NotAChoice) -> Finding:
    near = nearest(row.value, row.choices)
    what = "the default" if row.default else "what this include passes"
    related = [] if row.default else [Related(row.declared, f"the choices of '{row.argument}'")]
    return finding(
        "LCH008",
        row.place,
        f"'{row.value}' is {what} for '{row.argument}', and none of its choices: launch stops with a RuntimeError",
        help=f"write '{near}'" if near is not None else f"write one of {listed(row.choices)}, or add it to the choices",
        related=related,
        identity=(row.argument, row.value),
        meant=near or "",
    )


def _foreign(included: ForeignLaunchFile) -> Finding:
    return finding(
        "LCH008",
        included.place,
        f"{included.source} reads '{included.file}' as {included.reads}, and it is {included.language}: "
        "launch stops at this include",
        help="write AnyLaunchDescriptionSource, which asks what the file is",
        identity=(included.source, included.file),
    )


def _as_string(what: str) -> str:
    """What to write instead of a constant; launch files say 'true', not 'True'."""
    if what == "None":
        return "'', or leave the argument out"
    return f"the string '{what.lower()}'" if " " not in what else "strings and substitutions only"


def _of_description(file: str, wrong: WrongDescription) -> Finding:
    message, help = _said(wrong)
    diagnostic = finding(
        "LCH008",
        Place(file, *wrong.span),
        message,
        help=help,
        identity=(wrong.kind, wrong.given, wrong.of),
        group=(file, wrong.kind),
    )
    severity = _SEVERITIES.get(wrong.kind)
    return diagnostic if severity is None else replace(diagnostic, severity=severity)


_SEVERITIES = {Wrong.NOT_ADDED: Severity.INFO, Wrong.OVERWRITTEN: Severity.WARNING}
"""Of what leaves an action out; launch stops at the others."""


def _of_declaration(system: System, file: str, wrong: WrongDescription) -> Finding:
    """What is said of an action; to add a declaration may change what the launch file does."""
    told = _of_description(file, wrong)
    if system.workspace is None or not has_another_default(system.workspace, file, wrong.argument):
        return told
    return replace(told, help=f"delete it: in the list it would change the default of '{wrong.argument}'")


def _said(wrong: WrongDescription) -> tuple[str, str]:
    match wrong.kind:
        case Wrong.NOTHING:
            text = "generate_launch_description() returns nothing: launch stops with an AttributeError"
            return text, "end it with return LaunchDescription([…])"
        case Wrong.LIST:
            text = f"generate_launch_description() returns {wrong.given}: launch stops with an AttributeError"
            return text, "write return LaunchDescription([…]), with the actions in the list"
        case Wrong.MISNAMED:
            text = f"launch finds no generate_launch_description() in this file: the function is called '{wrong.given}'"
            return text, f"rename '{wrong.given}' to generate_launch_description"
        case Wrong.PARAMETER:
            text = (
                f"generate_launch_description() wants '{wrong.given}', and launch passes nothing: a TypeError stops it"
            )
            return text, f"remove the parameter '{wrong.given}', or give it a default"
        case Wrong.NOT_ADDED:
            text = f"nothing adds '{wrong.given}' to the launch description, so that launch never runs this {wrong.of}"
            whose = f", in place of '{wrong.wanted}', which it starts" if wrong.wanted else ""
            return text, f"put '{wrong.given}' into the list of LaunchDescription(){whose}, or delete it"
        case Wrong.OVERWRITTEN:
            text = (
                f"this {wrong.of} is lost: before it is added, line {wrong.wanted} gives '{wrong.given}' another action"
            )
            own = "give each a variable of its own, and put both into the list of LaunchDescription()"
            return text, f"remove one: both start the same program; if two are meant, {own}" if wrong.twice else own
        case Wrong.TUPLE:
            text = f"'{wrong.given}' is a tuple, where launch wants an action: it stops with an AttributeError"
            return text, f"remove the comma behind the {wrong.of}, which makes the tuple"
        case Wrong.COMMA:
            text = f"this {wrong.given} is called like a function: launch stops with a TypeError"
            return text, "put a comma behind it"
        case Wrong.OPAQUE:
            text = f"'{wrong.of}' returns a single {wrong.given}, where launch wants a list: it stops with a TypeError"
            return text, "return the actions in a list: [...]"
        case Wrong.OPAQUE_CALLED:
            text = f"'{wrong.given}' is called here, and OpaqueFunction wants the function itself"
            return text, f"write OpaqueFunction(function={wrong.given})"
        case Wrong.OPAQUE_CONTEXT:
            text = f"'{wrong.given}' takes no argument, and launch passes the context: a TypeError stops it"
            return text, f"write def {wrong.given}(context)"
        case Wrong.NO_LIST:
            return f"{wrong.of} is given {wrong.given}, and launch wants {wrong.wanted}", "put it into a list: […]"
    advice = _IN_LIST.get(wrong.wanted, f"write {wrong.wanted}")
    return f"{wrong.given} stands in {wrong.of}, where launch wants {wrong.wanted}", advice


_IN_LIST = {
    "a text": "move it to parameters=: here its keys alone become words of the command line",
    "texts alone": "write its values as texts of the list: here its keys alone become words of the command line",
    "actions": "put the actions themselves into the list",
    "each file by itself": "remove the braces, so that each file is an item of the list",
}
"""What to do about an item of a list, by what is wanted instead: otherwise it is an expression to write."""


def _without_context(failing: WithoutContext) -> Finding:
    given = f"is called with {failing.given}, which is not the launch context" if failing.given else _NEW
    return finding(
        "LCH008",
        failing.place,
        f"perform() of this {failing.substitution} {given}: the launch stops here with an exception",
        help="call it in the function of an OpaqueFunction, which receives the launch context",
        identity=(failing.substitution, failing.given),
        group=(failing.place.file, "perform"),
    )


_NEW = "is called with a new LaunchContext, in which no launch argument has a value"


@folds("LCH008", across_systems=True)
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for what a file does wrong in the same way at several places: launch stops at the first key of a file
    that is not there."""
    keys: dict[str, Finding] = {}
    for each in findings if _ABSENT in findings[0].group else ():
        keys.setdefault(each.identity[1], each)
    if len(keys) > 1:
        return with_others([*keys.values()], "another key is", "more keys are", "not there, either")
    return with_other_places(findings, "here, too")
