"""What launch, launch_ros and nav2_common offer: one row a class, with the parameters its constructor takes.

Signatures are those of launch and launch_ros, humble to rolling.  Each class is known by one name wherever it is
imported from; its objects are instances of ``launch.<Name>``.
"""

from __future__ import annotations

from functools import lru_cache

from archlint.libraries.tables import Api
from archlint.libraries.tables.api import EffectName
from archlint.string_enum import StringEnum

_PROCESS = (
    "prefix cwd env additional_env output output_format respawn respawn_delay respawn_max_retries shell "
    "emulate_tty sigterm_timeout sigkill_timeout on_exit log_cmd cached_output condition "
    "additional_env_file signal_lifecycle"
)
_NODE = "executable package name namespace exec_name parameters remappings ros_arguments arguments " + _PROCESS


class LaunchClass(StringEnum):
    """A class of launch, launch_ros or nav2_common: its name, and the parameters of its constructor."""

    signature: str

    def __new__(cls, name: str, signature: str) -> LaunchClass:
        member = str.__new__(cls, name)
        member._value_, member.signature = name, signature
        return member

    LAUNCH_DESCRIPTION = "LaunchDescription", "initial_entities * deprecated_reason"
    # ---- actions
    NODE = "Node", f"* {_NODE}"
    LIFECYCLE_NODE = "LifecycleNode", f"* {_NODE} autostart"
    COMPOSABLE_NODE_CONTAINER = "ComposableNodeContainer", f"* composable_node_descriptions {_NODE}"
    LOAD_COMPOSABLE_NODES = "LoadComposableNodes", "* composable_node_descriptions target_container condition"
    PUSH_ROS_NAMESPACE = "PushRosNamespace", "namespace * condition"
    SET_REMAP = "SetRemap", "src dst * condition"
    SET_PARAMETER = "SetParameter", "name value * condition"
    SET_PARAMETERS_FROM_FILE = "SetParametersFromFile", "filename * node_name condition"
    SET_USE_SIM_TIME = "SetUseSimTime", "value * condition"
    SET_ROS_LOG_DIR = "SetROSLogDir", "new_log_dir * condition"
    ROS_TIMER = "RosTimer", "* period actions cancel_on_shutdown condition"
    LIFECYCLE_TRANSITION = "LifecycleTransition", "* lifecycle_node_names transition_ids condition"
    INCLUDE_LAUNCH_DESCRIPTION = "IncludeLaunchDescription", "launch_description_source * launch_arguments condition"
    GROUP_ACTION = "GroupAction", "actions * scoped forwarding launch_configurations condition"
    DECLARE_LAUNCH_ARGUMENT = "DeclareLaunchArgument", "name * default_value description choices condition"
    DECLARE_BOOLEAN_LAUNCH_ARGUMENT = "DeclareBooleanLaunchArgument", "name * default_value description condition"
    SET_LAUNCH_CONFIGURATION = "SetLaunchConfiguration", "name value * condition"
    UNSET_LAUNCH_CONFIGURATION = "UnsetLaunchConfiguration", "name * condition"
    PUSH_LAUNCH_CONFIGURATIONS = "PushLaunchConfigurations", "* condition"
    POP_LAUNCH_CONFIGURATIONS = "PopLaunchConfigurations", "* condition"
    RESET_LAUNCH_CONFIGURATIONS = "ResetLaunchConfigurations", "launch_configurations * condition"
    SET_ENVIRONMENT_VARIABLE = "SetEnvironmentVariable", "name value * condition"
    APPEND_ENVIRONMENT_VARIABLE = "AppendEnvironmentVariable", "name value * prepend separator condition"
    UNSET_ENVIRONMENT_VARIABLE = "UnsetEnvironmentVariable", "name * condition"
    PUSH_ENVIRONMENT = "PushEnvironment", "* condition"
    POP_ENVIRONMENT = "PopEnvironment", "* condition"
    OPAQUE_FUNCTION = "OpaqueFunction", "* function args kwargs condition"
    OPAQUE_COROUTINE = "OpaqueCoroutine", "* coroutine args kwargs ignore_context condition"
    TIMER_ACTION = "TimerAction", "* period actions cancel_on_shutdown condition"
    EXECUTE_PROCESS = "ExecuteProcess", f"* cmd name {_PROCESS}"
    EXECUTE_LOCAL = "ExecuteLocal", f"* process_description {_PROCESS}"
    REGISTER_EVENT_HANDLER = "RegisterEventHandler", "event_handler * condition"
    UNREGISTER_EVENT_HANDLER = "UnregisterEventHandler", "event_handler * condition"
    EMIT_EVENT = "EmitEvent", "* event condition"
    LOG_INFO = "LogInfo", "* msg condition"
    SHUTDOWN = "Shutdown", "* reason condition"
    FOR_EACH = "ForEach", "input_values * function condition"
    FOR_LOOP = "ForLoop", "* function length condition"
    # ---- event handlers
    EVENT_HANDLER = "EventHandler", "* matcher entities handle_once"
    ON_PROCESS_EXIT = "OnProcessExit", "* target_action on_exit handle_once"
    ON_PROCESS_START = "OnProcessStart", "* target_action on_start handle_once"
    ON_PROCESS_IO = "OnProcessIO", "* target_action on_stdout on_stderr on_stdin"
    ON_EXECUTION_COMPLETE = "OnExecutionComplete", "* target_action on_completion handle_once"
    ON_SHUTDOWN = "OnShutdown", "* on_shutdown handle_once"
    ON_STATE_TRANSITION = (
        "OnStateTransition",
        "* target_lifecycle_node transition start_state goal_state entities matcher handle_once",
    )
    # ---- descriptions
    COMPOSABLE_NODE = (
        "ComposableNode",
        "* package plugin name namespace parameters remappings extra_arguments condition",
    )
    COMPOSABLE_LIFECYCLE_NODE = (
        "ComposableLifecycleNode",
        "* package plugin name namespace parameters remappings extra_arguments condition autostart",
    )
    PARAMETER_FILE = "ParameterFile", "param_file * allow_substs"
    PARAMETER_VALUE = "ParameterValue", "value * value_type"
    PARAMETER = "Parameter", "name value * value_type"
    # ---- launch description sources
    PYTHON_LAUNCH_DESCRIPTION_SOURCE = "PythonLaunchDescriptionSource", "launch_file_path"
    XML_LAUNCH_DESCRIPTION_SOURCE = "XMLLaunchDescriptionSource", "launch_file_path"
    YAML_LAUNCH_DESCRIPTION_SOURCE = "YAMLLaunchDescriptionSource", "launch_file_path"
    FRONTEND_LAUNCH_DESCRIPTION_SOURCE = "FrontendLaunchDescriptionSource", "launch_file_path * parser"
    ANY_LAUNCH_DESCRIPTION_SOURCE = "AnyLaunchDescriptionSource", "launch_file_path"
    LAUNCH_DESCRIPTION_SOURCE = "LaunchDescriptionSource", "launch_description location method"
    # ---- conditions
    CONDITION = "Condition", "* predicate"
    IF_CONDITION = "IfCondition", "predicate_expression"
    UNLESS_CONDITION = "UnlessCondition", "predicate_expression"
    LAUNCH_CONFIGURATION_EQUALS = "LaunchConfigurationEquals", "launch_configuration_name expected_value"
    LAUNCH_CONFIGURATION_NOT_EQUALS = "LaunchConfigurationNotEquals", "launch_configuration_name expected_value"
    # ---- substitutions
    SUBSTITUTION = "Substitution", ""
    LAUNCH_CONFIGURATION = "LaunchConfiguration", "variable_name * default"
    PATH_JOIN_SUBSTITUTION = "PathJoinSubstitution", "substitutions"
    STRING_JOIN_SUBSTITUTION = "StringJoinSubstitution", "substitutions * delimiter"
    TEXT_SUBSTITUTION = "TextSubstitution", "* text"
    PYTHON_EXPRESSION = "PythonExpression", "expression python_modules"
    ENVIRONMENT_VARIABLE = "EnvironmentVariable", "name * default_value"
    COMMAND = "Command", "command * on_stderr"
    FIND_EXECUTABLE = "FindExecutable", "* name"
    FIND_PACKAGE_SHARE = "FindPackageShare", "package"
    FIND_PACKAGE_PREFIX = "FindPackagePrefix", "package"
    EXECUTABLE_IN_PACKAGE = "ExecutableInPackage", "executable package"
    THIS_LAUNCH_FILE = "ThisLaunchFile", ""
    THIS_LAUNCH_FILE_DIR = "ThisLaunchFileDir", ""
    ANON_NAME = "AnonName", "name"
    LOCAL_SUBSTITUTION = "LocalSubstitution", "expression * description"
    FILE_CONTENT = "FileContent", "path"
    NOT_SUBSTITUTION = "NotSubstitution", "value"
    AND_SUBSTITUTION = "AndSubstitution", "left right"
    OR_SUBSTITUTION = "OrSubstitution", "left right"
    ANY_SUBSTITUTION = "AnySubstitution", ""
    ALL_SUBSTITUTION = "AllSubstitution", ""
    EQUALS_SUBSTITUTION = "EqualsSubstitution", "left right"
    NOT_EQUALS_SUBSTITUTION = "NotEqualsSubstitution", "left right"
    IF_ELSE_SUBSTITUTION = "IfElseSubstitution", "condition if_value else_value"
    BOOLEAN_SUBSTITUTION = "BooleanSubstitution", "value"
    FOR_LOOP_INDEX = "ForLoopIndex", "name"
    FOR_EACH_VAR = "ForEachVar", "name * default_value"
    PARAMETER_SUBSTITUTION = "ParameterSubstitution", "name"
    LAUNCH_CONTEXT = "LaunchContext", "* argv noninteractive"
    # ---- substitutions of nav2_common
    REWRITTEN_YAML = (
        "RewrittenYaml",
        "source_file param_rewrites root_key key_rewrites * value_rewrites convert_types out_dir",
    )
    REPLACE_STRING = "ReplaceString", "source_file replacements condition"
    HAS_NODE_PARAMS = "HasNodeParams", "source_file node_name"
    LAUNCH_CONFIG_AS_BOOL = "LaunchConfigAsBool", "name"
    # ---- of archlint itself
    BRANCH = "Branch", "action"
    """An action that is added in a branch of the code of a launch file."""


CLASSES = {row.value: row for row in LaunchClass if row is not LaunchClass.BRANCH}
"""What there is to import, by the names of the classes."""

_OF_NAV2 = frozenset(
    {
        LaunchClass.REWRITTEN_YAML,
        LaunchClass.REPLACE_STRING,
        LaunchClass.HAS_NODE_PARAMS,
        LaunchClass.LAUNCH_CONFIG_AS_BOOL,
    }
)
"""The classes of nav2_common: its ``Node`` of the days of Dashing took other arguments than that of launch_ros."""

SUBSTITUTIONS = frozenset(
    {
        LaunchClass.LAUNCH_CONFIGURATION,
        LaunchClass.TEXT_SUBSTITUTION,
        LaunchClass.PATH_JOIN_SUBSTITUTION,
        LaunchClass.STRING_JOIN_SUBSTITUTION,
        LaunchClass.ENVIRONMENT_VARIABLE,
        LaunchClass.FIND_PACKAGE_SHARE,
        LaunchClass.FIND_PACKAGE_PREFIX,
        LaunchClass.EXECUTABLE_IN_PACKAGE,
        LaunchClass.THIS_LAUNCH_FILE_DIR,
        LaunchClass.THIS_LAUNCH_FILE,
        LaunchClass.ANON_NAME,
        LaunchClass.PYTHON_EXPRESSION,
        LaunchClass.NOT_SUBSTITUTION,
        LaunchClass.AND_SUBSTITUTION,
        LaunchClass.ALL_SUBSTITUTION,
        LaunchClass.OR_SUBSTITUTION,
        LaunchClass.ANY_SUBSTITUTION,
        LaunchClass.EQUALS_SUBSTITUTION,
        LaunchClass.NOT_EQUALS_SUBSTITUTION,
        LaunchClass.IF_ELSE_SUBSTITUTION,
        LaunchClass.BOOLEAN_SUBSTITUTION,
        LaunchClass.PARAMETER_VALUE,
        LaunchClass.REWRITTEN_YAML,
        LaunchClass.REPLACE_STRING,
        LaunchClass.HAS_NODE_PARAMS,
        LaunchClass.LAUNCH_CONFIG_AS_BOOL,
        LaunchClass.COMMAND,
        LaunchClass.FIND_EXECUTABLE,
        LaunchClass.FILE_CONTENT,
        LaunchClass.LOCAL_SUBSTITUTION,
        LaunchClass.FOR_LOOP_INDEX,
        LaunchClass.FOR_EACH_VAR,
        LaunchClass.PARAMETER_SUBSTITUTION,
    }
)
"""The classes whose objects stand for a text that the launch makes."""

SOURCES = frozenset(
    {
        LaunchClass.PYTHON_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.XML_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.YAML_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.FRONTEND_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.ANY_LAUNCH_DESCRIPTION_SOURCE,
        LaunchClass.LAUNCH_DESCRIPTION_SOURCE,
    }
)
"""What an include is given where it is not a path."""

CONDITIONS = (
    LaunchClass.IF_CONDITION,
    LaunchClass.UNLESS_CONDITION,
    LaunchClass.LAUNCH_CONFIGURATION_EQUALS,
    LaunchClass.LAUNCH_CONFIGURATION_NOT_EQUALS,
)

ALIASES = {
    "PushROSNamespace": "PushRosNamespace",
    "ROSTimer": "RosTimer",
    "SetRosLogDir": "SetROSLogDir",
    "Parameter": "Parameter",
    "InvalidFrontendLaunchFileError": "",
}

_PACKAGES = ("launch", "launch_ros", "launch_xml", "launch_yaml", "nav2_common")

FUNCTIONS: dict[str, tuple[str, EffectName]] = {
    "ament_index_python.packages.get_package_share_directory": ("package_name", "package_share"),
    "ament_index_python.get_package_share_directory": ("package_name", "package_share"),
    "ament_index_python.packages.get_package_share_path": ("package_name", "package_share"),
    "ament_index_python.get_package_share_path": ("package_name", "package_share"),
    "ament_index_python.packages.get_package_prefix": ("package_name", "package_prefix"),
    "ament_index_python.get_package_prefix": ("package_name", "package_prefix"),
    "launch_ros.substitutions.FindPackageShare.find": ("package_name", "package_share"),
    "ament_index_python.get_search_paths": ("", "search_paths"),
    "ament_index_python.packages.get_search_paths": ("", "search_paths"),
    "ament_index_python.search_paths.get_search_paths": ("", "search_paths"),
    # Editors complete an import to the module of launch_ros that imports these two.
    "launch_ros.substitutions.find_package.get_package_share_directory": ("package_name", "package_share"),
    "launch_ros.substitutions.find_package.get_package_prefix": ("package_name", "package_prefix"),
}


@lru_cache(maxsize=4096)
def find(path: str) -> Api | None:
    """The row of a class of launch or launch_ros, by any name it is imported under."""
    if not path.startswith(("launch", "ament_index_python.", "nav2_common.launch.")):
        return None
    top, _, rest = path.partition(".")
    if path in FUNCTIONS:
        parameter, folder = FUNCTIONS[path]
        return Api(path, parameter, effect=folder)
    if top not in _PACKAGES or not rest:
        return None
    name = rest.rpartition(".")[2]
    row = CLASSES.get(ALIASES.get(name, name))
    if row is None or (top == "nav2_common" and row not in _OF_NAV2):
        return None
    effect: EffectName = "launch_description" if row is LaunchClass.LAUNCH_DESCRIPTION else "launch_object"
    return Api(f"launch.{row}", row.signature, effect=effect, makes=row.value)
