"""Python files that a launch file loads by their path: helpers beside it, which no import names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import NONE, External, Instance, ModuleValue, Unknown, Value
from archlint.launch.files import GENERATE
from archlint.launch.kinds import FileKind
from archlint.launch.objects import argument

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

    Plain = Callable[[LaunchRun, CallSite], Value]

SPEC = "importlib.machinery.ModuleSpec"
LOADER = "importlib.machinery.SourceFileLoader"
_NOT_FOLLOWED = Unknown("the result of a file that is not followed")


def _module_at(run: LaunchRun, path: Value) -> ModuleValue | None:
    """The module that a file of this workspace is, once it has run."""
    source = run.resolve(FileKind.LAUNCH, run.perform(path), run.place_now).source
    file = None if source is None else run.files.source_file(source)
    module = None if file is None else run.index.module(file)
    return None if module is None or module.state == "running" else run.import_module(module)


def _run_path(run: LaunchRun, site: CallSite) -> Value:
    """``runpy.run_path(path)``: the variables of a file."""
    if len(site.args) != 1 or site.keywords:
        return Unknown("the result of a file that is run with given variables")
    module = _module_at(run, site.args[0])
    if module is None or module.module.scope is None:
        return _NOT_FOLLOWED
    variables = dict(run.store.variables(module.module.scope.key))
    return containers.dict_of_names(run, variables, open_=bool(module.module.star_externals))


def _loaded(run: LaunchRun, site: CallSite) -> Value:
    """``load_python_launch_file_as_module(path)`` of launch."""
    return (_module_at(run, site.values[0]) if site.values else None) or _NOT_FOLLOWED


def _description(run: LaunchRun, site: CallSite) -> Value:
    """``get_launch_description_from_python_launch_file(path)``: what the function of that file returns."""
    module = _module_at(run, site.values[0]) if site.values else None
    function = None if module is None else run.module_attribute(module.module, GENERATE)
    return _NOT_FOLLOWED if function is None else run.call(function)


def _named_file(path: str) -> Plain:
    """``spec_from_file_location(name, path)`` and ``SourceFileLoader(name, path)``."""

    def make(run: LaunchRun, site: CallSite) -> Value:
        named = site.keywords.get("location") or site.keywords.get("path")
        given = named or (site.args[1] if len(site.args) > 1 else Unknown("no path is given"))
        return Instance(External(path), run.store.new_key(), None, {"path": given})

    return make


def _of_spec(run: LaunchRun, site: CallSite) -> Value:
    """``module_from_spec(spec)``: what its loader then runs."""
    path = argument(site.args[0], "path") if site.args else None
    return (None if path is None else _module_at(run, path)) or _NOT_FOLLOWED


def _of_loader(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``loader.load_module()``."""
    path = argument(receiver, "path")
    return (None if path is None else _module_at(run, path)) or _NOT_FOLLOWED


def _ran(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``spec.loader.exec_module(module)``: it has run already."""
    return NONE


def loader_of(run: LaunchRun, spec: Instance) -> Instance:
    """``spec.loader``."""
    return Instance(External(LOADER), run.store.new_key(), None, dict(spec.arguments))


_UTILITIES = "launch.launch_description_sources"
PLAIN = {
    "runpy.run_path": _run_path,
    f"{_UTILITIES}.load_python_launch_file_as_module": _loaded,
    f"{_UTILITIES}.python_launch_file_utilities.load_python_launch_file_as_module": _loaded,
    f"{_UTILITIES}.get_launch_description_from_python_launch_file": _description,
    f"{_UTILITIES}.python_launch_file_utilities.get_launch_description_from_python_launch_file": _description,
    "importlib.util.spec_from_file_location": _named_file(SPEC),
    LOADER: _named_file(LOADER),
    "importlib.util.module_from_spec": _of_spec,
}
METHODS = {f"{LOADER}.exec_module": _ran, f"{LOADER}.load_module": _of_loader}

__all__ = ["METHODS", "PLAIN", "SPEC", "loader_of"]
