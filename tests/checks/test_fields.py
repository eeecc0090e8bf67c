from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from checks.judging import Judge
from robot_package import write_files, write_robot

NODE = """
    import rclpy
    from geometry_msgs.msg import PoseStamped, Twist
    from nav2_msgs.action import Spin
    from nav_msgs.msg import Path
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
            self.create_subscription(Path, 'path', self.on_path, 10)
            self.client = self.create_client(SetBool, 'enable')
            self.spin = ActionClient(self, Spin, 'spin')

        def on_scan(self, scan):
            self.latest = scan
            {on_scan}

        def on_battery(self, battery):
            {on_battery}

        def on_path(self, path):
            {on_path}

        def smooth(self, poses):
            return unheard_of(poses)

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
PLACES = ("on_scan", "on_battery", "on_path", "on_done", "on_feedback", "helper")


HERE = "  # here"


def loop(head: str, read: str) -> str:
    return f"for {head}:\n                print({read})"


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
        # What rclpy wraps feedback and result in.
        {"on_scan": "self.spin.send_goal_async(Spin.Goal(), feedback_callback=self.on_feedback)",
         "on_feedback": "print(message.angular_distance_traveled)  # here"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal()).result().get_result_async().add_done_callback("
                    "self.on_done)",
         "on_done": "print(future.result().total_elapsed_time)  # here"},
        {"on_scan": "print(self.spin.send_goal(Spin.Goal()).total_elapsed_time)  # here"},
        {"on_battery": "print(self.latest.nothing)  # here"},  # None or a LaserScan
        # Items of arrays of messages.
        {"on_path": "print(path.poses[0].pose.positon)  # here"},
        {"on_path": "print(path.poses[-1].positon)  # here"},
        {"on_path": "print(path.poses[1:][0].positon)  # here"},
        {"on_path": "[print(pose.x) for pose in path.poses]  # here"},
        {"on_path": "print({pose.stamp for pose in reversed(path.poses)})  # here"},
        {"on_path": "print(next(pose for pose in path.poses).stamp)  # here"},
        {"on_path": "print(min(path.poses, key=len).stamp)  # here"},
        {"on_path": "first = path.poses.pop if path.poses else None; print(list(path.poses)[0].x)  # here"},
        {"on_path": loop("pose in path.poses", "pose.x") + HERE},
        {"on_path": loop("number, pose in enumerate(path.poses, 1)", "pose.x") + HERE},
        {"on_path": loop("one, other in zip(path.poses, path.poses[1:])", "other.x") + HERE},
        {"on_path": loop("pose in sorted(path.poses, key=id)", "pose.header.stamp.secs") + HERE},
        {"on_path": "built = []; built.append(PoseStamped()); path.poses = built; print(path.poses[0].x)  # here"},
        {"on_path": "print(Path(poses=[PoseStamped()]).poses[0].x)  # here"},
        # A helper that one type too many is handed to.
        {"on_scan": "self.describe(scan)  # here", "on_battery": "self.describe(battery)",
         "helper": "print(message.voltage)"},
        {"on_scan": "self.describe(scan)  # here", "on_battery": "self.describe(battery)",
         "helper": "print(message.voltage); print(message.current)"},
        # One that nothing right is handed to.
        {"on_scan": "self.describe(scan)", "on_battery": "self.describe(battery)",
         "helper": "print(message.volts)  # here"},
        {"on_scan": "self.describe(scan)", "helper": "print(message.volts)  # here"},
        # Constants.
        {"on_scan": "print(BatteryState.POWER_SUPPLY_STATUS_FUL)  # here"},
        {"on_scan": "print(BatteryState().POWER_SUPPLY_STATUS_FUL)  # here"},
        {"on_scan": "print(Spin.Result.NO_SUCH_OUTCOME)  # here"},
    ],
)  # fmt: skip
def test_a_field_that_is_not_there(judge: Judge, lines: dict[str, str]):
    judge("MSG001", node(**lines))


@pytest.mark.parametrize(
    "lines",
    [
        {"on_scan": "print(scan.ranges, scan.header.stamp.sec, scan.get_fields_and_field_types())"},
        {"on_scan": "print(BatteryState().POWER_SUPPLY_STATUS_FULL)"},
        {"on_scan": "print(BatteryState(voltage=1.0, check_fields=False).voltage)"},
        {"on_scan": "print(scan.extra) if hasattr(scan, 'extra') else None"},
        {"on_scan": "print(getattr(scan, 'extra', None))"},
        {"on_scan": "self.client.call_async(SetBool.Request()).add_done_callback(self.on_done)",
         "on_done": "print(future.result().success, future.done())"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal(), feedback_callback=self.on_feedback)",
         "on_feedback": "print(message.feedback.angular_distance_traveled, message.goal_id)"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal()).result().get_result_async().add_done_callback("
                    "self.on_done)",
         "on_done": "print(future.result().status, future.result().result.total_elapsed_time)"},
        {"on_scan": "self.spin.send_goal_async(Spin.Goal()).add_done_callback(self.on_done)",
         "on_done": "print(future.result().accepted, future.result().goal_id)"},
        {"on_scan": "print(self.spin.send_goal(Spin.Goal()).result.total_elapsed_time)"},
        {"on_scan": "print(BatteryState.POWER_SUPPLY_STATUS_FULL, BatteryState.SLOT_TYPES, LaserScan.__slots__)"},
        {"on_scan": "print(BatteryState.voltage, BatteryState.get_fields_and_field_types(), SetBool.Request)"},
        {"on_path": "print(path.poses[0].pose.position.x, path.poses[0].header.stamp.nanosec, len(path.poses))"},
        {"on_path": "path.poses = self.smooth(path.poses); print(path.poses[0].anything)"},
        {"on_path": "path.poses.append(self.smooth(path)); print([pose.pose for pose in path.poses])"},
        {"on_path": loop("pose in self.smooth(path.poses)", "pose.anything")},
        {"on_path": loop("name, pose in zip(self.names, path.poses)", "name.anything, pose.pose")},
        {"on_path": loop("number in range(len(path.poses))", "path.poses[number].pose.orientation.w")},
        {"on_scan": "print(scan.ranges[0].anything, [value.anything for value in scan.ranges])"},
        # A helper that several types of message are handed to.
        {"on_scan": "if self.latest: self.describe(scan)", "on_battery": "self.describe(battery)",
         "helper": "print(message.voltage)"},
        {"on_scan": "self.describe(scan)",
         "helper": "print(message.voltage if isinstance(message, BatteryState) else 0)"},
        {"on_scan": "self.describe(scan)",
         "helper": "print(message.voltage if type(message).__name__ == 'BatteryState' else 0)"},
    ],
)  # fmt: skip
def test_what_may_be_there(judge: Judge, lines: dict[str, str]):
    judge("MSG001", node(**lines))


def test_a_helper_that_waits_for_all_kinds_of_answers(judge: Judge):
    judge(
        "MSG001",
        """
        import rclpy
        from nav2_msgs.action import Spin
        from rclpy.action import ActionClient
        from rclpy.node import Node
        from std_srvs.srv import Trigger


        def answer_of(future):
            return future.result()


        def main():
            rclpy.init()
            node = Node('turner')
            action, client = ActionClient(node, Spin, 'spin'), node.create_client(Trigger, 'stop')

            def send(angle):
                return answer_of(action.send_goal_async(Spin.Goal(target_yaw=angle)))

            print(answer_of(client.call_async(Trigger.Request())).success)
            first = send(0.5)
            print(first.accepted, answer_of(first.get_result_async()).result.total_elapsed_time)
            second = send(1.5)
            print(second.accepted, answer_of(second.get_result_async()).result.total_elapsed_time)
            print(answer_of(client.call_async(Trigger.Request())).succes)  # here


        if __name__ == '__main__':
            main()
        """,
    )


WINDOW = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger
    from window import signals


    class Gui(Node):
        def __init__(self):
            super().__init__('gui')
            self.client = self.create_client(Trigger, 'ask')
            self.create_subscription(String, 'text', signals.text.emit, 10)
            self.create_timer(5.0, self.ask)
            {set_up}

        def show(self, message):
            {show}

        def ask(self):
            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer)

        def on_answer(self, future):
            {on_answer}


    def main():
        rclpy.init()
        rclpy.spin(Gui())


    if __name__ == '__main__':
        main()
"""
CONNECT = "signals.text.connect(self.show)"


@pytest.mark.parametrize(
    ("set_up", "show", "on_answer"),
    [
        pytest.param(CONNECT, "print(message.data)", "self.show(future.result())  # here", id="others call it"),
        pytest.param("pass", "print(message.data)  # here", "self.show(future.result())", id="nobody else"),
        pytest.param(CONNECT, "print(message.data)", "self.show(String(data='there'))", id="the right message"),
        pytest.param(CONNECT, "print(message.message)", "self.show(future.result())", id="it has the field"),
        pytest.param(
            CONNECT, "print(message.data if signals.on else 0)", "self.show(future.result())", id="may not come to it"
        ),
        pytest.param(
            CONNECT, "print(message.data)", "if signals.on: self.show(future.result())", id="may not be called"
        ),
        pytest.param(
            "self.show(signals.last)", "print(message.data)", "self.show(future.result())  # here", id="who knows what"
        ),
    ],
)
def test_a_function_that_is_called_with_something_else_too(judge: Judge, set_up: str, show: str, on_answer: str):
    judge("MSG001", WINDOW.format(set_up=set_up, show=show, on_answer=on_answer))


def test_a_call_that_passes_the_wrong_message_in_words(judge: Judge):
    text = WINDOW.format(set_up=CONNECT, show="print(message.data)", on_answer="self.show(future.result())  # here")
    [finding] = judge("MSG001", text)
    assert (
        finding.message == "Gui.show() is called with the response of std_srvs/srv/Trigger, which has no field 'data'"
    )
    assert finding.help == "this call raises AttributeError when it runs; the fields are success, message"
    [used] = finding.related
    assert (used.message, used.place.line) == ("'data' is used here", finding.place.line - 6)


ASKING = """
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import SetBool
    from nav_msgs.srv import GetMap


    class Asker(Node):
        def __init__(self):
            super().__init__('asker')
            self.maps = self.create_client(GetMap, 'map')
            self.switch = self.create_client(SetBool, 'enable')
            self.create_timer(1.0, self.ask)

        def ask(self):
            self.send(self.switch, SetBool.Request())
            self.send(self.maps, GetMap.Request())

        def send(self, client, request):
            client.call_async(request).add_done_callback(self.on_done)

        def on_done(self, future):
            {on_done}


    def main():
        rclpy.init()
        rclpy.spin(Asker())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize("field", ["map", "success"])
def test_a_helper_that_gives_all_futures_one_callback(judge: Judge, field: str):
    judge("MSG001", ASKING.format(on_done=f"print(future.result().{field} if self.waiting else None)"))


def test_a_field_that_no_answer_to_the_callback_has(judge: Judge):
    judge("MSG001", ASKING.format(on_done="print(future.result().grid)  # here"))


def test_what_was_probably_meant(judge: Judge):
    [found] = judge("MSG001", node(on_scan="print(scan.temperature)  # here"))
    assert found.message == "sensor_msgs/msg/LaserScan has no field 'temperature'"
    [found] = judge("MSG001", node(on_scan="print(scan.Ranges)  # here"))
    assert found.message == "sensor_msgs/msg/LaserScan has no field 'Ranges'; did you mean 'ranges'?"


def test_the_wrong_names_of_one_message_are_one_finding(judge: Judge):
    lines = ["print(scan.Ranges)  # here", "print(scan.Header)", "scan.Ranges = []"]
    [found] = judge("MSG001", node(on_scan="\n            ".join(lines)))
    assert found.message == (
        "sensor_msgs/msg/LaserScan has no fields 'Ranges' and 'Header', used at 3 places of Driver; did you mean "
        "'ranges' for 'Ranges' and 'header' for 'Header'?"
    )
    assert [(one.place.line, one.message) for one in found.related] == [
        (24, "'Header' is used here"),
        (25, "'Ranges' is used here"),
    ]
    [one] = judge("MSG001", node(on_scan="\n            ".join([lines[0], lines[2]])))
    assert one.message == (
        "sensor_msgs/msg/LaserScan has no field 'Ranges', used at 2 places of Driver; did you mean 'ranges'?"
    )
    of_two = [lines[0], "print(scan.header.Stamp)  # here"]
    assert len(judge("MSG001", node(on_scan="\n            ".join(of_two)))) == 2


def test_an_interface_of_another_version_is_one_finding(judge: Judge):
    sent = "self.spin.send_goal_async(Spin.Goal(tempo=1), feedback_callback=self.on_feedback)  # here"
    on_feedback = "print(message.feedback.state)\n            print(message.feedback.mode)"
    [found] = judge("MSG001", node(on_scan=sent, on_feedback=on_feedback))
    assert found.message == (
        "the goal of nav2_msgs/action/Spin has no field 'tempo'; 2 more uses of it here are wrong, too"
    )
    assert [row.message for row in found.related] == [
        "the feedback of nav2_msgs/action/Spin has no field 'state'",
        "the feedback of nav2_msgs/action/Spin has no field 'mode'",
    ]


def test_an_interface_of_another_version_is_one_finding_of_a_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """A server and its client were written for it."""
    monkeypatch.chdir(tmp_path)
    sent = dedent(node(on_scan="self.spin.send_goal_async(Spin.Goal(tempo=1), feedback_callback=self.on_feedback)"))
    talker = f"from robot import other\n{sent}"
    write_robot(tmp_path, **{"robot/talker.py": talker, "robot/other.py": sent.replace("tempo", "pace")})
    (tmp_path / "archlint.toml").write_text('select = ["MSG001"]', encoding="utf-8")
    [finding] = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert finding.message.endswith("; another use of it in the package 'robot' is wrong, too")


MONITOR = """
    import rclpy
    from nav_msgs.msg import OccupancyGrid
    from rclpy.node import Node


    class Monitor(Node):
        def __init__(self):
            super().__init__('monitor')
            self.info = None
            self.create_subscription(OccupancyGrid, 'map', self.on_map, 10)
            self.create_timer(1.0, self.tell)
            self.create_timer(2.0, self.compare)

        def on_map(self, grid):
            self.info = grid{kept}

        def tell(self):
            if self.info is not None:
                print(self.info.resolution){first}
                print(self.info.{origin}.position.x)

        def compare(self):
            if self.info is not None:
                print(self.info.resolution * 2){allowed}


    def main():
        rclpy.init()
        rclpy.spin(Monitor())


    if __name__ == '__main__':
        main()
"""


def monitor(kept: str = "", first: str = HERE, origin: str = "origin", allowed: str = "") -> str:
    return MONITOR.format(kept=kept, first=first and f"  {first}", origin=origin, allowed=allowed)


def test_one_wrong_value_is_one_finding(judge: Judge):
    [found] = judge("MSG001", monitor())
    assert found.message == (
        "nav_msgs/msg/OccupancyGrid has no fields 'resolution' and 'origin', used at 3 places of Monitor; did you "
        "mean those of 'info'?"
    )
    assert found.help.startswith("these lines raise AttributeError when they run; the fields are header, info")
    assert [one.message for one in found.related] == ["'origin' is used here", "'resolution' is used here"]
    assert [one.place.line - found.place.line for one in found.related] == [1, 5]


def test_the_right_value_at_the_same_places(judge: Judge):
    judge("MSG001", monitor(kept=".info", first=""))


def test_what_is_turned_off_is_not_counted(judge: Judge):
    [found] = judge("MSG001", monitor(allowed="  # archlint: ignore[MSG001]"))
    assert "used at 2 places" in found.message


def test_names_of_different_causes_are_findings_of_their_own(judge: Judge):
    found = judge(
        "MSG001", monitor(first="# here", origin="haeder.stamp)  # here\n                print(self.info.origin")
    )
    assert [one.message.partition("; ")[2] for one in found] == [
        "did you mean those of 'info'?",
        "did you mean 'header'?",
    ]


def test_a_field_of_the_message_inside(judge: Judge):
    [found] = judge("MSG001", node(on_path="print(path.poses[0].position)  # here"))
    assert found.message == "geometry_msgs/msg/PoseStamped has no field 'position'; did you mean 'pose.position'?"


@pytest.mark.parametrize(
    ("read", "hint"), [("CameraInfo().do_rectify", ""), ("CameraInfo().frame_id", "; did you mean 'header.frame_id'?")]
)
def test_a_field_inside_of_many_is_no_hint(judge: Judge, read: str, hint: str):
    """It may mean something else there; a header means the same in every message."""
    lines = f"from sensor_msgs.msg import CameraInfo; print({read})  # here"
    [diagnostic] = judge("MSG001", node(on_scan=lines))
    assert diagnostic.message.partition("has no field")[2].partition("'; ")[0].strip(" '") == read.partition(".")[2]
    assert diagnostic.message.endswith(f"'{hint}")


def test_a_name_of_ros_1(judge: Judge):
    [found] = judge("MSG001", node(on_scan="print(scan.header.stamp.nsecs)  # here"))
    assert found.message == "builtin_interfaces/msg/Time has no field 'nsecs'; did you mean 'nanosec'?"


def test_a_constant_in_words(judge: Judge):
    [found] = judge("MSG001", node(on_scan="print(BatteryState.POWER_SUPPLY_STATUS_FUL)  # here"))
    assert found.message == (
        "sensor_msgs/msg/BatteryState has no constant 'POWER_SUPPLY_STATUS_FUL'; did you mean "
        "'POWER_SUPPLY_STATUS_FULL'?"
    )


@pytest.mark.parametrize(
    ("errors", "found"),
    [("AttributeError", ""), ("(KeyError, AttributeError)", ""), ("ValueError", "  # here")],
)
def test_the_other_way_where_an_attribute_is_missing(judge: Judge, errors: str, found: str):
    judge(
        "MSG001",
        f"""
        import rclpy
        from sensor_msgs.msg import LaserScan

        def on_scan(scan):
            try:
                print(scan.ranges)
            except {errors}:
                try:
                    print(scan.angle_min)
                except {errors}:
                    print(scan.segments){found}

        rclpy.init()
        node = rclpy.create_node('watcher')
        node.create_subscription(LaserScan, 'scan', on_scan, 10)
        rclpy.spin(node)
        """,
    )


@pytest.mark.parametrize(
    ("errors", "found"),
    [
        ("AttributeError", ""),
        ("Exception", ""),
        ("(KeyError, AttributeError)", ""),
        ("ERRORS", ""),
        ("CvBridgeError", "  # here"),
        ("(ValueError, tf2_ros.TransformException)", "  # here"),
    ],
)
def test_an_attribute_that_may_fail_on_purpose(judge: Judge, errors: str, found: str):
    judge(
        "MSG001",
        f"""
        import rclpy
        from sensor_msgs.msg import LaserScan


        def on_scan(scan):
            try:
                print(scan.segments){found}
            except {errors}:
                print(scan.ranges)


        rclpy.init()
        node = rclpy.create_node('reader')
        node.create_subscription(LaserScan, 'scan', on_scan, 10)
        rclpy.spin(node)
        """,
    )


@pytest.mark.parametrize(
    ("handler", "found"),
    [
        ("node.get_logger().error('no scan')", "  # here"),
        ("node.get_logger().error('no scan'); return", "  # here"),
        ("print('no scan')", "  # here"),
        ("traceback.print_exc(); raise", "  # here"),
        ("raise", "  # here"),
        ("pass", ""),
        ("return", ""),
        ("node.get_logger().error(f'no scan of {node}')", "  # here"),
        ("node.get_logger().error('no scan: ' + str(node))", "  # here"),
        ("print(scan.ranges)", ""),
        ("node.is_old = True", ""),
        ("node.get_logger().warn('an old driver'); use(scan.ranges)", ""),
    ],
)
def test_a_handler_for_all_errors_that_only_says_so(judge: Judge, handler: str, found: str):
    judge(
        "MSG001",
        f"""
        import traceback

        import rclpy
        from sensor_msgs.msg import LaserScan


        def on_scan(scan):
            try:
                print(scan.segments){found}
            except Exception:
                {handler}


        rclpy.init()
        node = rclpy.create_node('reader')
        node.create_subscription(LaserScan, 'scan', on_scan, 10)
        rclpy.spin(node)
        """,
    )


SHARED = """
    import sys
    from functools import partial

    import rclpy
    from rclpy.node import Node
    from rosidl_runtime_py.utilities import get_message
    from sensor_msgs.msg import Imu, LaserScan


    class Recorder(Node):
        def __init__(self):
            super().__init__('recorder')
            self.mode = self.declare_parameter('mode', 'scan').value
            self.handlers = {{'scan': self.on_scan, 'imu': self.on_imu}}
            {set_up}

        def on_any(self, message):
            {on_any}

        def on_named(self, name, message):
            self.handlers[name](message)

        def on_scan(self, message):
            print(message.ranges){on_scan}

        def on_imu(self, message):
            print(message.orientation){on_imu}


    def main():
        rclpy.init()
        rclpy.spin(Recorder())


    if __name__ == '__main__':
        main()
"""
BOTH = (
    "self.create_subscription(LaserScan, 'scan', self.on_any, 10)",
    "self.create_subscription(Imu, 'imu', self.on_any, 10)",
)


def shared(*set_up: str, on_any: str = "pass", on_scan: str = "", on_imu: str = "") -> str:
    lines = "\n            ".join(set_up)
    return SHARED.format(set_up=lines, on_any=on_any.replace("\n", "\n            "), on_scan=on_scan, on_imu=on_imu)


def test_a_callback_of_two_subscriptions_of_which_one_lacks_the_field(judge: Judge):
    [found] = judge("MSG001", shared(*BOTH, on_any="print(message.ranges)  # here\nprint(message.angle_min)"))
    assert found.message == (
        "sensor_msgs/msg/Imu has no field 'ranges', and the topic 'imu' passes such messages to this code"
    )
    assert [(one.place.line, one.message) for one in found.related] == [
        (16, "this passes sensor_msgs/msg/Imu"),
        (15, "what this passes has the field"),
    ]


@pytest.mark.parametrize(
    "on_any",
    [
        "print(message.header)",
        "if isinstance(message, LaserScan):\n    print(message.ranges)",
        "if not isinstance(message, LaserScan):\n    return\nprint(message.ranges)",
        "if type(message).__name__ == 'LaserScan':\n    print(message.ranges)",
        "if type(message).__name__ != 'LaserScan':\n    return\nprint(message.ranges)",
        "if hasattr(message, 'ranges'):\n    print(message.ranges)",
        "if self.mode == 'scan':\n    print(message.ranges)",
        "print(message.ranges if self.mode == 'scan' else message.orientation)",
        "self.mode == 'scan' and print(message.ranges)",
        "print(getattr(message, 'ranges', None))",
        "try:\n    print(message.ranges)\nexcept AttributeError:\n    print(message.orientation)",
    ],
)
def test_a_callback_of_two_subscriptions_that_tells_them_apart(judge: Judge, on_any: str):
    judge("MSG001", shared(*BOTH, on_any=on_any))


@pytest.mark.parametrize(
    "set_up",
    [
        ("for name, kind in (('scan', LaserScan), ('imu', Imu)):",
         "    self.create_subscription(kind, name, partial(self.on_named, name), 10)"),
        ("for name in sys.argv:",
         "    self.create_subscription({'scan': LaserScan, 'imu': Imu}[name], name, self.handlers[name], 10)"),
        ("for name in sys.argv:",
         "    kind = LaserScan if name == 'scan' else get_message(name)",
         "    self.create_subscription(kind, name, self.handlers[name], 10)"),
        ("self.create_subscription(LaserScan, 'scan', partial(self.on_named, sys.argv[1]), 10)",),
        ("self.create_subscription(LaserScan, 'scan', lambda message: self.handlers[sys.argv[1]](message), 10)",),
    ],
    ids=["partial", "one of several", "a type that is not known", "chosen later", "chosen in a lambda"],
)  # fmt: skip
def test_callbacks_that_live_in_a_dictionary(judge: Judge, set_up: tuple[str, ...]):
    judge("MSG001", shared(*set_up))


def test_a_lambda_that_means_the_last_callback_of_a_loop(judge: Judge):
    judge(
        "MSG001",
        shared(
            "for name, kind in (('scan', LaserScan), ('imu', Imu)):",
            "    self.create_subscription(kind, name, lambda message: self.handlers[name](message), 10)",
            on_imu="  # here",
        ),
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


@pytest.mark.parametrize(("readme", "told"), [("For ROS 2 Foxy", False), ("For ROS 2 Humble", True)])
def test_an_interface_that_an_older_distribution_may_have_had(judge: Judge, tmp_path, readme: str, told: bool):
    """Foxy's nav2_msgs has RandomCrawl."""
    (tmp_path / "README.md").write_text(readme)
    mark = "  # here" if told else ""
    judge(
        "MSG002",
        "import rclpy\n"
        f"from nav2_msgs.action import RandomCrawl{mark}\n"
        "from std_msgs.msg import Strin  # here\n"
        "rclpy.create_node('x')\n",
    )


def test_a_program_whose_node_comes_from_elsewhere(judge: Judge):
    judge(
        "MSG001",
        """
        import rclpy
        from geometry_msgs.msg import PoseStamped
        from nav2_simple_commander.robot_navigator import BasicNavigator


        def main():
            rclpy.init()
            goal = PoseStamped()
            goal.heading = 'map'  # here
            BasicNavigator().goToPose(goal)


        if __name__ == '__main__':
            main()
        """,
    )


def interfaces(package: str, *listed: str, files: tuple[str, ...]) -> dict[str, str]:
    """A package that has some interface files and lists some in its CMakeLists.txt."""
    build = "<export><build_type>ament_cmake</build_type></export>"
    return {
        f"{package}/package.xml": f"<package format='3'><name>{package}</name>{build}</package>",
        f"{package}/CMakeLists.txt": f"project(it)\nrosidl_generate_interfaces(it {' '.join(listed)})\n",
        **{f"{package}/{name}": "---\n" if name.endswith(".srv") else "int32 x\n" for name in files},
    }


def lay_out(judge: Judge, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = judge.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def test_a_file_that_the_build_leaves_out_is_to_be_listed(judge: Judge):
    lay_out(judge, interfaces("flags", "msg/A.msg", "msg/B.msg", files=("msg/A.msg", "msg/B.msg", "msg/C.msg")))
    code = "import rclpy\nfrom flags.msg import A, B\nfrom flags.msg import {}  # here\nrclpy.create_node('x')\n"
    [left_out] = judge("MSG002", code.format("C"))
    assert "msg/C.msg is not listed in rosidl_generate_interfaces()" in left_out.message
    assert left_out.help == 'add "msg/C.msg" to rosidl_generate_interfaces() in the CMakeLists.txt of flags'
    lay_out(judge, interfaces("odd", "msg/A.msg", files=("msg/A.msg", "msg/Arm_Pose.msg")))
    [refused] = judge("MSG002", code.replace("flags", "odd").replace("A, B", "A").format("Arm_Pose"))
    assert refused.help is not None and refused.help.startswith("rename it to msg/ArmPose.msg, as names")
    [unknown] = judge("MSG002", code.format("Unknown"))
    assert unknown.help == (
        "the import fails when the node starts; flags.msg has A, B; if it is meant to be one of its own, add "
        "msg/Unknown.msg to flags"
    )


def test_a_constant_of_the_other_half_of_a_service(judge: Judge):
    parts = "int8 SLOW=0\nbool go\n---\nint8 STOPPED=1\nbool done\n"
    lay_out(judge, {**interfaces("rover", "srv/Dock.srv", files=()), "rover/srv/Dock.srv": parts})
    code = "import rclpy\nfrom rover.srv import Dock\nprint(Dock.Request.{}){}\nrclpy.create_node('x')\n"
    [found] = judge("MSG001", code.format("STOPPED", "  # here"))
    assert found.message.endswith("has no constant 'STOPPED'; did you mean 'Dock.Response.STOPPED'?")
    judge("MSG001", code.format("SLOW", ""))


MISSING = """
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Caller(Node):
    def __init__(self):
        super().__init__('caller')
        self.client = self.create_client(Trigger, 'go')
        self.create_timer(5.0, self.call)

    def call(self):
        from std_srvs.srv import {name}  # here
        self.client.call_async({name}())


rclpy.init()
rclpy.spin(Caller())
"""


def test_nothing_is_known_of_an_interface_that_is_not_there(judge: Judge):
    [found] = judge("MSG002", MISSING.format(name="Switch"))
    assert found.help.startswith("the import fails when that function runs; ")
    judge("TOP005", MISSING.format(name="TriggerRequest").replace("  # here", ""))
    there = MISSING.format(name="SetBool").replace("  # here", "")
    judge("TOP005", there.replace("SetBool())", "SetBool())  # here"))


def test_the_package_that_has_the_interface_is_named(judge: Judge):
    lay_out(judge, interfaces("rover", "srv/Stop.srv", files=("srv/Stop.srv",)))
    lay_out(judge, interfaces("arm", "srv/Trigger.srv", files=("srv/Trigger.srv",)))
    lay_out(judge, interfaces("old", "srv/Other.srv", files=("srv/Other.srv", "srv/Trigger.srv")))
    code = "import rclpy\nfrom rover.srv import Trigger  # here\nrclpy.create_node('x')\n"
    [one] = judge("MSG002", code)
    assert one.help == "write `from arm.srv import Trigger`: that package defines it"
    lay_out(judge, interfaces("leg", "srv/Trigger.srv", files=("srv/Trigger.srv",)))
    [several] = judge("MSG002", code)
    assert several.help == "import it from a package that defines it: arm, leg"


def test_what_one_file_imports_in_vain_is_one_finding(judge: Judge):
    lay_out(judge, interfaces("rover", "msg/Stop.msg", files=("msg/Stop.msg",)))
    code = "import rclpy\nfrom rover.msg import Box  # here\nfrom rover.msg import Key\nrclpy.create_node('x')\n"
    [found] = judge("MSG002", code)
    assert found.message.startswith("rover defines no messages 'Box' and 'Key'")
    assert [(row.place.line, row.message) for row in found.related] == [(3, "'Key' is imported here")]


@pytest.mark.parametrize("build_type", ["ament_cmake", "ament_python"])
def test_a_package_whose_build_generates_no_interfaces(judge: Judge, build_type: str):
    build = f"<export><build_type>{build_type}</build_type></export>"
    lay_out(
        judge,
        {
            "rover/package.xml": f"<package format='3'><name>rover</name>{build}</package>",
            "rover/msg/Stop.msg": "int32 x\n",
            "rover/CMakeLists.txt" if build_type == "ament_cmake" else "rover/setup.py": (
                "project(rover)\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
                if build_type == "ament_cmake"
                else "from setuptools import setup\n\nsetup(name='rover')\n"
            ),
        },
    )
    [found] = judge("MSG002", "import rclpy\nfrom rover.msg import Box  # here\nrclpy.create_node('x')\n")
    assert found.help == (
        "define it in a package whose build calls rosidl_generate_interfaces(), as that of rover does not, and "
        "import it from there"
    )


TAGS = """
import rclpy
from rover.msg import Target
from rclpy.node import Node


class Tags(Node):
    def __init__(self):
        super().__init__('tags')
        self.publisher = self.create_publisher(Target, 'target', 10)
        self.create_timer(0.1, self.tick)

    def tick(self):
        {}
        self.publisher.publish(message)


rclpy.init()
rclpy.spin(Tags())
"""


@pytest.mark.parametrize(
    ("lines", "is_meant"),
    [
        ("message = Target()\n        message.x = 1.0", True),
        ("message = Target(x=1.0)", True),
        ("message = Target()\n        message.corners = [1.0]", False),
        ("message = Target()\n        message.pose.x = 1.0", False),
        ("message = Target(corners=[1.0])", False),
        ("message = make(Target)\n        message.corners = [1.0]", True),
    ],
)
def test_a_message_is_not_meant_that_lacks_the_fields_which_the_code_sets(judge: Judge, lines: str, is_meant: bool):
    lay_out(judge, interfaces("rover", "msg/Targets.msg", files=()) | {"rover/msg/Targets.msg": "float64 x\n"})
    write_files(judge.folder, {"node.py": TAGS.format(lines), "archlint.toml": 'select = ["MSG002"]'})
    [found] = check(Request((".",), load(judge.folder), cached=False, jobs=1)).findings
    assert ("did you mean 'Targets'?" in found.message) == is_meant
    assert ("add msg/Target.msg to rover" in (found.help or "")) == (not is_meant)


def test_a_message_whose_file_lies_in_a_folder_of_its_own(judge: Judge):
    lay_out(judge, interfaces("rover", "msg/Boxes.msg", files=("msg/Boxes.msg", "msg/done/Box.msg")))
    [found] = judge("MSG002", "import rclpy\nfrom rover.msg import Box  # here\nrclpy.create_node('x')\n")
    assert found.message == "rover defines no message 'Box'"
    assert found.help == 'move msg/done/Box.msg to msg/, and list "msg/Box.msg" in rosidl_generate_interfaces()'


def test_what_several_files_lack_of_a_package_of_the_workspace_is_one_finding(judge: Judge):
    lay_out(judge, interfaces("rover", "msg/Stop.msg", files=("msg/Stop.msg", "msg/Go.msg")))
    code = "import rclpy\nfrom rover.msg import {}\nrclpy.create_node('x')\n"

    def told(*names: str) -> list[tuple[str, list[str]]]:
        files = {f"node{number}.py": code.format(name) for number, name in enumerate(names)}
        write_files(judge.folder, {"archlint.toml": 'select = ["MSG002"]', **files})
        found = check(Request((".",), load(judge.folder), cached=False, jobs=1)).findings
        return [(row.place.file, [related.place.file for related in row.related]) for row in found]

    assert told("Box", "Box") == [("node0.py", ["node1.py"])]
    assert told("Box", "Key") == [("node0.py", []), ("node1.py", [])]
    assert told("Go", "Go") == [("node0.py", ["node1.py"])]


def test_a_message_that_a_package_of_the_workspace_lists_as_a_service(judge: Judge):
    files = {
        "package.xml": "<package format='3'><name>arm_interfaces</name><export><build_type>ament_cmake</build_type>"
        "</export></package>",
        "CMakeLists.txt": "project(arm_interfaces)\n"
        "rosidl_generate_interfaces(arm_interfaces msg/Pose.msg srv/SetMode.srv)\n",
        "msg/Pose.msg": "float64 angle\n",
        "srv/SetMode.srv": "string mode\n---\nbool done\n",
    }
    for name, text in files.items():
        path = judge.folder / "arm_interfaces" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    [found] = judge(
        "MSG002",
        """
        import rclpy
        from arm_interfaces.msg import Pose
        from arm_interfaces.msg import SetMode  # here
        from arm_interfaces.srv import SetMode as Right
        rclpy.create_node('x').create_service(Right, 'set_mode', print)
        """,
    )
    assert found.message == "arm_interfaces defines no message 'SetMode'; there is arm_interfaces/srv/SetMode"


def test_the_parts_of_a_service_that_ros_1_had_apart(judge: Judge):
    code = "import rclpy\nfrom std_srvs.srv import {}  # here\nrclpy.create_node('x')\n"
    [both] = judge("MSG002", code.format("Empty, EmptyRequest, EmptyResponse"))
    assert both.message == "std_srvs defines no services 'EmptyRequest' and 'EmptyResponse'"
    assert both.help == "in ROS 2 it belongs to the service: import Empty and write Empty.Request()"
    [response] = judge("MSG002", code.format("SetBoolResponse"))
    assert response.message == "std_srvs defines no service 'SetBoolResponse'"
    assert response.help == "in ROS 2 it belongs to the service: import SetBool and write SetBool.Response()"
    [other] = judge("MSG002", code.format("PressRequest"))
    assert other.help.startswith("the import fails when the node starts")


def test_a_misspelt_interface_keeps_its_advice(judge: Judge):
    code = "import rclpy\nfrom std_srvs.srv import (\n    Triger,\n    SetBol,\n)\n"
    (judge.folder / "node.py").write_text(code)
    (judge.folder / "archlint.toml").write_text('select = ["MSG002"]')
    found = check(Request((".",), load(judge.folder), cached=False, jobs=1)).findings
    (one,) = found  # one statement is one finding
    assert one.message == (
        "std_srvs defines no services 'SetBol' and 'Triger'; did you mean 'SetBool' by 'SetBol'?; did you mean "
        "'Trigger' by 'Triger'?"
    )


@pytest.mark.parametrize(
    ("line", "renamed"),
    [
        ("from hud_msgs.msg import VFR_HUD", "VfrHud"),
        ("from my_robot_interfaces.srv import Set_led_panel", "SetLedPanel"),
        ("from some_srvs.srv import Pose_V", "PoseV"),
        ("from some_msgs.action import Drive_TO as DriveTo", "DriveTo"),
    ],
)
def test_a_name_that_no_interface_has(judge: Judge, line: str, renamed: str):
    [finding] = judge("MSG002", f"import rclpy\n{line}  # here\nrclpy.create_node('x')\n")
    assert finding.help == f"look for {renamed}: the names of interfaces have no '_'"


@pytest.mark.parametrize(
    "line",
    [
        "from mavros_msgs.msg import VfrHud, State",
        "from mavros_msgs.msg import _vfr_hud",
        "from some_srvs.srv import Blink_Request",
        "from some_tools.msg import make_message, Pose_V",
        "import mavros_msgs.msg",
        "try:\n    from mavros_msgs.msg import VFR_HUD\nexcept ImportError:\n    from mavros_msgs.msg import VfrHud",
    ],
)
def test_a_name_that_an_interface_or_other_code_may_have(judge: Judge, line: str):
    judge("MSG002", f"import rclpy\n{line}\nrclpy.create_node('x')\n")


@pytest.mark.parametrize(("folder", "told"), [("tools", 1), ("tools_old", 0), ("old_tools", 0)])
def test_a_field_in_a_disused_folder(findings, folder: str, told: int):
    main = "import rclpy\nfrom std_msgs.msg import String\n\nrclpy.init()\nnode = rclpy.create_node('n')\n"
    script = main + "publisher = node.create_publisher(String, 'x', 10)\npublisher.publish(String(date='a'))\n"
    readme = f"    python3 {folder}/say.py\n"
    assert len(findings("MSG001", **{f"{folder}/say.py": script, "README.md": readme})) == told


OLD = """
    import rclpy
    from nav2_msgs.action import ComputePathToPose
    from rclpy.node import Node


    class Planner(Node):
        def __init__(self):
            super().__init__('planner')
            goal = ComputePathToPose.Goal()
            goal.pose = None{mark}


    def main():
        rclpy.init()
        rclpy.spin(Planner())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({"Dockerfile": "FROM ros:foxy"}, False),
        ({".vscode/settings.json": '{"ros.distro": "foxy"}'}, False),
        ({"Dockerfile": "FROM ros:foxy", ".gitlab-ci.yml": "image: ros:humble"}, True),
        ({"Dockerfile": "FROM ros:humble"}, True),
        ({"README.md": "For ROS 2 Foxy"}, False),
        ({"README.md": "For ROS 2 Galactic", "parts/README.md": "| Humble | Rolling |"}, False),
        ({"README.md": "For ROS 2 Humble", "parts/README.md": "For ROS 2 Foxy"}, True),
        ({"README.md": "Foxy or Humble"}, True),
    ],
)
def test_a_workspace_for_a_distribution_whose_messages_are_not_known(judge: Judge, tmp_path, files, told: bool):
    """Foxy's action had the field 'pose', which is called 'goal' now."""
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    judge("MSG001", OLD.format(mark="  # here" if told else ""))


def test_messages_that_have_lost_nothing_since_foxy(judge: Judge, tmp_path):
    (tmp_path / "README.md").write_text("For ROS 2 Foxy")
    source = OLD.replace("nav2_msgs.action import ComputePathToPose", "geometry_msgs.msg import Twist")
    judge("MSG001", source.replace("ComputePathToPose.Goal()", "Twist()").format(mark="  # here"))


ACTION = """
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer
    from rclpy.node import Node


    class Counter(Node):
        def __init__(self):
            super().__init__('counter')
            self.server = ActionServer(self, Fibonacci, 'count', self.execute, goal_callback=self.accept)
            self.client = ActionClient(self, Fibonacci, 'count')
            self.client.send_goal_async(Fibonacci.Goal(), feedback_callback=self.on_feedback)

        def accept(self, goal):
            return goal.length  # here

        def on_feedback(self, message):
            print(message.feedback.accept)

        def execute(self, handle):
            return Fibonacci.Result()
"""


def test_callbacks_that_an_action_server_and_a_client_are_given(judge: Judge):
    (finding,) = judge("MSG001", ACTION)
    assert finding.message.endswith("has no field 'length'; another use of it here is wrong, too")


SIGNAL = """
    from PyQt5.QtCore import pyqtSignal
    from rclpy.node import Node
    from std_msgs.msg import String


    class Window(Node):
        changed = pyqtSignal(object)

        def __init__(self):
            super().__init__('window')
            self.create_subscription(String, 'state', self.show, 10)
            {line}

        def show(self, state):
            print(state.name){mark}
"""


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ("self.changed.connect(self.show)", False),
        ("self.changed.connect(self.close)", True),
        ("self.create_subscription(String, 'other', self.show, 10)", True),
    ],
)
def test_a_callback_that_a_signal_may_call_with_something_else(judge: Judge, line: str, told: bool):
    judge("MSG001", SIGNAL.format(line=line, mark="  # here" if told else ""))
