"""MSG003: fields of messages that code takes for something else, and code that takes them for what they are."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
import json
import math

from geometry_msgs.msg import Pose
from rclpy.node import Node
from sensor_msgs.msg import Imu, LaserScan
from std_msgs.msg import Bool, Float32, Int32, String
from std_srvs.srv import Trigger


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(Int32, 'count', self.on_count, 10)
        self.create_subscription(Float32, 'height', self.on_height, 10)
        self.create_subscription(Bool, 'flag', self.on_flag, 10)
        self.create_subscription(String, 'word', self.on_word, 10)
        self.create_subscription(LaserScan, 'scan', self.on_scan, 10)
        self.create_subscription(Imu, 'imu', self.on_imu, 10)
        self.create_subscription(Pose, 'pose', self.on_pose, 10)

    def on_{topic}(self, msg):
        {line}
"""


def _node(topic: str, line: str) -> str:
    others = ("count", "height", "flag", "word", "scan", "imu", "pose")
    rest = "".join(f"\n    def on_{name}(self, msg):\n        pass\n" for name in others if name != topic)
    return NODE.format(topic=topic, line=line.replace("; ", "\n        ")) + rest


@pytest.mark.parametrize(
    ("topic", "line", "says"),
    [
        (
            "count",
            "print('count: ' + msg.data)",
            "'data' of std_msgs/msg/Int32 is an int, and '+' with a string raises",
        ),
        ("count", "print(f'{self}: ' + msg.data)", "and '+' with a string raises TypeError"),
        ("count", "print('a ' + 'b ' + msg.data + ' c')", "and '+' with a string raises TypeError"),
        ("count", "number = msg.data; print('count: ' + number)", "and '+' with a string raises TypeError"),
        ("count", "return [each for each in msg.data]", "and a loop over it raises TypeError"),
        ("count", "print(msg.data[0])", "and taking an item of it raises TypeError"),
        ("count", "print(len(msg.data))", "and len() of it raises TypeError"),
        ("height", "return range(msg.data)", "is a float, and range() of it raises TypeError"),
        ("height", "return msg.data == 'high'", "which never equals a string: this is always False"),
        ("flag", "return msg.data != 'true'", "is a bool, which never equals a string: this is always True"),
        ("flag", "return msg.data in ('on', 'On')", "which never equals a string: this is always False"),
        ("word", "return msg.data == 1", "is a string, which never equals a number: this is always False"),
        ("word", "return msg.data > 0.5", "is a string, and '>' with a number raises TypeError"),
        ("word", "return msg.data + 1", "is a string, and '+' with a number raises TypeError"),
        ("scan", "return [1.0] + msg.ranges", "is an array of float32, and '+' with a list raises TypeError"),
        ("scan", "return msg.ranges + [r for r in (1.0,)]", "and '+' with a list raises TypeError"),
        ("scan", "return msg.ranges < 0.5", "is an array of float32, and '<' with a number raises TypeError"),
        ("scan", "return 'ranges ' + msg.ranges", "is an array of float32, and '+' with a string raises TypeError"),
        ("scan", "return msg.ranges == []", "which never equals a list: this is always False"),
        ("pose", "return msg.position > 0", "is a geometry_msgs/msg/Point, and '>' with a number raises TypeError"),
        ("pose", "return abs(msg.position)", "is a geometry_msgs/msg/Point, and abs() of it raises TypeError"),
        ("pose", "x, y, z = msg.position", "and unpacking it into several variables raises TypeError"),
        ("pose", "return 2 * msg.position", "is a geometry_msgs/msg/Point, and '*' with a number raises TypeError"),
        ("pose", "return msg.position.x.value", "is a float, and has no 'value': this line raises AttributeError"),
        ("word", "return msg.data.data", "is a string, and has no 'data': this line raises AttributeError"),
        ("word", "return math.sqrt(msg.data)", "is a string, and math.sqrt() of it raises TypeError"),
        ("flag", "return msg.data()", "is a bool, and calling it raises TypeError"),
        ("scan", "return msg.ranges.shape", "is an array of float32, and has no 'shape'"),
        ("scan", "return msg.ranges.copy()", "is an array of float32, and has no 'copy'"),
        ("height", "return sum(msg.data)", "is a float, and sum() of it raises TypeError"),
        ("height", "self.get_logger().info(msg.data)", "is a float, and info() of it raises TypeError"),
        ("word", "return msg == 'stop'", "'msg' is a message of type std_msgs/msg/String, which never equals a string"),
        ("word", "return msg + '!'", "'msg' is a message of type std_msgs/msg/String, and '+' with a string raises"),
        ("word", "return json.loads(msg)", "'msg' is a message of type std_msgs/msg/String, and json.loads() of it"),
        ("height", "return msg > 0.5", "'msg' is a message of type std_msgs/msg/Float32, and '>' with a number raises"),
        ("height", "return float(msg)", "'msg' is a message of type std_msgs/msg/Float32, and float() of it raises"),
        (
            "scan",
            "return msg[0]",
            "'msg' is a message of type sensor_msgs/msg/LaserScan, and taking an item of it raises",
        ),
        ("scan", "return min(msg)", "'msg' is a message of type sensor_msgs/msg/LaserScan, and min() of it raises"),
        ("scan", "return [each for each in msg]", "of type sensor_msgs/msg/LaserScan, and a loop over it raises"),
        ("count", "a, b = msg", "'msg' is a message of type std_msgs/msg/Int32, and unpacking it into several"),
        ("count", "self.get_logger().info(msg)", "'msg' is a message of type std_msgs/msg/Int32, and info() of it"),
    ],
)
def test_a_field_that_is_taken_for_something_else(judge: Judge, topic: str, line: str, says: str):
    """Python says so of each of these lines: ``TypeError``, or the one result."""
    body = _node(topic, line).splitlines()
    last = max(number for number, text in enumerate(body) if text.strip() == line.split("; ")[-1])
    body[last] += "  # here"
    (finding,) = judge("MSG003", "\n".join(body))
    assert says in finding.message


@pytest.mark.parametrize(
    ("topic", "line"),
    [
        ("count", "print('count: ' + str(msg.data))"),
        ("count", "print(f'count: {msg.data}')"),
        ("count", "print('count: %d' % msg.data)"),
        ("count", "return msg.data + 1 > 5"),
        ("count", "msg.data = self.shown(msg.data); print('count: ' + msg.data)"),
        ("count", "number = msg.data; number = str(number); print('count: ' + number)"),
        ("count", "number = str(msg.data); print('count: ' + number)"),
        ("count", "return 'yes' if isinstance(msg.data, str) and 'x' + msg.data else ''"),
        ("count", "return range(msg.data)"),
        ("count", "return ['a', 'b'][msg.data]"),
        ("flag", "return msg.data == 1"),
        ("flag", "return msg.data == True"),
        ("flag", "return int(msg.data) + 1"),
        ("word", "return 'word: ' + msg.data"),
        ("word", "return msg.data == 'stop' or msg.data[0] == 's'"),
        ("word", "return float(msg.data) > 0.5"),
        ("word", "return [letter for letter in msg.data]"),
        ("word", "return msg.data in ('stop', 1)"),
        ("word", "return msg.data * 2"),
        ("scan", "return min(msg.ranges) < 0.5"),
        ("scan", "return len(msg.ranges) > 5 and msg.ranges[0] < 0.5"),
        ("scan", "return list(msg.ranges) == []"),
        ("scan", "return [1.0] + list(msg.ranges)"),
        ("scan", "return 'range ' + str(msg.ranges)"),
        ("imu", "return msg.orientation_covariance < 0.5"),
        ("pose", "return msg.position.x > 0"),
        ("pose", "return msg.position == msg.position"),
        ("pose", "return msg == self.last"),
        ("pose", "x, y = msg.position.x, msg.position.y"),
        ("pose", "self.get_logger().info(str(msg)); print(msg, msg.position)"),
        ("pose", "self.get_logger().info(f'{msg}'); return [msg][0]"),
        ("pose", "msg = self.flat(msg); return msg[0]"),
        ("pose", "return [msg[0] for msg in self.rows]"),
        ("pose", "return lambda msg: msg[0]"),
        ("pose", "return msg[0] if isinstance(msg, list) else msg.position"),
        ("pose", "return self.show(msg)"),
        ("word", "return json.loads(msg.data)['x']"),
        ("word", "return msg.data.split()[0].strip()"),
        ("word", "self.get_logger().info(msg.data); first, second = msg.data.split()"),
        ("word", "first, second = msg.data"),
        ("flag", "return math.fsum([msg.data]) + round(msg.data)"),
        ("height", "return math.floor(msg.data).bit_length() + msg.data.hex()"),
        ("scan", "return msg.ranges.tolist()"),
        ("scan", "msg.ranges = self.flat(msg.ranges); return msg.ranges.shape"),
        ("scan", "return max(msg.ranges), sorted(msg.ranges), msg.ranges * 2"),
        ("scan", "self.get_logger().debug(msg)"),
    ],
)
def test_a_field_as_what_it_is(judge: Judge, topic: str, line: str):
    judge("MSG003", _node(topic, line))


def test_where_python_s_objection_is_expected(judge: Judge):
    judge("MSG003", _node("count", "try:; " + "    print('count: ' + msg.data); " + "except TypeError:; " + "    pass"))


def test_a_message_whose_operator_is_expected_to_fail(judge: Judge):
    judge("MSG003", _node("count", "try:; " + "    print(msg[0]); " + "except (TypeError, ValueError):; " + "    pass"))


def test_a_comparison_does_not_fail_whatever_is_expected(judge: Judge):
    tried = "try:; " + "    print(msg == 'stop')  # here; " + "except TypeError:; " + "    pass"
    judge("MSG003", _node("word", tried))


CALLED = """
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.create_subscription(String, 'word', self.on_word, 10{raw})
        {call}

    def on_word(self, msg):
        return msg[0]{here}
"""


def test_a_callback_that_code_calls_with_something_else(judge: Judge):
    judge("MSG003", CALLED.format(raw="", call="self.on_word(['start'])", here=""))
    judge("MSG003", CALLED.format(raw="", call="", here="  # here"))


@pytest.mark.parametrize(
    ("call", "here"),
    [
        ("self.changed.connect(self.on_word)", ""),
        ("Thread(target=self.on_word, args=(['start'],)).start()", ""),
        ("print('on_word')", "  # here"),
        ("self.create_subscription(String, 'other', self.on_word, 10)", "  # here"),
        ("self.changed.connect(self.on_words)", "  # here"),
    ],
)
def test_a_callback_that_others_may_call(judge: Judge, call: str, here: str):
    judge("MSG003", CALLED.format(raw="", call=call, here=here))


def test_a_callback_that_gets_the_bytes(judge: Judge):
    judge("MSG003", CALLED.format(raw=", raw=True", call="", here=""))


def test_a_callback_for_messages_and_for_requests(judge: Judge):
    body = """
        self.create_subscription(String, 'word', self.act, 10)
        self.create_service(Trigger, 'act', self.act)

    def act(self, msg, response=None):
        return {done}
    """
    head = NODE.partition("        self.create_subscription")[0]
    judge("MSG003", head + body.format(done="response or msg[0]"))


def test_a_request_that_is_taken_for_what_it_holds(judge: Judge):
    head = NODE.partition("        self.create_subscription")[0]
    (finding,) = judge(
        "MSG003",
        head
        + """
        self.create_service(Trigger, 'act', self.act)

    def act(self, request, response):
        response.success = request == 'go'  # here
        return response
    """,
    )
    assert finding.message.startswith("'request' is a message of type std_srvs/srv/Trigger.Request, which never equals")


def test_a_field_that_another_method_makes_something_else_of(judge: Judge):
    judge(
        "MSG003",
        """
        from rclpy.node import Node
        from std_msgs.msg import String


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.last = String()
                self.create_subscription(String, 'word', self.on_word, 10)
                self.create_timer(1.0, self.tick)

            def on_word(self, msg):
                self.last = msg
                self.last.data = self.parse(msg.data)

            def tick(self):
                print(self.last.data.x)
        """,
    )


def test_one_callback_for_topics_of_two_types(judge: Judge):
    judge(
        "MSG003",
        """
        from rclpy.node import Node
        from std_msgs.msg import Int32, String


        class Robot(Node):
            def __init__(self):
                super().__init__('robot')
                self.create_subscription(Int32, 'count', self.show, 10)
                self.create_subscription(String, 'word', self.show, 10)

            def show(self, msg):
                if isinstance(msg, String):
                    print('word: ' + msg.data)


        class Plain(Node):
            def __init__(self):
                super().__init__('plain')
                self.create_subscription(Int32, 'a', self.show, 10)
                self.create_subscription(String, 'b', self.show, 10)

            def show(self, msg):
                print('word: ' + msg.data)
        """,
    )


def test_a_response_that_a_client_reads(judge: Judge):
    (finding,) = judge(
        "MSG003",
        """
        import rclpy
        from example_interfaces.srv import AddTwoInts
        from rclpy.node import Node


        class Asker(Node):
            def __init__(self):
                super().__init__('asker')
                self.client = self.create_client(AddTwoInts, 'add')

            def ask(self):
                future = self.client.call_async(AddTwoInts.Request(a=1, b=2))
                future.add_done_callback(self.done)

            def done(self, future):
                response = future.result()
                self.get_logger().info('sum: ' + response.sum)  # here


        def main():
            rclpy.init()
            node = Asker()
            node.ask()
            rclpy.spin(node)
        """,
    )
    assert finding.message == (
        "'sum' of example_interfaces/srv/AddTwoInts.Response is an int, and '+' with a string raises TypeError"
    )


@pytest.mark.parametrize(
    ("asks", "help"), [("copy()", "convert it first: list(…)"), ("shape", "use its items, or make")]
)
def test_the_cure_for_what_a_list_has_or_an_array_of_numpy(judge: Judge, asks: str, help: str):
    (finding,) = judge("MSG003", _node("scan", f"return msg.ranges.{asks}  # here"))
    assert finding.help.startswith(help)


KEPT = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.speed = {first}
        self.create_subscription(Float32, 'speed', self.on_speed, 10)
        self.create_timer(1.0, self.tick)

    def on_speed(self, msg):
        self.speed = {kept}

    def tick(self):
        {line}


def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.mark.parametrize("first", ["None", "0.0"])
@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("print(self.speed > 0.5)", "'>' with a number raises TypeError"),
        ("print(self.speed + 1)", "'+' with a number raises TypeError"),
        ("print(abs(self.speed))", "abs() of it raises TypeError"),
        ("self.get_logger().info(self.speed)", "info() of it raises TypeError"),
    ],
)
def test_a_message_that_is_kept_and_taken_for_its_value(judge: Judge, first: str, line: str, says: str):
    (finding,) = judge("MSG003", KEPT.format(first=first, kept="msg", line=f"{line}  # here"))
    assert finding.message == (
        f"'self.speed' is a message of type std_msgs/msg/Float32 once Robot.on_speed has run, and {says}"
    )
    assert finding.help == "keep the field that is meant, or use one of its fields"


@pytest.mark.parametrize(
    ("first", "kept", "line"),
    [
        ("0.0", "msg.data", "print(self.speed > 0.5)"),
        ("None", "msg", "print(self.speed.data > 0.5)"),
        ("None", "msg", "if self.speed is not None: print(str(self.speed))"),
        ("0", "msg", "if self.speed == 0: print('none yet')"),
        ("Float32()", "msg", "print(self.speed.data)"),
        ("self.load()", "msg", "print(self.speed > 0.5)"),
        ("0.0", "msg", "self.speed = 0.1 if self.speed else 0.2; self.speed += self.step(); print(self.speed > 0.5)"),
        ("0.0", "msg", "print(isinstance(self.speed, float) and self.speed > 0.5)"),
        ("0.0", "self.value(msg)", "print(self.speed > 0.5)"),
        ("[]", "msg; self.speed = [msg]", "print(self.speed[0])"),
        ("0.0", "msg", "setattr(self, 'speed', 1.0); print(self.speed > 0.5)"),
    ],
)
def test_what_is_kept_of_a_message(judge: Judge, first: str, kept: str, line: str):
    judge("MSG003", KEPT.format(first=first, kept=kept, line=line))


def test_an_attribute_that_others_set(judge: Judge):
    others = """

def reset(robot):
    robot.speed = 0.0
"""
    judge("MSG003", KEPT.format(first="0.0", kept="msg", line="print(self.speed > 0.5)") + others)


@pytest.mark.parametrize("first", ["None", "0.0"])
@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("print('speed: ' + self.speed)", "'+' with a string raises TypeError"),
        ("print(self.speed[0])", "taking an item of it raises TypeError"),
        ("print(len(self.speed))", "len() of it raises TypeError"),
        ("self.get_logger().info(self.speed)", "info() of it raises TypeError"),
        ("print(self.speed())", "calling it raises TypeError"),
    ],
)
def test_a_field_that_is_kept_and_taken_for_something_else(judge: Judge, first: str, line: str, says: str):
    (finding,) = judge("MSG003", KEPT.format(first=first, kept="msg.data", line=f"{line}  # here"))
    assert finding.message == f"'self.speed' is 'data' of std_msgs/msg/Float32, a float, and {says}"
    assert [related.message for related in finding.related] == ["'self.speed' gets it here"]


@pytest.mark.parametrize(
    ("first", "kept", "line"),
    [
        ("0.0", "msg.data", "print(f'speed: {self.speed}', 'speed: ' + str(self.speed), self.speed + 1)"),
        ("'none'", "msg.data", "if self.speed == 'none': return"),
        ("0.0", "str(msg.data)", "print('speed: ' + self.speed)"),
        ("self.load()", "msg.data", "print('speed: ' + self.speed)"),
        ("0.0", "msg.data", "self.speed = self.load(); print('speed: ' + self.speed)"),
        ("0.0", "msg.data", "print('speed: ' + self.speed if isinstance(self.speed, str) else '')"),
        ("0.0", "msg.data; self.speed = [msg.data]", "print(self.speed[0])"),
    ],
)
def test_a_field_that_is_kept_as_what_it_is(judge: Judge, first: str, kept: str, line: str):
    judge("MSG003", KEPT.format(first=first, kept=kept, line=line))
