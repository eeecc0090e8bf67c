"""LCH003: launch configurations that nothing declares, and arguments that an included file does not take."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.checks.folding import folds, with_places
from archlint.checks.includes_elsewhere import PASSED_TO_ALL, is_shared, unknown_elsewhere
from archlint.checks.late_declarations import LATE, late_declaration
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch.kinds import FileStatus
from archlint.launch_files.fragments import is_left_out_fragment
from archlint.launch_files.launch_code import may_read_argument
from archlint.launch_files.misread_arguments import MisreadArgument, misread_arguments
from archlint.launch_files.substitution_values import is_chosen_in_vain
from archlint.launch_files.unread_arguments import all_readers_are_known, unread_argument_meant
from archlint.packaging.run_commands import is_told_to_set
from archlint.suggestions import did_you_mean, listed

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.mistakes import UndeclaredUse
    from archlint.launch.model import Included, Launched
    from archlint.systems.model import System, WorkspaceIndex


@rule("LCH003", scope=Scope.LAUNCH_FILE, command_line=False)
def undeclared_launch_argument(system: System, options: Options) -> Iterator[Finding]:
    """Launch configurations that are read and never set, and arguments that an include does not take; with
    ``command-line`` also the files that declare nothing, and get all values from whoever starts them."""
    launched = system.launched
    if launched is None or system.workspace is None:
        return
    told: list[Finding] = []
    if not launched.gaps and not _meant_to_be_included(launched):
        told = [*_of_one_call(_undeclared_uses(system, launched))]
        if not options.flag("command-line"):
            told = [diagnostic for diagnostic in told if diagnostic.severity is not Severity.INFO]
    yield from told
    if not told:
        yield from map(_misread, misread_arguments(system.workspace, launched.file))
    yield from _handed_on(system.workspace, _of_includes(system.workspace, launched))
    yield from unknown_elsewhere(system.workspace, launched)


def _of_includes(workspace: WorkspaceIndex, launched: Launched) -> list[Finding]:
    # One include may be of one of several files, or of all of them: an argument is for the one that takes it.
    reported: dict[tuple[object, ...], Finding] = {}
    for place, includes in groupby(launched.included, key=lambda include: include.place):
        if is_chosen_in_vain(workspace, place):
            continue  # LCH006 says why the other file, which may take the argument, is never included
        for unknown_argument in _unknown_arguments(workspace, launched, list(includes)):
            first = reported.setdefault((place.file, unknown_argument.message), unknown_argument)
            if first.place != unknown_argument.place:  # the same file is included with the same arguments again
                reported[place.file, unknown_argument.message] = replace(
                    first, related=(*first.related, Related(unknown_argument.place, "and here"))
                )
    return list(reported.values())


def _handed_on(workspace: WorkspaceIndex, findings: Sequence[Finding]) -> Iterator[Finding]:
    """Findings about includes; those of a file that hands the same arguments to several others are one mistake."""
    rows = [(told, tuple(part for part in told.identity if part not in workspace.launched_alone)) for told in findings]
    counts = Counter((told.place.file, names) for told, names in rows if told.severity is not Severity.INFO)
    for told, names in rows:
        many = told.severity is not Severity.INFO and counts[told.place.file, names] > 1
        yield replace(told, group=(told.place.file, *names, "handed on")) if many else told


def _misread(row: MisreadArgument) -> Finding:
    return finding(
        "LCH003",
        row.place,
        f"no launch argument '{row.name}' is declared, and nothing reads '{row.declared}', which is",
        help=f"read '{row.declared}', or declare '{row.name}'",
        related=[Related(row.declared_at, f"'{row.declared}' is declared here")],
        identity=(row.place.file, row.name),
        meant=row.declared,
    )


def places_of_unknown_arguments(workspace: WorkspaceIndex, launched: Launched) -> set[Place]:
    """Where includes are given arguments that no file of theirs takes."""
    places = set()
    for _, includes in groupby(launched.included, key=lambda include: include.place):
        for unknown in _unknown_arguments(workspace, launched, list(includes)):
            places |= {unknown.place, *(related.place for related in unknown.related)}
    return places


def told_as_left_out(system: System) -> set[tuple[str, str]]:
    """The files and names of the arguments of which LCH003 says that their declaration is not added, be it that this
    system is one of several which follow from values of such an argument."""
    launched = system.launched
    if launched is not None and system.workspace is not None:
        by_file = {other.file: other for other in system.workspace.launched}
        launched = by_file.get(launched.file, launched)
    if launched is None or launched.gaps or _meant_to_be_included(launched):
        return set()
    told = {(diagnostic.place, diagnostic.identity) for diagnostic in _undeclared_uses(system, launched)}
    left_out = (use for use in launched.undeclared if _left_out(launched, use) is not None)
    return {(use.file, use.name) for use in left_out if (use.place, (use.file, use.name)) in told}


def _comes_from_others(workspace: WorkspaceIndex, use: UndeclaredUse) -> bool:
    """Whether launch files that include one, or did so once, have what it reads."""
    return use.name in _passed_to_any(workspace) or is_left_out_fragment(workspace, use.file, use.name)


def _undeclared_uses(system: System, launched: Launched) -> Iterator[Finding]:
    reported: set[str] = set()
    own = {use.name: use.own_default for use in launched.undeclared if use.own_default is not None}
    plain: dict[str, list[UndeclaredUse]] = {}
    for use in launched.undeclared:
        alone = use.file == launched.file
        if use.conditional or (alone and system.is_included) or use.name in reported:
            continue  # whoever includes it may pass it: that system reports it
        if alone and system.workspace is not None and _comes_from_others(system.workspace, use):
            continue
        if system.workspace is not None and is_told_to_set(system.workspace, launched.file, use.name):
            continue
        if not alone and system.is_included and _is_set_above(system.workspace, launched, use):
            continue
        reported.add(use.name)
        if use.unseen is not None:
            continue  # an include in front of it is not there, which LCH004 reports: what it declares nobody knows
        if use.name in own:
            yield _its_own_default(use, own[use.name])
            continue
        places = [argument.place for argument in launched.declared if argument.name == use.name]
        later = [place for place in places if place.file == use.file]  # what an include declares is for itself
        if use.later and later:
            continue
        left_out = _left_out(launched, use)
        if left_out is not None:
            yield _never_added(use, left_out)
            continue
        if not places or (alone and not _declares(launched) and _is_required_by_include(launched, use)):
            plain.setdefault(use.file, []).append(use)
            continue
        if later:
            yield late_declaration(system.workspace, use, places[0])
            continue
        yield finding(
            "LCH003",
            use.place,
            f"no launch argument '{use.name}' is declared at this point, and nothing sets it",
            help=f"declare it before it is read: {_declaration(use)}",
            related=[Related(places[0], "declared here, later")],
            identity=(use.file, use.name),
        )
    for uses in plain.values():
        yield _never_declared(system.workspace, launched, uses)


def _is_set_above(workspace: WorkspaceIndex | None, launched: Launched, use: UndeclaredUse) -> bool:
    """Whether a launch file that includes this one has a value for what a file further down reads."""
    others = () if workspace is None else workspace.launched
    above = [other for other in others if launched.file in other.sources[1:] and use.file in other.sources]
    return not all(
        any((left.name, left.file) == (use.name, use.file) for left in other.undeclared if not left.conditional)
        for other in above
    )


@once
def _passed_to_any(workspace: WorkspaceIndex) -> frozenset[str]:
    """The arguments that launch files pass to an include of which nobody knows which file of the workspace it is."""
    includes = (include for launched in workspace.launched for include in launched.included)
    unknown = (include for include in includes if include.reference.source is None)
    return frozenset(name for include in unknown if _may_be_here(workspace, include) for name, _ in include.arguments)


def _may_be_here(workspace: WorkspaceIndex, include: Included) -> bool:
    return include.reference.status == FileStatus.UNKNOWN or include.reference.package in workspace.packages


def _is_required_by_include(launched: Launched, use: UndeclaredUse) -> bool:
    """Whether an included file wants a value of the argument anyway: ``--show-args`` lists it."""
    rows = [argument for argument in launched.declared if argument.name == use.name]
    return all(argument.default is None and argument.file != use.file for argument in rows)


def _never_declared(workspace: WorkspaceIndex | None, launched: Launched, uses: Sequence[UndeclaredUse]) -> Finding:
    """One finding for all that a file reads and nobody declares.  Where a file declares nothing at all, whoever starts
    it gives the names on the command line: they are only missing from what ``--show-args`` lists."""
    first, *others = uses
    meant = None if others or workspace is None else unread_argument_meant(workspace, launched, first.name, first.file)
    if meant is not None:
        return _misread(MisreadArgument(first.name, meant.name, first.place, meant.place))
    declared = sorted({argument.name for argument in launched.declared})
    message = f"no launch argument '{first.name}' is declared, and nothing sets it" + did_you_mean(first.name, declared)
    if others:
        shown = " and ".join(f"'{use.name}'" for use in uses)
        message = f"no launch arguments {shown} are declared, and nothing sets them"
    from_the_command_line = first.file == launched.file and not _declares(launched)
    if from_the_command_line:
        given = " and ".join(f"{use.name}:=…" for use in uses)
        message = f"the launch fails without {given} on its command line: no launch argument is declared"
    diagnostic = finding(
        "LCH003",
        first.place,
        message,
        help=f"declare {'each' if others else 'it'} before it is read: {_declaration(first)}",
        related=[
            Related(use.place, f"'{use.name}' is read here" + did_you_mean(use.name, declared))
            for use in (uses if others else ())
            if use is not first or did_you_mean(use.name, declared)
        ],
        identity=(first.file, *(use.name for use in uses)),
    )
    if not from_the_command_line:
        return diagnostic
    return replace(diagnostic, severity=Severity.INFO, group=(posixpath.dirname(first.file),))


def _declares(launched: Launched) -> bool:
    """Whether a launch file has a declaration of its own, be it one that it forgets to add."""
    written = {argument.file for argument in launched.declared} | {file for file, _ in launched.written}
    return launched.file in written


def _of_one_call(findings: Iterator[Finding]) -> Iterator[Finding]:
    """One finding for a call that reads several arguments, in the rounds of a loop say; an attribute in XML or YAML
    has a place for all that it reads."""
    of_call: dict[tuple[Place, str], Finding] = {}
    for diagnostic in findings:
        key = diagnostic.place, "" if diagnostic.place.file.endswith(".py") else diagnostic.message
        first = of_call.setdefault(key, diagnostic)
        if first is not diagnostic:
            rows = (*first.related, Related(diagnostic.place, diagnostic.message), *diagnostic.related)
            of_call[key] = replace(first, related=tuple(dict.fromkeys(rows)))
    yield from of_call.values()


def _its_own_default(use: UndeclaredUse, declaration: Place) -> Finding:
    return finding(
        "LCH003",
        declaration,
        f"the default of the launch argument '{use.name}' is '{use.name}' itself: without a value the launch fails",
        help="give it another default, or none if the argument is required",
        related=[Related(use.place, "it is read here")] if use.place != declaration else [],
        identity=(use.file, use.name),
    )


def _declaration(use: UndeclaredUse) -> str:
    """What declares an argument, in the language of the launch file that reads it."""
    if use.file.endswith(".py"):
        return f"DeclareLaunchArgument('{use.name}', default_value=…)"
    if use.file.endswith((".yaml", ".yml")):
        return f"- arg: {{name: {use.name}, default: …}}"
    return f'<arg name="{use.name}" default="…"/>'


def _left_out(launched: Launched, use: UndeclaredUse) -> Place | None:
    """Where the file that reads an argument makes a declaration of it that it then does not return."""
    declared = {(argument.file, argument.name) for argument in launched.declared}
    return None if (use.file, use.name) in declared else launched.written.get((use.file, use.name))


def _never_added(use: UndeclaredUse, declaration: Place) -> Finding:
    return finding(
        "LCH003",
        use.place,
        f"the launch argument '{use.name}' is read, but its declaration is not in the LaunchDescription",
        help="add the declaration to the LaunchDescription, before what reads it",
        related=[Related(declaration, "it is created here and never added")],
        identity=(use.file, use.name),
        group=(use.file, _NEVER_ADDED),
    )


_NEVER_ADDED = "never added"
"""The group of the declarations that a file makes and leaves out: mostly of one list that it does not return."""


_MANY = 3
"""From so many undeclared names on, nobody forgot one: whoever includes the file sets them all."""


def _meant_to_be_included(launched: Launched) -> bool:
    """Whether a launch file evidently gets its arguments from another one that is not here."""
    if any(argument.default is None and argument.file == launched.file for argument in launched.declared):
        return True
    uses = [use for use in launched.undeclared if not use.conditional and _left_out(launched, use) is None]
    return len({use.name for use in uses}) >= _MANY


# ----------------------------------------------------------------------------------------------- includes


def _unknown_arguments(
    workspace: WorkspaceIndex, launched: Launched, includes: Sequence[Included]
) -> Iterator[Finding]:
    """One finding an include, with all the arguments that no file of it takes."""
    given = dict(row for include in includes for row in include.arguments)
    sources = sorted({include.reference.source for include in includes if include.reference.source is not None})
    if not given or len(sources) < len({include.reference for include in includes}):
        return
    targets = [workspace.launched_alone[source] for source in sources]
    if not all(map(all_readers_are_known, targets)):
        return
    files = {source for target in targets for source in _files_of(target)}
    declared = sorted({argument.name for target in targets for argument in target.declared})
    read = {name for target in targets for name in target.read}
    unknown = [
        name
        for name, place in given.items()
        if name not in declared
        and place not in launched.reach_later
        and not is_shared(workspace, launched, includes, name, place)
        and name not in read
        and not any((include.file, name) in launched.set_by_includes for include in includes)
        and not any(may_read_argument(workspace, file, name) for file in files)
    ]
    if unknown:
        diagnostic = _finding(sources, unknown, given, declared)
        read_on = {name: launched.read_on[given[name]] for name in unknown if given[name] in launched.read_on}
        yield _not_scoped(diagnostic, read_on) if read_on else diagnostic


def _finding(sources: list[str], unknown: list[str], given: dict[str, Place], declared: list[str]) -> Finding:
    first, *others = unknown
    shown = " and ".join(posixpath.basename(source) for source in sources)
    verb = "declare" if len(sources) > 1 else "declares"
    said = f"{verb} no launch argument '{first}'" + did_you_mean(first, declared)
    if others:
        said = f"{verb} none of the launch arguments " + ", ".join(f"'{name}'" for name in unknown)
    diagnostic = finding(
        "LCH003",
        given[first],
        f"{shown} {said}",
        help=f"the value has no effect: declare the argument there or remove it; declared are {listed(declared)}",
        related=[Related(given[name], f"'{name}' is set here" + did_you_mean(name, declared)) for name in others],
        identity=(*sources, *unknown),
    )
    if set(unknown) <= PASSED_TO_ALL:
        folders = sorted({posixpath.dirname(source) for source in sources})
        return replace(diagnostic, severity=Severity.INFO, group=(*folders, *unknown))
    return replace(diagnostic, group=(*sources, *unknown))


def _not_scoped(diagnostic: Finding, read_on: Mapping[str, Place]) -> Finding:
    """Includes are not scoped: an argument that an include does not take replaces what the including file reads later.

    Source: launch, ``IncludeLaunchDescription.execute`` sets each argument in the context of the including file.
    """
    first, *_ = read_on
    shown = " and ".join(f"'{name}'" for name in read_on)
    return replace(
        diagnostic,
        message=f"{diagnostic.message}; includes are not scoped, so {shown} stays set to this for the rest of this "
        "file",
        help=f"remove the argument: LaunchConfiguration('{first}') then keeps its own value after this include",
        related=(*diagnostic.related, *(Related(place, f"'{name}' is read here") for name, place in read_on.items())),
        severity=Severity.WARNING,
        group=(*diagnostic.group, "not scoped"),
    )


@folds("LCH003", across_systems=True)
def _of_one_cause(findings: Sequence[Finding]) -> Finding:
    """One finding for an included file that does not take an argument, however many others hand it over; and for the
    launch files of a folder that all have the same habit."""
    first, *others = findings
    if LATE in first.group and others:
        names = listed([f"'{diagnostic.identity[-1]}'" for diagnostic in findings])
        message = f"the launch arguments {names} are read before they are declared"
        return replace(with_places(findings), message=message)
    if _NEVER_ADDED in first.group and others:
        names = listed([f"'{diagnostic.identity[-1]}'" for diagnostic in findings])
        message = f"the launch arguments {names} are read, but their declarations are not in the LaunchDescription"
        told = with_places(findings, "it is read here")
        return replace(
            told, message=message, help="add the declarations to the LaunchDescription, before what reads them"
        )
    alike = len({diagnostic.identity for diagnostic in findings}) - 1
    if not alike:
        return with_places(findings, "it is set here, too")
    more = "launch file" if alike == 1 else "launch files"
    rows = [Related(o.place, "it is set here, too" if o.identity == first.identity else o.message) for o in others]
    message = f"{first.message}; the same holds for {alike} more {more}"
    return replace(first, message=message, related=(*first.related, *rows))


def _files_of(target: Launched) -> set[str]:
    return {target.file, *(i.reference.source for i in target.included if i.reference.source is not None)}
