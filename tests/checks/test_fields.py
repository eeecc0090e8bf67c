from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from geometry_msgs.msg import PoseStamped, Twist
    from nav2_msgs.action import Spin
    from rclpy.action import ActionClient
    from rclpy.node import Node
    from sensor_msgs.msg import BatteryState, LaserScan
    from std_srvs.srv import SetBool, Trigger


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.latest = None
            self.create_subscription(LaserScan, 'scan', self.on_scan, 10)
            self.create_subscription(BatteryState, 'battery', self.on_battery, 10)
            self.client = self.create_client(SetBool, 'enable')
            self.spin = ActionClient(self, Spin, 'spin')

        def on_scan(self, scan):
            self.latest = scan
            {on_scan}

        def on_battery(self, battery):
            {on_battery}

        def on_done(self, future):
            {on_done}

        def on_feedback(self, message):
            {on_feedback}

        def describe(self, message):
            {helper}


    def main():
        rclpy.init()
        rclpy.spin(Driver())


    if __name__ == '__main__':
        main()
"""
PLACES = ("on_scan", "on_battery", "on_done", "on_feedback", "helper")


def node(**lines: str) -> str:
    return NODE.format(**{place: lines.get(place, "pass") for place in PLACES})


@pytest.mark.parametrize(
    "lines",
    [
        {"on_scan": "print(scan.range)  # here"},
        {"on_scan": "print(scan.header.seq)  # here"},  # gone since ROS 1
        {"on_scan": "print(scan.header.stamp.secs)  # here"},
        {"on_scan": "scan.angle_minimum = 0.0  # here"},
        {"on_scan": "Twist(linar=None)  # here"},
        {"on_scan": "pose = PoseStamped().pose; pose.position.w = 1.0  # here"},
        {"on_scan": "self.client.call_async(SetBool.Request()).add_done_callback(self.on_done)",
         "on_done": "print(future.result().succes)  # here"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal(), feedback_callback=self.on_feedback)",
         "on_feedback": "print(message.feedback.angle)  # here"},
        {"on_battery": "print(self.latest.nothing)  # here"},  # None or a LaserScan
    ],
)  # fmt: skip
def test_a_field_that_is_not_there(judge: Judge, lines: dict[str, str]):
    judge("MSG001", node(**lines))


@pytest.mark.parametrize(
    "lines",
    [
        {"on_scan": "print(scan.ranges, scan.header.stamp.sec, scan.get_fields_and_field_types())"},
        {"on_scan": "print(BatteryState().POWER_SUPPLY_STATUS_FULL)"},
        {"on_scan": "print(scan.extra) if hasattr(scan, 'extra') else None"},
        {"on_scan": "print(getattr(scan, 'extra', None))"},
        {"on_scan": "self.client.call_async(SetBool.Request()).add_done_callback(self.on_done)",
         "on_done": "print(future.result().success, future.done())"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal(), feedback_callback=self.on_feedback)",
         "on_feedback": "print(message.feedback.angular_distance_traveled, message.goal_id)"},
        # A helper that several types of message are handed to.
        {"on_scan": "self.describe(scan)", "on_battery": "self.describe(battery)",
         "helper": "print(message.voltage)"},
        {"on_scan": "self.describe(scan)",
         "helper": "print(message.voltage if isinstance(message, BatteryState) else 0)"},
        {"on_scan": "self.describe(scan)",
         "helper": "print(message.voltage if type(message).__name__ == 'BatteryState' else 0)"},
    ],
)  # fmt: skip
def test_what_may_be_there(judge: Judge, lines: dict[str, str]):
    judge("MSG001", node(**lines))


def test_what_was_probably_meant(judge: Judge):
    [found] = judge("MSG001", node(on_scan="print(scan.temperature)  # here"))
    assert found.message == "sensor_msgs/msg/LaserScan has no field 'temperature'"
    [found] = judge("MSG001", node(on_scan="print(scan.Ranges)  # here"))
    assert found.message == "sensor_msgs/msg/LaserScan has no field 'Ranges'; did you mean 'ranges'?"


def test_an_attribute_that_may_fail_on_purpose(judge: Judge):
    judge(
        "MSG001",
        """
        import rclpy
        from sensor_msgs.msg import LaserScan


        def on_scan(scan):
            try:
                print(scan.segments)
            except AttributeError:
                print(scan.ranges)


        rclpy.init()
        node = rclpy.create_node('reader')
        node.create_subscription(LaserScan, 'scan', on_scan, 10)
        rclpy.spin(node)
        """,
    )


@pytest.mark.parametrize(
    ("line", "hint"),
    [
        ("from std_msgs.msg import Strin  # here", "; did you mean 'String'?"),
        ("from std_srvs.msg import Trigger  # here", "; there is std_srvs/srv/Trigger"),
        ("import geometry_msgs.msg as g; g.Velocity()  # here", ""),
    ],
)
def test_an_interface_that_is_not_there(judge: Judge, line: str, hint: str):
    [found] = judge("MSG002", f"import rclpy\n{line}\nrclpy.create_node('x')\n")
    assert found.message.endswith(f"'{line.split()[3] if line.startswith('from') else 'Velocity'}'{hint}")


@pytest.mark.parametrize(
    "line",
    [
        "from vendor_msgs.msg import Anything",
        "from std_msgs.msg import String, Float64MultiArray",
        "from action_msgs.srv import CancelGoal_Response",
        "from sensor_msgs.msg._image import Image",
    ],
)
def test_interfaces_that_are_there_or_elsewhere(judge: Judge, line: str):
    judge("MSG002", f"import rclpy\n{line}\nrclpy.create_node('x')\n")
