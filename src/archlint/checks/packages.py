"""PKG002: the executables that a package installs, held against its files."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds
from archlint.checks.listed_packages import packages_in_vain
from archlint.checks.plugin_classes import plugin_classes
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch_files.launch_code import started_programs
from archlint.packaging.entry_points import NeverAwaited, NoFunction, NoFunctionNamed, NoModule, broken_target
from archlint.packaging.left_out_code import is_entry_left_out
from archlint.packaging.modules_meant import ModuleLeft, folder_to_rename, module_left, target_meant
from archlint.packaging.webots_plugins import loaded_by_webots
from archlint.suggestions import did_you_mean, listed, meant, nearest

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import Executable
    from archlint.workspace.model import Package


def workspace_of(system: System) -> WorkspaceIndex | None:
    """Packages are judged once: with the open system, or with the only one there is."""
    workspace = system.workspace
    return workspace if workspace is not None and (system.launched is None or workspace.explicit) else None


# ------------------------------------------------------------------------------------------------- PKG002


@rule("PKG002", scope=Scope.WORKSPACE)
def broken_entry_point(system: System, options: Options) -> Iterator[Finding]:
    """Console scripts whose module or function is not there."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    for name in sorted(workspace.installs):
        for executable in workspace.installs[name].executables.values():
            if executable.wrong:
                yield _wrong(workspace, executable)
            elif executable.module is not None and not _never_run(workspace, executable):
                yield from _broken(workspace, executable)
    yield from plugin_classes(workspace)


def _never_run(workspace: WorkspaceIndex, executable: Executable) -> bool:
    return is_ignored_by_cmake(workspace.packages.get(executable.package), executable)


def is_ignored_by_cmake(package: Package | None, executable: Executable) -> bool:
    """Whether a setup.py names an executable in a package that CMake builds: nobody reads that."""
    cmake = package is not None and package.build_type == "ament_cmake"
    return cmake and posixpath.basename(executable.place.file) == "setup.py"


def _wrong(workspace: WorkspaceIndex, executable: Executable) -> Finding:
    target = f"{executable.module}:{executable.function or 'main'}" if executable.module else "package.module:function"
    what, help = (
        executable.wrong,
        f"write '{executable.name} = {target}'" + ("," if "comma" in executable.wrong else ""),
    )
    if isinstance(broken_target(workspace, executable), NoModule):  # to write it in the right form does not suffice
        there = target_meant(workspace, executable)
        what += f", and module '{executable.module}' does not exist"
        help = "remove the entry" if there is None else help.replace(target, there.target)
    return finding(
        "PKG002",
        executable.place,
        f"this entry does not install an executable '{executable.name}': {what}",
        help=help,
        identity=(executable.package, executable.name),
    )


def _broken(workspace: WorkspaceIndex, executable: Executable) -> Iterator[Finding]:
    match broken_target(workspace, executable):
        case NoModule(module):
            there = target_meant(workspace, executable)
            hint = "" if there is None else meant(f"'{there.named}'")
            help = _without_module(workspace, executable)
            if there is not None:
                help = f"write '{executable.name} = {there.target}'"
                renamed = folder_to_rename(workspace, executable, there)
                if renamed is not None and renamed[1] in packages_in_vain(workspace).get(executable.package, ()):
                    return  # PKG004 says so where setup.py lists the package
                if renamed is not None:
                    help = f"rename the folder '{renamed[0]}' to '{renamed[1]}', as which its own code imports it"
            group = (executable.place.file, _NO_MODULE, "") if there is None and _NAME_IT not in help else ()
            yield _entry_finding(executable, f"module '{module}' does not exist{hint}", help, group)
        case NoFunctionNamed(module, functions):
            help = _with_a_function(executable.name, module, functions)
            group = () if functions is None or functions else (executable.place.file, "", "")
            what = f"'{module}' is a module, but the entry names no function in it"
            yield _entry_finding(executable, what, help, group)
        case NeverAwaited(module, function, place):
            what = (
                f"'{function}' of '{module}' is an async def, and nothing runs the coroutine that the script gets of it"
            )
            help = f"name a function in the entry that calls asyncio.run({function}())"
            told = _entry_finding(executable, what, help)
            yield replace(told, related=(Related(place, f"'{function}' is defined here"),))
        case NoFunction(module, function, names, runs_first, ros1, has_others):
            near = nearest(function, names)
            group = () if near is not None else (executable.place.file, function, ros1)
            hint = did_you_mean(function, names)
            otherwise = "use a function that it has" if has_others else "remove the entry: it has no function at all"
            help = f"define '{function}' in the module, or {otherwise}"
            left = None if has_others else module_left(workspace, executable)
            if left is not None:
                help, group = _name_it(executable, left), ()
            if near is not None:
                help = f"write '{executable.name} = {module}:{near}'"
            elif ros1:
                help = f"port the module to ROS 2, which has no {ros1}, or remove the entry"
            diagnostic = _entry_finding(executable, f"'{module}' has no function '{function}'{hint}", help, group)
            loaded = loaded_by_webots(workspace, module) if near is None and not runs_first else None
            if loaded is not None:
                diagnostic = _of_webots(diagnostic, *loaded)
            at_the_end = runs_first and near is None
            if at_the_end and is_entry_left_out(workspace, executable):
                return  # it is not even installed, as PKG004 says
            yield _fails_at_the_end(diagnostic, executable, module, function) if at_the_end else diagnostic


def _without_module(workspace: WorkspaceIndex, executable: Executable) -> str:
    """What to do about an entry whose module is nowhere: one that no launch file starts is left over."""
    if (executable.package, executable.name) in started_programs(workspace):
        return "add the module, or remove the entry"
    left = module_left(workspace, executable)
    return _LEFT_OVER if left is None else _name_it(executable, left)


_NAME_IT = "of the modules that no entry names"


def _name_it(executable: Executable, left: ModuleLeft) -> str:
    """Advice to start the one module that may have been meant."""
    function = executable.function or "main"
    why = f"only this one has a function '{function}'" if left.alone else "this one has the nearest name"
    return f"write '{executable.name} = {left.name}:{function}': {_NAME_IT}, {why}"


_LEFT_OVER = "remove the entry: it has no module, and no launch file starts it"


def _of_webots(diagnostic: Finding, name: str, place: Place) -> Finding:
    """What Webots loads by its class needs no entry: nobody starts that one."""
    return replace(
        diagnostic,
        help=f"remove the entry: Webots loads '{name}' by its class, without an executable",
        related=(Related(place, "it is loaded here"),),
        severity=Severity.INFO,
        group=(),
    )


def _with_a_function(name: str, module: str, functions: Sequence[str] | None) -> str:
    """What to write where an entry names no function: the one that is there."""
    if functions is not None and not functions:
        return f"remove the entry: '{module}' defines no function"
    chosen = "main" if functions is not None and "main" in functions else None
    if functions is not None and len(functions) == 1:
        chosen = functions[0]
    return f"write '{name} = {module}:{chosen or 'function'}'"


def _fails_at_the_end(diagnostic: Finding, executable: Executable, module: str, function: str) -> Finding:
    """What does its work when it is imported starts, and fails only afterwards."""
    return replace(
        diagnostic,
        message=f"the executable '{executable.name}' fails when its work is done: '{module}' runs when it is imported "
        f"and has no function '{function}'",
        help=f"move what the module runs into a function '{function}'",
        severity=Severity.WARNING,
        group=(),
    )


_ADD_THEM = "add the modules, or remove the entries"
_LEFT_OVER_ENTRIES = "remove the entries: they have no modules, and no launch file starts them"
_NO_MODULE = "no module"
"""The group of entries whose modules are not there, and that have no near name."""


@folds("PKG002")
def _without_one_function(several: Sequence[Finding]) -> Finding:
    """One finding for the entries of a file whose modules all lack the same function."""
    first, *others = several
    if not others:
        return first
    _, function, _ = first.group
    names = [entry.identity[1] for entry in several]
    if function == _NO_MODULE:
        return replace(
            first,
            message=f"{len(names)} executables cannot start: their modules do not exist: {listed(names)}",
            help=_LEFT_OVER_ENTRIES if all(entry.help == _LEFT_OVER for entry in several) else _ADD_THEM,
            related=tuple(Related(entry.place, entry.message) for entry in others),
            identity=(first.identity[0], *names),
        )
    what = f"their modules have no function '{function}'" if function else "their modules define no function at all"
    return replace(
        first,
        message=f"{len(names)} executables cannot start: {what}: {listed(names)}",
        help=first.help if function else "remove these entries",
        related=tuple(Related(entry.place, f"the entry of '{entry.identity[1]}'") for entry in others),
        identity=(first.identity[0], *names),
    )


def _entry_finding(executable: Executable, what: str, help: str, group: Sequence[str] = ()) -> Finding:
    return finding(
        "PKG002",
        executable.place,
        f"the executable '{executable.name}' cannot start: {what}",
        help=help,
        identity=(executable.package, executable.name),
        group=group,
    )
