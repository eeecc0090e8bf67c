"""The methods of ``MoveItConfigsBuilder`` and of what it makes, for code of launch files that calls them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    TRUE,
    DictValue,
    External,
    Instance,
    Known,
    Unknown,
    Value,
    reason,
)
from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

from archlint.launch.moveit_configs.builder import SEMANTIC_FILE, Builder, arguments, update
from archlint.launch.moveit_configs.collected import COLLECT

_BUILDER, CONFIGS = "MoveItConfigsBuilder", "moveit_configs_utils.MoveItConfigs"
_MODULES = ("moveit_configs_utils", "moveit_configs_utils.moveit_configs_builder")
_PARTS = (
    "robot_description",
    "robot_description_semantic",
    "robot_description_kinematics",
    "planning_pipelines",
    "trajectory_execution",
    "planning_scene_monitor",
    "sensors_3d",
    "joint_limits",
    "moveit_cpp",
    "pilz_cartesian_limits",
)
"""What is collected, in the order in which ``to_dict()`` joins it."""
_PILZ = "pilz_industrial_motion_planner"
Method = Callable[["LaunchRun", Value, "CallSite"], Value]


def _builder(run: LaunchRun, site: CallSite) -> Value:
    """``MoveItConfigsBuilder(…)``."""
    place = run.place(site.expression.span) if site.expression is not None and run.activations else None
    given = {str(number): value for number, value in enumerate(site.args)} | site.keywords
    path = f"{_MODULES[0]}.{_BUILDER}"
    instance = Instance(External(path), run.store.new_key(), place, given, path)
    Builder(run, instance).forget("parameters", *_PARTS)
    return instance


def _collects(name: str) -> Method:
    def method(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
        if isinstance(receiver, Instance):
            COLLECT[name](Builder(run, receiver), site)
        return receiver

    return method


def _to_configs(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``to_moveit_configs()``: what has not been asked for is collected with its defaults."""
    if not isinstance(receiver, Instance):
        return Unknown(reason(receiver))
    builder = Builder(run, receiver)
    for name in _PARTS:
        if builder.part(name) is None and (name not in ("moveit_cpp", "pilz_cartesian_limits") or _asks(builder, name)):
            COLLECT[name](builder, type(site)())
    configs = Instance(External(CONFIGS), run.store.new_key())
    for name in _PARTS:
        run.store.set(configs.key, name, builder.part(name) or builder.dict_of({}))
    empty: dict[str, Value] = {"capabilities": Known(""), "disable_capabilities": Known("")}
    run.store.set(configs.key, "move_group_capabilities", builder.dict_of(empty))
    file = run.store.get(builder.instance.key, SEMANTIC_FILE)
    run.store.set(configs.key, SEMANTIC_FILE, file or Unknown("which SRDF it is"))
    share = builder.share
    run.store.set(configs.key, "package_path", Unknown("a package") if share is None else Known(share, kind="path"))
    return configs


def _asks(builder: Builder, name: str) -> bool:
    """Whether the limits of the Pilz planner are collected, which only its pipeline needs."""
    pipelines = builder.part("planning_pipelines")
    keys = {} if pipelines is None else pipelines.entries(builder.run).entries
    return name == "pilz_cartesian_limits" and Known(_PILZ).entry_key() in keys


def configs_to_dict(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``MoveItConfigs.to_dict()``: all of it in one dict."""
    if not isinstance(receiver, Instance):
        return Unknown(reason(receiver))
    parts = {name: run.store.get(receiver.key, name) for name in _PARTS}
    merged = containers.dict_of_names(run, {})
    for part in list(parts.values())[:-1]:
        update(run, merged, part if isinstance(part, DictValue) else containers.dict_of_names(run, {}, True))
    limits = parts["pilz_cartesian_limits"]
    for key, value in run.entries(limits if isinstance(limits, DictValue) else None):
        row = merged.entries(run).entries.get(key.entry_key() or "")
        if row is not None and isinstance(row[1], DictValue) and isinstance(value, DictValue):
            update(run, row[1], value)
    return merged


def _builder_to_dict(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``to_dict()`` of a builder: its own parameters, and the rest of them."""
    if not isinstance(receiver, Instance):
        return Unknown(reason(receiver))
    builder = Builder(run, receiver)
    (wanted,) = arguments(site, "include_moveit_configs")
    merged = builder.dict_of({})
    own = builder.part("parameters")
    if own is not None:
        update(run, merged, own)
    if wanted is None or wanted == TRUE:
        configs = configs_to_dict(run, _to_configs(run, receiver, site), site)
        update(run, merged, configs if isinstance(configs, DictValue) else builder.open_dict())
    elif not isinstance(wanted, Known):
        update(run, merged, builder.open_dict())
    return merged


def _own(make: Callable[[Builder, Sequence[Value | None]], DictValue], *names: str) -> Method:
    """A method of ``ParameterBuilder`` that sets parameters of the user's."""

    def method(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
        if isinstance(receiver, Instance):
            builder = Builder(run, receiver)
            own = builder.part("parameters") or builder.dict_of({})
            update(run, own, make(builder, arguments(site, *names)))
            builder.keep("parameters", own)
        return receiver

    return method


def _of_file(builder: Builder, given: Sequence[Value | None]) -> DictValue:
    content = builder.yaml(builder.path(given[0], None))
    if given[1] in (None, NONE):
        return content
    name = known_text(given[1])
    return builder.open_dict() if name is None else builder.dict_of({name: content})


def _named(builder: Builder, given: Sequence[Value | None]) -> DictValue:
    name, value = known_text(given[0]), given[1]
    return builder.open_dict() if name is None or value is None else builder.dict_of({name: value})


def _document(builder: Builder, given: Sequence[Value | None]) -> DictValue:
    name = known_text(given[0])
    return builder.open_dict() if name is None else builder.dict_of({name: Unknown("the content of a file")})


def _path_in_package(builder: Builder, given: Sequence[Value | None]) -> DictValue:
    name, path = known_text(given[0]), builder.path(given[1], None)
    return builder.open_dict() if name is None or path is None else builder.dict_of({name: Known(path)})


_OF_BUILDER: dict[str, Method] = {
    **{name: _collects(name) for name in COLLECT},
    "yaml": _own(_of_file, "file_path", "parameter_namespace"),
    "parameter": _own(_named, "parameter_name", "parameter_value"),
    "file_parameter": _own(_document, "parameter_name", "file_path"),
    "xacro_parameter": _own(_document, "parameter_name", "file_path"),
    "path_parameter": _own(_path_in_package, "parameter_name", "file_path"),
    "to_moveit_configs": _to_configs,
    "to_dict": _builder_to_dict,
}

PLAIN = {f"{module}.{_BUILDER}": _builder for module in _MODULES}
METHODS: dict[str, Method] = {
    **{f"{module}.{_BUILDER}.{name}": act for module in _MODULES for name, act in _OF_BUILDER.items()},
    f"{CONFIGS}.to_dict": configs_to_dict,
}

__all__ = ["CONFIGS", "METHODS", "PLAIN", "configs_to_dict"]
