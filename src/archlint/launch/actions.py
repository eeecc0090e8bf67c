"""Actions by name: what each of them does to the launch context, and what it starts."""

from __future__ import annotations

from archlint.launch import included, processes, scopes, visiting
from archlint.launch.visiting import visit, visit_items

visiting.ACTIONS.update(
    {
        "LaunchDescription": included.description,
        "Branch": included.branch,
        "GroupAction": scopes.group,
        "TimerAction": visiting.visit_argument("actions"),
        "RosTimer": visiting.visit_argument("actions"),
        "DeclareLaunchArgument": scopes.declare,
        "DeclareBooleanLaunchArgument": scopes.declare,
        "SetLaunchConfiguration": scopes.let,
        "UnsetLaunchConfiguration": scopes.unset,
        "SetEnvironmentVariable": scopes.environment,
        "PushRosNamespace": scopes.push_namespace,
        "SetRemap": scopes.set_remap,
        "SetParameter": scopes.set_parameter,
        "SetUseSimTime": scopes.set_parameter,
        "SetParametersFromFile": scopes.set_parameters_from_file,
        "IncludeLaunchDescription": included.include,
        "PythonLaunchDescriptionSource": included.include,
        "OpaqueFunction": included.opaque,
        "RegisterEventHandler": included.event_handler,
        "Node": processes.node,
        "LifecycleNode": processes.node,
        "ComposableNodeContainer": processes.node,
        "LoadComposableNodes": processes.load,
        "ExecuteProcess": processes.process,
    }
)

__all__ = ["visit", "visit_items"]
