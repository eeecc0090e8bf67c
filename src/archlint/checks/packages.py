"""PKG002: the executables that a package installs, held against its files."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds
from archlint.checks.plugin_classes import plugin_classes
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.packaging.entry_points import NeverAwaited, NoFunction, NoFunctionNamed, NoModule, broken_target
from archlint.packaging.imports import imports
from archlint.packaging.left_out_code import is_entry_left_out
from archlint.packaging.webots_plugins import loaded_by_webots
from archlint.python_code.offered_names import own_names
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
                yield _wrong(executable)
            elif executable.module is not None and not _never_run(workspace, executable):
                yield from _broken(workspace, executable)
    yield from plugin_classes(workspace)


def _never_run(workspace: WorkspaceIndex, executable: Executable) -> bool:
    return is_ignored_by_cmake(workspace.packages.get(executable.package), executable)


def is_ignored_by_cmake(package: Package | None, executable: Executable) -> bool:
    """Whether a setup.py names an executable in a package that CMake builds: nobody reads that."""
    cmake = package is not None and package.build_type == "ament_cmake"
    return cmake and posixpath.basename(executable.place.file) == "setup.py"


def _wrong(executable: Executable) -> Finding:
    target = f"{executable.module}:{executable.function or 'main'}" if executable.module else "package.module:function"
    return finding(
        "PKG002",
        executable.place,
        f"this entry does not install an executable '{executable.name}': {executable.wrong}",
        help=f"write '{executable.name} = {target}'" + ("," if "comma" in executable.wrong else ""),
        identity=(executable.package, executable.name),
    )


def _broken(workspace: WorkspaceIndex, executable: Executable) -> Iterator[Finding]:
    match broken_target(workspace, executable):
        case NoModule(module, function, known):
            parent, _, last = module.rpartition(".")
            near = _near_module(module, _that_start(workspace, executable, module, known))
            target = f"{near}:{function or 'main'}"
            if function is None and parent in known and _may_offer(workspace, executable.package, parent, last):
                near = target = f"{parent}:{last}"
            elif near is not None and not _may_offer(workspace, executable.package, near, function or "main"):
                near = None
            if near is None:
                near = _shorter(workspace, executable, module, function or "main", known)
                target = f"{near}:{function or 'main'}"
            hint = "" if near is None else meant(f"'{near}'")
            help = "add the module, or remove the entry" if near is None else f"write '{executable.name} = {target}'"
            group = (executable.place.file, _NO_MODULE, "") if near is None else ()
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


def _that_start(workspace: WorkspaceIndex, executable: Executable, module: str, known: Collection[str]) -> list[str]:
    """The modules that may have been meant: they lie in a Python package, as the missing one does; no entry starts
    them; and they do not go on to the missing one, as a script of its name in ``scripts/`` may."""
    modules, others = workspace.code.modules_of(executable.package), _in_other_entries(workspace, executable)
    return [
        name
        for name in sorted({*known} - others)
        if ("." in name or "." not in module) and not imports(workspace, modules[name], module)
    ]


def _in_other_entries(workspace: WorkspaceIndex, executable: Executable) -> set[str]:
    """The modules that further entries of the package start: another command for one of them is not what was meant."""
    others = workspace.installs[executable.package].executables.values()
    return {other.module for other in others if other.module is not None and other is not executable}


def _shorter(
    workspace: WorkspaceIndex, executable: Executable, module: str, function: str, known: Collection[str]
) -> str | None:
    """The only module beside the missing one with the end of its name: ``arm.driver`` for ``arm.arm_driver``, which
    defines the function."""
    modules, (parent, _, last) = workspace.code.modules_of(executable.package), module.rpartition(".")
    beside = _that_start(workspace, executable, module, known) if parent else []
    ends = [name for name in beside if name.startswith(f"{parent}.") and last.endswith(f"_{name[len(parent) + 1 :]}")]
    code = {name: workspace.facts_at(modules[name]) for name in ends}
    having = [name for name, read in code.items() if read is not None and function in own_names(read)]
    return having[0] if len(having) == 1 else None


def _near_module(module: str, known: Collection[str]) -> str | None:
    """The module that was meant: one beside it by the last part of its name, else by the whole name."""
    parent, _, last = module.rpartition(".")
    beside = [name.rpartition(".")[2] for name in known if name.rpartition(".")[0] == parent]
    if not beside:
        return nearest(module, known)
    near = nearest(last, beside)
    return f"{parent}.{near}" if near is not None else None


def _may_offer(workspace: WorkspaceIndex, package: str, module: str, function: str) -> bool:
    """Whether a module has a word for a function: an empty ``__init__.py`` cannot be what was meant."""
    path = workspace.code.modules_of(package).get(module)
    return path is None or workspace.code.mentions(path, function.partition(".")[0])


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
            help="add the modules, or remove the entries",
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
