"""The distribution that the files of CI and containers name: EXE006 is quieter where the callback is right in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.finding import Severity
from checks.judging import Judge

LISTENER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String


    class Listener(Node):
        def __init__(self):
            super().__init__('listener')
            self.create_subscription(String, 'words', self.on_words, 10)  # here

        def on_words(self, message, message_info):
            pass


    def main():
        rclpy.init()
        rclpy.spin(Listener())


    if __name__ == '__main__':
        main()
"""
WORKFLOW = ".github/workflows/ci.yml"


@pytest.mark.parametrize(
    ("files", "severity"),
    [
        ({WORKFLOW: "jobs: {build: {container: 'ros:jazzy'}}"}, Severity.INFO),
        ({WORKFLOW: "env:\n  ROS_DISTRO: jazzy\n"}, Severity.INFO),
        ({"Dockerfile": "FROM osrf/ros:jazzy-desktop\n"}, Severity.INFO),
        ({"docker/Dockerfile.robot": "RUN apt-get install -y ros-jazzy-nav2-bringup\n"}, Severity.INFO),
        ({"Docker/Dockerfile": "FROM ros:jazzy\n"}, Severity.INFO),
        ({"docker-compose.yml": "command: bash -c 'source /opt/ros/jazzy/setup.bash'\n"}, Severity.INFO),
        ({WORKFLOW: "jobs: {build: {container: 'ros:humble'}}"}, Severity.WARNING),
        ({WORKFLOW: "matrix: {ros_distro: [humble, jazzy]}"}, Severity.WARNING),
        ({WORKFLOW: "container: 'ros:jazzy'", "Dockerfile": "FROM ros:humble\n"}, Severity.WARNING),
        ({WORKFLOW: "name: a jazzy name"}, Severity.WARNING),
        ({"README.md": "For ros:jazzy only.", "docker/notes.md": "ros:jazzy"}, Severity.WARNING),
        ({}, Severity.WARNING),
    ],
    ids=[
        "a container",
        "a variable",
        "an image",
        "a package",
        "a folder with a capital",
        "a compose file",
        "the one where it is wrong",
        "two of them",
        "another in another file",
        "a word",
        "a README",
        "nothing",
    ],
)
def test_what_names_one_distribution(judge: Judge, tmp_path: Path, files: dict[str, str], severity: Severity):
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    [found] = judge("EXE006", LISTENER)

    assert found.severity is severity
    assert ("names jazzy alone" in found.message) == (severity is Severity.INFO)


def test_the_advice_settles_it(judge: Judge, tmp_path: Path):
    (tmp_path / "Dockerfile").write_text("FROM ros:jazzy\n")
    [found] = judge("EXE006", LISTENER)
    assert found.message.endswith("; Dockerfile names jazzy alone")
    assert found.help == 'set the distribution in the configuration, if the code is for jazzy only: distro = "jazzy"'

    judge("EXE006", LISTENER.replace("  # here", ""), config='distro = "jazzy"')
