"""Console scripts held against the code that they name."""

from __future__ import annotations

import posixpath
import re
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING, Union

from archlint.analysis.aside import ros1_module
from archlint.analysis.kept import kept
from archlint.packaging.absent_packages import is_nowhere
from archlint.packaging.generated_files import submodule_around
from archlint.place import Place
from archlint.records import dataclass
from archlint.ros.python_modules import key_of
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name, calls_in, calls_on_import, main_guard, statements_of

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Executable


@dataclass(frozen=True)
class NoModule:
    """There is no such module among those of the package."""

    module: str
    function: str | None
    known: tuple[str, ...]


@dataclass(frozen=True)
class NoFunctionNamed:
    """A module is named and no function of it, and importing it does nothing.  ``functions`` are those that it has,
    None where it may have more."""

    module: str
    functions: tuple[str, ...] | None = ()


@dataclass(frozen=True)
class NoFunction:
    """The module has no such function among the names that it has.  One that ``runs_first`` does its work when it is
    imported, so that nobody notices before the end of it."""

    module: str
    function: str
    known: frozenset[str]
    runs_first: bool = False
    ros1: str = ""
    """The first module of ROS 1 that it imports: a function alone would not start it either."""
    has_others: bool = True
    """Whether it has any function, of which another one may have been meant."""


@dataclass(frozen=True)
class NeverAwaited:
    """The function is an ``async def``: the script calls it, and nothing runs the coroutine that it gets."""

    module: str
    function: str
    place: Place


Broken = Union[NoModule, NoFunctionNamed, NoFunction, NeverAwaited]


def broken_target(workspace: WorkspaceIndex, executable: Executable) -> Broken | None:
    """What is wrong with what a console script starts; None where it can start, or may be of another distribution."""
    module, function = executable.module, executable.function
    modules = workspace.code.modules_of(executable.package)
    if module is None or not modules:
        return None
    package = module.removesuffix(".__init__")
    module = package if package in modules else module  # Python imports `robot.__init__`, too
    paths = [modules[module]] if module in modules else workspace.code.files_named(executable.package, module)
    if not paths:
        ours = {name.partition(".")[0] for name in modules}
        top = module.partition(".")[0]
        foreign = top not in ours and nearest(top, ours) is None and not _is_of_old_name(workspace, executable, modules)
        unread = is_on_disk(workspace, executable.package, module) or _is_in_empty_submodule(workspace, executable)
        if foreign or unread:
            return None
        return NoModule(module, function, tuple(modules))
    if module not in modules and _is_inside_package(workspace, executable, paths[0]):
        return NoModule(module, function, tuple(modules))
    file_facts = workspace.facts_at(paths[0])
    if file_facts is None or file_facts.problems:
        return None
    if function is None:
        return None if any(map(_does_something, file_facts.body)) else NoFunctionNamed(module, _functions(file_facts))
    head = function.partition(".")[0]
    if any(map(partial(_defines, head), file_facts.body)):
        coroutine = _coroutine(file_facts, function)
        if coroutine is None or calls_on_import(file_facts, function):
            return None
        return NeverAwaited(module, function, Place(paths[0], *coroutine.name_span))
    names = _bound_names(file_facts.body)
    if head in names or _binds_more(file_facts.body):
        return None
    if _serves_on_import(file_facts) or any(map(_never_ends, file_facts.body)):
        return None
    return NoFunction(
        module,
        head,
        names,
        _works_on_import(file_facts),
        ros1_module(file_facts) or "",
        _functions(file_facts) != (),
    )


def _is_inside_package(workspace: WorkspaceIndex, executable: Executable, path: str) -> bool:
    """Whether a file is installed with the package of Python around it, so that Python finds it under that name alone:
    the setup.py says nothing of other folders and of single modules."""
    code, setup = workspace.installs[executable.package].python, executable.place.file
    if code is None or posixpath.basename(setup) != "setup.py" or path in code.modules:
        return False
    is_installed = (
        posixpath.dirname(path) in code.folders and path in workspace.code.modules_of(executable.package).values()
    )
    return is_installed and not any(workspace.code.mentions(setup, word) for word in ("package_dir", "py_modules"))


def _is_of_old_name(workspace: WorkspaceIndex, executable: Executable, own: Mapping[str, str]) -> bool:
    """Whether a module of a package that is nowhere, or has no such module, is one of this package under its own name:
    who renames or copies a package forgets its entries."""
    module, function = executable.module or "", (executable.function or "main").partition(".")[0]
    top, _, rest = module.partition(".")
    same = [path for name, path in own.items() if rest and name.partition(".")[2] == rest]
    if top in sys.stdlib_module_names or not any(workspace.code.mentions(path, function) for path in same):
        return False
    if top in workspace.packages:
        return module not in workspace.code.modules_of(top)
    return is_nowhere(workspace, top) and key_of(top) is None


def _coroutine(file_facts: facts.Facts, function: str) -> facts.Function | None:
    """The ``async def`` that a module has under a name, which nothing else there binds and no decorator changes."""
    defined = [item for item in everything_in(file_facts.body, facts.Function) if item.name == function]
    if len(defined) != 1 or not defined[0].is_async or defined[0].decorators or defined[0] not in file_facts.body:
        return None
    assigned = (target.variable for part in everything_in(file_facts.body) for target in part.assigned)
    return None if function in assigned or _binds_more(file_facts.body) else defined[0]


def is_empty(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file has nothing in it at all."""
    return not (workspace.tree.text(file) or "").strip()


def starts_nothing(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a module has no ``main`` and does nothing when it is run: a process of it ends at once."""
    file_facts = workspace.facts_at(file)
    if file_facts is None or file_facts.problems or main_guard(file_facts) is not None:
        return False
    body, names = file_facts.body, _bound_names(file_facts.body)
    if "main" in names or _binds_more(body) or _works_on_import(file_facts):
        return False
    calls = calls_in([statement for statement in statements_of(body) if isinstance(statement, facts.Expression)])
    own = {statement.name for statement in statements_of(body, facts.Function)}
    return next(calls, None) is None and all(call.func.variable not in own for call in calls_in(body))


def only_defines_node(workspace: WorkspaceIndex, file: str) -> str | None:
    """The class of a node, where a script defines it and calls nothing at all: a process of it ends at once."""
    file_facts = workspace.facts_at(file)
    if file_facts is None or file_facts.problems or not all(map(_only_defines, file_facts.body)):
        return None
    classes = (statement for statement in file_facts.body if isinstance(statement, facts.Class))
    return next((cls.name for cls in classes if any(base.value.last_name.endswith("Node") for base in cls.bases)), None)


def _only_defines(statement: facts.Stmt) -> bool:
    match statement:
        case facts.Import() | facts.ImportFrom() | facts.Function() | facts.Class():
            return True
        case facts.Assign() | facts.Annotated() | facts.Expression():
            return next(calls_in([statement]), None) is None
    return False


def _functions(file_facts: facts.Facts) -> tuple[str, ...] | None:
    """The functions that a module defines, or the ``main`` that it imports: no other function of another module is a
    program.  None where a star import may bring one."""
    functions = tuple(statement.name for statement in file_facts.body if isinstance(statement, facts.Function))
    if "main" not in functions and "main" in _bound_names(file_facts.body):
        return ("main",)
    return None if not functions and _binds_more(file_facts.body) else functions


def _works_on_import(file_facts: facts.Facts) -> bool:
    """Whether importing a module runs a loop that calls something, or one that may go on, spins a node, shows a window
    until that is closed, or runs all from rclpy's start to its end."""
    guard = main_guard(file_facts)
    body = [statement for statement in file_facts.body if statement is not guard]
    if any(True for _ in statements_of(body, facts.While)):
        return True
    if any(True for loop in statements_of(body, facts.For) for _ in calls_in(loop.body)):
        return True
    calls = list(calls_in(body))
    starts_and_ends = {_method_of(call, "rclpy") for call in calls} >= {"init", "shutdown"}
    return starts_and_ends or any(called_name(call) == "spin" or _shows_window(call) for call in calls)


def _method_of(call: facts.Call, *names: str) -> str | None:
    """What a call asks of one of these names."""
    match call.func:
        case facts.Attribute(value=facts.Name(id=name), attr=method) if name in names:
            return method
    return None


def _shows_window(call: facts.Call) -> bool:
    """Whether a call returns when a window is closed: of pyplot, Tk or Qt."""
    return _method_of(call, "plt", "pyplot") == "show" or called_name(call) in ("mainloop", "exec_")


def _serves_on_import(file_facts: facts.Facts) -> bool:
    """Whether importing a module starts a server that serves until Ctrl-C, so that nothing after it is asked for."""
    guard = main_guard(file_facts)
    for call in calls_in([statement for statement in file_facts.body if statement is not guard]):
        match call.func:
            case facts.Attribute(attr="serve_forever" | "run_forever"):
                return True
            case facts.Attribute(value=facts.Name(id="app" | "uvicorn"), attr="run"):
                return True
    return False


def _never_ends(statement: facts.Stmt) -> bool:
    """Whether a statement is a loop that only the end of the program ends, so that nothing after it is asked for."""
    match statement:
        case facts.While(test=test, body=body):
            return test.truth is True and not any(map(_leaves_loop, body))
        case facts.Try(body=body, handlers=[], final=final):
            return any(map(_never_ends, body)) and not any(map(_leaves_loop, final))
        case facts.With(body=body):
            return any(map(_never_ends, body))
    return False


def _leaves_loop(statement: facts.Stmt) -> bool:
    """Whether a statement has a ``break`` of the loop around it."""
    match statement:
        case facts.Jump(kind="break"):
            return True
        case facts.For(orelse=inner) | facts.While(orelse=inner):
            return any(map(_leaves_loop, inner))
    return any(_leaves_loop(each) for block in statement.blocks for each in block)


def is_on_disk(workspace: WorkspaceIndex, package: str, module: str) -> bool:
    """Whether a module is there and not read: a pattern of ``.gitignore`` leaves it out, or it is compiled."""
    installs = workspace.installs.get(package)
    if installs is None:
        return False
    path = "/" + module.replace(".", "/")
    there = kept(workspace, (is_on_disk, package), lambda: _modules_below(workspace, installs.folder))
    return any(name.endswith(path) for name in there)


def _modules_below(workspace: WorkspaceIndex, folder: str) -> tuple[str, ...]:
    """The paths below a folder, without endings, of all files and folders that Python imports as a module."""
    below = "" if folder == "." else f"{folder}/"
    modules = (_MODULE.fullmatch(f"/{file.removeprefix(below)}") for file in workspace.tree.files_below(folder))
    return tuple(path for match in modules if match is not None for path in match.groups() if path is not None)


_MODULE = re.compile(r"((/.*)/__init__|.*)\.py|((.*)\.[^/.]+|.*)\.(?:so|pyd)", re.DOTALL)
"""What Python imports as a module, of code or compiled, such as ``driver.cpython-312-x86_64-linux-gnu.so``."""


def _is_in_empty_submodule(workspace: WorkspaceIndex, executable: Executable) -> bool:
    """Whether the module lies in a git submodule that is not checked out: what is in it is not known."""
    installs = workspace.installs.get(executable.package)
    if installs is None or executable.module is None:
        return False
    path = posixpath.normpath(posixpath.join(installs.folder, executable.module.replace(".", "/")))
    submodule = submodule_around(workspace, path)
    return submodule is not None and not workspace.tree.files_below(submodule)


def _does_something(statement: facts.Stmt) -> bool:
    """Whether a statement of a module does more than define a name: that may be all that the module is there for."""
    match statement:
        case facts.For() | facts.While() | facts.With() | facts.Try() | facts.Expression(value=facts.Call()):
            return True
    return False


def _defines(name: str, statement: facts.Stmt) -> bool:
    match statement:
        case facts.Function(name=defined) | facts.Class(name=defined):
            return defined == name
    return False


def _bound_names(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """The names that a module binds, wherever in it."""
    names: set[str] = set()
    for part in everything_in(body, facts.Statement):
        match part:
            case facts.Function(name=name) | facts.Class(name=name):
                names.add(name)
            case facts.ImportFrom(names=bound):
                names.update(name for _, name in bound)
            case facts.Import(module=module, alias=alias):
                names.add(alias or module.partition(".")[0])
            case facts.Assign(targets=targets):
                names.update(target.variable for target in targets)
    return frozenset(names - {""})


def _binds_more(body: Sequence[facts.Stmt]) -> bool:
    """Whether a module may bind names that stand nowhere in it."""
    stars = (name == "*" for statement in everything_in(body, facts.ImportFrom) for name, _ in statement.names)
    return any(stars) or any(variable.id in ("globals", "setattr") for variable in everything_in(body, facts.Name))


__all__ = [
    "NeverAwaited",
    "NoFunction",
    "NoFunctionNamed",
    "NoModule",
    "broken_target",
    "is_empty",
    "is_on_disk",
    "starts_nothing",
]
