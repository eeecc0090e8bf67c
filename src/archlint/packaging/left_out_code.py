"""Python code that installed programs and launch files import and that the setup.py of its package leaves out.

Only imports that run whenever the file is loaded count: not those below an ``if`` or a ``try``.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.workspace.folders import folders_above

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable, Installs


@dataclass(frozen=True)
class LeftOut:
    """A file of a package that its setup.py does not install, and the place that needs it: an import, or the entry of
    the executable that it is."""

    file: str
    package: str
    needed_at: Place
    entry: str = ""
    """The executable that cannot start, where its own module is left out, or a module beside its script."""
    module: str = ""
    """The name under which the entry asks for the file, where that is not the name of a module of the package."""


def left_out_code(workspace: WorkspaceIndex) -> Iterator[LeftOut]:
    """Each such file with each place that needs it, in the order in which programs come to them."""
    seen: set[str] = set()
    for package in sorted(workspace.installs):
        for executable in workspace.installs[package].executables.values():
            start = _file_of(workspace, executable)
            if start is None:
                continue
            if is_entry_left_out(workspace, executable):
                yield LeftOut(start, package, executable.place, executable.name, executable.module or "")
            yield from _imported_from(workspace, start, seen)
    for file in launch_files_in_python(workspace):
        yield from _imported_from(workspace, file, seen)


def launch_files_in_python(workspace: WorkspaceIndex) -> list[str]:
    """The launch files in Python that are in use; launch loads them by their paths, and their folder is not on
    Python's."""
    files = (file.relative for file, _ in workspace.code.asked_for() if file.kind == "launch_python")
    return [file for file in files if not workspace.roles.is_test(file) and not is_aside(workspace, file)]


def _file_of(workspace: WorkspaceIndex, executable: Executable) -> str | None:
    """The file that an executable runs; None where it is not of Python, or nothing starts it."""
    if executable.wrong:
        return None
    if executable.module is None:
        return executable.script
    known = workspace.code.modules_of(executable.package).get(executable.module)
    return known or _beside_setup(workspace, executable.package, executable.module)


def _beside_setup(workspace: WorkspaceIndex, package: str, module: str) -> str | None:
    """The file of a module in a folder beside setup.py that is no package of Python, such as ``scripts``, or in that
    of ``package_dir={'': 'src'}``."""
    installs = workspace.installs[package]
    folder = (installs.python.root if installs.python is not None else "") or installs.folder
    path = posixpath.normpath(posixpath.join(folder, f"{module.replace('.', '/')}.py"))
    return path if path in workspace.code.files_named(package, module) else None


def is_entry_left_out(workspace: WorkspaceIndex, executable: Executable) -> bool:
    """Whether setup.py does not install the module of an entry."""
    start = None if executable.module is None else _file_of(workspace, executable)
    return start is not None and _is_left_out(workspace, start, executable.module or "", of_entry=True)


def _imported_from(workspace: WorkspaceIndex, start: str, seen: set[str]) -> Iterator[LeftOut]:
    """What a file imports that is left out, and what the files that it imports do."""
    pending = [start]
    while pending:
        file = pending.pop(0)
        file_facts = workspace.facts_at(file)
        if file in seen or file_facts is None:
            continue
        seen.add(file)
        if changes_path(workspace, file):
            continue
        for statement in certain_imports(file_facts.body):
            for imported in files_of_import(workspace, file, statement):
                pending.append(imported)
                package = workspace.package_of(imported)
                if package is None or not _is_left_out(workspace, imported, _module_of(statement)):
                    continue
                if not _lies_beside_programs(workspace, package, statement):
                    yield LeftOut(imported, package, Place(file, *statement.span))


def _module_of(statement: facts.Import | facts.ImportFrom) -> str:
    """The module that an import names from the top on; empty for one that is beside the file."""
    return "" if isinstance(statement, facts.ImportFrom) and statement.level else statement.module


def _is_left_out(workspace: WorkspaceIndex, file: str, module: str, of_entry: bool = False) -> bool:
    """Whether a file, which code asks for as a ``module``, belongs to a package whose setup.py is understood and does
    not install it; one ``of_entry`` is not found in the share folder."""
    installs = _installs_of(workspace, file)
    if installs is None or installs.python is None or installs.open_files:
        return False
    if _is_of_another_distribution(workspace, installs.folder, file, module):
        return False
    scripts = (executable.script for executable in installs.executables.values())  # they find each other
    places = [place for place in installs.places_of(file) if not (of_entry and place.startswith("share/"))]
    return not installs.python.has(file) and not places and file not in scripts


def _lies_beside_programs(workspace: WorkspaceIndex, package: str, statement: facts.Import | facts.ImportFrom) -> bool:
    """Whether a module that is asked for by a bare name is installed as a file beside the programs, whatever folder it
    comes from: there Python looks first."""
    bare = "." not in statement.module and (isinstance(statement, facts.Import) or statement.level == 0)
    sources = workspace.installs[package].source_of(f"lib/{package}/{statement.module}.py")
    return bare and any(workspace.tree.is_file(source) for source in sources)


def _installs_of(workspace: WorkspaceIndex, file: str) -> Installs | None:
    installs = workspace.installs.get(workspace.package_of(file) or "")
    inside = installs is not None and (installs.folder == "." or file.startswith(f"{installs.folder}/"))
    return installs if inside else None


def _is_of_another_distribution(workspace: WorkspaceIndex, outer: str, file: str, module: str) -> bool:
    """Whether a folder inside of that of a setup.py has another, with which whoever needs the file installs it.  Under
    a name that begins with the way to that folder it does not come: the names of what is in there begin in it."""
    for folder in folders_above(file):
        if folder == outer:
            return False
        if any(workspace.tree.is_file(posixpath.join(folder, name)) for name in ("setup.py", "pyproject.toml")):
            first, _, _ = posixpath.relpath(file, folder).partition("/")
            way = posixpath.relpath(folder, outer).replace("/", ".")
            return first.removesuffix(".py") == module.partition(".")[0] or not f"{module}.".startswith(f"{way}.")
    return False


@kept_for_each_file
def changes_path(file_facts: facts.Facts) -> bool:
    """Whether a file may say itself where Python looks for modules, with ``sys.path``.  Its text is not asked: an edit
    of a comment would be a reason to judge the workspace again."""
    names = {i.alias or "sys" for i in everything_in(file_facts.body, facts.Import) if i.module == "sys"}
    from_sys = any(i.module == "sys" for i in everything_in(file_facts.body, facts.ImportFrom))
    paths = (a for a in everything_in(file_facts.body, facts.Attribute) if a.attr == "path")
    return from_sys or any(a.value.variable in names for a in paths)


def certain_imports(body: Sequence[facts.Stmt]) -> Iterator[facts.Import | facts.ImportFrom]:
    """The imports that run whenever a file is loaded."""
    for statement in body:
        match statement:
            case facts.Import() | facts.ImportFrom():
                yield statement
            case facts.With(body=inner) | facts.Class(body=inner):
                yield from certain_imports(inner)


def files_of_import(workspace: WorkspaceIndex, file: str, statement: facts.Import | facts.ImportFrom) -> Iterator[str]:
    """The files that an import runs, each under the name under which the import asks for it."""
    match statement:
        case facts.Import(module=module):
            names = [module.rsplit(".", cut)[0] for cut in range(module.count("."), -1, -1)]
            level = 0
        case facts.ImportFrom(module=module, level=level, names=bound):
            names = [module, *(f"{module}.{name}".lstrip(".") for name, _ in bound)]
    for name in dict.fromkeys(filter(None, names)):
        imported = workspace.code.file_of_import(file, name, level)
        if imported is not None:
            yield imported


def has_init(workspace: WorkspaceIndex, folder: str) -> bool:
    """Whether a folder is a package for ``find_packages()``."""
    return workspace.tree.is_file(posixpath.join(folder, "__init__.py"))


__all__ = [
    "LeftOut",
    "certain_imports",
    "changes_path",
    "files_of_import",
    "has_init",
    "is_entry_left_out",
    "launch_files_in_python",
    "left_out_code",
]
