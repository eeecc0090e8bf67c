"""What XML and YAML launch files may hold: the attributes of elements, and the names of substitutions."""

from __future__ import annotations

HARMLESS = frozenset(
    {"keep", "log", "log_info", "log_debug", "log_warning", "log_error", "shutdown", "set_ros_log_dir", "append_env"}
    | {"reset", "reset_env", "rep_env", "push_env", "pop_env"}
)
"""Elements that start nothing, and whose effect no name depends on."""

_PROCESS = [
    "output",
    "respawn",
    "respawn_delay",
    "respawn_max_retries",
    "launch-prefix",
    "cwd",
    "on_exit",
    "shell",
    "emulate_tty",
    "sigterm_timeout",
    "sigkill_timeout",
    "output_format",
    "exec_name",
]
_NODE = ["pkg", "exec", "name", "namespace", "args", "ros_args", *_PROCESS]

ATTRIBUTES: dict[str, list[str]] = {
    "node": _NODE,
    "lifecycle_node": [*_NODE, "autostart"],
    "node_container": _NODE,
    "composable_node": ["pkg", "plugin", "name", "namespace"],
    "load_composable_node": ["target"],
    "include": ["file"],
    "group": ["scoped", "forwarding"],
    "arg": ["name", "default", "description"],
    "let": ["name", "value"],
    "push_ros_namespace": ["namespace"],
    "push-ros-namespace": ["namespace"],
    "set_remap": ["from", "to"],
    "timer": ["period"],
}

SUBSTITUTIONS: dict[str, tuple[str, tuple[str, ...]]] = {
    "var": ("LaunchConfiguration", ("variable_name", "default")),
    "env": ("EnvironmentVariable", ("name", "default_value")),
    "optenv": ("EnvironmentVariable", ("name", "default_value")),
    "find-pkg-share": ("FindPackageShare", ("package",)),
    "find-pkg-prefix": ("FindPackagePrefix", ("package",)),
    "exec-in-pkg": ("ExecutableInPackage", ("executable", "package")),
    "eval": ("PythonExpression", ("expression",)),
    "command": ("Command", ("command", "on_stderr")),
    "dirname": ("ThisLaunchFileDir", ()),
    "filename": ("ThisLaunchFile", ()),
    "anon": ("AnonName", ("name",)),
    "not": ("NotSubstitution", ("value",)),
    "and": ("AndSubstitution", ("left", "right")),
    "or": ("OrSubstitution", ("left", "right")),
    "any": ("AnySubstitution", ()),
    "all": ("AllSubstitution", ()),
    "equals": ("EqualsSubstitution", ("left", "right")),
    "not-equals": ("NotEqualsSubstitution", ("left", "right")),
    "if": ("IfElseSubstitution", ("condition", "if_value", "else_value")),
    "file-content": ("FileContent", ("path",)),
    "find-exec": ("FindExecutable", ("name",)),
    "param": ("ParameterSubstitution", ("name",)),
    "path-join": ("PathJoinSubstitution", ()),
}
