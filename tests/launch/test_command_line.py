"""The command line of ``ros2 launch``, which a launch file may look at."""

from __future__ import annotations

import pytest

from launching import names


@pytest.fixture
def launched_alone(launches):
    """Launch files that the user names with all of their arguments."""
    launches.knows_command_line = True
    return launches


FROM_WORDS = "import sys\nname = next((word[5:] for word in sys.argv if word.startswith('mode:')), 'plain')"
TALKER = "Node(package='robot', executable='talker', name=name)"


@pytest.mark.parametrize(("given", "expected"), [({}, "plain"), ({"mode": "fast"}, "=fast")])
def test_the_words_are_those_that_are_given(launched_alone, given: dict[str, str], expected: str):
    assert names(launched_alone.python(f"[{TALKER}]", FROM_WORDS, **given)) == [expected]


def test_the_first_words_are_package_and_file(launched_alone):
    before = "import sys\nname = '_'.join(sys.argv[1:4])"
    assert names(launched_alone.python(f"[{TALKER}]", before)) == ["launch_robot_it.launch.py"]


def test_robots_that_the_command_line_names(launched_alone):
    before = "from nav2_common.launch import ParseMultiRobotPose\nrobots = ParseMultiRobotPose('robots').value()"
    nodes = "[Node(package='robot', executable='talker', name=name) for name in robots]"
    assert names(launched_alone.python(nodes, before)) == []
    given = "left={x: 1.0, y: 1.0, yaw: 0.0}; right={x: 2.0}"
    assert names(launched_alone.python(nodes, before, robots=given)) == ["left", "right"]
    of_poses = (
        "[Node(package='robot', executable='talker', name=f\"{n}_{p['x']}_{p['roll']}\") for n, p in robots.items()]"
    )
    assert names(launched_alone.python(of_poses, before, robots=given)) == ["left_1.0_0.0", "right_2.0_0.0"]


def test_without_a_word_on_arguments_the_command_line_may_say_anything(launches):
    assert names(launches.python(f"[{TALKER}]", FROM_WORDS)) == ["?"]
    before = "from nav2_common.launch import ParseMultiRobotPose\nrobots = ParseMultiRobotPose('robots').value()"
    nodes = "[Node(package='robot', executable='talker', name=name) for name in robots]"
    assert names(launches.python(nodes, before)) == ["?"]
