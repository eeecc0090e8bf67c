"""MSG001: what a keyword that a message does not have comes to in each distribution."""

from __future__ import annotations

import pytest

from checks.judging import Judge

SOURCE = """
    from rclpy.node import Node
    from std_msgs.msg import String


    class Talker(Node):
        def __init__(self):
            super().__init__('talker')
            self.publisher = self.create_publisher(String, 'chatter', 10)
            self.publisher.publish(String({field}='hello')){mark}
"""


ALL = (
    "such a keyword raises AssertionError on humble and TypeError on lyrical and rolling, and jazzy and kilted "
    "ignore it"
)


@pytest.mark.parametrize(
    ("dockerfile", "config", "words"),
    [
        ("", "", ALL),
        ("", "distro = 'humble'", "such a keyword raises AssertionError"),
        ("", "distro = 'rolling'", "such a keyword raises TypeError"),
        ("", "distro = 'kilted'", "the constructor ignores such a keyword, and the field keeps its default"),
        ("FROM ros:jazzy", "", "the constructor ignores such a keyword, and the field keeps its default"),
        ("FROM ros:jazzy\nRUN ros:humble", "", "such a keyword raises AssertionError on humble, and jazzy ignores it"),
    ],
)
def test_what_comes_of_it_is_said_for_the_distributions_in_use(judge: Judge, dockerfile: str, config: str, words: str):
    (judge.folder / "Dockerfile").write_text(dockerfile)
    [finding] = judge("MSG001", SOURCE.format(field="dat", mark="  # here"), config=config)
    assert finding.help == f"{words}; the fields are data"


def test_a_keyword_that_is_a_field(judge: Judge):
    judge("MSG001", SOURCE.format(field="data", mark=""))
