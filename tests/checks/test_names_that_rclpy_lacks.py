"""API002: calls of functions and methods that rclpy does not have."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.trigger = self.create_client(Trigger, 'trigger')
        self.timer = self.create_timer(1.0, self.tick)
        self.goals = ActionServer(self, Fibonacci, 'count', self.tick)
        executor = SingleThreadedExecutor()
        {call}

    def tick(self):
        pass
"""


@pytest.mark.parametrize(
    ("call", "message", "help"),
    [
        ("self.get_loger()", "Node has no get_loger()", "use get_logger()"),
        ("self.get_param('rate')", "Node has no get_param()", "use get_parameter()"),
        ("self.destroy_subscriber(None)", "Node has no destroy_subscriber()", "use destroy_subscription()"),
        ("self.logger().info('up')", "Node has no logger()", "use get_logger()"),
        ("self.clock().now()", "Node has no clock()", "use get_clock()"),
        ("self.name()", "Node has no name()", "use get_name()"),
        ("self.parameter('rate')", "Node has no parameter()", "use get_parameter()"),
        ("self.battery()", "Node has no battery()", "define battery() in the class of the node, or remove the call"),
        ("self.take_off()", "Node has no take_off()", "define take_off() in the class of the node, or remove the call"),
        ("self.shutdown()", "Node has no shutdown()", "use rclpy.shutdown()"),
        ("self.logerr('no')", "Node has no logerr()", "use get_logger().error()"),
        ("self.trigger.call_sync(Trigger.Request())", "Client has no call_sync()", "use call()"),
        (
            "self.trigger.send_goal_async(Trigger.Request())",
            "Client has no send_goal_async()",
            "make an ActionClient of rclpy.action, which has it, in place of the client",
        ),
        ("self.trigger.call_async(Trigger.Request()).get_result()", "Future has no get_result()", "use result()"),
        ("self.timer.stop()", "Timer has no stop()", "use cancel()"),
        ("self.goals.set_succeeded()", "ActionServer has no set_succeeded()", "use succeed() of the goal handle"),
        ("executor.submit(self.tick)", "SingleThreadedExecutor has no submit()", "use create_task()"),
        ("rclpy.loginfo('ready')", "rclpy has no loginfo()", "use get_logger().info() of a node"),
        ("rclpy.Rate(10)", "rclpy has no Rate()", "use create_rate() of a node"),
        ("rclpy.Time.now()", "Time has no now()", "use get_clock().now() of a node"),
    ],
)
def test_a_name_that_rclpy_lacks(judge: Judge, call: str, message: str, help: str):
    [finding] = judge("API002", NODE.format(call=f"{call}  # here"))
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "call",
    [
        "self.get_logger().info('ready')",
        "self.get_clock().now()",
        "self.count_publishers('chatter')",
        "self.trigger.wait_for_service(1.0)",
        "self.trigger.call_async(Trigger.Request()).add_done_callback(print)",
        "self.timer.cancel()",
        "executor.add_node(self)",
        "rclpy.ok()",
        "setattr(self, 'beep', print); self.beep()",
        "self.beep = print; self.beep()",
    ],
)
def test_a_name_that_it_has(judge: Judge, call: str):
    judge("API002", NODE.format(call=call))


def test_a_subclass_in_another_file_may_define_it(judge: Judge):
    judge(
        "API002",
        NODE.format(call="self.take_off()"),
        """
        from node import Robot


        class Drone(Robot):
            def take_off(self):
                pass
        """,
    )


def test_a_base_of_another_package_may_have_it(judge: Judge):
    judge(
        "API002",
        """
        import rclpy
        from fleet.nodes import FleetNode


        class Robot(FleetNode):
            def __init__(self):
                super().__init__('robot')
                self.take_off()
        """,
    )


def test_a_call_for_a_distribution_that_has_it(judge: Judge):
    judge(
        "API002",
        NODE.format(
            call="""try:
            self.of_the_next_distribution()
        except AttributeError:
            pass
"""
        ),
    )


def test_the_same_name_twice_in_a_file_is_one_finding(judge: Judge):
    [finding] = judge("API002", NODE.format(call="rclpy.loginfo('a')  # here\n        rclpy.loginfo('b')"))
    assert finding.message == "rclpy has no loginfo(); another call in this file does the same"


def test_functions_of_rospy_are_one_finding_for_a_file(judge: Judge):
    [finding] = judge("API002", NODE.format(call="rclpy.loginfo('a')  # here\n        rclpy.Rate(10)"))
    assert finding.message == "rclpy has no loginfo(); another call in this file is of rospy, too"
    assert "rclpy has no Rate(): use create_rate() of a node" in [one.message for one in finding.related]


def test_what_else_a_file_of_rospy_has_is_told_with_its_functions(judge: Judge):
    more = "try:\n            rclpy.spin()\n        except rclpy.ROSInterruptException:\n            pass"
    [finding] = judge("API002", NODE.format(call=f"rclpy.loginfo('a')  # here\n        {more}"))
    assert finding.message == "rclpy has no loginfo(); another call in this file is of rospy, too"
    judge("API001", NODE.format(call=f"rclpy.loginfo('a')\n        {more}"))
    judge("API001", NODE.format(call="rclpy.spin()  # here"))  # a node that was forgotten


def test_the_methods_that_a_node_lacks_are_one_finding(judge: Judge):
    [finding] = judge("API002", NODE.format(call="self.take_off()  # here\n        self.land_here()"))
    assert finding.message == "Node has no take_off(); another call in this file is like that"
    assert [one.message for one in finding.related] == ["Node has no land_here()"]


def test_a_node_that_is_taken_for_its_logger(judge: Judge):
    [finding] = judge("API002", NODE.format(call="self.info('a')  # here\n        self.error('b')"))
    assert finding.message == "Node has no info(); another call in this file is like that"
    assert finding.help == "write self.get_logger().info(…)"


def test_a_lifecycle_node_has_what_its_mixin_has(judge: Judge):
    judge(
        "API002",
        """
        from rclpy.lifecycle import LifecycleNode


        class Robot(LifecycleNode):
            def __init__(self):
                super().__init__('robot')
                self.trigger_configure()
                self.add_managed_entity(self.create_lifecycle_publisher(str, 'x', 1))
        """,
    )


MIXED = """
import time

import rclpy
from rclpy.node import Node


class Arms:
    side = 'left'

    def set_up(self):
        self.create_timer(5.0, self.tick)
        self.create_timer(9.0, print)

    def tick(self):
        time.sleep(2.0)  # slow

    def create_subscription(self):
        return self.side

    def spin_once(self):
        rclpy.spin_once(self)


class Robot({bases}):
    def __init__(self):
        super().__init__('robot')
        self.set_up()
        {more}


def main():
    rclpy.init()
    rclpy.spin(Robot())


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize("bases", ["Arms, Node", "Node, Arms"])
def test_methods_that_a_class_after_node_mixes_in(judge: Judge, bases: str):
    text = MIXED.replace("{bases}", bases).replace("{more}", "print(self.spin_once)")
    judge("API002", text)
    judge("API001", text)  # self is no node in Arms alone, and is one here
    [slow] = judge("EXE003", text.replace("# slow", "# here"))
    assert slow.node == "/robot"


def test_super_leads_to_what_is_mixed_in_behind_node(judge: Judge):
    text = MIXED.replace("{bases}", "Node, Arms").replace("{more}", "")
    text = text.replace("self.set_up()\n", "self.set_up()\n\n    def set_up(self):\n        super().set_up()\n", 1)
    judge("API002", text)
    [slow] = judge("EXE003", text.replace("# slow", "# here"))
    assert slow.node == "/robot"


def test_what_node_has_itself_comes_before_what_is_mixed_in_behind_it(judge: Judge):
    calls = "self.create_subscription()  # here"
    judge("API001", MIXED.replace("{bases}", "Node, Arms").replace("{more}", calls))
    judge("API001", MIXED.replace("{bases}", "Arms, Node").replace("{more}", "self.create_subscription()"))


def test_a_method_that_another_script_gives_the_class(judge: Judge):
    robot = NODE.replace("{call}", "self.patrol(){mark}")
    judge("API002", robot.replace("{mark}", "  # here"))
    judge("API002", robot.replace("{mark}", ""), "import node\n\nnode.Robot.patrol = print\nnode.main()\n")


HINTS = """
{first}
import rclpy


class Board:
    pass


def board_of(node: {hint}) -> Board:
    board: Board = Board()
    return board


def main():
    rclpy.init()
    kept: {local} = rclpy.create_node('robot')
    rclpy.spin(kept)
"""
EVALUATED_LATER = "from __future__ import annotations"


@pytest.mark.parametrize(
    ("first", "hint", "local"),
    [
        ("", "rclpy.Node  # here", "'robot'"),
        (EVALUATED_LATER, "rclpy.Node", "rclpy.Node"),
        ("", "'rclpy.Node'", "rclpy.Node"),  # that of a local variable is never evaluated
    ],
)
def test_annotations_that_python_evaluates(judge: Judge, first: str, hint: str, local: str):
    source = HINTS.format(first=first, hint=hint.partition("  ")[0], local=local)
    if hint.endswith("# here"):
        source = source.replace("-> Board:", "-> Board:  # here")
    judge("API002", source)


def test_a_future_that_is_taken_for_the_goal_handle(judge: Judge):
    source = NODE.format(call="self.goal = self.trigger.call_async(Trigger.Request())")
    [finding] = judge("API002", source.replace("pass", "self.goal.cancel_goal_async()  # here"))
    assert finding.message == "Future has no cancel_goal_async()"
    assert finding.help == "keep the future apart from the goal handle, which is its result()"


def test_a_client_that_is_made_for_an_action_lacks_what_an_action_client_has(judge: Judge):
    call = "self.count = self.create_client(Fibonacci, 'count')\n        self.count.send_goal_async(Fibonacci.Goal())"
    judge("API002", NODE.format(call=call))  # API001 says to make an ActionClient
    judge("API001", NODE.format(call=call.replace("'count')", "'count')  # here")))
    judge("API002", NODE.format(call=f"{call}\n        self.count.call_sync(1)  # here"))


@pytest.mark.parametrize("call", ["super().__init('robot')", "super()._init_('robot')", "super().init('robot')"])
def test_a_misspelt_constructor_of_the_base(judge: Judge, call: str):
    [finding] = judge(
        "API002",
        f"""
        import rclpy
        from rclpy.node import Node


        class Robot(Node):
            def __init__(self):
                {call}  # here


        rclpy.init()
        rclpy.spin(Robot())
        """,
    )
    assert finding.help == "use super().__init__(…)"
