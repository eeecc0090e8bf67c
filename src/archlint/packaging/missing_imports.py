"""Imports of the workspace's own Python code that find nothing.

A module of an installed package is imported by its whole name.  The folder that a file lies in is on Python's path only
while that very file is run as a script: `ros2 run` starts a console script, which imports the module, and then nothing
beside it is found.
"""

from __future__ import annotations

import posixpath
import re
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Union

from archlint.analysis.kept import kept, kept_for_each_file, once
from archlint.packaging.entry_points import is_on_disk
from archlint.packaging.generated_files import is_ignored, submodule_around
from archlint.packaging.imports_by_path import absolute, installed_name, module_of_package
from archlint.packaging.imports_of_launch_files import is_installed_package, is_only_beside
from archlint.packaging.mistaken_imports import interfaces_of, kind_left_out, module_of_ros, near_module
from archlint.packaging.renamed_packages import present_name
from archlint.packaging.told_scripts import is_told_to_run
from archlint.place import Place
from archlint.python_code.absent_imports import forgiving, is_tolerant
from archlint.python_code.offered_names import offers
from archlint.records import dataclass
from archlint.ros.python_modules import key_of
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile

_Import = Union[facts.Import, facts.ImportFrom]
_KINDS = ("python", "launch_python")
_INTERFACES = frozenset({"action", "msg", "srv"})
_COMPILED = frozenset({"cython", "generate_parameter_module", "nanobind", "pybind11", "python_add_library", "swig"})
"""Words of a build that makes modules which no file of Python is."""
_MADE_BY_TOOLS = ("_pb2", "_pb2_grpc", "_parameters", "_rc", "_ui", "_version")
"""How the names of modules end that a tool writes while the package is built."""

_PROSE = re.compile(r"""\b(?:long_)?description\s*=\s*(\"{3}|'{3}|\"|')(?:\\.|(?!\1)[^\\])*\1""")
"""What a setup.py says for people to read: a name in there installs nothing."""


@dataclass(frozen=True)
class MissingImport:
    """An import that finds nothing.  ``name`` is empty where the ``module`` itself is not there; ``near`` is what has
    almost the same name; ``beside`` is the name by which a file that lies beside this one can be imported."""

    place: Place
    module: str
    name: str = ""
    near: str = ""
    beside: str = ""
    without_init: str = ""
    """The folder of that module, where it is no package that ``find_packages()`` would install."""
    present: str = ""
    """What the module is called now that its package has another name."""
    outside: bool = False
    """Whether the module lies outside of every package, so that no build installs it under any name."""
    interfaces: str = ""
    """The module that has the ``name``, an interface, where it is imported from the package itself."""
    by_launch: bool = False
    """Whether the module lies beside a launch file, which launch loads by its path."""
    names: tuple[str, ...] = ()
    """What is imported from a module of which the top-level name is a slip."""


@once
def missing_imports(workspace: WorkspaceIndex) -> list[MissingImport]:
    """Every such import in the files that were asked for, but for test code."""
    return list(_missing_imports(workspace))


def _missing_imports(workspace: WorkspaceIndex) -> Iterator[MissingImport]:
    for file, _ in workspace.code.judged():
        if file.kind not in _KINDS or file.package is None or workspace.roles.is_test(file.relative):
            continue
        if _is_no_package(workspace, file):
            continue
        for written, level, names, span in _imports(workspace, file.relative) or ():
            place, module = Place(file.relative, *span), absolute(file, written, level)
            compiled = _compiled_part(file)
            if not module or module.rpartition(".")[2] == compiled:
                continue
            names = [name for name in names if name != compiled]
            beside = not level and span not in _of_scripts(workspace, file.relative)
            judged = _of_launch_file if file.kind == "launch_python" else _of_import
            yield from judged(workspace, file, module, names, place, beside)


def _is_no_package(workspace: WorkspaceIndex, file: SourceFile) -> bool:
    """Whether a file would make a package of a folder that setup.py installs as none, and that nothing imports: of
    scripts, say."""
    installs = workspace.installs.get(file.package or "")
    if installs is None or installs.python is None or posixpath.basename(file.relative) != "__init__.py":
        return False
    return not installs.python.has(file.relative) and file.relative not in workspace.code.in_use


def _of_import(
    workspace: WorkspaceIndex, file: SourceFile, module: str, names: list[str], place: Place, beside: bool
) -> Iterator[MissingImport]:
    missing = _beside(workspace, file, module, place) if beside else None
    missing = missing or _absent(workspace, file, module, names, place)
    missing = missing or (_nowhere(workspace, file, module, names, place) if beside else None)
    yield from [missing] if missing else _absent_names(workspace, file, module, names, place)


def _of_launch_file(
    workspace: WorkspaceIndex, file: SourceFile, module: str, names: list[str], place: Place, beside: bool
) -> Iterator[MissingImport]:
    if is_installed_package(workspace, module):
        missing = _absent(workspace, file, module, names, place)
        yield from [missing] if missing else _absent_names(workspace, file, module, names, place)
    elif beside and is_only_beside(workspace, file, module):
        yield MissingImport(place, module, by_launch=True)
    elif not beside:
        return
    elif (present := module_of_ros(workspace, file, module, names)) is not None:
        yield MissingImport(place, module, present=present, names=tuple(names))


def _compiled_part(file: SourceFile) -> str:
    """``_firmware`` for ``firmware.py``: so SWIG calls the library that it compiles for a wrapper in Python."""
    return f"_{posixpath.basename(file.relative).removesuffix('.py')}"


def _nowhere(
    workspace: WorkspaceIndex, file: SourceFile, module: str, names: list[str], place: Place
) -> MissingImport | None:
    """An import from a package that is nowhere, if it is known what was meant."""
    present = present_name(workspace, file, module, names) or interfaces_of(workspace, file, module, names)
    if present is None and file.relative in _by_console_scripts(workspace):
        present = installed_name(workspace, file, module, names) or module_of_package(workspace, file, module, names)
    near = near_module(workspace, file, module)
    if present is None and near is None:
        present = module_of_ros(workspace, file, module, names)
    if present is not None:
        path = workspace.code.file_of_import(file.relative, present)
        outside = path is not None and workspace.package_of(path) is None
        return MissingImport(place, module, present="" if outside else present, outside=outside)
    return MissingImport(place, module, near=near, names=tuple(names)) if near is not None else None


@kept_for_each_file
def _imports(code: facts.Facts) -> list[tuple[str, int, list[str], facts.Span]]:
    """The imports of a file that nothing goes on without: modules, how many dots stand before them, and names of
    these."""
    forgiven = {Itself[object](part) for block in _tried(code) for part in everything_in(block)}
    every: list[_Import] = [*everything_in(code.body, facts.Import), *everything_in(code.body, facts.ImportFrom)]
    left = [statement for statement in every if Itself(statement) not in forgiven]
    return [(*asked, statement.span) for statement in left for asked in _asked_for(statement)]


def _of_scripts(workspace: WorkspaceIndex, file: str) -> frozenset[facts.Span]:
    """The imports that a file comes to only while it is the program."""
    return _in_main_guard(workspace, file) or frozenset()


@kept_for_each_file
def _in_main_guard(code: facts.Facts) -> frozenset[facts.Span]:
    guard = main_guard(code)
    body = [] if guard is None else guard.body
    every: list[_Import] = [*everything_in(body, facts.Import), *everything_in(body, facts.ImportFrom)]
    return frozenset(statement.span for statement in every)


def _tried(code: facts.Facts) -> Iterator[list[facts.Stmt]]:
    """The blocks of which one is there for where another one's imports are not found."""
    yield from forgiving(code)
    for statement in everything_in(code.body, facts.Try):
        if any(map(is_tolerant, statement.handlers)):
            yield from (handler.body for handler in statement.handlers)


def _asked_for(statement: _Import) -> Iterator[tuple[str, int, list[str]]]:
    match statement:
        case facts.Import(module=module):
            yield module, 0, []
        case facts.ImportFrom(module=module, level=level, names=names):
            yield module, level, [name for name, _ in names if name != "*"]


# ------------------------------------------------------------------------------------- what a package does not have


def _absent(
    workspace: WorkspaceIndex, file: SourceFile, module: str, names: list[str], place: Place
) -> MissingImport | None:
    """A module that no file of the package of its name is."""
    if not _is_whole(workspace, module) or _is_there(workspace, file, module):
        return None
    first = _first_absent(workspace, file, module)
    above, _, last = first.rpartition(".")
    if file.relative in _by_console_scripts(workspace) and (there := installed_name(workspace, file, module, names)):
        return MissingImport(place, module, present=there) if names else MissingImport(place, module, near=there)
    if above not in workspace.code.modules or _is_on_disk(workspace, first):
        return None
    if any(map(_is_made_by_a_tool, (last, module.rpartition(".")[2], *names))):
        return None
    if first != module and _is_kept_out(workspace, first):
        return None
    beside = [name for name in workspace.code.modules if name.rpartition(".")[0] == above]
    near = nearest(last, [name.rpartition(".")[2] for name in beside])
    return MissingImport(place, first, near=f"{above}.{near}" if near else "")


def _is_kept_out(workspace: WorkspaceIndex, module: str) -> bool:
    """Whether git ignores the folder of a module, or has it in a repository of its own that is not here."""
    [package] = workspace.code.modules[module.partition(".")[0]]
    installs = workspace.installs.get(package or "")
    folder = "." if installs is None else installs.folder
    path = posixpath.normpath(posixpath.join(folder, module.replace(".", "/")))
    return is_ignored(workspace, path) or submodule_around(workspace, path) is not None


def _first_absent(workspace: WorkspaceIndex, file: SourceFile, module: str) -> str:
    """What is imported first of a dotted name and is not there: ``robot.tools`` for ``robot.tools.camera``."""
    above = module.rpartition(".")[0]
    is_there = _is_there(workspace, file, above) or _is_on_disk(workspace, above)
    if "." not in above or is_there or any(name.startswith(f"{above}.") for name in workspace.code.modules):
        return module
    return _first_absent(workspace, file, above)


def _absent_names(
    workspace: WorkspaceIndex, file: SourceFile, module: str, names: list[str], place: Place
) -> Iterator[MissingImport]:
    """The names that a module of the workspace does not have."""
    path = workspace.code.file_of_import(file.relative, module)
    if path is None and "." not in module:
        for name in names:
            having = kind_left_out(workspace, file, module, name)
            if having is not None:
                yield MissingImport(place, module, name, interfaces=having)
    if path is None or not _is_whole(workspace, module):
        return
    for name in names:
        inner = f"{module}.{name}"
        is_inner = _is_there(workspace, file, inner) or _is_on_disk(workspace, inner)
        if not is_inner and not _is_made_by_a_tool(name) and not offers(workspace, path, name):
            yield MissingImport(place, module, name)


def _is_made_by_a_tool(name: str) -> bool:
    return name == "version" or name.endswith(_MADE_BY_TOOLS)


def _is_there(workspace: WorkspaceIndex, file: SourceFile, module: str) -> bool:
    return module in workspace.code.modules or workspace.code.path_of_import(file.relative, module) is not None


def _is_on_disk(workspace: WorkspaceIndex, module: str) -> bool:
    [package] = workspace.code.modules[module.partition(".")[0]]
    return is_on_disk(workspace, package or "", module)


def _is_whole(workspace: WorkspaceIndex, module: str) -> bool:
    """Whether a dotted name begins with a Python package of which all modules are files of one package here."""
    top, _, rest = module.partition(".")
    if rest.partition(".")[0] in _INTERFACES:
        return False
    having = workspace.code.modules.get(top, frozenset())
    return len(having) == 1 and all(package is not None and _is_plain(workspace, package) for package in having)


def _is_plain(workspace: WorkspaceIndex, package: str) -> bool:
    """Whether the build of a package makes no modules of its own."""
    installs = workspace.installs.get(package)
    return installs is not None and installs.python is not None and _COMPILED.isdisjoint(installs.words)


# ------------------------------------------------------------------------------------------------ what lies beside it


def _beside(workspace: WorkspaceIndex, file: SourceFile, module: str, place: Place) -> MissingImport | None:
    """A module that is imported by its short name from a file that a console script imports."""
    top = module.partition(".")[0]
    path = workspace.code.path_of_import(file.relative, module)
    if path is None or top in workspace.code.modules or file.relative not in _by_console_scripts(workspace):
        return None
    if any(asked.partition(".")[0] == top and not level for asked, level, *_ in _imports(workspace, path) or ()):
        return None  # the file imports a module of its own name, which is somebody else's
    there = posixpath.join(posixpath.dirname(file.relative), module.replace(".", "/"))
    if top in sys.stdlib_module_names or key_of(top) is not None or path not in (f"{there}.py", f"{there}/__init__.py"):
        return None
    above, package = (file.module or "").rpartition(".")[0], file.package or ""
    if not above or _is_named_in_setup(workspace, package, above, top) or _is_beside_scripts(workspace, package, path):
        return None
    inside = "" if path.endswith("/__init__.py") else module.rpartition(".")[0].replace(".", "/")
    folder = posixpath.join(posixpath.dirname(file.relative), inside)
    without_init = inside if inside and not workspace.tree.is_file(f"{folder}/__init__.py") else ""
    return MissingImport(place, module, beside=f"{above}.{module}", without_init=without_init)


def _is_beside_scripts(workspace: WorkspaceIndex, package: str, path: str) -> bool:
    """Whether a file is installed among the console scripts of its package, too: Python looks into the folder of the
    program first."""
    installs = workspace.installs.get(package)
    place = f"lib/{package}/{posixpath.basename(path)}"
    return installs is not None and place in installs.places_of(path)


def _is_named_in_setup(workspace: WorkspaceIndex, package: str, above: str, top: str) -> bool:
    """Whether the setup.py of a package has a word, but for the name of the module inside of the package ``above``, as
    `packages=` lists it: it may install the module somewhere else, too."""
    installs = workspace.installs.get(package)
    if installs is None:
        return True
    path = posixpath.normpath(f"{installs.folder}/setup.py")
    if not workspace.code.mentions(path, top):
        return False
    text = workspace.tree.text(path)
    if text is None or "package_dir" in text:
        return True
    inside = "[./]".join(map(re.escape, [*above.split("."), top]))
    return re.search(rf"\b{re.escape(top)}\b", re.sub(rf"['\"]{inside}['\"]", "", _PROSE.sub("", text))) is not None


@once
def _by_console_scripts(workspace: WorkspaceIndex) -> frozenset[str]:
    """The files that console scripts import, and what these import in turn, in packages of Python alone that do not
    touch the path.  Where people are told to run the file of a console script itself, it finds what lies beside it."""
    starts: set[str] = set()
    for package, installs in workspace.installs.items():
        for executable in installs.executables.values() if _leaves_the_path(workspace, package) else ():
            if executable.module and not executable.script:
                files = workspace.code.files_named(package, executable.module)
                starts.update(file for file in files if not is_told_to_run(workspace, file))
    reached = workspace.code.reached_from(starts)
    return frozenset(path for path in reached if _leaves_the_path(workspace, workspace.package_of(path) or ""))


def _leaves_the_path(workspace: WorkspaceIndex, package: str) -> bool:
    installs = workspace.installs.get(package)
    return installs is not None and installs.python is not None and not _touches_the_path(workspace, package)


def _touches_the_path(workspace: WorkspaceIndex, package: str) -> bool:
    def touches() -> bool:
        read = (workspace.facts_at(path) for path in workspace.code.files_of(package))
        return any(map(_may_touch, read))

    return kept(workspace, (_touches_the_path, package), touches)


def _may_touch(code: facts.Facts | None) -> bool:
    return code is None or ("path" in code.names and "sys" in code.names and _has_path(code))


def _has_path(code: facts.Facts) -> bool:
    return any(part.dotted == "sys.path" for part in everything_in(code.body, facts.Attribute))


__all__ = ["MissingImport", "missing_imports"]
