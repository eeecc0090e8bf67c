"""The launch descriptions that ``moveit_configs_utils.launches`` makes of a ``MoveItConfigs``: the launch files that
MoveIt's setup assistant writes call these functions and nothing else.

Source: ``launches.py`` of moveit_configs_utils of MoveIt 2 (branches jazzy and main).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    FALSE,
    NONE,
    TRUE,
    Builtin,
    External,
    Instance,
    Items,
    Known,
    Unknown,
    Value,
    reason,
)
from archlint.launch import file_texts, read_files
from archlint.launch.moveit_configs.actions import Actions
from archlint.launch.moveit_configs.builder import SEMANTIC_FILE, arguments, entry
from archlint.launch.moveit_configs.methods import CONFIGS, configs_to_dict
from archlint.launch.objects import LaunchObject, known_text
from archlint.launch.tables import LaunchClass
from archlint.syntax.srdf import virtual_joints

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

_MODULE = "moveit_configs_utils.launches"
_SIMPLE = "moveit_simple_controller_manager"


class _Description(Actions):
    """What a function of ``launches`` makes of a configuration."""

    def __init__(self, run: LaunchRun, configs: Instance, site: CallSite) -> None:
        super().__init__(run, site)
        self.configs = configs

    def part(self, name: str) -> Value:
        value = self.run.store.get(self.configs.key, name)
        return value if isinstance(value, Value) else Unknown("what a MoveItConfigs has")

    def path(self, below: str) -> Value:
        """A path below the package of the configuration."""
        package = self.part("package_path")
        text = known_text(package)
        return Unknown(reason(package)) if text is None else Known(f"{text}/{below}")

    def says(self, name: str) -> LaunchObject:
        """``LaunchConfiguration(name)``."""
        return self.configuration(Known(name))

    def boolean(self, name: str, default: bool = False) -> None:
        self.actions.append(self.boolean_argument(Known(name), Known(default)))

    def start(self, package: str, executable: str, **given: Value) -> None:
        self.node(Known(package), Known(executable), **given)

    def start_debuggable(self, package: str, executable: str, **given: Value) -> None:
        self.debuggable_node(Known(package), Known(executable), Known("debug"), **given)

    def include(self, path: Value, condition: Value | None = None) -> None:
        source = self.object(LaunchClass.PYTHON_LAUNCH_DESCRIPTION_SOURCE, {"launch_file_path": path})
        given: dict[str, Value] = {"launch_description_source": source}
        if condition is not None:
            given["condition"] = condition
        self.actions.append(self.object(LaunchClass.INCLUDE_LAUNCH_DESCRIPTION, given))


def _robot_state_publisher(description: _Description, site: CallSite) -> None:
    description.declare("publish_frequency", Known("15.0"))
    frequency = description.dict({"publish_frequency": description.says("publish_frequency")})
    parameters = description.list(description.part("robot_description"), frequency)
    description.start("robot_state_publisher", "robot_state_publisher", parameters=parameters)


def _rviz(description: _Description, site: CallSite) -> None:
    description.boolean("debug")
    description.declare("rviz_config", description.path("config/moveit.rviz"))
    parts = ("planning_pipelines", "robot_description_kinematics", "joint_limits")
    words = description.list(Known("-d"), description.says("rviz_config"))
    description.start_debuggable(
        "rviz2", "rviz2", arguments=words, parameters=description.list(*map(description.part, parts))
    )


def _setup_assistant(description: _Description, site: CallSite) -> None:
    description.boolean("debug")
    words = description.list(description.list(Known("--config_pkg="), description.part("package_path")))
    description.start_debuggable("moveit_setup_assistant", "moveit_setup_assistant", arguments=words)


def _virtual_joints(description: _Description, site: CallSite) -> None:
    path = description.run.store.get(description.configs.key, SEMANTIC_FILE)
    text = file_texts.text_of(description.run, path) if isinstance(path, Known) else path
    joints = virtual_joints(text) if isinstance(text, str) else None
    if joints is None:
        description.actions.append(Unknown("a static_transform_publisher for each virtual joint of an SRDF"))
    for number, joint in enumerate(joints or ()):
        words = ("--frame-id", joint.parent_frame, "--child-frame-id", joint.child_link)
        given = {
            "name": Known(f"static_transform_publisher{number}"),
            "arguments": description.list(*map(Known, words)),
        }
        description.start("tf2_ros", "static_transform_publisher", **given)


def _spawners(description: _Description, site: CallSite) -> None:
    names = entry(
        description.run, entry(description.run, description.part("trajectory_execution"), _SIMPLE), "controller_names"
    )
    items = Items(()) if names is None else names.items(description.run)
    if items is None or items.open:
        description.actions.append(Unknown("a spawner for each controller of a list that is not known"))
    for name in (*(() if items is None else items.values), Known("joint_state_broadcaster")):
        description.start("controller_manager", "spawner", arguments=description.list(name))


def _warehouse(description: _Description, site: CallSite) -> None:
    description.declare("moveit_warehouse_database_path", description.path("default_warehouse_mongo_db"))
    description.boolean("reset")
    description.declare("moveit_warehouse_port", Known("33829"))
    description.declare("moveit_warehouse_host", Known("localhost"))
    settings = {
        "overwrite": FALSE,
        "database_path": description.says("moveit_warehouse_database_path"),
        "warehouse_port": description.says("moveit_warehouse_port"),
        "warehouse_host": description.says("moveit_warehouse_host"),
        "warehouse_exec": Known("mongod"),
        "warehouse_plugin": Known("warehouse_ros_mongo::MongoDatabaseConnection"),
    }
    description.start(
        "warehouse_ros_mongo", "mongo_wrapper_ros.py", parameters=description.list(description.dict(settings))
    )
    description.start(
        "moveit_ros_warehouse", "moveit_init_demo_warehouse", condition=description.whether(Known("reset"))
    )


def _move_group(description: _Description, site: CallSite) -> None:
    description.boolean("debug")
    description.boolean("allow_trajectory_execution", True)
    description.boolean("publish_monitored_planning_scene", True)
    capabilities = description.part("move_group_capabilities")
    texts = {}
    for name in ("capabilities", "disable_capabilities"):
        description.declare(name, entry(description.run, capabilities, name) or Known(""))
        given = {"value": description.says(name), "value_type": Builtin("str")}
        texts[name] = description.object(LaunchClass.PARAMETER_VALUE, given)
    description.boolean("monitor_dynamics")
    publishes = ("planning_scene", "geometry_updates", "state_updates", "transforms_updates")
    settings = {
        "publish_robot_description_semantic": TRUE,
        "allow_trajectory_execution": description.says("allow_trajectory_execution"),
        **texts,
        **{f"publish_{name}": description.says("publish_monitored_planning_scene") for name in publishes},
        "monitor_dynamics": FALSE,
    }
    everything = configs_to_dict(description.run, description.configs, site)
    description.start_debuggable(
        "moveit_ros_move_group", "move_group", parameters=description.list(everything, description.dict(settings))
    )


def _demo(description: _Description, site: CallSite) -> None:
    """All of the above, included from the launch files of the package, or of another one that is given."""
    _, given = arguments(site, "moveit_config", "launch_package_path")
    package = description.part("package_path") if given is None or given == NONE else given
    text = known_text(package)

    def of_package(name: str) -> Value:
        return Unknown(reason(package)) if text is None else Known(f"{text}/launch/{name}.launch.py")

    for name in ("db", "debug"):
        description.boolean(name)
    description.boolean("use_rviz", True)
    joints = of_package("static_virtual_joint_tfs")
    if isinstance(joints, Known) and read_files.is_there(description.run, str(joints.value)):
        description.include(joints)
    description.include(of_package("rsp"))
    description.include(of_package("move_group"))
    description.include(of_package("moveit_rviz"), description.whether(Known("use_rviz")))
    database = of_package("warehouse_db")  # asked for with db:=true alone, and some packages have no such file
    if not isinstance(database, Known) or read_files.is_there(description.run, str(database.value)) is not False:
        description.include(database, description.whether(Known("db")))
    renamed = description.list(Known("/controller_manager/robot_description"), Known("/robot_description"))
    description.start(
        "controller_manager",
        "ros2_control_node",
        parameters=description.list(description.path("config/ros2_controllers.yaml")),
        remappings=description.list(renamed),
    )
    description.include(of_package("spawn_controllers"))


_MAKE: dict[str, Callable[[_Description, CallSite], None]] = {
    "generate_rsp_launch": _robot_state_publisher,
    "generate_moveit_rviz_launch": _rviz,
    "generate_setup_assistant_launch": _setup_assistant,
    "generate_static_virtual_joint_tfs_launch": _virtual_joints,
    "generate_spawn_controllers_launch": _spawners,
    "generate_warehouse_db_launch": _warehouse,
    "generate_move_group_launch": _move_group,
    "generate_demo_launch": _demo,
}


def _function(name: str) -> Callable[[LaunchRun, CallSite], Value]:
    def generate(run: LaunchRun, site: CallSite) -> Value:
        (configs,) = arguments(site, "moveit_config")
        if not isinstance(configs, Instance) or configs.cls != External(CONFIGS):
            return Unknown(f"the configuration that {name}() is given")
        description = _Description(run, configs, site)
        _MAKE[name](description, site)
        return description.description()

    return generate


PLAIN = {f"{_MODULE}.{name}": _function(name) for name in _MAKE}

__all__ = ["PLAIN"]
