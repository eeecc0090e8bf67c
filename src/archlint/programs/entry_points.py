"""Executables: what setup.py, setup.cfg, pyproject.toml and CMakeLists.txt start, and the files they install.

setup.py is never executed: its module is run symbolically, and the keywords of its ``setup(…)`` call are
read, so that variables, f-strings and comprehensions resolve.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from glob import has_magic
from typing import TYPE_CHECKING, Protocol

from archlint import model
from archlint.faults import Faults
from archlint.finding import Place
from archlint.interpreter.heap import Store
from archlint.interpreter.modules import Module, ModuleIndex
from archlint.interpreter.values import DictValue, Known, OneOf, Value
from archlint.launch.library import LaunchLibrary
from archlint.libraries.setuptools.setup_run import SetupRun
from archlint.programs.entry import EntryPoint
from archlint.programs.installs import console_script, read_cmake
from archlint.programs.python_code import python_code
from archlint.syntax.entry_point_tables import (
    ScriptEntry,
    data_files_of_setup_cfg,
    entries_of_pyproject,
    entries_of_setup_cfg,
    parse_entry,
)
from archlint.workspace.installed import Executable, InstalledFiles, Installs
from archlint.workspace.model import CODE_KINDS

if TYPE_CHECKING:
    from archlint.syntax.workspace_files import WorkspaceFiles
    from archlint.workspace.model import BuildType, SourceFile
    from archlint.workspace.tree import Tree


class PackageFolder(Protocol):
    """A package of the workspace: its name, the shown path of the folder of its package.xml, its build type."""

    @property
    def name(self) -> str: ...

    @property
    def relative(self) -> str: ...

    @property
    def build_type(self) -> BuildType: ...


def read_installs(
    packages: Iterable[PackageFolder],
    workspace: WorkspaceFiles,
    faults: Faults | None = None,
    index: ModuleIndex | None = None,
) -> dict[str, Installs]:
    """What each package installs, by package name.  What fails here is noted in ``faults``; the modules that were run
    for it are those of ``index``."""
    files, tree = workspace.files, workspace.tree
    index = index or ModuleIndex(workspace.importable, workspace.facts_of)
    setups = {file.relative: file for file in files if file.kind == "setup_py"}
    faults = faults or Faults()
    by_package: dict[str, Installs] = {}
    for package in packages:
        installs = by_package[package.name] = Installs(package.name, package.relative)
        with _reading(installs, "CMakeLists.txt", faults) as cmake:
            if tree.is_file(cmake) and not _is_built_by_setup_py(package, tree):
                read_cmake(installs, cmake, tree)
        if package.build_type == "ament_python":  # which does not run CMake
            installs.open_executables = installs.open_files = False
        installs.generates_nothing &= package.build_type == "ament_cmake"
        installs.generates_nothing |= package.build_type == "ament_python"
        with _reading(installs, "setup.cfg", faults):
            _read_tables(installs, tree)
        before, named = (installs.open_executables, installs.open_files), dict(installs.executables)
        with _reading(installs, "setup.py", faults) as path:
            _read_setup_at(installs, path, setups, index, tree, faults)
        if package.build_type == "ament_cmake":  # which does not run setup.py
            installs.open_executables, installs.open_files = before
            installs.executables.update(named)
            _without_renamed(installs, named)
            installs.python = installs.data_files_at = None
        with _reading(installs, "package.xml", faults):
            _find_programs(installs, tree)
            _follow_links(installs, files, tree)
    return by_package


def _without_renamed(installs: Installs, by_cmake: Mapping[str, Executable]) -> None:
    """Take away the entry points of a setup.py that nobody runs whose programs CMake installs as scripts, under the
    names of their files: ``ros2 run`` finds ``drive.py``, and no ``drive``."""
    for name, executable in list(installs.executables.items()):
        module = (executable.module or "").rpartition(".")[2]
        script = by_cmake.get(f"{module}.py")
        if name not in by_cmake and name == module and script is not None and script.script is not None:
            del installs.executables[name]


def _is_built_by_setup_py(package: PackageFolder, tree: Tree) -> bool:
    """Whether a package is built by its setup.py alone: a CMakeLists.txt beside that is never run."""
    return package.build_type == "ament_python" and tree.is_file(posixpath.join(package.relative, "setup.py"))


@contextmanager
def _reading(installs: Installs, name: str, faults: Faults) -> Iterator[str]:
    """The path of a package's build file.  Where reading it fails there may be more than is known of, and ``faults``
    are told."""
    path = posixpath.normpath(posixpath.join(installs.folder, name))
    try:
        yield path
    except Exception as error:
        faults.note("reading what this package installs", error, Place(path, 1, 1, 1, 1))
        installs.open_executables = installs.open_files = True


def _read_setup_at(
    installs: Installs, path: str, setups: dict[str, SourceFile], index: ModuleIndex, tree: Tree, faults: Faults
) -> None:
    setup = setups.get(path)
    if setup is None:
        return
    module = index.module(setup)
    if module is None:
        installs.open_executables = installs.open_files = True
    else:
        _read_setup(installs, module, index, tree, faults)


def _find_programs(installs: Installs, tree: Tree) -> None:
    """The scripts, of any language, that come to the program folder with a whole folder or by a pattern."""
    programs = f"lib/{installs.package}"
    rows = [row for row in installs.files if posixpath.normpath(row.destination) == programs]
    if not rows:
        return
    place = Place(installs.build_files[-1], 1, 1, 1, 1)
    folders = dict.fromkeys(row.source if row.folder else posixpath.dirname(row.source) for row in rows)
    for path in dict.fromkeys(path for folder in folders for path in tree.files_below(folder or ".")):
        name = posixpath.basename(path)
        if path in installs.source_of(f"{programs}/{name}", rows):
            installs.add(Executable(name, installs.package, place, script=path))


def _follow_links(installs: Installs, files: Sequence[SourceFile], tree: Tree) -> None:
    """A script that is a link to another file of the workspace is that file."""
    scripts = [executable for executable in installs.executables.values() if executable.script is not None]
    if not scripts:
        return
    known = {file.relative for file in files}
    for executable in scripts:
        assert executable.script is not None
        if executable.script not in known:
            meant = tree.same_file(executable.script, files)
            if meant is not None:
                installs.executables[executable.name] = replace(executable, script=meant.relative)


def entry_points(installs: dict[str, Installs], files: Sequence[SourceFile]) -> list[EntryPoint]:
    """Every Python executable of the workspace as the linker wants it."""
    by_path = {file.relative: file for file in files}
    entries: list[EntryPoint] = []
    for package in sorted(installs):
        for executable in installs[package].executables.values():
            if executable.module is not None:
                entries.append(EntryPoint(executable.name, package, executable.module, executable.function))
            elif executable.script in by_path:
                file = by_path[executable.script]
                if file.kind in CODE_KINDS:
                    entries.append(EntryPoint(executable.name, package, file.module or "", None, file))
    return entries


def _read_tables(installs: Installs, tree: Tree) -> None:
    for name, read in (("setup.cfg", entries_of_setup_cfg), ("pyproject.toml", entries_of_pyproject)):
        path = posixpath.normpath(posixpath.join(installs.folder, name))
        text = tree.text(path)
        for entry in read(text) if text is not None and "scripts" in text else ():
            installs.build_files.append(path)
            installs.add(console_script(entry, installs.package, path))


# ------------------------------------------------------------------------------------------------ setup.py


def _read_setup(installs: Installs, module: Module, index: ModuleIndex, tree: Tree, faults: Faults) -> None:
    installs.build_files.append(module.path)
    place = Place(module.path, 1, 1, 1, 1)
    program = model.Program("setup", module.file.package, module.path)
    run = SetupRun(LaunchLibrary, index, Store(), program, model.Callback(model.Role.MODULE, "setup", place, None))
    run.faults = faults
    run.tree, run.folder = tree, installs.folder
    run.import_module(module)
    cut_short = run.exhausted or run.program.exhausted
    if cut_short:
        installs.open_executables = installs.open_files = True
    if run.keywords is None:
        installs.open_executables = installs.open_files = True
        return
    keywords = run.keywords
    if _has_entries(run, keywords.get("entry_points")):
        _drop_those_of_table(installs)
    installs.open_executables |= run.open
    installs.open_files |= run.open
    where = run.called_at or place
    _console_scripts(installs, run, keywords.get("entry_points"), where, tree)
    _scripts(installs, run, keywords.get("scripts"), where)
    _data_files(installs, run, keywords.get("data_files"))
    installs.data_files_at = run.data_files_at or where
    if run.data_files_at is None and not run.open:  # what setup.py says itself counts
        _data_files_of_table(installs, tree)
    if not run.open and not cut_short:
        installs.python = python_code(installs, run, keywords)


def _items(run: SetupRun, value: Value | None) -> tuple[list[Value], bool]:
    """The items of a list, and whether there may be more."""
    if value is None or value.is_none:
        return [], False
    items = value.items(run)
    return ([], True) if items is None else (list(items.values), items.open)


def _has_entries(run: SetupRun, value: Value | None) -> bool:
    entries = value.entries(run) if isinstance(value, DictValue) else None
    return entries is not None and bool(entries.entries)


def _drop_those_of_table(installs: Installs) -> None:
    """Where ``setup()`` is given entry points, those of setup.cfg are not read, whatever their names.

    Source: ``ConfigHandler.__setitem__`` of setuptools, which leaves what has a value already.
    """
    table = posixpath.normpath(posixpath.join(installs.folder, "setup.cfg"))
    for row in [row for row in installs.executables.values() if row.place.file == table]:
        del installs.executables[row.name]


def _console_scripts(installs: Installs, run: SetupRun, value: Value | None, where: Place, tree: Tree) -> None:
    if value is None:
        return
    if not isinstance(value, DictValue):
        installs.open_executables = True
        return
    entries = value.entries(run)
    installs.open_executables |= entries.open
    for key, rows in entries.entries.values():
        if key.text != "console_scripts":
            continue
        texts, more = _items(run, rows)
        if isinstance(rows, Known) and isinstance(rows.value, str):
            texts, more = [Known(row, rows.via, rows.origin) for row in rows.value.splitlines()], False
        installs.open_executables |= more
        for text in texts:
            _script_text(installs, text, where, tree)


def _script_text(installs: Installs, text: Value, where: Place, tree: Tree) -> None:
    match text:
        case OneOf(values=options):
            for option in options:
                _script_text(installs, option, where, tree)
            return
        case Known(value=str(written), origin=origin):
            entry = parse_entry(written)
        case _:
            installs.open_executables = True
            return
    if entry is None:
        return
    joined = _joined_entries(origin, tree) if entry.wrong else []
    if joined:
        names = " and ".join(f"'{script.name}'" for script in joined)
        wrong = f"a comma is missing between {names}; newer setuptools stop the build here"
        entry = replace(joined[0], wrong=wrong)
    for script in (entry, *joined[1:]):
        place = origin or where
        installs.add(
            Executable(script.name, installs.package, place, script.module, script.function, wrong=script.wrong)
        )


_LITERAL = re.compile(r"""(["'])([^"'\n]*)\1""")


def _joined_entries(place: Place | None, tree: Tree) -> list[ScriptEntry]:
    """The entries of neighbouring strings, which Python makes one text; none where they are something else."""
    text = None if place is None else tree.text(place.file)
    if place is None or text is None:
        return []
    lines = text.splitlines()[place.line - 1 : place.end_line]
    lines[-1:] = [line[: place.end_column - 1] for line in lines[-1:]]
    lines[:1] = [line[place.column - 1 :] for line in lines[:1]]
    written = "\n".join(lines)
    parts = [parse_entry(match[2]) for match in _LITERAL.finditer(written)]
    entries = [entry for entry in parts if entry is not None and not entry.wrong]
    return entries if len(entries) == len(parts) > 1 else []


def _scripts(installs: Installs, run: SetupRun, value: Value | None, where: Place) -> None:
    rows, more = _items(run, value)
    installs.open_executables |= more
    for row in rows:
        match row:
            case Known(value=str(written), origin=origin) if "*" not in written:
                shown = posixpath.normpath(posixpath.join(installs.folder, written))
                name = posixpath.basename(written)
                installs.add(Executable(name, installs.package, origin or where, script=shown))
            case _:
                installs.open_executables = True


def _data_files_of_table(installs: Installs, tree: Tree) -> None:
    """The data files that a setup.cfg lists."""
    path = posixpath.normpath(posixpath.join(installs.folder, "setup.cfg"))
    for row in data_files_of_setup_cfg(tree.text(path) or ""):
        if has_magic(posixpath.dirname(row.source)):  # files of several folders
            installs.open_files = True
            continue
        place = Place(path, row.line, 1, row.line, 1)
        installs.data_files_at = place
        _data_file(installs, row.source, row.destination.lstrip("/"), place)


def _data_file(installs: Installs, source: str, destination: str, place: Place | None) -> None:
    shown = posixpath.normpath(posixpath.join(installs.folder, source))
    if destination.rstrip("/") == f"lib/{installs.package}" and "*" not in shown:
        name = posixpath.basename(shown)
        at = Place(installs.build_files[-1], 1, 1, 1, 1)
        installs.add(Executable(name, installs.package, at, script=shown))
    installs.files.append(InstalledFiles(shown, destination or ".", place=place))


def _data_files(installs: Installs, run: SetupRun, value: Value | None) -> None:
    rows, more = _items(run, value)
    installs.open_files |= more
    for row in rows:
        parts, open_ = _items(run, row)
        if open_ or len(parts) != 2 or not isinstance(parts[0], Known):
            installs.open_files = True
            continue
        destination = str(parts[0].value).lstrip("/")
        sources, more = _items(run, parts[1])
        patterns = [source for source in sources if isinstance(source, Known)]
        installs.open_files |= len(patterns) != len(sources) or (
            more and not any("*" in str(pattern.value) for pattern in patterns)
        )
        for pattern in patterns:
            _data_file(installs, str(pattern.value), destination, pattern.origin)
