"""The launch descriptions that ``moveit_configs_utils.launches`` makes of a ``MoveItConfigs``: the launch files that
MoveIt's setup assistant writes call these functions and nothing else.

Source: ``launches.py`` and ``launch_utils.py`` of moveit_configs_utils of MoveIt 2 (branches jazzy and main).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING

from archlint.interpreter import containers
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
from archlint.launch import read_files
from archlint.launch.moveit_configs.builder import arguments
from archlint.launch.moveit_configs.methods import CONFIGS, configs_to_dict
from archlint.launch.objects import ENTITIES, LaunchObject, known_text, launch_object
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

_MODULE = "moveit_configs_utils.launches"
_SIMPLE = "moveit_simple_controller_manager"


class _Description:
    """A launch description that grows: all in it stands where the launch file calls for it."""

    def __init__(self, run: LaunchRun, configs: Instance, site: CallSite) -> None:
        self.run, self.configs = run, configs
        self.place = run.place(site.expression.span) if site.expression is not None and run.activations else None
        self.actions: list[Value] = []

    def made(self) -> LaunchObject:
        description = self.object(LaunchClass.LAUNCH_DESCRIPTION, {})
        self.run.store.set(description.key, ENTITIES, Items(tuple(self.actions)))
        return description

    # ------------------------------------------------------------------------------------------- values

    def object(self, kind: LaunchClass, given: dict[str, Value]) -> LaunchObject:
        arms = frozenset(self.run.branch_arms)
        return launch_object(self.run.store.new_key(), kind, self.place, given, branch_arms=arms)

    def part(self, name: str) -> Value:
        value = self.run.store.get(self.configs.key, name)
        return value if isinstance(value, Value) else Unknown("what a MoveItConfigs has")

    def path(self, below: str) -> Value:
        """A path below the package of the configuration."""
        package = self.part("package_path")
        text = known_text(package)
        return Unknown(reason(package)) if text is None else Known(f"{text}/{below}")

    def configuration(self, name: str) -> LaunchObject:
        return self.object(LaunchClass.LAUNCH_CONFIGURATION, {"variable_name": Known(name)})

    def list(self, *values: Value) -> Value:
        return containers.new_list(self.run, list(values))

    def dict(self, values: Mapping[str, Value]) -> Value:
        return containers.dict_of_names(self.run, values)

    def whether(self, name: str, kind: LaunchClass = LaunchClass.IF_CONDITION) -> LaunchObject:
        return self.object(kind, {"predicate_expression": self.configuration(name)})

    # ------------------------------------------------------------------------------------------ actions

    def declare(self, name: str, default: Value) -> None:
        given = {"name": Known(name), "default_value": default}
        self.actions.append(self.object(LaunchClass.DECLARE_LAUNCH_ARGUMENT, given))

    def declare_boolean(self, name: str, default: bool = False) -> None:
        given: dict[str, Value] = {"name": Known(name), "default_value": Known(str(default))}
        given["choices"] = self.list(*(Known(text) for text in ("true", "false", "True", "False")))
        self.actions.append(self.object(LaunchClass.DECLARE_LAUNCH_ARGUMENT, given))

    def node(self, package: str, executable: str, **given: Value) -> None:
        names: dict[str, Value] = {"package": Known(package), "executable": Known(executable)}
        self.actions.append(self.object(LaunchClass.NODE, {**names, **given}))

    def debuggable_node(self, package: str, executable: str, **given: Value) -> None:
        """One node, and the same under gdb: ``debug`` says which of the two is started."""
        for kind in (LaunchClass.UNLESS_CONDITION, LaunchClass.IF_CONDITION):
            self.node(package, executable, condition=self.whether("debug", kind), **given)

    def include(self, path: Value, condition: Value | None = None) -> None:
        source = self.object(LaunchClass.PYTHON_LAUNCH_DESCRIPTION_SOURCE, {"launch_file_path": path})
        given: dict[str, Value] = {"launch_description_source": source}
        if condition is not None:
            given["condition"] = condition
        self.actions.append(self.object(LaunchClass.INCLUDE_LAUNCH_DESCRIPTION, given))


def _robot_state_publisher(made: _Description, site: CallSite) -> None:
    made.declare("publish_frequency", Known("15.0"))
    frequency = made.dict({"publish_frequency": made.configuration("publish_frequency")})
    parameters = made.list(made.part("robot_description"), frequency)
    made.node("robot_state_publisher", "robot_state_publisher", parameters=parameters)


def _rviz(made: _Description, site: CallSite) -> None:
    made.declare_boolean("debug")
    made.declare("rviz_config", made.path("config/moveit.rviz"))
    parts = ("planning_pipelines", "robot_description_kinematics", "joint_limits")
    words = made.list(Known("-d"), made.configuration("rviz_config"))
    made.debuggable_node("rviz2", "rviz2", arguments=words, parameters=made.list(*map(made.part, parts)))


def _setup_assistant(made: _Description, site: CallSite) -> None:
    made.declare_boolean("debug")
    words = made.list(made.list(Known("--config_pkg="), made.part("package_path")))
    made.debuggable_node("moveit_setup_assistant", "moveit_setup_assistant", arguments=words)


def _virtual_joints(made: _Description, site: CallSite) -> None:
    made.actions.append(Unknown("a static_transform_publisher for each virtual joint of an SRDF that xacro makes"))


def _spawners(made: _Description, site: CallSite) -> None:
    names = _entry(made.run, _entry(made.run, made.part("trajectory_execution"), _SIMPLE), "controller_names")
    items = Items(()) if names is None else names.items(made.run)
    if items is None or items.open:
        made.actions.append(Unknown("a spawner for each controller of a list that is not known"))
    for name in (*(() if items is None else items.values), Known("joint_state_broadcaster")):
        made.node("controller_manager", "spawner", arguments=made.list(name))


def _entry(run: LaunchRun, value: Value | None, name: str) -> Value | None:
    """``value.get(name)``: None where there is none, an unknown value where that is not known."""
    entries = None if value is None else value.entries(run)
    if entries is None:
        return None if value is None else Unknown(reason(value))
    row = entries.entries.get(Known(name).entry_key() or "")
    return row[1] if row is not None else Unknown("a dict that is only partly known") if entries.open else None


def _warehouse(made: _Description, site: CallSite) -> None:
    made.declare("moveit_warehouse_database_path", made.path("default_warehouse_mongo_db"))
    made.declare_boolean("reset")
    made.declare("moveit_warehouse_port", Known("33829"))
    made.declare("moveit_warehouse_host", Known("localhost"))
    settings = {
        "overwrite": FALSE,
        "database_path": made.configuration("moveit_warehouse_database_path"),
        "warehouse_port": made.configuration("moveit_warehouse_port"),
        "warehouse_host": made.configuration("moveit_warehouse_host"),
        "warehouse_exec": Known("mongod"),
        "warehouse_plugin": Known("warehouse_ros_mongo::MongoDatabaseConnection"),
    }
    made.node("warehouse_ros_mongo", "mongo_wrapper_ros.py", parameters=made.list(made.dict(settings)))
    made.node("moveit_ros_warehouse", "moveit_init_demo_warehouse", condition=made.whether("reset"))


def _move_group(made: _Description, site: CallSite) -> None:
    made.declare_boolean("debug")
    made.declare_boolean("allow_trajectory_execution", True)
    made.declare_boolean("publish_monitored_planning_scene", True)
    capabilities = made.part("move_group_capabilities")
    texts = {}
    for name in ("capabilities", "disable_capabilities"):
        made.declare(name, _entry(made.run, capabilities, name) or Known(""))
        given = {"value": made.configuration(name), "value_type": Builtin("str")}
        texts[name] = made.object(LaunchClass.PARAMETER_VALUE, given)
    made.declare_boolean("monitor_dynamics")
    publishes = ("planning_scene", "geometry_updates", "state_updates", "transforms_updates")
    settings = {
        "publish_robot_description_semantic": TRUE,
        "allow_trajectory_execution": made.configuration("allow_trajectory_execution"),
        **texts,
        **{f"publish_{name}": made.configuration("publish_monitored_planning_scene") for name in publishes},
        "monitor_dynamics": FALSE,
    }
    everything = configs_to_dict(made.run, made.configs, site)
    made.debuggable_node("moveit_ros_move_group", "move_group", parameters=made.list(everything, made.dict(settings)))


def _demo(made: _Description, site: CallSite) -> None:
    """All of the above, included from the launch files of the package, or of another one that is given."""
    _, given = arguments(site, "moveit_config", "launch_package_path")
    package = made.part("package_path") if given is None or given == NONE else given
    text = known_text(package)

    def of_package(name: str) -> Value:
        return Unknown(reason(package)) if text is None else Known(f"{text}/launch/{name}.launch.py")

    for name in ("db", "debug"):
        made.declare_boolean(name)
    made.declare_boolean("use_rviz", True)
    joints = of_package("static_virtual_joint_tfs")
    if isinstance(joints, Known) and read_files.is_there(made.run, str(joints.value)):
        made.include(joints)
    made.include(of_package("rsp"))
    made.include(of_package("move_group"))
    made.include(of_package("moveit_rviz"), made.whether("use_rviz"))
    made.include(of_package("warehouse_db"), made.whether("db"))
    description = made.list(Known("/controller_manager/robot_description"), Known("/robot_description"))
    made.node(
        "controller_manager",
        "ros2_control_node",
        parameters=made.list(made.path("config/ros2_controllers.yaml")),
        remappings=made.list(description),
    )
    made.include(of_package("spawn_controllers"))


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
        made = _Description(run, configs, site)
        _MAKE[name](made, site)
        return made.made()

    return generate


PLAIN = {f"{_MODULE}.{name}": _function(name) for name in _MAKE}

__all__ = ["PLAIN"]
