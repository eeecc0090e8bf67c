"""PKG002: the executables that a package installs, held against its files."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.completeness import walk
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.suggestions import did_you_mean, nearest
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.launch.load import LaunchLoader
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.workspace.installed import Executable


def workspace_of(system: System) -> WorkspaceIndex | None:
    """Packages are judged once: with the open system, or with the only one there is."""
    workspace = system.workspace
    return workspace if workspace is not None and (system.launched is None or workspace.explicit) else None


# ------------------------------------------------------------------------------------------------- PKG002


@rule("PKG002", scope=Scope.WORKSPACE)
def broken_entry_point(system: System, options: Options) -> Iterator[Finding]:
    """Console scripts whose module or function is not there."""
    workspace = workspace_of(system)
    if workspace is None or workspace.loader is None:
        return
    for name in sorted(workspace.installs):
        for executable in workspace.installs[name].executables.values():
            if executable.wrong:
                yield _wrong(executable)
            elif executable.module is not None and not _never_run(workspace, executable):
                yield from _broken(workspace, executable)


def _never_run(workspace: WorkspaceIndex, executable: Executable) -> bool:
    """Whether a setup.py names it in a package that CMake builds: nobody reads that."""
    package = workspace.packages.get(executable.package)
    cmake = package is not None and package.build_type == "ament_cmake"
    return cmake and posixpath.basename(executable.place.file) == "setup.py"


def _wrong(executable: Executable) -> Finding:
    target = f"{executable.module}:{executable.function or 'main'}" if executable.module else "package.module:function"
    return finding(
        "PKG002",
        executable.place,
        f"this entry installs no executable '{executable.name}': {executable.wrong}",
        help=f"write '{executable.name} = {target}'" + ("," if "comma" in executable.wrong else ""),
        identity=(executable.package, executable.name),
    )


def _is_on_disk(loader: LaunchLoader, package: str, module: str) -> bool:
    """Whether a module is there and not read: a pattern of ``.gitignore`` leaves it out."""
    installs = loader.installs.get(package)
    path = "/" + module.replace(".", "/")
    files = [] if installs is None else loader.tree.files_below(installs.folder)
    below = "" if installs is None or installs.folder == "." else f"{installs.folder}/"
    return any(f"/{file.removeprefix(below)}".endswith((f"{path}.py", f"{path}/__init__.py")) for file in files)


def _broken(workspace: WorkspaceIndex, executable: Executable) -> Iterator[Finding]:
    assert workspace.loader is not None and executable.module is not None
    modules = workspace.loader.modules_of(executable.package)
    if not modules:
        return
    module, function = executable.module, executable.function
    paths = [path for name, path in modules.items() if name == module]
    paths = paths or workspace.loader.files_named(executable.package, module)
    if not paths:
        top = module.partition(".")[0]
        ours = {name.partition(".")[0] for name in modules}
        if top not in ours and nearest(top, ours) is None:
            return  # a module of another distribution
        if _is_on_disk(workspace.loader, executable.package, module):
            return
        parent, _, last = module.rpartition(".")
        meant = f"; did you mean '{parent}:{last}'?" if function is None and parent in modules else ""
        yield _entry_finding(executable, f"module '{module}' is not there{meant or _near_module(module, modules)}")
        return
    found = workspace.loader.facts_at(paths[0])
    if found is None or found.problems:
        return
    if function is None:
        if not _runs_when_imported(found.body):
            yield _entry_finding(executable, f"'{module}' is a module, and no function of it is named")
        return
    names, open_ = _top_level(found.body)
    head = function.partition(".")[0]
    if head not in names and not open_:
        yield _entry_finding(executable, f"'{module}' has no function '{head}'{did_you_mean(head, names)}")


def _runs_when_imported(body: list[facts.Stmt]) -> bool:
    """Whether a module does more than define names when it is imported: that may be all that it is there for."""
    loops = (facts.For, facts.While, facts.With, facts.Try)
    return any(
        isinstance(item, loops) or (isinstance(item, facts.Expression) and isinstance(item.value, facts.Call))
        for item in body
    )


def _near_module(module: str, known: Iterable[str]) -> str:
    """The hint for a module: one beside it by the last part of its name, else by the whole name."""
    parent, _, last = module.rpartition(".")
    beside = [name.rpartition(".")[2] for name in known if name.rpartition(".")[0] == parent]
    if not beside:
        return did_you_mean(module, known)
    near = nearest(last, beside)
    return f"; did you mean '{parent}.{near}'?" if near is not None else ""


def _entry_finding(executable: Executable, what: str) -> Finding:
    return finding(
        "PKG002",
        executable.place,
        f"the executable '{executable.name}' cannot start: {what}",
        help="an entry point is 'name = package.module:function'",
        identity=(executable.package, executable.name),
    )


def _top_level(body: list[facts.Stmt]) -> tuple[set[str], bool]:
    """The names that a module binds, and whether there may be more."""
    names: set[str] = set()
    open_ = False
    for item in walk(body):
        if isinstance(item, (facts.Function, facts.Class)):
            names.add(item.name)
        elif isinstance(item, facts.ImportFrom):
            names.update(bound for _, bound in item.names)
            open_ = open_ or any(name == "*" for name, _ in item.names)
        elif isinstance(item, facts.Import):
            names.add(item.alias or item.module.partition(".")[0])
        elif isinstance(item, facts.Assign):
            names.update(target.id for target in item.targets if isinstance(target, facts.Name))
        elif isinstance(item, facts.Name) and item.id in ("globals", "setattr"):
            open_ = True
    return names, open_
