"""What a launch yields is plain data, and comes back as it was."""

from __future__ import annotations

import re
from dataclasses import fields

from archlint.branches import Branch
from archlint.launch.encoding import LAUNCHES
from archlint.model.encoding import decode, encode

ACTIONS = """[
    DeclareLaunchArgument('side', choices=['left', 'right']),
    DeclareLaunchArgument('file', default_value='nowhere.yaml'),
    GroupAction([
        PushRosNamespace(LaunchConfiguration('side')),
        Node(
            package='robot', executable='talker', name='talker', remappings=[('a', 'b')],
            parameters=[{'rate': 5.0, 'names': ['x', LaunchConfiguration('side')]}, LaunchConfiguration('file')],
            condition=IfCondition(LaunchConfiguration('side')),
        ),
    ]),
    IncludeLaunchDescription('missing.launch.py', launch_arguments={'side': 'left'}.items()),
]"""


def test_a_launch_comes_back_as_it_was(launches):
    launched = launches.python(ACTIONS)
    [again] = decode(encode([launched], LAUNCHES), LAUNCHES)
    for row in fields(launched):
        before, after = getattr(launched, row.name), getattr(again, row.name)
        if row.name == "started":
            before, after = (
                [{own.name: getattr(one, own.name) for own in fields(one)} for one in several]
                for several in (before, after)
            )
        assert after == before, row.name
    assert launched.started and launched.included and launched.declared and launched.labels


def test_every_class_of_a_launch_is_known():
    """Each class that a field of what a launch yields names, and each kind of branch."""
    annotations = " ".join(str(row.type) for kind in LAUNCHES.records for row in fields(kind))
    named = set(re.findall(r"\b[A-Z]\w+\b", annotations)) - {"None", "ClassVar", "Literal"}
    aliases = {"Branch", "BranchArm", "BranchArms", "OriginKind", "ParameterData", "Parameters", "Resolution"}
    records = {kind.__name__ for kind in LAUNCHES.records}
    words = {kind.__name__ for kind in LAUNCHES.words}
    assert named - aliases <= records | words
    assert {kind.__name__ for kind in Branch.__subclasses__()} <= records
