"""Programs that make a node and never call ``rclpy.init()``.

Where a program imports anything beside rclpy, messages, Python's own modules and those that rosdep knows, that may have
called it.
"""

from __future__ import annotations

import posixpath
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.python_code.offered_names import may_make_names
from archlint.records import dataclass
from archlint.ros.python_modules import key_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import main_guard

if TYPE_CHECKING:
    from archlint.model import Blueprint
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex

_INTERFACES = frozenset({"action", "msg", "srv"})
_HARMLESS = frozenset(
    {"ament_index_python", "cv2", "cv_bridge", "mavros", "message_filters", "numpy", "rclpy", "rosidl_runtime_py"}
    | {"sensor_msgs_py", "tf2_geometry_msgs", "tf2_ros", "tf_transformations", "yaml"}
)
_INITIALISES, _MAIN = "init", "main"


@dataclass(frozen=True)
class Uninitialised:
    """The node that a program makes first of all, by its class, and where."""

    place: Place
    node: str


def uninitialised_programs(system: System) -> Iterator[Uninitialised]:
    """The first node of every such program."""
    workspace = system.workspace
    if workspace is None:
        return
    for program in system.programs:
        nodes = [node for node in program.nodes if _is_made(node)]
        followed = program.executable and not program.exhausted
        if (
            nodes
            and followed
            and not _may_initialise(workspace, program.file)
            and not _is_called(workspace, program.file)
        ):
            first = min(nodes, key=lambda node: node.number)
            yield Uninitialised(first.made_at or first.place, first.class_name if first.classes else "create_node")


def _is_made(node: Blueprint) -> bool:
    """Whether a call makes it that is certainly one of a program: of its class, or of ``create_node()``."""
    by_call = node.made_at is not None or not node.classes
    return node.constructed and by_call and not node.caller_unknown and not node.test


def _may_initialise(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether any file that a program imports may call ``rclpy.init()``."""
    paths = workspace.code.reached_from([file])
    if not file.endswith(".py") or not paths:
        return True
    calls_own = not any(_takes_main(workspace, path) for path in paths)
    return any(
        _calls_init_or_others(workspace, path, calls_own and path != file, workspace.code.top_modules)
        for path in sorted(paths)
    )


def _is_called(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a file is there for others, which import it and may call ``rclpy.init()`` first: nothing installs it as a
    program, so that its ``if __name__ == '__main__':`` is for trying it out."""
    if file in workspace.code.installed_programs:
        return False
    importers = workspace.code.files_that_mention(_name_in_imports(file))
    others = (other for other in importers if other != file and not workspace.roles.is_test(other))
    return any(file in workspace.code.reached_from([other]) for other in others)


def _name_in_imports(file: str) -> str:
    folder, name = posixpath.split(file)
    return posixpath.basename(folder) if name == "__init__.py" else name.removesuffix(".py")


def _calls_init_or_others(workspace: WorkspaceIndex, path: str, without_main: bool, own: frozenset[str]) -> bool:
    modules = _modules_or_none(workspace, path, without_main)
    return modules is None or any(
        top not in own and workspace.code.path_of_import(path, top) is None and not _is_harmless(top) for top in modules
    )


@kept_for_each_file
def _modules_of(code: facts.Facts) -> tuple[bool, frozenset[str]]:
    """Whether a file may call ``init()`` itself, and the first words of the modules that it imports, but for those of
    interfaces."""
    names = [part.module for part in everything_in(code.body, facts.Import)]
    names += [part.module for part in everything_in(code.body, facts.ImportFrom) if not part.level]
    tops = frozenset(name.partition(".")[0] for name in names if name.rpartition(".")[2] not in _INTERFACES)
    imported = {name for part in everything_in(code.body, facts.ImportFrom) for name, _ in part.names}
    return _INITIALISES in {*code.names, *imported} or may_make_names(code), tops


@kept_for_each_file
def _calls_init_in_main_alone(code: facts.Facts) -> bool:
    """Whether only the ``main()`` of a file calls ``init()``, and only the file as a program calls that."""
    guard = main_guard(code)
    rest = [part for part in code.body if part is not guard and not _is_main(part)]
    names = {part.id for part in everything_in(rest, facts.Name)}
    names |= {part.attr for part in everything_in(rest, facts.Attribute)}
    names |= {name for part in everything_in(rest, facts.ImportFrom) for name, _ in part.names}
    return names.isdisjoint({_INITIALISES, _MAIN}) and not may_make_names(code)


def _is_main(part: facts.Statement) -> bool:
    return isinstance(part, facts.Function) and part.name == _MAIN


@kept_for_each_file
def _takes_main(code: facts.Facts) -> bool:
    """Whether a file may call the ``main()`` of another one."""
    imported = {name for part in everything_in(code.body, facts.ImportFrom) for name, _ in part.names}
    asked = (part.attr for part in everything_in(code.body, facts.Attribute))
    return not imported.isdisjoint({_MAIN, "*"}) or _MAIN in asked


def _modules_or_none(workspace: WorkspaceIndex, path: str, without_main: bool) -> frozenset[str] | None:
    row = _modules_of(workspace, path)
    calls = row is None or (row[0] and not (without_main and _calls_init_in_main_alone(workspace, path)))
    return None if row is None or calls else row[1]


def _is_harmless(top: str) -> bool:
    return top in _HARMLESS or top in sys.stdlib_module_names or key_of(top) is not None


__all__ = ["Uninitialised", "uninitialised_programs"]
