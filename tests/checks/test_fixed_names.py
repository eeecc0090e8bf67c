"""NME001 where the workspace itself holds a name to its form: code that refuses another, a model and its bridge."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.finding import Severity
from checks.judging import Judge

WATCHER = """
    import rclpy
    from checking import checked
    from rclpy.node import Node
    from std_msgs.msg import String


    class Watcher(Node):
        def __init__(self, topics):
            super().__init__('watcher')
            {body}


    def main():
        rclpy.init()
        rclpy.spin(Watcher(['/words']))  # here


    main()
"""
CHECK = "if not {name}.startswith('/'):\n                    raise ValueError({name})\n"
LOOP = "for topic in topics:\n                "
CREATE = "self.create_subscription(String, topic, print, 10)\n"


@pytest.mark.parametrize(
    ("body", "severity"),
    [
        (LOOP + CREATE, Severity.WARNING),
        (LOOP + CHECK.format(name="topic") + " " * 16 + CREATE, None),
        (LOOP + CHECK.format(name="topic").replace("raise ValueError(topic)", "topic = '/' + topic"), None),
        ("for topic in checked(topics):\n                " + CREATE, None),
        (
            "self.topics = checked(topics)\n            for topic in self.topics:\n                " + CREATE,
            None,
        ),
    ],
)
def test_the_code_refuses_another_form(judge: Judge, tmp_path: Path, body: str, severity: Severity | None):
    (tmp_path / "checking.py").write_text(
        "def checked(topics):\n    for topic in topics:\n        if not topic.startswith('/'):\n"
        "            raise ValueError(topic)\n    return topics\n"
    )
    text = WATCHER.format(body=body)
    found = judge("NME001", text if severity is not None else text.replace("  # here", ""))

    assert [one.severity for one in found] == ([] if severity is None else [severity])


MOVER = """
    import rclpy
    from std_msgs.msg import String


    def main():
        rclpy.init()
        node = rclpy.create_node('mover')
        node.create_publisher(String, '/ball/words', 10)  # here


    if __name__ == '__main__':
        main()
"""
BRIDGE = """
    from launch import LaunchDescription
    from launch_ros.actions import Node


    def generate_launch_description():
        return LaunchDescription([
            Node(package='ros_gz_bridge', executable='parameter_bridge',
                 arguments=['{name}@std_msgs/msg/String]gz.msgs.StringMsg']),
        ])
"""


@pytest.mark.parametrize(
    ("model", "bridged", "told"),
    [
        ("/ball/words", "/ball/other", False),
        ("words", "/ball/words", False),  # the bridge has it
        ("words", "/ball/other", True),
    ],
)
def test_the_topic_of_a_model(judge: Judge, tmp_path: Path, model: str, bridged: str, told: bool):
    (tmp_path / "package.xml").write_text("<package format='3'><name>ball</name><version>0.0.1</version></package>")
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "model.sdf").write_text(f"<sdf><plugin><topic>{model}</topic></plugin></sdf>")
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch" / "bridge.launch.py").write_text(dedent(BRIDGE).format(name=bridged))

    judge("NME001", MOVER if told else MOVER.replace("  # here", ""))
