"""Code that no package installs: what rules find in it is information, for only who knows where it lies starts it."""

from __future__ import annotations

import math
import os
import posixpath
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.kept import kept
from archlint.checks.folding import all_sites, with_others
from archlint.checks.registry import registered
from archlint.engine.unused_files import named_files
from archlint.finding import Finding, Place, Related, Severity
from archlint.packaging.absent_packages import is_from_nowhere
from archlint.packaging.missing_imports import missing_imports
from archlint.packaging.renamed_packages import is_no_package
from archlint.python_code.how_imported import imports_file
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.engine.request import Request
    from archlint.systems.model import WorkspaceIndex

_DEPTH = 4
"""How many files that import each other are looked at."""


def files_of(workspace: WorkspaceIndex, findings: Iterable[Finding]) -> frozenset[str]:
    """The files of findings about code that no package installs; none where there are no packages, for all code is
    started by its path then."""
    if not workspace.manifests:
        return frozenset()
    files = {finding.place.file for finding in findings if _is_about_code(finding)}
    return frozenset(file for file in files if is_not_installed(workspace, file))


def as_information(findings: Iterable[Finding], files: AbstractSet[str]) -> list[Finding]:
    """The findings, those about code in some files as no more than information.  What has no ending of Python besides
    is a copy that nobody can import either, and is left out."""
    rows = [(finding, finding.place.file in files and _is_about_code(finding)) for finding in findings]
    return [
        replace(finding, severity=min(finding.severity, Severity.INFO)) if aside else finding
        for finding, aside in rows
        if not aside or finding.place.file.endswith(_ENDINGS)
    ]


def without_dead_ends(findings: Sequence[Finding], files: AbstractSet[str], workspace: WorkspaceIndex) -> list[Finding]:
    """The findings without those about code in some files that nobody can run: what imports beside itself
    (``from .arm import Arm``) cannot be started by its path, and a folder without ``__init__.py`` is not installed.
    What imports interfaces of a package that is nowhere stops there.  So it is with a module that no program comes to
    and that cannot be imported itself.  Where an import of such a file finds nothing, nothing else fails in it."""
    dead = {file for file in files if _is_dead_end(workspace, file)}
    others = {finding.place.file for finding in findings if _is_about_calls(finding)} - files
    dead |= {file for file in others if _is_stillborn(workspace, file)}
    ends = _first_missing(workspace, {each.place.file for each in findings if _is_about_calls(each)} & files)
    return [
        finding
        for finding in findings
        if not _is_about_calls(finding)
        or not (
            finding.place.file in dead
            or (_is_about_failures(finding) and ends.get(finding.place.file, math.inf) < finding.place.line)
            or _is_for_stillborn_alone(workspace, finding.place)
        )
    ]


def without_waits(
    findings: Iterable[Finding], files: AbstractSet[str], request: Request
) -> tuple[list[Finding], list[Finding]]:
    """The findings but for those about waits and sleeps in some files, and these: who starts such a file by its path
    sees that it waits, and ends it.  All where the settings want all files shown, or the run was asked about a file by
    its name."""
    if request.settings.unused_files:
        return list(findings), []
    shown: list[Finding] = []
    hidden: list[Finding] = []
    named = named_files(request)
    for each in findings:
        file = each.place.file
        waits = file in files and each.code.startswith(_OF_WAITS)
        (hidden if waits and os.path.abspath(file) not in named else shown).append(each)
    return shown, hidden


_OF_WAITS = ("TMO", "EXE003", "SRV008")
_OF_IMPORTS = "API006"


def _is_about_failures(finding: Finding) -> bool:
    return finding.code.startswith("API") and finding.code != _OF_IMPORTS


def _first_missing(workspace: WorkspaceIndex, files: AbstractSet[str]) -> dict[str, int]:
    """The lines of the first imports that find nothing as files are loaded."""
    ends: dict[str, int] = {}
    for missing in missing_imports(workspace) if files else ():
        place = missing.place
        code = workspace.facts_at(place.file) if place.file in files else None
        imports = [] if code is None else [part for part in code.body if isinstance(part, _IMPORTS)]
        if any(part.span[:2] == (place.line, place.column) for part in imports):
            ends[place.file] = min(place.line, ends.get(place.file, place.line))
    return ends


_IMPORTS = (facts.Import, facts.ImportFrom)


def _is_dead_end(workspace: WorkspaceIndex, file: str) -> bool:
    init, code = posixpath.join(posixpath.dirname(file), "__init__.py"), workspace.facts_at(file)
    if code is None or workspace.package_of(file) is None:
        return False
    if any(is_from_nowhere(workspace, package) for package in _interface_packages(code)):
        return True
    if workspace.tree.is_file(init):
        return False
    return any(isinstance(statement, facts.ImportFrom) and statement.level > 0 for statement in code.body)


def _is_stillborn(workspace: WorkspaceIndex, file: str, depth: int = _DEPTH) -> bool:
    """Whether a file is no program and in use by none, and imports a module that is nowhere as it starts, or is
    imported by such files alone."""
    return kept(workspace, (_is_stillborn, file, depth), lambda: _work_out_stillborn(workspace, file, depth))


def _work_out_stillborn(workspace: WorkspaceIndex, file: str, depth: int) -> bool:
    code = workspace.facts_at(file)
    if code is None or depth == 0 or file in workspace.code.in_use or _may_be_started(workspace, file, code):
        return False
    stem = posixpath.basename(file).removesuffix(".py")
    paths = (path for path in workspace.code.files_that_mention(stem) if path != file)
    importing = [path for path in paths if imports_file(workspace, path, file)]
    if importing:
        return all(_is_stillborn(workspace, path, depth - 1) for path in importing)
    return any(
        workspace.code.path_of_import(file, module) is None and is_no_package(workspace, module.partition(".")[0])
        for module in _modules_at_start(code)
    )


def _is_for_stillborn_alone(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether a place is in a function or class of a module that only files of its package name which cannot be
    imported."""
    code, package = workspace.facts_at(place.file), workspace.package_of(place.file)
    for part in () if code is None or package is None else code.body:
        if isinstance(part, (facts.Class, facts.Function)) and part.span[0] <= place.line <= part.span[2]:
            others = [other for other in code.body if other is not part] if code is not None else []
            if any(name.id == part.name for name in everything_in(others, facts.Name)):
                return False
            paths = [path for path in workspace.code.files_that_mention(part.name) if path != place.file]
            same = all(workspace.package_of(path) == package for path in paths)
            return bool(paths) and same and all(_is_stillborn(workspace, path) for path in paths)
    return False


def _may_be_started(workspace: WorkspaceIndex, file: str, code: facts.Facts) -> bool:
    """Whether a file does something as it is loaded, or is in no package whose programs are known."""
    installs = workspace.installs.get(workspace.package_of(file) or "")
    if installs is None or installs.open_executables or not installs.executables or main_guard(code) is not None:
        return True
    return posixpath.basename(file) == "__init__.py" or any(
        isinstance(statement, facts.Expression) and isinstance(statement.value, facts.Call) for statement in code.body
    )


def _modules_at_start(code: facts.Facts) -> Iterator[str]:
    """The modules that a file imports as it starts, whatever then happens, but for those beside it."""
    for statement in code.body:
        if isinstance(statement, facts.Import) or (isinstance(statement, facts.ImportFrom) and not statement.level):
            yield statement.module


def _interface_packages(code: facts.Facts) -> Iterator[str]:
    """The packages of whose interfaces a file imports some as it starts."""
    for statement in code.body:
        if isinstance(statement, facts.ImportFrom) and not statement.level:
            package, _, kind = statement.module.partition(".")
            if kind in ("action", "msg", "srv"):
                yield package


_ENDINGS = (".py", ".pyw")
_OF_CALLS = ("API", "EXE", "SRV", "TMO")


def once_for_a_file(findings: Iterable[Finding], files: AbstractSet[str]) -> list[Finding]:
    """The findings, those that are information for this reason with the reason in their message.  What a rule says of
    calls and waits in one such file is one finding, and so is the same in a copy beside it; where the file is a draft
    of an installed program, it belongs to the finding there.  Each wrong name and message stays."""
    of_files: dict[tuple[str, str, str | None, int | None], list[Finding]] = {}
    shown: list[Finding] = []
    for number, finding in enumerate(findings):
        if finding.place.file in files and finding.severity is Severity.INFO and _is_about_code(finding):
            apart = None if _is_about_calls(finding) else number
            of_files.setdefault((finding.code, finding.place.file, finding.system, apart), []).append(finding)
        else:
            shown.append(finding)
    drafts = _with_drafts(shown, of_files)
    of_copies: dict[tuple[object, ...], list[Finding]] = {}
    for (code, file, _, apart), row in of_files.items():
        finding = _first_of(row, "another line like it", "more lines like it")
        # The line and the message are those of a copy, which may have other values.
        twin = posixpath.dirname(file), finding.message, finding.place.line
        of_copies.setdefault((code, *twin, apart), []).append(finding)
    copies = (_first_of(row, "so does a copy beside it", "copies beside it do, too") for row in of_copies.values())
    reason = "; no installed program uses this file"
    return [*drafts, *(replace(finding, message=f"{finding.message}{reason}") for finding in copies)]


def _with_drafts(
    shown: Sequence[Finding], of_files: dict[tuple[str, str, str | None, int | None], list[Finding]]
) -> list[Finding]:
    """The findings in installed programs, each with the places where drafts of it, which no package installs, show the
    same of the same node.  These are taken out of ``of_files``."""
    told = {_of_node(finding): finding for finding in reversed(shown) if finding.node and _is_about_calls(finding)}
    drafts: dict[tuple[str, ...], list[Finding]] = {}
    for key, row in list(of_files.items()):
        if key[-1] is None and all(_of_node(finding) in told for finding in row):
            for finding in of_files.pop(key):
                drafts.setdefault(_of_node(finding), []).append(finding)
    return [_with_others_of(finding, drafts, told) for finding in shown]


def _with_others_of(
    finding: Finding, drafts: Mapping[tuple[str, ...], Sequence[Finding]], told: Mapping[tuple[str, ...], Finding]
) -> Finding:
    others = drafts.get(_of_node(finding), ()) if told.get(_of_node(finding)) is finding else ()
    if not others:
        return finding
    rows = (Related(other.place, "the same in a draft that no installed program uses") for other in others)
    return replace(finding, related=(*finding.related, *rows), sites=all_sites([finding, *others]))


def _of_node(finding: Finding) -> tuple[str, ...]:
    """What a program and a draft of it have in common, wherever in their files it stands."""
    return finding.code, finding.message, finding.node or ""


def _is_about_calls(finding: Finding) -> bool:
    return finding.code.startswith(_OF_CALLS)


def _first_of(findings: Sequence[Finding], another: str, more: str) -> Finding:
    """The first finding for all; the message ends with how many others there are."""
    ordered = sorted(findings, key=lambda finding: finding.sort_key)
    return with_others(ordered, another, more) if len(ordered) > 1 else ordered[0]


def _is_about_code(finding: Finding) -> bool:
    check = registered().get(finding.code)
    return check is not None and check.scope.of_code and not check.says_if_installed


__all__ = ["as_information", "files_of", "once_for_a_file", "without_dead_ends"]
