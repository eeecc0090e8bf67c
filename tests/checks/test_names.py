from __future__ import annotations

import pytest

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

    SCAN = '/robot/scan'


    def main():
        rclpy.init()
        node = rclpy.create_node('script')
        {lines}


    if __name__ == '__main__':
        main()
"""


def script(*lines: str) -> str:
    return SCRIPT.format(lines="\n        ".join(lines))


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
            "node.create_publisher(String, SCAN, 10)",
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

    def test_a_name_that_is_passed_on_is_shown_where_it_is_written(self, judge: Judge):
        [found] = judge(
            "NME001",
            script(
                "def publisher(topic):",
                "    node.create_publisher(String, topic, 10)  # here",
                "publisher('/left')",
                "publisher('/right')",
            ),
        )

        assert [(related.place.line, related.message) for related in found.related] == [
            (19, "'/left' is written here"),
            (20, "'/right' is written here"),
        ]

    def test_a_constant_is_shown_where_it_is_written(self, judge: Judge):
        [found] = judge("NME001", script("node.create_publisher(String, SCAN, 10)  # here"))

        assert [related.place.line for related in found.related] == [11]

    def test_names_that_the_team_allows(self, judge: Judge):
        judge(
            "NME001",
            script(
                "node.create_publisher(String, '/fleet/state', 10)",
                "node.create_publisher(String, '/words', 10)  # here",
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


class TestInvalidName:
    @pytest.mark.parametrize(
        "name", ["front-camera", "", "scan/", "2d", "a/2d", "~scan", "a~", "{robot}/x", "a//b", "/", "{ns}/x"]
    )
    def test_names_that_rcl_refuses(self, judge: Judge, name: str):
        judge("NME002", script(f"node.create_publisher(String, {name!r}, 10)  # here"))

    @pytest.mark.parametrize("name", ["scan", "/scan", "~", "~/scan", "{node}/scan", "a__b", "A/b2"])
    def test_names_that_rcl_takes(self, judge: Judge, name: str):
        judge("NME002", script(f"node.create_publisher(String, {name!r}, 10)"))

    @pytest.mark.parametrize(
        ("arguments", "wrong"),
        [
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

        assert "(complete: '//scan')" in found.message
