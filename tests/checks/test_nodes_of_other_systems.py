"""Nodes that are none of ROS: what they create has no name, type or QoS of ROS."""

from __future__ import annotations

import pytest

from checks.judging import Judge

SOURCE = """
    import rclpy
    {imports}
    from std_msgs.msg import String


    class Poses(Node):
        def __init__(self):
            super().__init__('poses')
            self.create_subscription(String, '/poses', self.keep, 10){mark}

        def keep(self, message):
            pass


    def main():
        rclpy.init()
        rclpy.spin(Poses())
"""


@pytest.mark.parametrize(
    ("imports", "mark"),
    [
        ("from rclpy.node import Node\n    from gz.transport14 import Node", ""),  # the last one is meant
        ("from gz.transport13 import Node", ""),
        ("from gz.transport13 import Node\n    from rclpy.node import Node", "  # here"),
        ("from rclpy.node import Node\n    from gz.transport13 import Node as GzNode", "  # here"),
        ("from robot_base import Node", "  # here"),  # another package's, most likely a node of ROS
    ],
)
def test_the_class_that_a_name_means_decides(judge: Judge, imports: str, mark: str):
    judge("NME001", SOURCE.format(imports=imports, mark=mark))
