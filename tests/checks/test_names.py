from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

SCRIPT = """
    import sys

    import rclpy
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer
    from rclpy.parameter_client import AsyncParameterClient
    from std_msgs.msg import String
    from std_srvs.srv import Trigger
    from tf2_ros import TransformBroadcaster

    SCAN = '/robot/scan'{mark}


    def main():
        rclpy.init()
        node = rclpy.create_node('script')
        {lines}


    if __name__ == '__main__':
        main()
"""


def script(*lines: str, mark: str = "") -> str:
    """``mark`` follows the constant ``SCAN``."""
    return SCRIPT.format(lines="\n        ".join(lines), mark=mark)


class TestHardcodedName:
    @pytest.mark.parametrize(
        "line",
        [
            "node.create_publisher(String, '/words', 10)",
            "node.create_subscription(String, '/words', print, 10)",
            "node.create_service(Trigger, '/go', print)",
            "node.create_client(Trigger, '/go')",
            "ActionClient(node, Fibonacci, '/count')",
            "ActionServer(node, Fibonacci, '/count', print)",
            "node.create_publisher(String, f'{SCAN}/filtered', 10)",
            "node.create_publisher(String, SCAN + '/filtered', 10)",
            "node.create_publisher(String, topic='/words', qos_profile=10)",
        ],
    )
    def test_an_absolute_name_in_the_code(self, judge: Judge, line: str):
        judge("NME001", script(line + "  # here"))

    @pytest.mark.parametrize(
        "lines",
        [
            ("node.create_publisher(String, 'words', 10)",),
            ("node.create_publisher(String, '~/words', 10)",),
            ("node.create_publisher(String, '/tf', 10)",),
            ("TransformBroadcaster(node)",),
            ("node.create_publisher(String, node.declare_parameter('topic', '/words').value, 10)",),
            ("node.create_publisher(String, f\"/{node.declare_parameter('robot', 'a').value}/scan\", 10)",),
            ("node.create_publisher(String, sys.argv[1], 10)",),
            ("node.create_publisher(String, '/' + sys.argv[1], 10)",),
            ("node.create_publisher(String, '/' + node.get_name() + '/words', 10)",),
            ("AsyncParameterClient(node, '/other')",),
        ],
        ids=[
            "relative",
            "private",
            "conventional",
            "a library's own",
            "parameter",
            "made of a parameter",
            "argument of the program",
            "made of an argument",
            "made of the node's name",
            "another node's parameters",
        ],
    )
    def test_other_names(self, judge: Judge, lines: tuple[str, ...]):
        judge("NME001", script(*lines))

    @pytest.mark.parametrize(("type", "mark"), [("Int32", ""), ("String", "  # here")])
    def test_a_node_that_has_a_relative_name_of_another_type(self, judge: Judge, type: str, mark: str):
        """A converter takes in ``words`` and gives ``/words``: one form for both would be one topic of two types."""
        lines = (
            f"node.create_publisher(String, '/words', 10){mark}",
            f"node.create_subscription({type}, 'words', print, 10)",
        )
        judge("NME001", script(*lines).replace("import String", "import Int32, String"))

    def test_the_default_of_an_argument_is_for_the_caller_to_change(self, judge: Judge):
        judge(
            "NME001",
            script(
                "def publisher(topic='/words', prefix='/robot'):",
                "    node.create_publisher(String, topic, 10)",
                "    node.create_publisher(String, f'{prefix}/words', 10)",
                "publisher()",
            ),
        )

    @pytest.mark.parametrize(
        "name",
        [
            "options.topic",
            "Settings().topic",
            "Settings().other",
            "getattr(node, 'topic', '/words')",
            "getattr(json.load(sys.stdin), 'topic', '/words')",
            "os.environ.get('TOPIC', '/words')",
            "{**json.load(sys.stdin)}.get('topic', '/words')",
        ],
    )
    def test_the_default_of_a_setting_is_for_the_user_to_change(self, judge: Judge, name: str):
        source = """
            import argparse, json, os, sys
            from dataclasses import dataclass, field

            import rclpy
            from std_msgs.msg import String


            @dataclass
            class Settings:
                topic: str = '/words'
                other: str = field(default='/words')


            parser = argparse.ArgumentParser()
            parser.add_argument('--topic', default='/words')
            options = parser.parse_args()
            rclpy.init()
            node = rclpy.create_node('script')
            node.create_publisher(String, {name}, 10){mark}
        """

        judge("NME001", source.replace("{name}", name).replace("{mark}", ""))
        judge("NME001", source.replace("{name}", "Settings('/words').topic").replace("{mark}", "  # here"))

    @pytest.mark.parametrize(("last", "mark"), [("return words[0]", ""), ("raise ValueError(words)", "  # here")])
    def test_one_of_what_a_user_may_say_is_not_fixed(self, judge: Judge, last: str, mark: str):
        text = """
            import sys

            import rclpy
            from rclpy.node import Node
            from std_msgs.msg import String


            def topic_of(words):
                if len(words) < 2:
                    return '/unknown'{mark}
                {last}


            class Parser(Node):
                def __init__(self):
                    super().__init__('parser')
                    self.create_publisher(String, topic_of(sys.argv), 10)


            def main():
                rclpy.init()
                rclpy.spin(Parser())


            if __name__ == '__main__':
                main()
        """
        judge("NME001", text.replace("{last}", last).replace("{mark}", mark))

    def test_a_name_that_is_passed_on_is_found_where_it_is_written(self, judge: Judge):
        [found] = judge(
            "NME001",
            script(
                "def publisher(topic):",
                "    node.create_publisher(String, topic, 10)",
                "publisher('/left')  # here",
                "publisher('/right')",
            ),
        )

        assert [(related.place.line, related.message) for related in found.related] == [(20, "the topic '/right'")]

    def test_a_constant_is_found_where_it_is_written(self, judge: Judge):
        [found] = judge("NME001", script("node.create_publisher(String, SCAN, 10)", mark="  # here"))

        assert [(one.place.line, one.message) for one in found.related] == [
            (17, "the topic is created under this name here")
        ]

    def test_names_that_the_team_allows(self, judge: Judge):
        judge(
            "NME001",
            script(
                "node.create_publisher(String, '/fleet/state', 10)",
                "node.create_publisher(String, '/bus/words', 10)  # here",
            ),
            config="""
            [rules.hardcoded-name]
            allow = ["/fleet/*"]
            """,
        )

    def test_relative_names_for_those_who_want_parameters_everywhere(self, judge: Judge):
        judge(
            "NME001",
            script(
                "node.create_publisher(String, 'words', 10)  # here",
                "node.create_publisher(String, node.declare_parameter('topic', 'words').value, 10)",
            ),
            config="""
            [rules.NME001]
            relative = true
            """,
        )

    def test_a_name_put_together_from_parts_that_are_fixed_for_some_callers_only(self, judge: Judge):
        judge(
            "NME001",
            script(
                "def listen(robot): node.create_subscription(String, f'/{robot}/pose', print, 10)",
                "listen('origin')",
                "listen(node.declare_parameter('robot', 'left').value)",
            ),
        )
        judge(
            "NME001",
            script(
                "def listen(robot): node.create_subscription(String, f'/{robot}/pose', print, 10)  # here",
                "listen('origin')",
            ),
        )

    def test_a_name_that_ros_rejects_has_a_worse_fault(self, judge: Judge):
        judge("NME001", script("node.create_publisher(String, '/my-words', 10)"))


ROBOT = """
    import rclpy
    from gazebo_msgs.srv import SpawnEntity
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Empty, Trigger
    {top}

    class Robot(Node):
        def __init__(self):
            super().__init__('robot')
            {lines}


    def main():
        rclpy.init()
        rclpy.spin(Robot())


    main()
"""


ATTACH = "from linkattacher_msgs.srv import AttachLink"
AUTOWARE = "from autoware_system_msgs.msg import AutowareState"
TRANSFORMS = "from tf2_msgs.msg import TFMessage"
FLEET = "from rmf_fleet_msgs.msg import PathRequest"


def robot(*lines: str, top: str = "") -> str:
    return ROBOT.format(lines="\n            ".join(lines), top=top)


class TestHardcodedNamesOfOneClass:
    def test_they_are_one_finding_at_the_first(self, judge: Judge):
        [found] = judge(
            "NME001",
            robot(
                "self.create_publisher(String, 'words', 10)",
                "self.create_publisher(String, '/words', 10)  # here",
                "self.create_subscription(String, '/words', print, 10)",
                "self.create_client(Trigger, '/reset')",
            ),
        )

        assert found.message == (
            "2 names of Robot are absolute and fixed in the code, such as the topic '/words', beside relative names of "
            "the same node such as 'words': in a namespace, only those move"
        )
        assert [(one.place.line, one.message) for one in found.related] == [
            (13, "the topic '/words'"),
            (14, "the service '/reset'"),
        ]

    def test_what_is_suppressed_is_not_counted(self, judge: Judge):
        [found] = judge(
            "NME001",
            robot(
                "self.create_publisher(String, '/words', 10)  # archlint: ignore[NME001]",
                "self.create_publisher(String, '/more', 10)  # here",
            ),
        )

        assert "the topic '/more' is absolute" in found.message and not found.related

    def test_several_classes_without_relative_names_are_one_finding(self, judge: Judge):
        [found] = judge(
            "NME001",
            robot("self.create_publisher(String, '/words', 10)  # here"),
            robot("self.create_publisher(String, '/words', 10)"),
        )

        assert [one.place.file for one in found.related] == ["node1.py"]

    def test_constants_of_another_module_are_one_finding_there(self, judge: Judge):
        top = "from node import SAID, HEARD"
        [found] = judge(
            "NME001",
            """
            SAID = '/said'  # here
            HEARD = '/heard'
            """,
            robot("self.create_publisher(String, SAID, 10)", top=top),
            robot("self.create_publisher(String, HEARD, 10)", top=top),
        )

        assert [one.place.line for one in found.related] == [2]

    @pytest.mark.parametrize(
        "lines",
        [
            (
                "robot = self.declare_parameter('robot', '').value",
                "topic = f'/{robot}/words' if robot else '/words'",
                "self.create_publisher(String, topic, 10)",
            ),
            (
                "shared = self.declare_parameter('shared', False).value",
                "self.create_publisher(String, '/words' if shared else 'words', 10)",
            ),
            (
                "if self.declare_parameter('shared', False).value:",
                "    self.create_publisher(String, '/words', 10)",
                "else:",
                "    self.create_publisher(String, 'words', 10)",
            ),
        ],
        ids=["made absolute by a parameter", "chosen", "one of two calls"],
    )
    def test_one_of_the_forms_that_whoever_starts_the_node_can_choose(self, judge: Judge, lines: tuple[str, ...]):
        judge("NME001", robot(*lines))

    @pytest.mark.parametrize(
        "lines",
        [
            ("self.create_publisher(String, '/fmu/in/arming', 10)",),
            ("self.create_client(Trigger, '/world/empty/create')",),
            ("self.create_publisher(String, '/model/arm/joint/wrist/cmd_vel', 10)",),
            ("self.create_subscription(String, '/model/rover/odometry', print, 10)",),
            ("self.create_client(SpawnEntity, '/spawn_entity')",),
            ("self.create_client(Empty, '/reset_world')",),
            ("self.create_subscription(String, '/utlidar/cloud', print, 10)",),
            ("self.create_publisher(String, '/api/loco/request', 10)",),
            (f"{FLEET}; self.create_publisher(PathRequest, '/robot_path_requests', 10)",),
            (f"{ATTACH}; self.create_client(AttachLink, '/ATTACHLINK')",),
            (f"{AUTOWARE}; self.create_subscription(AutowareState, '/awapi/state', print, 10)",),
            ("self.create_subscription(String, '/scanner_sdk_node/words', print, 10)",),
            ("self.create_publisher(String, '/arm_controller/commands', 10)",),
            ("self.create_client(Trigger, '/controller_manager/switch_controller')",),
        ],
        ids=[
            "PX4's",
            "Gazebo's",
            "Gazebo's for a joint",
            "Gazebo's for a model that drives",
            "Gazebo's by its type",
            "a service of Gazebo's for all robots",
            "Unitree's",
            "a service of Unitree's",
            "Open-RMF's by its type",
            "a Gazebo plugin's by its type",
            "Autoware's by name and type",
            "below the name of a node from elsewhere",
            "a controller's",
            "a controller manager's",
        ],
    )
    def test_names_that_something_outside_of_the_workspace_chooses(self, judge: Judge, lines: tuple[str, ...]):
        judge("NME001", robot(*lines))

    def test_what_the_tools_of_rviz_send_to_is_named_by_rviz(self, judge: Judge):
        judge("NME001", robot("self.create_subscription(String, '/clicked_point', print, 10)"))
        judge("NME001", robot("self.create_subscription(String, '/clicked_points', print, 10)  # here"))

    def test_a_node_that_speaks_with_autoware_uses_its_names(self, judge: Judge):
        other = "self.create_subscription(String, '/localization/pose', print, 10)"
        with_it = f"{AUTOWARE}; self.create_subscription(AutowareState, '/awapi/state', print, 10)"
        judge("NME001", robot(with_it, other))
        [alone] = judge("NME001", robot(f"{other}  # here"))
        assert alone.severity is Severity.WARNING

    def test_a_name_that_a_helper_goes_on_with_is_told_where_it_begins(self, judge: Judge):
        wrapper = "def ask(name):\n                return self.create_client(Trigger, f'{name}/get_state')"
        judge("NME001", robot(wrapper, "ask('/left')  # here", "ask('right')"))
        whole = wrapper.replace("f'{name}", "f'/{name}").replace("get_state')", "get_state')  # here")
        judge("NME001", robot(whole, "ask('left')"))

    def test_a_copy_of_tf_is_a_topic_for_all_robots_too(self, judge: Judge):
        judge("NME001", robot(f"{TRANSFORMS}; self.create_subscription(TFMessage, '/tf_static_old', print, 10)"))
        judge("NME001", robot("self.create_subscription(String, '/tf_static_old', print, 10)  # here"))
        judge("NME001", robot(f"{TRANSFORMS}; self.create_subscription(TFMessage, '/frames', print, 10)  # here"))

    def test_types_of_another_system_between_nodes_of_the_workspace(self, judge: Judge):
        talker = robot("self.create_publisher(PathRequest, '/plan', 10)  # here")
        listener = robot("self.create_subscription(PathRequest, '/plan', print, 10)").replace("robot'", "fleet'")
        [found] = judge("NME001", talker, listener)

        assert found.severity is Severity.WARNING and len(found.related) == 1

    def test_types_of_another_system_below_a_namespace_of_the_workspace(self, judge: Judge):
        [found] = judge("NME001", robot("self.create_publisher(PathRequest, '/site_2/plan', 10)  # here", top=FLEET))

        assert found.severity is Severity.WARNING

    @pytest.mark.parametrize(
        "lines",
        [
            (
                "self.create_subscription(String, '/other_node/words', print, 10)  # here",
                "self.other = rclpy.create_node('other_node')",
            ),
            ("self.create_subscription(String, '/camera/words', print, 10)  # here",),
            ("self.create_client(Trigger, '/spawn_entity')  # here",),
            ("self.create_subscription(String, '/other_node', print, 10)  # here",),
            ("self.create_subscription(String, '/model/joint/words', print, 10)  # here",),
        ],
        ids=[
            "below the name of a node that is here",
            "below some name",
            "Gazebo's name for another type",
            "no name below it",
            "no joint of a model",
        ],
    )
    def test_names_that_nothing_outside_is_seen_to_fix(self, judge: Judge, lines: tuple[str, ...]):
        [found] = judge("NME001", robot(*lines))

        assert found.severity is Severity.WARNING

    @pytest.mark.parametrize(("other", "mark"), [("words", ""), ("{robot}", ""), ("state", "  # here")])
    def test_a_branch_with_another_topic_of_the_type(self, judge: Judge, other: str, mark: str):
        lines = (
            "robot = read()",
            "if robot:",
            f"    self.create_subscription(String, f'/robot_{{robot}}/out/{other}', print, 10)",
            "else:",
            f"    self.create_subscription(String, '/swarm/words', print, 10){mark}",
        )
        judge("NME001", robot(*lines))

    def test_a_branch_that_only_picks_one_of_two_absolute_names_is_no_reason(self, judge: Judge):
        [found] = judge(
            "NME001",
            robot(
                "left = self.declare_parameter('left', True).value",
                "topic = '/left' if left else '/right'  # here",
                "self.create_publisher(String, topic, 10)",
            ),
        )

        assert found.severity is Severity.WARNING


class TestInvalidName:
    @pytest.mark.parametrize(
        "name", ["front-camera", "", "scan/", "2d", "a/2d", "~scan", "a~", "{robot}/x", "a//b", "/", "{ns}/x"]
    )
    def test_names_that_rcl_refuses(self, judge: Judge, name: str):
        judge("NME002", script(f"node.create_publisher(String, {name!r}, 10)  # here"))

    @pytest.mark.parametrize("name", ["scan", "/scan", "~", "~/scan", "{node}/scan", "a__b", "A/b2"])
    def test_names_that_rcl_takes(self, judge: Judge, name: str):
        judge("NME002", script(f"node.create_publisher(String, {name!r}, 10)"))

    @pytest.mark.parametrize("name", ["[Namespace]/scan", "/<robot>/scan", "<your name>/scan"])
    def test_names_that_the_reader_is_to_fill_in(self, judge: Judge, name: str):
        judge("NME002", script(f"node.create_publisher(String, {name!r}, 10)"))

    @pytest.mark.parametrize(
        ("arguments", "wrong"),
        [
            ("'<robot>'", False),
            ("'front-camera'", True),
            ("'left/camera'", True),
            ("''", True),
            ("'camera', namespace='left-side'", True),
            ("'camera', namespace='/left'", False),
            ("'camera', namespace=''", False),
        ],
    )
    def test_nodes(self, judge: Judge, arguments: str, wrong: bool):
        mark = "  # here" if wrong else ""
        judge("NME002", script(f"rclpy.create_node({arguments}){mark}"))

    def test_a_default_that_rcl_refuses(self, judge: Judge):
        [found] = judge(
            "NME002",
            script(
                "topic = node.declare_parameter('topic', 'my topic').value",
                "node.create_publisher(String, topic, 10)  # here",
            ),
        )

        assert "the default of the parameter 'topic'" in found.message

    def test_parameters_of_one_node_with_the_same_default(self, judge: Judge):
        [found] = judge(
            "NME002",
            script(
                "left = node.declare_parameter('left_topic', 'my topic').value",
                "right = node.declare_parameter('right_topic', 'my topic').value",
                "node.create_publisher(String, left, 10)  # here",
                "node.create_publisher(String, right, 10)",
            ),
        )

        assert found.message.endswith("; so is the default of 'right_topic'")
        assert [row.message for row in found.related][-1] == "it is used here"

    def test_parameters_with_different_defaults_are_findings_of_their_own(self, judge: Judge):
        found = judge(
            "NME002",
            script(
                "left = node.declare_parameter('left_topic', 'left topic').value",
                "right = node.declare_parameter('right_topic', 'right topic').value",
                "node.create_publisher(String, left, 10)  # here",
                "node.create_publisher(String, right, 10)  # here",
            ),
        )

        assert len(found) == 2

    def test_a_parameter_that_decides_whether_its_name_is_used(self, judge: Judge):
        judge(
            "NME002",
            script(
                "topic = node.declare_parameter('topic', '').value",
                "if node.declare_parameter('publish', False).value:",
                "    node.create_publisher(String, topic, 10)",
            ),
        )

    def test_a_name_that_a_loop_leaves_out(self, judge: Judge):
        judge(
            "NME002",
            script(
                "for given in sys.argv[1:]:",
                "    topic = given if len(given) > 3 else ''",
                "    if not topic or given in sys.path:",
                "        continue",
                "    node.create_publisher(String, topic, 10)",
            ),
        )

    def test_a_name_of_which_a_part_is_not_known(self, judge: Judge):
        judge("NME002", script("node.create_publisher(String, sys.argv[1] + '/words', 10)"))

    def test_the_complete_name_is_shown_where_only_that_is_wrong(self, judge: Judge):
        [found] = judge("NME002", script("node.create_publisher(String, '{ns}/scan', 10)  # here"))

        assert "(full name: '//scan')" in found.message

    @pytest.mark.parametrize(
        "lines",
        [
            ("topic = 'words/'", "for part in sys.argv[1:]:", "    topic += part"),
            ("topic = ''", "for part in sys.argv[1:]:", "    topic = topic + '/' + part"),
            ("topic = 'words/'", "if len(sys.argv) > 1:", "    topic += sys.argv[1]"),
            ("topic = ''", "for part in sys.argv[1:]:", "    topic = part"),
        ],
    )
    def test_a_text_that_is_not_finished(self, judge: Judge, lines: tuple[str, ...]):
        judge("NME002", script(*lines, "node.create_publisher(String, topic, 10)"))

    @pytest.mark.parametrize(
        "topic",
        [
            "str(given.get('topic', '') or '')",
            "given.get('topic', '')",
            "given['topic'] if 'topic' in given else '?'",
        ],
    )
    def test_what_stands_where_a_file_does_not_say(self, judge: Judge, topic: str):
        lines = ["import json", "given = json.load(open('a.json'))", f"topic = {topic}"]
        judge("NME002", script(*lines, "node.create_publisher(String, topic, 10)"))

    @pytest.mark.parametrize("topic", ["''", "str('' or '')", "'?'"])
    def test_a_bad_name_that_is_the_only_one(self, judge: Judge, topic: str):
        create = f"node.create_publisher(String, {topic}, 10)  # here"
        judge("NME002", script(create))
        judge("NME002", script("if len(sys.argv) > 1:", f"    {create}"))

    def test_names_that_begin_with_an_empty_namespace_are_one_finding(self, judge: Judge):
        lines = ["space = node.get_namespace()", "node.create_publisher(String, f'{space}/words', 10)  # here"]
        [found] = judge("NME002", script(*lines, "node.create_client(Trigger, f'{space}/go')"))
        assert "the topic name '//words' of a node in no namespace: " in found.message
        assert found.message.endswith("; the same applies to '//go'")
        assert found.help == "write the relative name 'words': ROS adds the node's namespace"
        [alone] = judge("NME002", script(*lines, "node.create_client(Trigger, 'go')"))
        assert "the same goes" not in alone.message
        judge("NME002", script("node.create_publisher(String, 'words', 10)"))  # the advice works

    def test_a_text_of_which_either_form_is_finished(self, judge: Judge):
        judge(
            "NME002",
            script(
                "topic = 'my-words' if len(sys.argv) > 1 else 'words'",
                "node.create_publisher(String, topic, 10)  # here",
            ),
        )

    def test_a_node_with_a_bad_name_has_other_bad_names_too(self, judge: Judge):
        judge(
            "NME002",
            script(
                "node = rclpy.create_node('my-script')  # here",
                "node.create_publisher(String, 'my-words', 10)  # here",
                "node.create_publisher(String, 'words', 10)",
                "node.create_client(Trigger, '~go')  # here",
            ),
        )


def test_a_name_that_the_node_resolves_follows_its_namespace(judge: Judge):
    judge("NME001", script("node.create_publisher(String, node.resolve_topic_name('words'), 10)"))
    judge("NME001", script("node.create_publisher(String, node.resolve_topic_name('/words'), 10)  # here"))


@pytest.mark.parametrize(
    ("lines", "others"),
    [
        (
            (
                "name = 'base/' + '/%s'",
                "node.create_publisher(String, name % 'left', 10)  # here",
                "node.create_publisher(String, name % 'right', 10)",
            ),
            "; another name of the file goes the same way",
        ),
        (
            (
                "base = 'base/'",
                "node.create_publisher(String, base + '/left', 10)  # here",
                "node.create_client(Trigger, base + '/go')",
                "for side in ('right', 'rear'):",
                "    node.create_publisher(String, f'{base}/{side}', 10)",
            ),
            "; 3 more names of the file go the same way",
        ),
        (
            (
                "for leg in ('fl', 'fr', 'rl'):",
                "    node.create_publisher(String, f'{leg}//go', 10)  # here",
            ),
            "; 2 more names of the file go the same way",
        ),
        (("node.create_publisher(String, 'base//left', 10)  # here",), ""),
    ],
    ids=["a pattern", "one beginning", "one line of a loop", "a single name"],
)
def test_names_that_one_text_makes_wrong_are_one_finding(judge: Judge, lines: tuple[str, ...], others: str):
    [finding] = judge("NME002", script(*lines))
    assert finding.message.endswith("topic name must not contain repeated '/'" + others)
    assert all(related.message.endswith("' is used here") for related in finding.related[-len(lines) + 2 :])


def test_names_that_are_wrong_for_themselves_are_told_each(judge: Judge):
    judge(
        "NME002",
        script(
            "node.create_publisher(String, 'left-wheel', 10)  # here",
            "node.create_publisher(String, 'right-wheel', 10)  # here",
            "node.create_publisher(String, 'left/1', 10)  # here",
        ),
    )
