"""Nodes whose source is not here, and what is known of them from the table of well-known nodes."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.engine.request import NothingToDo
from archlint.render.json import document
from archlint.ros import external_nodes
from archlint.ros.external_nodes import ExternalEnd, ExternalNode, ExternalParameter
from archlint.systems.nodes import Node
from robot_package import manifest, write_files, write_robot

TURTLE = ExternalNode(
    "acme_drivers",
    ("base", "acme::Base"),
    "base",
    versions={"humble": "1.0.0", "jazzy": "2.0.0"},
    ends=(
        ExternalEnd("publisher", "odom", "nav_msgs/msg/Odometry"),
        ExternalEnd("subscriber", "cmd_vel", "geometry_msgs/msg/Twist", distros=("humble",)),
        ExternalEnd("subscriber", "cmd_vel", "geometry_msgs/msg/TwistStamped", distros=("jazzy",)),
        ExternalEnd("service", "~/stop", "std_srvs/srv/Trigger", distros=("jazzy",)),
        ExternalEnd("publisher", "scan", "sensor_msgs/msg/LaserScan", parameter="scan_topic"),
    ),
    parameters=(ExternalParameter("scan_topic", "string", "scan"),),
)


@pytest.fixture
def started(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The external nodes of a launch file with these lines."""
    monkeypatch.chdir(tmp_path)

    def start(lines: str, distro: str | None = None) -> list[Node]:
        write_robot(tmp_path, lines)
        settings = Settings(external_nodes=(TURTLE,), distro=distro)
        request = Request((".",), settings, cached=False, jobs=1, launch="launch/it.launch.xml")
        return [node for node in graph(request).nodes if node.external]

    return start


def ends(node: Node) -> dict[str | None, tuple[str, str | None, bool]]:
    return {end.name: (end.kind, end.type, end.conditional) for end in node.endpoints}


def test_names_are_expanded_and_remapped_as_those_of_a_node_that_is_here(started):
    [node] = started(
        '<node pkg="acme_drivers" exec="base" name="left" namespace="rover"><remap from="odom" to="/odo/left"/></node>',
        "jazzy",
    )
    assert node.name == "/rover/left"
    assert ends(node) == {
        "/odo/left": ("publisher", "nav_msgs/msg/Odometry", False),
        "/rover/cmd_vel": ("subscriber", "geometry_msgs/msg/TwistStamped", False),
        "/rover/left/stop": ("service", "std_srvs/srv/Trigger", False),
        "/rover/scan": ("publisher", "sensor_msgs/msg/LaserScan", False),
    }


def test_a_parameter_of_the_launch_file_decides_a_name(started):
    line = '<node pkg="acme_drivers" exec="base"><param name="scan_topic" value="/scan/{}"/></node>'
    [node] = started(line.format("front"), "humble")
    assert "/scan/front" in ends(node)
    [node] = started(line.format("$(env PLACE)"), "humble")
    assert "/scan" not in ends(node), "what the parameter is set to is not known"


def test_without_a_distribution_only_what_all_have_alike_is_certain(started):
    [node] = started('<node pkg="acme_drivers" exec="base"/>')
    certain = {end.name for end in node.endpoints if not end.conditional}
    assert certain == {"/odom", "/scan"}
    assert node.known is not None and node.known.complete


def test_a_distribution_that_was_not_read_leaves_all_of_it_open(started):
    [node] = started('<node pkg="acme_drivers" exec="base"/>', "rolling")
    assert all(end.conditional for end in node.endpoints)
    assert node.is_stranger


def test_a_component_goes_by_its_class(started):
    [node, _] = started(
        '<node_container pkg="rclcpp_components" exec="component_container" name="box" namespace="">'
        '<composable_node pkg="acme_drivers" plugin="acme::Base" name="base"/></node_container>',
        "humble",
    )
    assert "/odom" in ends(node)


def test_what_nothing_knows_stays_a_stranger(started):
    [node] = started('<node pkg="acme_drivers" exec="camera"/>')
    assert (node.known, list(node.endpoints), node.is_stranger) == (None, [], True)


def test_a_package_of_the_workspace_is_not_the_one_that_is_known(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(tmp_path)
    write_robot(tmp_path / "robot", '<node pkg="acme_drivers" exec="base"/>')
    request = Request(
        (".",), Settings(external_nodes=(TURTLE,)), cached=False, jobs=1, launch="robot/launch/it.launch.xml"
    )
    [node] = graph(request).nodes
    assert node.known is not None
    write_files(
        tmp_path / "acme_drivers", {"package.xml": manifest("acme_drivers")}
    )  # a fork, of which nothing is read
    [node] = graph(request).nodes
    assert (node.external, node.known) == (True, None)


def test_the_arguments_of_a_bridge_say_what_it_has(started):
    [node] = started(
        '<node pkg="ros_gz_bridge" exec="parameter_bridge" args="'
        "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan /cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist "
        '/clock@rosgraph_msgs/msg/Clock@gz.msgs.Clock"/>'
    )
    assert [(end.kind, end.name, end.conditional) for end in node.endpoints] == [
        ("publisher", "/clock", True),
        ("subscriber", "/clock", False),
        ("subscriber", "/cmd_vel", False),
        ("publisher", "/scan", False),
    ]
    assert not node.is_stranger


@pytest.mark.parametrize(
    "more",
    ['<param name="config_file" value="bridge.yaml"/>', '<param from="elsewhere.yaml"/>'],
    ids=["file", "params"],
)
def test_a_bridge_may_have_more_than_its_arguments_say(started, more: str):
    [node] = started(
        '<node pkg="ros_gz_bridge" exec="parameter_bridge" args="/a@std_msgs/msg/Bool[gz.msgs.Boolean">'
        + more
        + "</node>"
    )
    assert node.is_stranger


@pytest.mark.parametrize(
    ("program", "option"),
    [
        ('pkg="ros_gz_sim" exec="create"', "-topic robot_description"),
        ('pkg="ros_gz_sim" exec="create"', "--topic=robot_description"),
        ('pkg="gazebo_ros" exec="spawn_entity.py"', "-entity robot -topic robot_description"),
    ],
)
def test_what_spawns_a_model_listens_where_its_arguments_say(started, program: str, option: str):
    [node] = started(f'<node {program} args="{option} -z 0.1"/>')
    subscribed = [(end.name, end.type) for end in node.endpoints if end.kind == "subscriber" and not end.conditional]
    assert subscribed == [("/robot_description", "std_msgs/msg/String")]
    assert node.is_stranger  # plug-ins of the simulator have ends of their own


@pytest.mark.parametrize("arguments", ['args="-file robot.sdf -name topic"', 'args="-topic"', ""])
def test_what_spawns_a_model_of_a_file_listens_to_nothing(started, arguments: str):
    [node] = started(f'<node pkg="ros_gz_sim" exec="create" {arguments}/>')
    assert list(node.endpoints) == []


def test_a_bridge_of_images_publishes_what_its_arguments_name(started):
    [node] = started('<node pkg="ros_gz_image" exec="image_bridge" args="/front/image depth" namespace="rover"/>')
    assert [(end.kind, end.name) for end in node.endpoints] == [
        ("publisher", "/front/image"),
        ("publisher", "/rover/depth"),
    ]


def test_the_costmap_of_a_server_has_a_namespace_of_its_own(started):
    [costmap, server] = started(
        '<node pkg="nav2_planner" exec="planner_server" name="planner" namespace="rover"/>', "jazzy"
    )
    assert (costmap.name, server.name) == ("/rover/global_costmap/global_costmap", "/rover/planner")
    assert "/rover/global_costmap/costmap" in ends(costmap)
    assert ends(server)["/rover/compute_path_to_pose"][0] == "action_server"


def test_the_json_says_where_it_is_known_from(started, tmp_path: Path):
    write_robot(tmp_path, '<node pkg="robot_state_publisher" exec="robot_state_publisher"/>')
    request = Request((".",), Settings(distro="jazzy"), cached=False, jobs=1, launch="launch/it.launch.xml")
    [node] = document(graph(request))["nodes"]
    assert node["external"] and node["known_from"] == {
        "source": "https://github.com/ros2-gbp/robot_state_publisher-release",
        "versions": {"jazzy": "3.3.4"},
        "open": [],
    }
    assert [end["name"] for end in node["publishers"]] == ["/robot_description", "/tf", "/tf_static"]


def test_the_table_is_read_only_where_something_is_started_that_is_not_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(external_nodes, "FILE", tmp_path / "no such table.json")
    external_nodes.well_known.cache_clear()
    request = Request((".",), Settings(), cached=False, jobs=1, launch="launch/it.launch.xml")
    write_robot(tmp_path, '<node pkg="robot" exec="talker"/>')
    assert [node.name for node in graph(request).nodes] == ["/talker"]
    write_robot(tmp_path, '<node pkg="acme" exec="camera"/>')
    with pytest.raises(NothingToDo):
        graph(request)


@pytest.mark.parametrize(
    ("inside", "is_open"),
    [
        ("", False),
        ('<param name="rate" value="30"/>', False),
        ('<param name="source_list" value="[arm/joint_states]"/>', True),
        ('<param from="elsewhere.yaml"/>', True),
    ],
    ids=["nothing", "another parameter", "the parameter", "a file"],
)
def test_a_question_that_a_parameter_decides_is_open_where_that_may_be_set(started, inside: str, is_open: bool):
    [node] = started(f'<node pkg="joint_state_publisher" exec="joint_state_publisher">{inside}</node>')
    assert node.is_stranger is is_open


@pytest.mark.parametrize("arguments", ["--ros-args -p source_list:=[a]", "$(var unknown)"])
def test_an_argument_may_set_the_parameter_that_decides(started, arguments: str):
    declared = '<arg name="unknown"/>'
    [node] = started(f'{declared}<node pkg="joint_state_publisher" exec="joint_state_publisher" args="{arguments}"/>')
    assert node.is_stranger
