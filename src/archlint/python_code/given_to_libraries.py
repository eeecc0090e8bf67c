"""Classes whose objects hand themselves to a library: it may give them attributes and methods.

So does ``Machine(model=self, …)`` of transitions, which gives its model a ``state`` and a method for each trigger.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept, kept_for_each_file
from archlint.analysis.own_names import is_defined_somewhere
from archlint.python_code.class_chains import (
    Chain,
    ClassInFile,
    chain_of,
    classes_of,
    kept_for_each_class,
    methods_of,
)
from archlint.ros import packages
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import System, WorkspaceIndex

_LIBRARIES_OF_ROS = frozenset({"launch", "launch_ros", "message_filters", "rclpy", "tf2_geometry_msgs", "tf2_ros"})
"""Modules whose tables say what they do with what they are given."""
_CALCULATE = frozenset(
    {"PIL", "cv2", "numpy", "pandas", "scipy", "shapely", "skimage", "sklearn", "transforms3d", "yaml"}
)
"""Libraries whose functions only calculate with what they are given."""


def gives_itself_to_library(workspace: WorkspaceIndex, chain: Chain) -> bool:
    """Whether a method of a class, or of one that it derives from, hands the object to a library that is neither
    Python's nor of ROS, itself or by a function of the workspace that is given it."""
    return any(_gives(workspace, cls) for cls in chain.own)


def may_have(system: System, place: Place, name: str, *, of_library: bool) -> bool:
    """Whether something of the workspace gives an object at a place a method of a name, or a library may."""
    if system.workspace is None or is_defined_somewhere(system, place.file, name):
        return True
    return of_library and may_get_more(system.workspace, place)


def may_get_more(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether the object that code at a place is about may have been given methods by a library: the one of the class
    around it or, outside of all classes, one of any class of the file."""
    file_facts = workspace.facts_at(place.file)
    every = [ClassInFile(place.file, code) for code in classes_of(file_facts)] if file_facts is not None else []
    around = [cls for cls in every if cls.code.span[:2] <= place.span[:2] and place.span[2:] <= cls.code.span[2:]]
    return any(gives_itself_to_library(workspace, chain_of(workspace, cls)) for cls in around or every)


@kept_for_each_class
def _hands_itself_on(code: facts.Class) -> bool:
    """Whether a method of a class gives the object to any call at all: most do not."""
    return any(
        argument.value.variable == name
        for name, method in _methods_with_object(code)
        for call in everything_in(method.body, facts.Call)
        for argument in call.args
    )


def _gives(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    return _hands_itself_on(workspace, cls) and kept(
        workspace, (_gives, Itself(cls.code)), lambda: _gives_by_methods(workspace, cls)
    )


def _gives_by_methods(workspace: WorkspaceIndex, cls: ClassInFile) -> bool:
    return any(
        _hands_on(workspace, cls.file, name, method, cls.code) for name, method in _methods_with_object(cls.code)
    )


def _methods_with_object(code: facts.Class) -> Iterator[tuple[str, facts.Function]]:
    """The methods that are given the object, or its class, with the name that they have for it."""
    for method in methods_of(code):
        if method.params and not any(decorator.last_name == "staticmethod" for decorator in method.decorators):
            yield method.params[0].name, method


def _hands_on(
    workspace: WorkspaceIndex,
    file: str,
    name: str,
    function: facts.Function,
    cls: facts.Class | None = None,
    *,
    further: bool = True,
) -> bool:
    """Whether a function gives what it has in a variable to a library, or to a function that does."""
    for call in everything_in(function.body, facts.Call):
        given = [number for number, argument in enumerate(call.args) if argument.value.variable == name]
        if not given:
            continue
        if _is_of_library(workspace, file, call.func.dotted, function, cls):
            return True
        for path, called, first in _called(workspace, file, call.func.variable) if further else ():
            keywords = {keyword for number in given if (keyword := call.args[number].keyword)}
            params = [param.name for param in called.params]
            by_position = {params[first + number] for number in given if first + number < len(params)}
            for param in keywords & {*params} or by_position:
                if _hands_on(workspace, path, param, called, further=False):
                    return True
    return False


def _called(workspace: WorkspaceIndex, file: str, name: str | None) -> Iterator[tuple[str, facts.Function, int]]:
    """The functions of the workspace that a name may mean in a file, with the file of each and its first parameter
    that is given: those of the name, and the constructors of classes of it."""
    file_facts = workspace.facts_at(file)
    if file_facts is None or not name:
        return
    own, path = name, file
    for statement in everything_in(file_facts.body, facts.ImportFrom):
        source = next((taken for taken, bound in statement.names if bound == name), None)
        if source is not None:
            own, path = source, workspace.code.path_of_import(file, statement.module, statement.level) or ""
    there = workspace.facts_at(path) if path else None
    for definition in there.body if there is not None else ():
        match definition:
            case facts.Function(name=defined) if defined == own:
                yield path, definition, 0
            case facts.Class(name=defined) if defined == own:
                yield from ((path, method, 1) for method in methods_of(definition) if method.name == "__init__")


def _is_of_library(
    workspace: WorkspaceIndex, file: str, called: str, function: facts.Function, cls: facts.Class | None
) -> bool:
    """Whether a dotted name is that of a function or class of a library, or of a method of an object that one has
    made."""
    modules = _imported(workspace, file) or {}
    head, _, rest = called.partition(".")
    if head in modules:
        return _is_library(workspace, file, modules[head])
    owner = called.rpartition(".")[0] if rest else ""
    bodies = [function.body, *([] if cls is None else [cls.body])]
    makers = {
        assign.value.func.dotted.partition(".")[0]
        for body in bodies
        for assign in everything_in(body, facts.Assign)
        if isinstance(assign.value, facts.Call) and any(target.dotted == owner != "" for target in assign.targets)
    }
    return any(maker in modules and _is_library(workspace, file, modules[maker]) for maker in makers)


@kept_for_each_file
def _imported(file_facts: facts.Facts) -> dict[str, str]:
    """The modules that the names which a file imports are of."""
    modules: dict[str, str] = {}
    for statement in everything_in(file_facts.body):
        match statement:
            case facts.Import(module=module, alias=alias):
                modules[alias or module.partition(".")[0]] = module
            case facts.ImportFrom(module=module, level=0, names=names):
                modules.update(dict.fromkeys((bound for _, bound in names), module))
    return modules


def _is_library(workspace: WorkspaceIndex, file: str, module: str) -> bool:
    top = module.partition(".")[0]
    if top in sys.stdlib_module_names or top in _LIBRARIES_OF_ROS | _CALCULATE or top in packages.table().names:
        return False
    return top not in workspace.code.top_modules and workspace.code.path_of_import(file, top) is None


__all__ = ["gives_itself_to_library", "may_get_more", "may_have"]
