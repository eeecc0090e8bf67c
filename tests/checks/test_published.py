from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
    import sys
    import rclpy
    from geometry_msgs.msg import Twist, TwistStamped
    from nav2_msgs.action import Spin
    from rclpy.action import ActionClient
    from std_msgs.msg import Bool, String
    from std_srvs.srv import SetBool, Trigger

    rclpy.init()
    node = rclpy.create_node('sender')
    flags = node.create_publisher(Bool, 'flags', 10)
    client = node.create_client(SetBool, 'enable')
    spin = ActionClient(node, Spin, 'spin')
    {line}
"""
SERVER = """
    import rclpy
    from nav2_msgs.action import Spin, Wait
    from rclpy.action import ActionServer
    from rclpy.node import Node


    class Spinner(Node):
        def __init__(self):
            super().__init__('spinner')
            ActionServer(self, Spin, 'spin', self.execute)

        def execute(self, goal_handle):
            {line}
            return Spin.Result()


    rclpy.init()
    rclpy.spin(Spinner())
"""


@pytest.mark.parametrize(
    ("line", "given"),
    [
        ("goal_handle.publish_feedback(Spin.Result())", "nav2_msgs/action/Spin.Result"),
        ("goal_handle.publish_feedback(0.5)", "0.5"),
        ("goal_handle.succeed(Spin.Feedback())", "nav2_msgs/action/Spin.Feedback"),
        ("goal_handle.abort(response=Wait.Result())", "nav2_msgs/action/Wait.Result"),
        ("goal_handle.canceled(True)", "True"),
        ("goal_handle.publish_feedback(goal_handle.request.target_yaw)", "a float"),
    ],
)
def test_what_a_goal_is_told(judge: Judge, line: str, given: str):
    [found] = judge("TOP005", SERVER.format(line=line + "  # here"))
    assert f"is called with {given}, but expects nav2_msgs/action/Spin." in found.message
    assert found.related[0].message == "the action server is created here"


@pytest.mark.parametrize(
    "line",
    [
        "goal_handle.publish_feedback(Spin.Feedback())",
        "goal_handle.succeed(Spin.Result())",
        "goal_handle.succeed()",
        "goal_handle.abort(None)",
        "goal_handle.canceled(self.outcome())",
    ],
)
def test_what_a_goal_may_be_told(judge: Judge, line: str):
    judge("TOP005", SERVER.format(line=line))


@pytest.mark.parametrize(
    ("line", "given"),
    [
        ("flags.publish(True)", "True"),
        ("flags.publish(String())", "std_msgs/msg/String"),
        ("flags.publish(Bool)", "the class std_msgs/msg/Bool itself"),
        ("flags.publish(None)", "None"),
        ("flags.publish({'data': True})", "a dict"),
        ("client.call_async(Trigger.Request())", "std_srvs/srv/Trigger.Request"),
        ("client.call_async(SetBool.Response())", "std_srvs/srv/SetBool.Response"),
        ("spin.send_goal_async(Spin.Result())", "nav2_msgs/action/Spin.Result"),
    ],
)
def test_a_wrong_argument(judge: Judge, line: str, given: str):
    [found] = judge("TOP005", NODE.format(line=line + "  # here"))
    assert f"is called with {given}, but expects" in found.message


@pytest.mark.parametrize(
    ("line", "help"),
    [
        ("client.call_async(SetBool())", "write SetBool.Request()"),
        ("spin.send_goal_async(Spin())", "write Spin.Goal()"),
    ],
)
def test_nothing_makes_objects_of_a_service_or_an_action(judge: Judge, line: str, help: str):
    [found] = judge("TOP005", NODE.format(line=line + "  # here"))
    assert "() raises NotImplementedError, before " in found.message
    assert found.help == help


@pytest.mark.parametrize(
    "line",
    [
        "flags.publish(Bool(data=True))",
        "flags.publish(b'serialized')",
        "flags.publish(sys.argv[1])",
        "client.call_async(SetBool.Request())",
        "spin.send_goal_async(Spin.Goal())",
    ],
)
def test_a_right_or_unknown_argument(judge: Judge, line: str):
    judge("TOP005", NODE.format(line=line))


@pytest.mark.parametrize(
    ("line", "given"),
    [
        ("flags.publish(node.get_parameter('flag'))", "an object of rclpy.parameter.Parameter"),
        ("flags.publish(client.call_async(SetBool.Request()))", "a future"),
        ("flags.publish(node)", "a node"),
        ("flags.publish(Duration(seconds=1))", "a Duration of rclpy"),
        ("client.call_async(node.get_parameter('flag'))", "an object of rclpy.parameter.Parameter"),
    ],
)
def test_an_object_of_rclpy(judge: Judge, line: str, given: str):
    declared = f"node.declare_parameter('flag', True); from rclpy.duration import Duration; {line}"
    [finding] = judge("TOP005", NODE.format(line=declared + "  # here"))
    assert finding.message.startswith(f"{line.split('(')[0].split('.')[1]}() is called with {given}, but expects")


@pytest.mark.parametrize(
    "line",
    [
        "flags.publish(node.get_parameter('flag').value)",
        "flags.publish(Bool(data=node.get_parameter('flag').value))",
    ],
)
def test_what_an_object_of_rclpy_holds(judge: Judge, line: str):
    judge("TOP005", NODE.format(line=f"node.declare_parameter('flag', os.environ['FLAG']); {line}"))


def test_one_of_two_publishers_fits(judge: Judge):
    judge(
        "TOP005",
        """
        import os
        import rclpy
        from geometry_msgs.msg import Twist, TwistStamped

        rclpy.init()
        node = rclpy.create_node('teleop')
        stamped = 'STAMPED' in os.environ
        if stamped:
            publisher = node.create_publisher(TwistStamped, 'cmd_vel', 10)
        else:
            publisher = node.create_publisher(Twist, 'cmd_vel', 10)
        publisher.publish(TwistStamped() if stamped else Twist())
        if stamped:
            publisher.publish(TwistStamped())
        else:
            publisher.publish(Twist())
        """,
    )


BUTTONS = """
    from rclpy.node import Node
    from std_msgs.msg import Int32, String

    class Panel(Node):
        def __init__(self):
            super().__init__('panel')
            self.key = self.create_publisher(String, 'key', 10)
            self.count = self.create_publisher(Int32, 'count', 10)
            self.lamp = self.create_publisher(String, 'lamp', 10)
            self.create_timer(1.0, self.press)

        def press(self):
            self.key.publish('<Y>')  # here
            self.key.publish('<N>')
            self.key.publish(String(data='<Q>'))
            self.lamp.publish('on')
            self.count.publish('one')  # here
"""


def test_calls_of_a_file_that_are_wrong_in_the_same_way_are_one_finding(judge: Judge):
    key, count = judge("TOP005", BUTTONS)
    assert key.message.endswith("; 2 more calls are wrong in the same way")
    assert [related.place.line for related in key.related] == [7, 14, 16]
    assert count.message.endswith("expects std_msgs/msg/Int32")


@pytest.mark.parametrize(
    ("type_", "mark"),
    [
        ("Bool", "  # here"),
        ("Double", ""),  # no message of std_msgs: the import fails
    ],
)
def test_a_type_that_its_package_does_not_define(judge: Judge, type_: str, mark: str):
    judge(
        "TOP005",
        f"""
        import rclpy
        from std_msgs.msg import String
        from std_msgs.msg import {type_}

        rclpy.init()
        node = rclpy.create_node('sender')
        codes = node.create_publisher({type_}, 'codes', 10)
        codes.publish(String()){mark}
        """,
    )


LEFT_OVER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Int32, String


    class Lamp(Node):
        def __init__(self):
            super().__init__('lamp')
            self.state = self.create_publisher(String, 'state', 10)
            self.create_timer(1.0, self.blink)

        def blink(self):
            {line}

        def count(self):
            self.state.publish(Int32(data=1))  # here


    def main():
        rclpy.init()
        rclpy.spin(Lamp())


    if __name__ == '__main__':
        main()
"""
OTHERS = "import rclpy\nfrom rclpy.node import Node\n" + "".join(
    f"\n\nclass Idle{number}(Node):\n    def __init__(self):\n        super().__init__('idle{number}')\n"
    for number in range(5)
)
"""What makes a workspace too large for a lesson."""


def test_a_method_of_a_program_that_nothing_calls(judge: Judge):
    judge("TOP005", LEFT_OVER.format(line="self.state.publish(String())").replace("  # here", ""))
    [called] = judge("TOP005", LEFT_OVER.format(line="self.count()"))
    assert called.severity is Severity.ERROR
