"""How the files of a workspace import a name, for those who have forgotten to."""

from __future__ import annotations

import sys
from collections import Counter, defaultdict
from collections.abc import Collection
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.libraries.module_names import modules_with
from archlint.ros import standard_interfaces
from archlint.ros.interfaces import is_interface_name
from archlint.syntax import facts
from archlint.syntax.interfaces import INTERFACE_KINDS
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_USUAL = {
    "cv2": "import cv2",
    "get_package_share_directory": "from ament_index_python.packages import get_package_share_directory",
    "np": "import numpy as np",
    "pd": "import pandas as pd",
    "plt": "import matplotlib.pyplot as plt",
    "rclpy": "import rclpy",
    "tf2_ros": "import tf2_ros",
} | {
    name: f"from {module} import {name}"
    for module, names in {
        "cv_bridge": ("CvBridge", "CvBridgeError"),
        "typing": ("Any", "Callable", "Dict", "Iterable", "List", "Optional", "Sequence", "Set", "Tuple", "Union"),
        "message_filters": ("ApproximateTimeSynchronizer", "TimeSynchronizer"),
        "tf2_ros": (
            "Buffer",
            "ConnectivityException",
            "ExtrapolationException",
            "LookupException",
            "StaticTransformBroadcaster",
            "TransformBroadcaster",
            "TransformException",
            "TransformListener",
        ),
    }.items()
    for name in names
}


_MODULES_OF_VALUES = frozenset({"rclpy", "rclpy.qos"})
"""What these offer is for others, values too: ``qos_profile_sensor_data``."""


def import_of(
    workspace: WorkspaceIndex, name: str, *, file: str = "", in_launch_file: bool = False, called: bool = False
) -> str:
    """The statement that would bind a name in a file: what most other files of the workspace write, or what is usual;
    empty where neither is known.  A variable somewhere in ROS is not what a name means that is not ``called``, and no
    class; nor is the import of an interface by a name that ROS 2 gives none."""
    statements = _imports(workspace).get(name, Counter())
    sections = _sections_used(workspace, file, name)
    counts = {
        statement: n
        for statement, n in statements.items()
        if not _asks_in_vain(statement) and _is_of(statement.split()[1], sections)
    }
    if counts:
        return min(counts, key=lambda statement: (-counts[statement], statement))
    if name in _USUAL:
        return _USUAL[name]
    if name in sys.stdlib_module_names:
        return f"from {name} import {name}" if called and name in _WITH_A_FUNCTION_OF_THEIR_NAME else f"import {name}"
    offering = [*(modules_with(name, "launch") if in_launch_file else ()), *modules_with(name, "rclpy")]
    if not offering:
        return _import_of_interface(workspace, name, file, sections)
    if not (called or name[0].isupper() or offering[0] in _MODULES_OF_VALUES):
        return ""
    return f"from {offering[0]} import {name}"


def _import_of_interface(workspace: WorkspaceIndex, name: str, file: str, sections: Collection[str]) -> str:
    """The statement that imports an interface: from where the file imports others, else from the only package that has
    one of the name, those of the workspace before others."""
    table, code = workspace.interfaces, workspace.facts_at(file)
    if table is None or code is None or not is_interface_name(name):
        return ""
    own = [
        f"{package}.{kind}"
        for kind in INTERFACE_KINDS
        for package in table.packages_with(kind, name)
        if package not in workspace.installs or not workspace.installs[package].generates_nothing
    ]
    full = (full.split("/") for full in standard_interfaces.table().interfaces if full.endswith(f"/{name}"))
    common = [f"{package}.{kind}" for package, kind, _ in full]
    asked = {imported.module for imported in everything_in(code.body, facts.ImportFrom) if not imported.level}
    usual = [module for module in common if module.partition(".")[0] not in _FOR_FEW]
    own, common, usual = ([each for each in row if _is_of(each, sections)] for row in (own, common, usual))
    modules = [*asked.intersection(own + common)] or own or usual
    return f"from {modules[0]} import {name}" if len(modules) == 1 else ""


def _sections_used(workspace: WorkspaceIndex, file: str, name: str) -> frozenset[str]:
    """The kinds of interfaces that have what a file asks a name for, ``Move.Request`` of services alone, and messages
    where it makes one, ``Move()``; empty for any."""
    code = workspace.facts_at(file)
    uses = () if code is None else everything_in(code.body, facts.Attribute)
    parts = {use.attr for use in uses if use.value.variable == name}
    sections = frozenset(section for section, of in _PARTS.items() if not parts.isdisjoint(of))
    calls = () if code is None or sections else everything_in(code.body, facts.Call)
    return sections or frozenset({".msg"} if any(call.func.variable == name for call in calls) else ())


def _is_of(module: str, sections: Collection[str]) -> bool:
    """Whether a module may have an interface of some kind."""
    return not sections or not module.endswith(_SECTIONS) or module.endswith((*sections,))


_FOR_FEW = frozenset({"action_tutorials_interfaces", "example_interfaces", "turtlesim", "turtlesim_msgs"}) | {
    "actionlib_msgs"
}
"""Packages of lessons and of ROS 1, whose messages are meant where a file imports from them already."""


_WITH_A_FUNCTION_OF_THEIR_NAME = frozenset({"glob", "pprint"})
_SECTIONS = (".msg", ".srv", ".action")
_PARTS = {
    ".action": ("Goal", "Result", "Feedback"),
    ".srv": ("Request", "Response"),
}
"""What ROS 1 makes a class of its own of, and ROS 2 an attribute of that of the action or service."""


def _asks_in_vain(statement: str) -> bool:
    """Whether a statement imports an interface by a name that ROS 2 gives none."""
    words = statement.split()
    return words[0] == "from" and words[1].endswith(_SECTIONS) and not is_interface_name(words[3])


def interface_meant(workspace: WorkspaceIndex, file: str, name: str) -> str:
    """What of the interfaces that a file imports a name of ROS 1 means, ``Move.Result`` for ``MoveResult``, or ``Tick``
    for the ``tick`` that other files import in vain; empty for any other name."""
    code = workspace.facts_at(file)
    if code is None:
        return ""
    in_vain = any(map(_asks_in_vain, _imports(workspace).get(name, ())))
    for imported in everything_in(code.body, facts.ImportFrom):
        for section in _SECTIONS if imported.module.endswith(_SECTIONS) else ():
            for _, bound in imported.names if imported.module.endswith(section) else ():
                for part in _PARTS.get(section, ()):
                    if name == f"{bound}{part}":
                        return f"{bound}.{part}"
                if in_vain and bound.lower() == name.lower() and bound != name:
                    return bound
    return ""


def idle_import_with(workspace: WorkspaceIndex, file: str, word: str) -> str | None:
    """The only name that a file imports and does not use in which a word stands: ``FRONT_CAMERA`` for ``front``."""
    code = workspace.facts_at(file)
    if code is None:
        return None
    bound = {name for imported in everything_in(code.body, facts.ImportFrom) for _, name in imported.names}
    idle = sorted(bound - {*code.names})
    having = [name for name in idle if word.lower() in name.lower().split("_")]
    return having[0] if len(having) == 1 else None


def defined_beside(workspace: WorkspaceIndex, file: str, name: str) -> str:
    """The statement that imports a function or class from the only other module of the file's package that defines it;
    empty where none does, where several do, or where the module imports this very file."""
    package = workspace.package_of(file)
    if package is None or workspace.roles.is_test(file):
        return ""
    paths = {path: module for module, path in workspace.code.modules_of(package).items() if "." in module}
    mentioning = (path for path in workspace.code.files_that_mention(name) if path in paths and path != file)
    having = [path for path in mentioning if not workspace.roles.is_test(path) and _defines(workspace, path, name)]
    if len(having) != 1 or imports_file(workspace, having[0], file):
        return ""
    return f"from {paths[having[0]]} import {name}"


def _defines(workspace: WorkspaceIndex, path: str, name: str) -> bool:
    code = workspace.facts_at(path)
    body = () if code is None else code.body
    return any(isinstance(part, (facts.Class, facts.Function)) and part.name == name for part in body)


def imports_file(workspace: WorkspaceIndex, path: str, file: str) -> bool:
    """Whether one file imports another one, or something from it, in whichever line."""
    code = workspace.facts_at(path)
    for statement in () if code is None else everything_in(code.body):
        modules: list[str] = []
        level = 0
        match statement:
            case facts.Import(module=module):
                modules = [module]
            case facts.ImportFrom(module=module, names=names, level=level):
                modules = [module, *(f"{module}.{name}".lstrip(".") for name, _ in names)]
        if any(workspace.code.path_of_import(path, module, level) == file for module in modules):
            return True
    return False


@once
def _imports(workspace: WorkspaceIndex) -> dict[str, Counter[str]]:
    """By the name that it binds, how many files have each import statement."""
    counts: dict[str, Counter[str]] = defaultdict(Counter)
    for file, _ in workspace.code.asked_for():
        for name, statement in _statements(workspace, file.relative) or ():
            counts[name][statement] += 1
    return counts


@kept_for_each_file
def _statements(code: facts.Facts) -> frozenset[tuple[str, str]]:
    rows = set()
    for statement in everything_in(code.body, facts.Import):
        if statement.alias is not None:
            rows.add((statement.alias, f"import {statement.module} as {statement.alias}"))
        elif "." not in statement.module:
            rows.add((statement.module, f"import {statement.module}"))
    for imported in everything_in(code.body, facts.ImportFrom):
        for name, bound in imported.names if not imported.level else ():
            alias = "" if name == bound else f" as {bound}"
            rows.add((bound, f"from {imported.module} import {name}{alias}"))
    return frozenset(rows)


__all__ = ["defined_beside", "idle_import_with", "import_of", "imports_file", "interface_meant"]
