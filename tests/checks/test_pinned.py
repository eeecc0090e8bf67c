"""The distributions that the files of CI and containers name: EXE006 asks whether the callback is right in them."""

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
    ("files", "told"),
    [
        ({WORKFLOW: "jobs: {build: {container: 'ros:jazzy'}}"}, False),
        ({WORKFLOW: "env:\n  ROS_DISTRO: jazzy\n"}, False),
        ({"Dockerfile": "FROM osrf/ros:jazzy-desktop\n"}, False),
        ({"docker/Dockerfile.robot": "RUN apt-get install -y ros-jazzy-nav2-bringup\n"}, False),
        ({"Docker/Dockerfile": "FROM ros:jazzy\n"}, False),
        ({"docker-compose.yml": "command: bash -c 'source /opt/ros/jazzy/setup.bash'\n"}, False),
        ({WORKFLOW: "jobs: {build: {container: 'ros:humble'}}"}, True),
        ({WORKFLOW: "matrix: {ros_distro: [humble, jazzy]}"}, True),
        ({WORKFLOW: "with:\n  distro: humble\n"}, True),
        ({WORKFLOW: "container: 'ros:jazzy'", "Dockerfile": "FROM ros:humble\n"}, True),
        ({WORKFLOW: "name: a jazzy name"}, False),
        ({"README.md": "For ros:jazzy only.", "docker/notes.md": "ros:jazzy"}, False),
        ({}, False),
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
        "an input of an action",
        "another in another file",
        "a word",
        "a README",
        "nothing",
    ],
)
def test_what_names_a_distribution(judge: Judge, tmp_path: Path, files: dict[str, str], told: bool):
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    found = judge("EXE006", LISTENER if told else LISTENER.replace("  # here", ""))

    assert [one.severity for one in found] == [Severity.WARNING] * told
    assert all(" in humble, and Listener.on_words takes 2 arguments" in one.message for one in found)


def test_the_configuration_names_one(judge: Judge):
    [found] = judge("EXE006", LISTENER, config='distro = "humble"')
    assert found.severity is Severity.ERROR

    judge("EXE006", LISTENER.replace("  # here", ""), config='distro = "jazzy"')


def test_what_fails_everywhere_needs_no_evidence(judge: Judge):
    [found] = judge("EXE006", LISTENER.replace("message, message_info", "message, info, more"))
    assert found.severity is Severity.ERROR


SPINS_INSIDE = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Job(Node):
        def __init__(self):
            super().__init__('job')
            self.other = rclpy.create_node('other')
            self.client = self.other.create_client(Trigger, 'far')
            self.create_service(Trigger, 'job', self.on_job)

        def on_job(self, request, response):
            future = self.client.call_async(Trigger.Request())
            rclpy.spin_until_future_complete(self.other, future, timeout_sec=1.0)  # here
            response.success = future.done()
            return response


    def main():
        rclpy.init()
        rclpy.spin(Job())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("files", "severity", "fails"),
    [
        ({}, Severity.ERROR, True),
        ({"setup.bash": "source /opt/ros/humble/setup.bash\n"}, Severity.WARNING, False),
        ({"Dockerfile": "FROM ros:humble\n"}, Severity.WARNING, False),
        ({"Dockerfile": "FROM ros:humble\n", WORKFLOW: "container: 'ros:jazzy'"}, Severity.ERROR, True),
        ({"Dockerfile": "FROM ros:kilted\n"}, Severity.ERROR, True),
        ({"setup.bash": "echo humble\n"}, Severity.ERROR, True),
    ],
)
def test_a_handler_that_works_in_the_one_distribution_of_the_workspace(
    judge: Judge, tmp_path: Path, files: dict[str, str], severity: Severity, fails: bool
):
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    [found] = judge("SRV003", SPINS_INSIDE)

    assert found.severity is severity
    assert ("Executor is already spinning" in found.message) is fails
