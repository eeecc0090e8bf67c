"""The module that an entry of a setup.py was meant to start, where the one that it names is not there."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from archlint.packaging.entry_points import NoModule, broken_target
from archlint.packaging.imports import imports, imports_at_start
from archlint.python_code.offered_names import own_names
from archlint.records import dataclass
from archlint.suggestions import distance, nearest

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable


@dataclass(frozen=True)
class Meant:
    """A module, or a function of one (``named``), and the ``target`` to write for it in the entry."""

    named: str
    target: str


@dataclass(frozen=True)
class ModuleLeft:
    """A module that no entry starts, and whether there is no other one with the function."""

    name: str
    alone: bool


def target_meant(workspace: WorkspaceIndex, executable: Executable) -> Meant | None:
    """What an entry whose module is not there was meant to start; None where that is not known.  Of several such
    entries for which the same one would do, it is that of the entry with the most similar name."""
    likely = _likely(workspace, executable)
    if likely is None or executable.module is None:
        return None
    edits = _edits(executable.module, likely.named)
    for other in workspace.installs[executable.package].executables.values():
        if other.module is None or other.module == executable.module or _edits(other.module, likely.named) > edits:
            continue
        if _likely(workspace, other) == likely:
            return None
    return likely


def module_left(workspace: WorkspaceIndex, executable: Executable) -> ModuleLeft | None:
    """The module of the package that defines the function of a broken entry, that no entry starts, and that alone is
    like what the entry names; None where another broken entry may be meant for it."""
    near = _like(workspace, executable, _that_are_left(workspace, executable))
    if len(near) != 1 or near[0] == executable.module:
        return None
    for other in workspace.installs[executable.package].executables.values():
        if other.module is None or other.module == executable.module or broken_target(workspace, other) is None:
            continue
        if near[0] in _like(workspace, other, _that_are_left(workspace, other)):
            return None
    return ModuleLeft(near[0], len(_that_are_left(workspace, executable)) == 1)


def _that_are_left(workspace: WorkspaceIndex, executable: Executable) -> list[str]:
    known, function = workspace.code.modules_of(executable.package), executable.function or "main"
    left = _that_start(workspace, executable, executable.module or "", known)
    return [name for name in left if _defines(workspace, executable, name, function)]


def _like(workspace: WorkspaceIndex, executable: Executable, names: Sequence[str]) -> list[str]:
    """The modules that share a word with the name of a broken entry, or of its module, or have it in their code."""
    modules = workspace.code.modules_of(executable.package)
    wanted = {executable.name, (executable.module or "").rpartition(".")[2]}
    words = {word for name in wanted for word in _telling_words(name)}
    return [
        name
        for name in names
        if words & _telling_words(name.rpartition(".")[2])
        or any(workspace.code.mentions(modules[name], each) for each in wanted)
    ]


def _telling_words(name: str) -> set[str]:
    return {word for word in re.split(r"[^a-z]+", name.lower()) if len(word) > 2} - _SAY_NOTHING


_SAY_NOTHING = frozenset({"main", "node", "nodes", "ros", "run", "script", "test"})


def is_called_in_its_code(workspace: WorkspaceIndex, package: str, folder: str, name: str) -> bool:
    """Whether the modules of a folder with Python code import each other as those of a Python package of another
    ``name``: what has to change then is the name of the folder."""
    modules = workspace.code.modules_of(package)
    files = {path for module, path in modules.items() if module.partition(".")[0] == folder}
    own = {module.partition(".")[2] for module, path in modules.items() if path in files}
    return any(
        row.file.relative in files and row.module.startswith(f"{name}.") and row.module.partition(".")[2] in own
        for row in imports_at_start(workspace)
    )


def folder_to_rename(workspace: WorkspaceIndex, executable: Executable, meant: Meant) -> tuple[str, str] | None:
    """The folder in which the module that was meant lies, and the name by which its own code and the entry call it."""
    there, _, rest = meant.named.partition(":")[0].partition(".")
    wanted, _, missing = (executable.module or "").partition(".")
    if rest != missing or not rest or not is_called_in_its_code(workspace, executable.package, there, wanted):
        return None
    return there, wanted


def _edits(module: str, named: str) -> int:
    return distance(module, named, len(module) + len(named))


def _likely(workspace: WorkspaceIndex, executable: Executable) -> Meant | None:
    """What one entry alone would be taken for."""
    broken = broken_target(workspace, executable)
    if not isinstance(broken, NoModule):
        return None
    module, known, package = broken.module, broken.known, executable.package
    function = broken.function or "main"
    parent, _, last = module.rpartition(".")
    if broken.function is None and parent in known and _may_offer(workspace, package, parent, last):
        return Meant(f"{parent}:{last}", f"{parent}:{last}")
    inside = [name for name in known if name.endswith(f".{module}")]
    near = inside[0] if len(inside) == 1 else _without_folders(workspace, package, module, function, known)
    near = near or _near_module(module, _that_start(workspace, executable, module, known))
    if near is None or not _may_offer(workspace, package, near, function):
        near = _shorter(workspace, executable, module, function, known)
        near = near or _of_its_own_name(workspace, executable, module, function, known)
        near = near or _in_another_folder(workspace, executable, module, function, known)
    return None if near is None else Meant(near, f"{near}:{function}")


def _without_folders(
    workspace: WorkspaceIndex, package: str, module: str, function: str, known: Collection[str]
) -> str | None:
    """The module that is left of a name without the folders that it begins with: ``robot.talker`` of
    ``src.robot.robot.talker``."""
    parts = module.split(".")
    shorter = (".".join(parts[count:]) for count in range(1, len(parts) - 1))
    return next((name for name in shorter if name in known and _may_offer(workspace, package, name, function)), None)


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
    parent, _, last = module.rpartition(".")
    beside = _that_start(workspace, executable, module, known) if parent else []
    ends = [name for name in beside if name.startswith(f"{parent}.") and last.endswith(f"_{name[len(parent) + 1 :]}")]
    having = [name for name in ends if _defines(workspace, executable, name, function)]
    return having[0] if len(having) == 1 else None


def _of_its_own_name(
    workspace: WorkspaceIndex, executable: Executable, module: str, function: str, known: Collection[str]
) -> str | None:
    """The module beside the missing one that has the name of the executable, and defines the function: an entry that
    is made of a copy of another one still names that one's module."""
    parent, _, _ = module.rpartition(".")
    own = f"{parent}.{executable.name}" if parent else executable.name
    starts = own in _that_start(workspace, executable, module, known)
    return own if starts and _defines(workspace, executable, own, function) else None


def _in_another_folder(
    workspace: WorkspaceIndex, executable: Executable, module: str, function: str, known: Collection[str]
) -> str | None:
    """The only module of the package with the last part of the name of the missing one, if it defines the function: a
    folder has been renamed, or the module was moved."""
    last = module.rpartition(".")[2]
    same = [name for name in _that_start(workspace, executable, module, known) if name.rpartition(".")[2] == last]
    return same[0] if len(same) == 1 and _defines(workspace, executable, same[0], function) else None


def _defines(workspace: WorkspaceIndex, executable: Executable, module: str, function: str) -> bool:
    code = workspace.facts_at(workspace.code.modules_of(executable.package)[module])
    return code is not None and function in own_names(code)


def _near_module(module: str, known: Collection[str]) -> str | None:
    """The module that was meant: one beside it by the last part of its name, else by the whole name."""
    parent, _, last = module.rpartition(".")
    beside = [name.rpartition(".")[2] for name in known if name.rpartition(".")[0] == parent]
    same = [name for name in known if parent and name.partition(".")[2] == module.partition(".")[2]]
    if not beside and len(same) == 1:
        return same[0]
    if not beside:
        return nearest(module, known)
    near = nearest(last, beside)
    return f"{parent}.{near}" if near is not None else None


def _may_offer(workspace: WorkspaceIndex, package: str, module: str, function: str) -> bool:
    """Whether a module has a word for a function: an empty ``__init__.py`` cannot be what was meant."""
    path = workspace.code.modules_of(package).get(module)
    return path is None or workspace.code.mentions(path, function.partition(".")[0])


__all__ = ["Meant", "ModuleLeft", "folder_to_rename", "is_called_in_its_code", "module_left", "target_meant"]
