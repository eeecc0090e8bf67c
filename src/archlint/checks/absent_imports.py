"""API002 about modules of launch, launch_ros and rclpy: names that they do not have, and modules that are not there."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.own_names import is_defined_somewhere
from archlint.checks.registry import finding
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding
from archlint.libraries import python_names
from archlint.libraries.absent_names import instead_of
from archlint.libraries.api_signatures import attributes_of
from archlint.libraries.module_names import modules_with, near_module, near_name
from archlint.python_code.absent_imports import Absent, absent_imports
from archlint.python_code.absent_in_python import absent_in_python
from archlint.suggestions import hint, meant

if TYPE_CHECKING:
    from archlint.systems.model import System

_WANTS_A_NAME = frozenset({"rclpy.logging.get_logger"})
"""Functions that have another one's name and fail without the argument that this does without."""
_BY_NAME = frozenset({"rclpy.duration.Duration", "rclpy.time.Time"})
"""What takes no argument by position."""
OF_MODULE = "module"
"""The group of findings that are about one name of a module."""
OF_NODES = "methods of nodes"
"""The group of findings about methods of nodes that a file calls as functions of rclpy: it has no node."""


def absent_import_findings(system: System, told: Collection[tuple[str, int]]) -> Iterator[Finding]:
    """The findings about names of modules, but for the lines (file and number) of which something is said already."""
    if system.workspace is None:
        return
    for file, absent in absent_imports(system.workspace):
        if (file, absent.span[0]) not in told and (absent.is_import or not _is_told_or_given(system, file, absent)):
            yield _no_module(file, absent) if absent.is_module else _no_name(file, absent)


def absent_in_python_findings(system: System) -> Iterator[Finding]:
    """The findings about names that modules of Python's library do not have."""
    for file, absent in () if system.workspace is None else absent_in_python(system.workspace):
        yield from unless_uncalled(system, _not_in_python(file, absent))


def _not_in_python(file: str, absent: Absent) -> Finding:
    module, name = absent.module, absent.name
    instead = python_names.instead_of(module, name)
    near = "" if instead else python_names.near_name(module, name)
    error = "an ImportError" if absent.is_import else "an AttributeError"
    return finding(
        "API002",
        absent.place(file),
        f"Python's module {module} has no '{name}': this line fails with {error}" + hint(near or instead),
        help=_cure_in_python(absent, f"{module}.{near}" if near else instead),
        identity=(f"{module}.{name}",),
        group=(OF_MODULE, file, f"{module}.{name}"),
        meant=near or instead,
        fails=not absent.in_except,
    )


def _cure_in_python(absent: Absent, instead: str) -> str:
    """What to write for what a module of Python does not have, with the dotted name that is meant, if there is one."""
    owner, _, name = instead.rpartition(".")
    from_module, inside = python_names.is_module(owner), instead.removeprefix(f"{absent.module}.")
    if not instead:
        return _failing(absent)
    if absent.is_import:
        return f"write `from {owner} import {name}`" if from_module else f"remove it, and write {instead}"
    if inside != instead and (owner in (absent.module, "os.path") or not from_module):
        return f"write {absent.written}.{inside}"
    return f"import {owner} and write {instead}" if from_module else f"write {instead}"


def _is_told_or_given(system: System, file: str, absent: Absent) -> bool:
    """Whether an attribute is one of rospy, whose calls are noted while the code is followed, or the workspace adds it
    to the module."""
    of_ros_1 = bool(instead_of(f"{absent.module}.{absent.name}"))
    return of_ros_1 or is_defined_somewhere(system, file, absent.name)


def _no_name(file: str, absent: Absent) -> Finding:
    module, name = absent.module, absent.name
    own = absent.in_node and module == "rclpy" and name in (attributes_of("rclpy.node.Node") or ())
    if own:
        return _of_node(file, absent)
    moved = modules_with(name, module)[:1]
    near = "" if moved else near_name(module, name)
    instead = instead_of(f"{module}.{name}")
    of_node = (
        not (moved or near or instead or absent.is_import)
        and module == "rclpy"
        and name in (attributes_of("rclpy.node.Node") or ())
    )
    if of_node:
        instead = f"{name}() of a node"
    where = f"; it is in {moved[0]}" if moved and not instead else hint("" if instead else near)
    return finding(
        "API002",
        absent.place(file),
        f"{module} has no '{name}'{where}",
        help=f"use {instead}" if instead else _cure(absent, moved[0] if moved else module, name if moved else near),
        identity=(f"{module}.{name}",),
        group=(OF_MODULE, file, OF_NODES) if of_node else (OF_MODULE, file, f"{module}.{name}"),
        meant=moved[0] if moved else near,
    )


def _of_node(file: str, absent: Absent) -> Finding:
    """About a method of nodes that is called as a function of rclpy: others of its name want an argument."""
    return finding(
        "API002",
        absent.place(file),
        f"rclpy has no '{absent.name}': it is a method of the node",
        help=f"write self.{absent.name}()",
        identity=(f"rclpy.{absent.name}",),
        group=(OF_MODULE, file, f"rclpy.{absent.name}", "self"),
    )


def _no_module(file: str, absent: Absent) -> Finding:
    offering = modules_with(absent.name, absent.module) if absent.name else []
    near = near_module(absent.module)
    module = near if near in offering or not offering else offering[0]
    return finding(
        "API002",
        absent.place(file),
        f"there is no module {absent.module}{meant(module)}",
        help=_cure(absent, module, absent.name) if module and (offering or not absent.name) else _failing(absent),
        identity=(absent.module,),
        group=(OF_MODULE, file, absent.module),
        meant=module,
    )


def _cure(absent: Absent, module: str, name: str) -> str:
    """The line to write, if there is something else to write."""
    if absent.is_import and name:
        return f"write `from {module} import {name}`"
    if absent.called_bare and f"{module}.{name}" in _WANTS_A_NAME:
        name = f"{name}('robot'), with any name"
    if absent.by_position and f"{module}.{name}" in _BY_NAME:
        name = f"{name}(seconds=…)"
    if name:
        return f"write {module}.{name}" if module == absent.module else f"import {module} and write {module}.{name}"
    return f"write `import {module}`" if absent.is_module and absent.is_import else _failing(absent)


def _failing(absent: Absent) -> str:
    if absent.in_except:
        return "the except fails, too, as soon as something is raised in its try: name a class that there is"
    what = "the import" if absent.is_import else "the line"
    when = "that function runs" if absent.in_function else "the file is loaded"
    when = "the file is run as a program" if absent.in_main and not absent.in_function else when
    return f"remove it, or name what there is: {what} fails when {when}"


__all__ = ["OF_MODULE", "OF_NODES", "absent_import_findings", "absent_in_python_findings"]
