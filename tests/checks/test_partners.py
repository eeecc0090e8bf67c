"""TOP002 to TOP004, SRV001, ACT001 and the QoS rules, over systems written by hand."""

from __future__ import annotations

import pytest

from archlint.checks.near_misses import nearly_equal
from archlint.config.options import options_for
from archlint.config.settings import Settings
from archlint.engine.judging import judge
from archlint.finding import Finding, Place
from archlint.launch.kinds import FileKind, FileStatus, StartedKind
from archlint.launch.model import Gap, Included, Launched
from archlint.launch.named_files import FileReference
from archlint.launch.started import Started
from archlint.ros.qos import Qos
from archlint.systems.model import System
from archlint.systems.nodes import Node
from systems.builders import (
    action_client,
    action_server,
    client,
    exact,
    node,
    partial,
    publisher,
    service,
    subscriber,
    system,
    unknown,
)


def findings(found_in: System, *codes: str, **settings: object) -> list[Finding]:
    return list(judge(found_in, options_for(Settings(**settings), codes)))  # type: ignore[arg-type]


def subjects(found: list[Finding]) -> list[str]:
    return [f"{one.code} {one.identity[1]}" for one in found]


LONELY = ("TOP002", "TOP003", "SRV001", "ACT001")


def test_a_name_with_one_side_only():
    closed = system(
        node("/a", publisher("said"), subscriber("heard"), client("asked"), action_client("sent")),
        node("/b", service("offered"), action_server("done")),
        closed=True,
    )
    assert subjects(findings(closed, *LONELY)) == ["ACT001 /sent", "SRV001 /asked", "TOP002 /said", "TOP003 /heard"]


def test_an_open_system_has_partners_elsewhere():
    assert findings(system(node("/a", publisher("said"), subscriber("heard"))), *LONELY) == []


@pytest.mark.parametrize(
    "other",
    [
        node("/b", subscriber("said")),
        node("/b", subscriber("said", conditional=True)),
        node("/b", subscriber(unknown())),
        node("/b", subscriber(partial("sa*"))),
        node("/b", subscriber(unknown(), type=None)),
    ],
)
def test_whoever_may_be_the_partner_counts(other):
    assert findings(system(node("/a", publisher("said")), other, closed=True), "TOP002") == []


def test_a_node_of_unknown_name_with_another_type_is_no_partner():
    other = node("/b", subscriber(unknown(), type="std_msgs/msg/Bool"))
    assert subjects(findings(system(node("/a", publisher("said")), other, closed=True), "TOP002")) == ["TOP002 /said"]


def test_names_of_tools_and_of_others_are_left_out():
    closed = system(node("/a", publisher("/tf"), publisher("/x/said"), subscriber("/clock")), closed=True)
    assert findings(closed, *LONELY, external=("/x/*",)) == []


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("/camera/image", "/camera/images"),
        ("/cmdVel", "/cmd_vel"),
        ("/robot/comand_velocity", "/robot/command_velocity"),
        ("/odometry/filterd", "/odometry/filtered"),
        ("/cmd_vel", "/cmd_vell"),
        ("/sensor_dat", "/sensor_data"),
        ("/imu/data", "/imu_data"),
        ("/odom", "/doom"),
        ("/left_wheel_speed", "/speed_left_wheel"),
        ("/front_scn", "/front_scan"),
    ],
)
def test_names_that_are_nearly_equal(one: str, other: str):
    assert nearly_equal(one, other)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("/camera_1/image", "/camera_2/image"),
        ("/left/image", "/right/image"),
        ("/in", "/on"),
        ("/goal_x", "/goal_y"),
        ("/input", "/output"),
        ("/scan", "/robot/scan"),
        ("/camera/image_raw", "/camera/image"),
        ("/point", "/joint"),
        ("/cam", "/came"),
        ("/cmd_vel", "/cmd_acc"),
        ("/vel_min", "/vel_mini_max"),
        ("/current_mode", "/current_node"),
        ("/map_to_odom", "/odom_to_map"),
        ("/pi_board", "/board_pi"),  # from the one to the other, and back
        ("/left_wheel_speed", "/right_speed_wheel"),
    ],
)
def test_names_that_differ_on_purpose(one: str, other: str):
    assert not nearly_equal(one, other)


def test_a_near_miss_is_shown_with_both_ends():
    [found] = findings(
        system(node("/a", publisher("doors")), node("/b", subscriber("door")), node("/c", subscriber("other"))),
        "TOP004",
    )
    assert (found.node, found.related[0].message) == ("/b", "/a publishes '/doors'")


@pytest.mark.parametrize(("published", "asked", "at"), [("chartter", "chatter", "/a"), ("chatter", "chartter", "/b")])
def test_a_near_miss_of_a_name_that_everybody_knows_is_told_where_the_slip_is(published: str, asked: str, at: str):
    [found] = findings(system(node("/a", publisher(published)), node("/b", subscriber(asked))), "TOP004")
    assert found.node == at
    assert found.message.endswith("did you mean '/chatter'?")


@pytest.mark.parametrize(
    "nodes",
    [
        [node("/a", publisher("images"), subscriber("image"))],  # one node tells them apart
        [node("/a", publisher("images")), node("/b", subscriber("image", type="std_msgs/msg/Bool"))],
        [node("/a", publisher("images")), node("/b", subscriber("image")), node("/c", publisher("image"))],
        [node("/a", publisher("images")), node("/b", subscriber("image"), package="elsewhere")],
    ],
)
def test_no_near_miss(nodes):
    assert findings(system(*nodes), "TOP004") == []


@pytest.mark.parametrize(
    ("publishing", "subscribing", "launch", "near"),
    [
        ("/robot/wheels", "/odometry", "robot.launch.py", True),
        ("/wheels", "/robot/odometry", "robot.launch.py", False),  # the publisher asks for that name in so many words
        ("/fleet/robot/wheels", "/fleet/odometry", "robot.launch.py", True),
        ("/robot/wheels", "/odometry", None, False),  # some launch file may start both in the namespace
    ],
)
def test_a_namespace_that_one_end_lacks(publishing: str, subscribing: str, launch: str | None, near: bool):
    namespace = publishing.rpartition("/")[0] or "/robot"
    pair = system(
        node(publishing, publisher(f"{namespace}/odom")),
        node(subscribing, subscriber(f"{subscribing.rpartition('/')[0].removesuffix('/robot')}/odom")),
        name=launch,
    )
    assert bool(findings(pair, "TOP004")) is near


BEST_EFFORT = Qos(reliability="best_effort")
LATCHED = Qos(durability="transient_local")


@pytest.mark.parametrize(
    ("offered", "requested", "codes"),
    [
        (BEST_EFFORT, Qos(), ["QOS001"]),
        (Qos(), BEST_EFFORT, []),
        (Qos(), LATCHED, ["QOS002"]),
        (LATCHED, Qos(), []),
        (BEST_EFFORT, LATCHED, ["QOS001", "QOS002"]),
        (Qos(), Qos(deadline=0.1), ["QOS003"]),
        (Qos(deadline=0.1), Qos(deadline=0.5), []),
        (Qos(liveliness="automatic"), Qos(liveliness="manual_by_topic"), ["QOS003"]),
        (Qos(), Qos(liveliness="manual_by_topic"), []),  # the middleware decides the default
        (Qos(reliability="system_default"), Qos(), []),
        (Qos(reliability="best_available"), Qos(), []),
        (Qos(reliability=None), Qos(), []),
        (Qos(reliability="best_effort", overridable=True), Qos(), []),
    ],
)
def test_an_offer_and_a_request(offered: Qos, requested: Qos, codes: list[str]):
    pair = system(node("/a", publisher("said", qos=offered)), node("/b", subscriber("said", qos=requested)))
    assert [one.code for one in findings(pair, "QOS001", "QOS002", "QOS003")] == codes


def test_the_one_bad_publisher_of_three_is_named():
    [found] = findings(
        system(
            node("/good", publisher("said")),
            node("/bad", publisher("said", qos=BEST_EFFORT)),
            node("/fine", publisher("said")),
            node("/b", subscriber("said")),
        ),
        "QOS001",
    )
    assert [one.message for one in found.related] == ["/bad offers best effort"]


def test_who_is_heard_is_said_where_another_is_not():
    served = system(
        node("/good", publisher("said")),
        node("/bad", publisher("said", qos=BEST_EFFORT)),
        node("/b", subscriber("said")),
    )
    alone = system(node("/bad", publisher("said", qos=BEST_EFFORT)), node("/b", subscriber("said")))
    messages = [one.message.partition(": ")[2] for made in (served, alone) for one in findings(made, "QOS001")]
    assert messages == ["its messages do not arrive, those of /good do", "no message arrives"]


@pytest.mark.parametrize(
    ("qos", "wrong"),
    [
        (Qos(history="keep_all", depth=5, explicit=frozenset({"depth", "history"})), True),
        (Qos(history="keep_all"), False),
        (Qos(depth=0), True),
        (Qos(depth=1), False),
        (Qos(depth=None), False),
    ],
)
def test_a_profile_against_itself(qos: Qos, wrong: bool):
    assert bool(findings(system(node("/a", publisher("said", qos=qos))), "QOS004")) is wrong


# --- what must be in sight before anybody is missed

PLACE = Place("launch/robot.launch.py", 5, 1, 5, 20)


def launched(*nodes: Node, **parts: object) -> System:
    """A closed system that a launch file starts; ``parts`` are what that file holds besides the nodes."""
    launched = Launched(PLACE.file, "robot", **parts)  # type: ignore[arg-type]
    return system(*nodes, name=PLACE.file, closed=True, launched=launched)


def process(dormant: bool = False) -> Started:
    """``ros2 topic pub /heard …``, which no reader of its words would take for a node."""
    words = ["topic", "pub", "/heard"]
    return Started(StartedKind.PROCESS, unknown(), exact("ros2"), PLACE, PLACE.file, arguments=words, dormant=dormant)


def include(source: str | None) -> Included:
    status = FileStatus.INSTALLED if source else FileStatus.EXTERNAL
    found = FileReference(FileKind.LAUNCH, "camera.launch.py", source, status, "camera", PLACE)
    return Included(found, (), PLACE, PLACE.file)


@pytest.mark.parametrize(
    ("parts", "told"),
    [
        ({}, True),
        ({"started": [process()]}, False),
        ({"started": [process(dormant=True)]}, True),
        ({"included": [include(None)]}, False),
        ({"included": [include("launch/camera.launch.py")]}, True),
        ({"gaps": [Gap("a file that is read at run time", PLACE)]}, False),
    ],
)
def test_nobody_is_missed_while_somebody_is_out_of_sight(parts: dict[str, object], told: bool):
    found = launched(
        node("/a", publisher("said"), subscriber("heard"), client("asked"), action_client("sent")), **parts
    )
    assert bool(findings(found, *LONELY)) is told


def test_a_node_without_its_source_may_be_anybodys_partner():
    camera = Node("/camera", None, "camera", "camera_node", "unknown", external=True)
    assert findings(launched(node("/a", publisher("said"), subscriber("heard")), camera), *LONELY, "GRF001") == []


def test_a_library_may_do_what_it_likes_with_a_node_that_it_is_given():
    given = node("/a", subscriber("heard"))
    assert given.blueprint is not None
    given.blueprint.escapes = True
    assert findings(system(given, closed=True), "TOP003") == []


def test_tools_show_markers():
    markers = publisher("shapes", "visualization_msgs/msg/MarkerArray")
    assert findings(system(node("/a", markers), closed=True), "TOP002") == []


def test_a_name_is_proposed_where_a_slip_of_the_pen_explains_it():
    offered = service("/robot/set_speed")
    [slip] = findings(system(node("/a", client("/robot/set_sped")), node("/b", offered), closed=True), "SRV001")
    assert slip.message.endswith("did you mean '/robot/set_speed'?")
    [other] = findings(system(node("/a", client("/robot/get_speed")), node("/b", offered), closed=True), "SRV001")
    assert "did you mean" not in other.message


@pytest.mark.parametrize(
    ("user", "provider", "code"),
    [
        (client("/set_moter"), service("/set_motor"), "SRV001"),
        (client("/motors/enable"), service("/motor/enable"), "SRV001"),
        (action_client("/dock_robt"), action_server("/dock_robot"), "ACT001"),
    ],
)
def test_two_ends_that_almost_meet_need_no_closed_world(user, provider, code):
    [slip] = findings(system(node("/a", user), node("/b", provider)), code)
    assert slip.message.endswith(f"did you mean '{provider.name.text}'?")
    assert slip.help == "use the same name at both ends, or remap one in the launch file"


@pytest.mark.parametrize(
    ("user", "providers"),
    [
        (client("/get_speed"), [service("/set_speed")]),
        (client("/arm_1/enable"), [service("/arm_2/enable")]),
        (client("/set_moter"), [service("/set_motor"), client("/set_motor")]),
        (client("/set_moter", "std_srvs/srv/Trigger"), [service("/set_motor", "std_srvs/srv/SetBool")]),
    ],
    ids=["another word", "another number", "it has a client", "another type"],
)
def test_two_ends_that_are_meant_to_differ(user, providers):
    assert findings(system(node("/a", user), node("/b", *providers)), "SRV001") == []


# --- the shape of what is in sight


def test_an_isolated_node_may_talk_to_the_outside():
    three = [node("/a", publisher("said")), node("/b", subscriber("said")), node("/c", service("offered"))]
    assert [one.node for one in findings(system(*three, closed=True), "GRF001")] == ["/c"]
    assert findings(system(*three, closed=True), "GRF001", external=("/offered",)) == []
    assert findings(system(three[2], closed=True), "GRF001") == []  # alone, and not among others


def chain(middle: Node) -> list[Node]:
    """Two nodes on each side of another one."""
    return [
        node("/mission", publisher("goals"), subscriber("done")),
        node("/planner", subscriber("goals"), publisher("plans")),
        middle,
        node("/control", subscriber("commands"), publisher("effort")),
        node("/motor", subscriber("effort"), publisher("done")),
    ]


def test_the_one_node_that_holds_two_parts_together():
    nodes = chain(node("/bridge", subscriber("plans"), publisher("commands")))
    nodes[0] = node("/mission", publisher("goals"))
    nodes[4] = node("/motor", subscriber("effort"))
    assert [one.node for one in findings(system(*nodes), "GRF004")] == ["/bridge"]
    unseen = Node("/camera", None, "camera", "camera_node", "unknown", external=True)
    assert findings(system(*nodes, unseen), "GRF004") == []  # it may tie the parts, too
    assert findings(system(*nodes, node("/x", subscriber(unknown()))), "GRF004") == []


def test_a_second_way_is_enough():
    assert findings(system(*chain(node("/bridge", subscriber("plans"), publisher("commands")))), "GRF004") == []


def test_in_the_smallest_system_the_node_in_the_middle_is_the_single_point_of_failure():
    middle = node("/control", subscriber("/scan"), publisher("/cmd"))
    ends = [node("/sensor", publisher("/scan")), node("/motor", subscriber("/cmd"))]
    [found] = findings(system(middle, *ends), "GRF004")
    assert found.node == "/control"
    assert found.message == "without /control the system splits into 2 unconnected parts: {/motor}, {/sensor}"
    assert findings(system(*ends), "GRF004") == []


def test_a_node_that_hangs_on_a_larger_system_alone_splits_nothing():
    ring = [
        node("/a", publisher("/ab"), subscriber("/ca")),
        node("/b", publisher("/bc"), subscriber("/ab")),
        node("/c", publisher("/ca"), subscriber("/bc"), publisher("/led")),
        node("/lamp", subscriber("/led")),
    ]
    assert findings(system(*ring), "GRF004") == []
