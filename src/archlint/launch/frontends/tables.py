"""What XML and YAML launch files may hold: the attributes of elements, and the names of substitutions."""

from __future__ import annotations

from archlint.launch.tables import LaunchClass

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

NEEDED: dict[str, tuple[str, ...]] = {
    "node": ("pkg", "exec"),
    "lifecycle_node": ("pkg", "exec", "name", "namespace"),
    "node_container": ("pkg", "exec", "name", "namespace"),
    "composable_node": ("pkg", "plugin"),
    "load_composable_node": ("target",),
    "include": ("file",),
    "arg": ("name",),
    "let": ("name", "value"),
    "push_ros_namespace": ("namespace",),
    "push-ros-namespace": ("namespace",),
    "set_remap": ("from", "to"),
    "set_parameter": ("name", "value"),
    "set_env": ("name", "value"),
    "unset_env": ("name",),
    "timer": ("period",),
    "executable": ("cmd",),
}
"""What launch reads of an element without a default.

Source: the ``parse`` methods of launch and launch_ros, humble to rolling, which call ``entity.get_attr(name)``.
"""
NEEDED_BELOW: dict[str, tuple[str, ...]] = {
    "remap": ("from", "to"),
    "env": ("name", "value"),
    "keep": ("name", "value"),
}
"""The same of elements inside of those that start a process, and of groups."""
NEEDED_BY_INCLUDES: dict[str, tuple[str, ...]] = {"arg": ("name", "value"), "let": ("name", "value")}

NESTED: dict[str, tuple[str, ...]] = {
    "node": ("param", "remap", "env"),
    "lifecycle_node": ("param", "remap", "env"),
    "include": ("arg", "let"),
}
"""What an element may hold, of those that hold no actions: launch refuses anything else."""

SUBSTITUTIONS: dict[str, tuple[LaunchClass, tuple[str, ...]]] = {
    "var": (LaunchClass.LAUNCH_CONFIGURATION, ("variable_name", "default")),
    "env": (LaunchClass.ENVIRONMENT_VARIABLE, ("name", "default_value")),
    "optenv": (LaunchClass.ENVIRONMENT_VARIABLE, ("name", "default_value")),
    "find-pkg-share": (LaunchClass.FIND_PACKAGE_SHARE, ("package",)),
    "find-pkg-prefix": (LaunchClass.FIND_PACKAGE_PREFIX, ("package",)),
    "exec-in-pkg": (LaunchClass.EXECUTABLE_IN_PACKAGE, ("executable", "package")),
    "eval": (LaunchClass.PYTHON_EXPRESSION, ("expression",)),
    "command": (LaunchClass.COMMAND, ("command", "on_stderr")),
    "dirname": (LaunchClass.THIS_LAUNCH_FILE_DIR, ()),
    "filename": (LaunchClass.THIS_LAUNCH_FILE, ()),
    "anon": (LaunchClass.ANON_NAME, ("name",)),
    "not": (LaunchClass.NOT_SUBSTITUTION, ("value",)),
    "and": (LaunchClass.AND_SUBSTITUTION, ("left", "right")),
    "or": (LaunchClass.OR_SUBSTITUTION, ("left", "right")),
    "any": (LaunchClass.ANY_SUBSTITUTION, ()),
    "all": (LaunchClass.ALL_SUBSTITUTION, ()),
    "equals": (LaunchClass.EQUALS_SUBSTITUTION, ("left", "right")),
    "not-equals": (LaunchClass.NOT_EQUALS_SUBSTITUTION, ("left", "right")),
    "if": (LaunchClass.IF_ELSE_SUBSTITUTION, ("condition", "if_value", "else_value")),
    "file-content": (LaunchClass.FILE_CONTENT, ("path",)),
    "find-exec": (LaunchClass.FIND_EXECUTABLE, ("name",)),
    "param": (LaunchClass.PARAMETER_SUBSTITUTION, ("name",)),
    "path-join": (LaunchClass.PATH_JOIN_SUBSTITUTION, ()),
}
