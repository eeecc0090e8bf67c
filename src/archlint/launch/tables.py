"""What launch, launch_ros and nav2_common offer: one row a class, with the parameters its constructor takes.

Signatures are those of launch and launch_ros, humble to rolling.  Each class is known by one name wherever it is
imported from; its objects are instances of ``launch.<Name>``.
"""

from __future__ import annotations

from functools import lru_cache

from archlint.libraries.tables import Api
from archlint.libraries.tables.api import EffectName

_PROCESS = (
    "prefix cwd env additional_env output output_format respawn respawn_delay respawn_max_retries shell "
    "emulate_tty sigterm_timeout sigkill_timeout on_exit log_cmd cached_output condition "
    "additional_env_file signal_lifecycle"
)
_NODE = "executable package name namespace exec_name parameters remappings ros_arguments arguments " + _PROCESS

SIGNATURES: dict[str, str] = {
    "LaunchDescription": "initial_entities * deprecated_reason",
    # ---- actions
    "Node": f"* {_NODE}",
    "LifecycleNode": f"* {_NODE} autostart",
    "ComposableNodeContainer": f"* composable_node_descriptions {_NODE}",
    "LoadComposableNodes": "* composable_node_descriptions target_container condition",
    "PushRosNamespace": "namespace * condition",
    "SetRemap": "src dst * condition",
    "SetParameter": "name value * condition",
    "SetParametersFromFile": "filename * node_name condition",
    "SetUseSimTime": "value * condition",
    "SetROSLogDir": "new_log_dir * condition",
    "RosTimer": "* period actions cancel_on_shutdown condition",
    "LifecycleTransition": "* lifecycle_node_names transition_ids condition",
    "IncludeLaunchDescription": "launch_description_source * launch_arguments condition",
    "GroupAction": "actions * scoped forwarding launch_configurations condition",
    "DeclareLaunchArgument": "name * default_value description choices condition",
    "DeclareBooleanLaunchArgument": "name * default_value description condition",
    "SetLaunchConfiguration": "name value * condition",
    "UnsetLaunchConfiguration": "name * condition",
    "PushLaunchConfigurations": "* condition",
    "PopLaunchConfigurations": "* condition",
    "ResetLaunchConfigurations": "launch_configurations * condition",
    "SetEnvironmentVariable": "name value * condition",
    "AppendEnvironmentVariable": "name value * prepend separator condition",
    "UnsetEnvironmentVariable": "name * condition",
    "PushEnvironment": "* condition",
    "PopEnvironment": "* condition",
    "OpaqueFunction": "* function args kwargs condition",
    "OpaqueCoroutine": "* coroutine args kwargs ignore_context condition",
    "TimerAction": "* period actions cancel_on_shutdown condition",
    "ExecuteProcess": f"* cmd name {_PROCESS}",
    "ExecuteLocal": f"* process_description {_PROCESS}",
    "RegisterEventHandler": "event_handler * condition",
    "UnregisterEventHandler": "event_handler * condition",
    "EmitEvent": "* event condition",
    "LogInfo": "* msg condition",
    "Shutdown": "* reason condition",
    "ForEach": "input_values * function condition",
    "ForLoop": "* function length condition",
    # ---- event handlers
    "EventHandler": "* matcher entities handle_once",
    "OnProcessExit": "* target_action on_exit handle_once",
    "OnProcessStart": "* target_action on_start handle_once",
    "OnProcessIO": "* target_action on_stdout on_stderr on_stdin",
    "OnExecutionComplete": "* target_action on_completion handle_once",
    "OnShutdown": "* on_shutdown handle_once",
    "OnStateTransition": "* target_lifecycle_node transition start_state goal_state entities matcher handle_once",
    # ---- descriptions
    "ComposableNode": "* package plugin name namespace parameters remappings extra_arguments condition",
    "ComposableLifecycleNode": "* package plugin name namespace parameters remappings extra_arguments "
    "condition autostart",
    "ParameterFile": "param_file * allow_substs",
    "ParameterValue": "value * value_type",
    "Parameter": "name value * value_type",
    # ---- launch description sources
    "PythonLaunchDescriptionSource": "launch_file_path",
    "XMLLaunchDescriptionSource": "launch_file_path",
    "YAMLLaunchDescriptionSource": "launch_file_path",
    "FrontendLaunchDescriptionSource": "launch_file_path * parser",
    "AnyLaunchDescriptionSource": "launch_file_path",
    "LaunchDescriptionSource": "launch_description location method",
    # ---- conditions
    "Condition": "* predicate",
    "IfCondition": "predicate_expression",
    "UnlessCondition": "predicate_expression",
    "LaunchConfigurationEquals": "launch_configuration_name expected_value",
    "LaunchConfigurationNotEquals": "launch_configuration_name expected_value",
    # ---- substitutions
    "Substitution": "",
    "LaunchConfiguration": "variable_name * default",
    "PathJoinSubstitution": "substitutions",
    "StringJoinSubstitution": "substitutions * delimiter",
    "TextSubstitution": "* text",
    "PythonExpression": "expression python_modules",
    "EnvironmentVariable": "name * default_value",
    "Command": "command * on_stderr",
    "FindExecutable": "* name",
    "FindPackageShare": "package",
    "FindPackagePrefix": "package",
    "ExecutableInPackage": "executable package",
    "ThisLaunchFile": "",
    "ThisLaunchFileDir": "",
    "AnonName": "name",
    "LocalSubstitution": "expression * description",
    "FileContent": "path",
    "NotSubstitution": "value",
    "AndSubstitution": "left right",
    "OrSubstitution": "left right",
    "AnySubstitution": "",
    "AllSubstitution": "",
    "EqualsSubstitution": "left right",
    "NotEqualsSubstitution": "left right",
    "IfElseSubstitution": "condition if_value else_value",
    "BooleanSubstitution": "value",
    "ForLoopIndex": "name",
    "ForEachVar": "name * default_value",
    "ParameterSubstitution": "name",
    "LaunchContext": "* argv noninteractive",
    # ---- substitutions of nav2_common
    "RewrittenYaml": "source_file param_rewrites root_key key_rewrites * value_rewrites convert_types out_dir",
    "ReplaceString": "source_file replacements condition",
    "HasNodeParams": "source_file node_name",
    "LaunchConfigAsBool": "name",
}

SUBSTITUTIONS = frozenset(
    {
        "LaunchConfiguration",
        "TextSubstitution",
        "PathJoinSubstitution",
        "StringJoinSubstitution",
        "EnvironmentVariable",
        "FindPackageShare",
        "FindPackagePrefix",
        "ExecutableInPackage",
        "ThisLaunchFileDir",
        "ThisLaunchFile",
        "AnonName",
        "PythonExpression",
        "NotSubstitution",
        "AndSubstitution",
        "AllSubstitution",
        "OrSubstitution",
        "AnySubstitution",
        "EqualsSubstitution",
        "NotEqualsSubstitution",
        "IfElseSubstitution",
        "BooleanSubstitution",
        "ParameterValue",
        "RewrittenYaml",
        "ReplaceString",
        "HasNodeParams",
        "LaunchConfigAsBool",
        "Command",
        "FindExecutable",
        "FileContent",
        "LocalSubstitution",
        "ForLoopIndex",
        "ForEachVar",
        "ParameterSubstitution",
    }
)
"""The classes whose objects stand for a text that the launch makes."""

CONDITIONS = ("IfCondition", "UnlessCondition", "LaunchConfigurationEquals", "LaunchConfigurationNotEquals")

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
    name = ALIASES.get(name, name)
    signature = SIGNATURES.get(name)
    if signature is None:
        return None
    effect: EffectName = "launch_description" if name == "LaunchDescription" else "launch_object"
    return Api(f"launch.{name}", signature, effect=effect, makes=name)
