"""Launch files in Python: all classes of launch and launch_ros, with arguments that fit and others."""

from __future__ import annotations

from archlint.launch.tables import LaunchClass
from benchmarks.fuzz.grammar import Grammar
from benchmarks.fuzz.pick import NUMBERS, Pick

_FILE = """\
import os
from launch import *
from launch.actions import *
from launch.conditions import *
from launch.event_handlers import *
from launch.launch_description_sources import *
from launch.substitutions import *
from launch_ros.actions import *
from launch_ros.descriptions import *
from launch_ros.parameter_descriptions import *
from launch_ros.substitutions import *
from ament_index_python.packages import get_package_share_directory


def helper(context, *given, **named):
    return [«action»]


def generate_launch_description():
    first = «value»
    second = «value»
    description = LaunchDescription([
        «action»,
        «action»,
        «actions»
    ])
    «adding»
    return «returned»
"""
_LISTS = (
    "actions",
    "initial_entities",
    "entities",
    "on_exit",
    "on_start",
    "on_completion",
    "composable_node_descriptions",
)
_KINDS = {
    **dict.fromkeys(_LISTS, "[«actions»]"),
    **dict.fromkeys(["executable", "package"], "«ours»"),
    "parameters": "[«parameter»]",
    "remappings": "[(«value», «value»), «value»]",
    "launch_arguments": "{«value»: «value»}.items()",
    "condition": "«condition»",
    "launch_description_source": "«source»",
    "launch_file_path": "«path»",
    "function": "«callable»",
    "event_handler": "«handler»",
    "target_action": "«action»",
}
"""What an argument is made of, by the name of the parameter; a value otherwise."""


def _calls(kinds: list[LaunchClass]) -> list[str]:
    """Two calls of each class: with few arguments, and with all that stand first."""
    return [_call(kind, most) for kind in kinds for most in (2, 6)]


def _call(kind: LaunchClass, most: int) -> str:
    positional, _, keywords = kind.signature.partition("*")
    given = [_KINDS.get(name, "«value»") for name in positional.split()]
    named = [
        f"{name}={_KINDS.get(name, '«value»')}"
        for name in dict.fromkeys(keywords.split()[:most] + ["condition"][: most - 5])
    ]
    return f"{kind}({', '.join(given + named)})"


def _ending_in(*words: str) -> list[LaunchClass]:
    return [kind for kind in LaunchClass if kind.signature and any(word in kind for word in words)]


_SUBSTITUTIONS = _ending_in(
    "Substitution", "Find", "Configuration", "Expression", "ThisLaunch", "Variable", "Command", "Content", "Name"
)
_HANDLERS = _ending_in("OnProcess", "OnExecution", "OnShutdown", "OnState", "EventHandler")
_COMMON = (
    LaunchClass.NODE,
    LaunchClass.DECLARE_LAUNCH_ARGUMENT,
    LaunchClass.GROUP_ACTION,
    LaunchClass.INCLUDE_LAUNCH_DESCRIPTION,
)

_LAUNCHES = Grammar(
    {
        "file": [_FILE],
        "actions": ["", "«action»", "«action», «actions»", "*«value»", "«value»"],
        "action": [
            *("LogInfo(msg='x')", "Node(package='robot', executable='robot')"),
            *[_call(kind, 4) for kind in _COMMON for _ in range(8)],
            *_calls([kind for kind in LaunchClass if kind.signature and kind != LaunchClass.BRANCH]),
            "Node(package=«ours», executable=«ours», odd=«value»)",
            "helper(None)",
            "«value»",
        ],
        "adding": [
            *("pass", "pass", "pass", "description.add_action(«action»)", "second.append(description)"),
            "for second in «value»:\n    description.add_action(«action»)",
            "if «value»:\n    description.add_action(«action»)\nelse:\n    return «value»",
        ],
        "returned": ["description", "description", "description", "[description]", "None", "«value»"],
        "ours": ["'robot'", "'robot'", "'talker'", "«value»"],
        "parameter": [
            "{«value»: «value»}",
            "«path»",
            "«value», {'use_sim_time': «value»}",
            "{'a': {'b': «value»}}",
            "[«value»]",
        ],
        "condition": _calls(_ending_in("Condition", "ConfigurationEquals", "ConfigurationNotEquals")),
        "source": _calls(_ending_in("DescriptionSource")),
        "handler": _calls(_HANDLERS),
        "callable": ["helper", "lambda context: [helper(context)]", "lambda: «action»", "None"],
        "path": [
            "os.path.join(get_package_share_directory('robot'), 'launch', 'robot.launch.xml')",
            "PathJoinSubstitution([FindPackageShare('robot'), 'config', 'robot.yaml'])",
            "[ThisLaunchFileDir(), '/robot.launch.py']",
            "__file__",
            "«value»",
        ],
        "value": [
            *("«literal»", "«literal»", "«number»", "first", "second", "LaunchConfiguration('scan')", "description"),
            *(
                "[«value», «value»]",
                "{«value»: «value»}",
                "(«value», «value»)",
                "«value» + «value»",
                "str(«value»)",
                "«substitution»",
            ),
            *(
                "os.path.join(«value», «value»)",
                "open(«value»).read()",
                "«value».perform(None)",
                "[n for n in «value»]",
                "«substitution»",
            ),
            *(
                "«value»[«value»]",
                "«literal».format(«value»)",
                "«value» * «number»",
                "LaunchConfiguration(«value», default=«value»)",
            ),
        ],
        "substitution": _calls(_SUBSTITUTIONS),
    },
    {"number": lambda pick: pick.among(NUMBERS), "literal": lambda pick: repr(pick.name())},
    depth=9,
    size=150,
)


def python_launch(pick: Pick) -> str:
    """A launch file in Python."""
    return _LAUNCHES.text(pick, "file")
