"""What each method of ``MoveItConfigsBuilder`` collects, by its name.

Source: ``moveit_configs_builder.py`` of MoveIt 2 (branches jazzy and main).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    NONE,
    TRUE,
    DictValue,
    Known,
    Unknown,
    Value,
)
from archlint.launch import read_files
from archlint.launch.moveit_configs.defaults import PIPELINES, PLANNER_CONFIGS, SINCE
from archlint.launch.objects import known_text

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

from archlint.launch.moveit_configs.builder import SEMANTIC_FILE, Builder, arguments, entry, update

FOLDER_ORDER = "the order in which a folder lists its files"
XACRO = "a document that xacro makes"

_CONTROLLERS = "_controllers.yaml"
_PLANNING = "_planning.yaml"
_MONITOR = {
    "publish_planning_scene": True,
    "publish_geometry_updates": True,
    "publish_state_updates": True,
    "publish_transforms_updates": True,
    "publish_robot_description": False,
    "publish_robot_description_semantic": False,
}


def _robot_description(builder: Builder, site: CallSite) -> None:
    (file,) = arguments(site, "file_path")
    path = builder.path(file, f"config/{builder.robot}.urdf.xacro")
    asked = builder.path(None, ".setup_assistant")
    plain = builder.path(None, f"config/{builder.robot}.urdf")
    named_elsewhere = file in (None, NONE) and (builder.is_there(asked) is not False or builder.is_there(plain))
    lost = builder.is_there(path) is False and not named_elsewhere
    builder.keep("robot_description", builder.dict_of({}) if lost else builder.prefixed("", Unknown(XACRO)))


def _semantic(builder: Builder, site: CallSite) -> None:
    (file,) = arguments(site, "file_path")
    path = builder.path(file, _named_semantic_file(builder))
    unknown = Unknown("which SRDF it is")
    builder.run.store.set(builder.instance.key, SEMANTIC_FILE, unknown if path is None else Known(path))
    builder.keep("robot_description_semantic", builder.prefixed("_semantic", Unknown(XACRO)))


def _named_semantic_file(builder: Builder) -> str | None:
    """The SRDF that ``.setup_assistant`` names, or else the usual one."""
    assistant = builder.path(None, ".setup_assistant")
    if builder.is_there(assistant) is False:
        return f"config/{builder.robot}.srdf"
    config = entry(builder.run, builder.yaml(assistant), "moveit_setup_assistant_config")
    named = entry(builder.run, config, "srdf") or entry(builder.run, config, "SRDF")
    path = entry(builder.run, named, "relative_path")
    return f"config/{builder.robot}.srdf" if path is None else known_text(path)


def _file_under(part: str, suffix: str, default: str) -> Callable[[Builder, CallSite], None]:
    """A method that puts the content of a file under one key."""

    def collect(builder: Builder, site: CallSite) -> None:
        (file,) = arguments(site, "file_path")
        builder.keep(part, builder.prefixed(suffix, builder.yaml(builder.path(file, default))))

    return collect


def _moveit_cpp(builder: Builder, site: CallSite) -> None:
    (file,) = arguments(site, "file_path")
    builder.keep("moveit_cpp", builder.yaml(builder.path(file, "config/moveit_cpp.yaml")))


def _trajectory_execution(builder: Builder, site: CallSite) -> None:
    file, manage = arguments(site, "file_path", "moveit_manage_controllers")
    execution = builder.dict_of({"moveit_manage_controllers": TRUE if manage is None else manage})
    path = builder.path(file, None)
    if file in (None, NONE):
        name = _controllers(builder)
        path = builder.path(None, f"config/{name}{_CONTROLLERS}") if name else None
        if name == "":
            builder.keep("trajectory_execution", execution)
            return
    update(builder.run, execution, builder.yaml(path))
    builder.keep("trajectory_execution", execution)


def _controllers(builder: Builder) -> str | None:
    """Which controllers' file is meant: one that has no rival, or the usual name; empty without any."""
    names = builder.names(_CONTROLLERS)
    if names is None:
        return None
    usual = [name for name in ("moveit", "moveit2", builder.robot) if name in names]
    return "" if not names else names[0] if len(names) == 1 else next(iter(usual), None)


def _planning_scene_monitor(builder: Builder, site: CallSite) -> None:
    rows = zip(_MONITOR.items(), arguments(site, *_MONITOR), strict=True)
    values = {name: Known(default) if value is None else value for (name, default), value in rows}
    builder.keep("planning_scene_monitor", builder.dict_of(values))


def _sensors(builder: Builder, site: CallSite) -> None:
    (file,) = arguments(site, "file_path")
    path = builder.path(file, "config/sensors_3d.yaml")
    if builder.is_there(path) is False:
        builder.keep("sensors_3d", builder.dict_of({}))
        return
    content = builder.yaml(path)
    row = content.entries(builder.run).entries.get(Known("sensors").entry_key() or "")
    sensors = [] if row is None else builder.run.items(row[1])
    if row is not None and (not sensors or sensors[0] in (Known(""), NONE)):
        content = builder.dict_of({})
    builder.keep("sensors_3d", content)


def _planning_pipelines(builder: Builder, site: CallSite) -> None:
    default, pipelines, load_all = arguments(site, "default_planning_pipeline", "pipelines", "load_all")
    given = pipelines not in (None, NONE)
    names = _texts(builder.run, pipelines) if given else _in_files(builder, load_all)
    if names is None:
        builder.keep("planning_pipelines", builder.open_dict())
        return
    order = pipelines if given and pipelines is not None else Unknown(FOLDER_ORDER)
    if not given and len(names) == 1:
        order = containers.new_list(builder.run, [Known(name) for name in names])
    first = Known("ompl" if "ompl" in names else names[0]) if given or "ompl" in names else Unknown(FOLDER_ORDER)
    chosen = first if default in (None, NONE) or default is None else default
    values: dict[str, Value] = {"planning_pipelines": order, "default_planning_pipeline": chosen}
    values |= {name: _pipeline(builder, name) for name in names}
    builder.keep("planning_pipelines", builder.dict_of(values))


def _in_files(builder: Builder, load_all: Value | None) -> list[str] | None:
    """The pipelines that the package has files for, and those of moveit_configs_utils."""
    names, everything = builder.names(_PLANNING), TRUE if load_all is None else load_all
    if names is None or not isinstance(everything, Known):
        return None
    return sorted({*names, *PIPELINES}) if everything.value else names or None


def _texts(run: LaunchRun, value: Value | None) -> list[str] | None:
    if value is None or not run.is_closed(value):
        return None
    texts = [known_text(item) for item in run.items(value)]
    known = [text for text in texts if text is not None]
    return known if known and len(known) == len(texts) else None


def _pipeline(builder: Builder, name: str) -> DictValue:
    """The parameters of one pipeline: those of the package, or else of moveit_configs_utils."""
    path = builder.path(None, f"config/{name}{_PLANNING}")
    there, known = builder.is_there(path), builder.run.distro in SINCE
    if there is False and known and name in PIPELINES:
        settings = read_files.value_of(builder.run, PIPELINES[name])
    else:
        settings = builder.yaml(path)
    assert isinstance(settings, DictValue)
    entries = settings.entries(builder.run)
    if name == "ompl" and not entries.open and Known("planner_configs").entry_key() not in entries.entries:
        configs = read_files.value_of(builder.run, PLANNER_CONFIGS) if known else builder.open_dict()
        assert isinstance(configs, DictValue)
        update(builder.run, settings, configs)
    return settings


COLLECT: dict[str, Callable[[Builder, CallSite], None]] = {
    "robot_description": _robot_description,
    "robot_description_semantic": _semantic,
    "robot_description_kinematics": _file_under(
        "robot_description_kinematics", "_kinematics", "config/kinematics.yaml"
    ),
    "planning_pipelines": _planning_pipelines,
    "trajectory_execution": _trajectory_execution,
    "planning_scene_monitor": _planning_scene_monitor,
    "sensors_3d": _sensors,
    "joint_limits": _file_under("joint_limits", "_planning", "config/joint_limits.yaml"),
    "moveit_cpp": _moveit_cpp,
    "pilz_cartesian_limits": _file_under("pilz_cartesian_limits", "_planning", "config/pilz_cartesian_limits.yaml"),
}


__all__ = ["COLLECT", "FOLDER_ORDER", "XACRO"]
