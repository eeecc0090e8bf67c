"""API001: classes of messages that a later import of the same name hides."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
{imports}
from rclpy.node import Node


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.publisher = self.create_publisher(Path, 'path', 10){mark}


def main():
    rclpy.init()
    rclpy.spin(Planner())


main()
"""


def test_a_message_that_another_import_hides(judge: Judge) -> None:
    imports = "from nav_msgs.msg import Path\nfrom pathlib import Path"
    (finding,) = judge("API001", NODE.format(imports=imports, mark="  # here"))
    told = "create_publisher() fails: 'msg_type' gets Path of pathlib, which hides that of nav_msgs.msg"
    assert finding.message == told
    assert [place.place.line for place in finding.related] == [3, 2]


@pytest.mark.parametrize(
    "imports",
    [
        "from nav_msgs.msg import Path",
        "from pathlib import Path\nfrom nav_msgs.msg import Path",
        "from nav_msgs.msg import Path\nfrom pathlib import Path as FilePath",
        "from nav_msgs.msg import Path\nfrom nav_msgs import Path",
        "from nav_msgs.msg import Path\nif True:\n    from pathlib import Path",
        "from nav_msgs.msg import Path\nfrom pathlib import Path\nPath = None",
    ],
)
def test_a_name_that_is_the_message_or_may_be(judge: Judge, imports: str) -> None:
    judge("API001", NODE.format(imports=imports, mark=""))
