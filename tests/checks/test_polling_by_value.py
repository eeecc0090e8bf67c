"""SRV004: which values are sent by service and how often, however the code is written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from textwrap import dedent, indent

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from checks.judging import Judge
from learners import Learned, complete

Robot = Callable[..., list[str]]

CLASS = """\
import random
import threading
import time

import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node
from std_msgs.msg import Float64
from std_srvs.srv import SetBool, Trigger
from my_robot_interfaces.srv import GetSensorData, SetMotorSpeed


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.speed = 0.0
        self.motor = self.create_client(SetMotorSpeed, 'set_motor')
        self.sensor = self.create_client(GetSensorData, 'query_sensor')
{setup}

{methods}

def main():
    rclpy.init()
    rclpy.spin(Robot())
"""


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[Finding]]:
    """What SRV004 finds in the package of a learner; the lesson's sensor and motor are there, too."""
    monkeypatch.chdir(tmp_path)

    def run(setup: str, methods: str, **files: str) -> list[Finding]:
        text = CLASS.format(setup=indent(dedent(setup), " " * 8), methods=indent(dedent(methods).strip("\n"), " " * 4))
        workspace = Learned("", "")
        workspace.files["src/my_first_package/my_first_package/robot.py"] = text
        workspace.files.update(files)
        complete(workspace, ["sensor_node", "motor_node"])
        workspace.write(tmp_path)
        (tmp_path / "archlint.toml").write_text('select = ["SRV004"]', "utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


@pytest.fixture
def robot(findings: Callable[..., list[Finding]]) -> Robot:
    """The words of what is found."""
    return lambda *words, **files: [finding.message.partition(" sends ")[2] for finding in findings(*words, **files)]


TICK = "self.create_timer(0.1, self.tick)"
SHOW = "\ndef show(self, future):\n    print(future.result().latest_value)\n"


# ------------------------------------------------------------------------------------------------ the same request


@pytest.mark.parametrize(
    ("setup", "tick"),
    [
        ("", "self.sensor.call_async(GetSensorData.Request(sensor_id='a'))"),
        ("self.request = GetSensorData.Request(sensor_id='a')", "self.sensor.call_async(self.request)"),
        ("", "request = GetSensorData.Request()\n    request.sensor_id = 'a'\n    self.sensor.call_async(request)"),
        ("self.declare_parameter('id', 'a')\nself.id = self.get_parameter('id').value",
         "self.sensor.call_async(GetSensorData.Request(sensor_id=self.id))"),
    ],
    ids=["made here", "kept", "filled", "from a parameter"],
)  # fmt: skip
def test_where_a_request_is_made_does_not_matter(robot: Robot, setup: str, tick: str):
    methods = f"def tick(self):\n    {tick}.add_done_callback(self.show)\n{SHOW}"
    [words] = robot(f"{setup}\n{TICK}", methods)
    assert words == "the service 'query_sensor' the same request 10 times a second: use a topic for this data"


def test_what_one_callback_asks_for_is_one_finding(findings: Callable[..., list[Finding]]):
    asks = "    self.sensor.call_async(GetSensorData.Request(sensor_id='{}')).add_done_callback(self.show)\n"
    [told] = findings(TICK, f"def tick(self):\n{asks.format('a')}{asks.format('b')}{SHOW}")
    assert told.message.endswith("; another request is sent like that")
    assert told.related[-1].place.line == told.place.line + 1


def test_a_helper_makes_it_or_sends_it(robot: Robot):
    methods = """
    def tick(self):
        self.ask(self.request_for('a'))

    def request_for(self, name):
        return GetSensorData.Request(sensor_id=name)

    def ask(self, request):
        self.sensor.call_async(request).add_done_callback(self.show)
    """
    assert len(robot(TICK, dedent(methods) + SHOW)) == 1


def test_a_request_that_depends_on_what_was_seen_is_another_each_time(robot: Robot):
    methods = """
    def on_name(self, message):
        self.name = str(message.data)

    def tick(self):
        self.sensor.call_async(GetSensorData.Request(sensor_id=self.name)).add_done_callback(self.show)
    """
    setup = f"self.name = ''\nself.create_subscription(Float64, 'name', self.on_name, 10)\n{TICK}"
    assert robot(setup, dedent(methods) + SHOW) == []


def test_a_command_that_is_repeated_is_no_data(robot: Robot):
    methods = """
    def tick(self):
        self.lamp.call_async(SetBool.Request(data=True)).add_done_callback(self.show)

    def show(self, future):
        print(future.result().message)
    """
    assert robot(f"self.lamp = self.create_client(SetBool, 'lamp')\n{TICK}", methods) == []


def test_a_lambda(robot: Robot):
    ask = "lambda: self.sensor.call_async(GetSensorData.Request(sensor_id='a')).add_done_callback(self.show)"
    assert len(robot(f"self.create_timer(0.1, {ask})", SHOW)) == 1
    guarded = ask.replace("lambda: ", "lambda: self.speed > load() and ")
    assert robot(f"self.create_timer(0.1, {guarded})", SHOW) == []


# ------------------------------------------------------------------------------------------------------- the pace


THREAD = "threading.Thread(target=self.work, daemon=True).start()"


@pytest.mark.parametrize(
    ("loop", "pace"),
    [
        ("while rclpy.ok():\n        self.ask()\n        time.sleep(0.2)", "up to 5 times a second"),
        ("rate = self.create_rate(5)\n    while True:\n        self.ask()\n        rate.sleep()",
         "up to 5 times a second"),
        ("while True:\n        for _ in ('a', 'b'):\n            self.ask()\n        time.sleep(0.5)",
         "up to 2 times a second"),
        ("while True:\n        self.ask()\n        time.sleep(2.0)", None),
        ("while True:\n        self.ask()\n        time.sleep(load())", None),
        ("for _ in range(10):\n        self.ask()\n        time.sleep(0.1)", None),
        ("while True:\n        self.ask()\n        time.sleep(0.1)\n        if done():\n            break", None),
        ("while True:\n        if wanted():\n            self.ask()\n        time.sleep(0.1)", None),
        ("while self.speed < 3.0:\n        self.ask()\n        time.sleep(0.1)", None),
    ],
)  # fmt: skip
def test_loops(robot: Robot, loop: str, pace: str | None):
    methods = f"""
def work(self):
    {loop}

def ask(self):
    self.sensor.call_async(GetSensorData.Request(sensor_id='a')).add_done_callback(self.show)
"""
    found = robot(THREAD, methods + SHOW)
    assert [pace in words for words in found] == ([] if pace is None else [True])


def test_each_answer_sends_the_next_request(robot: Robot):
    methods = """
    def ask(self):
        self.sensor.call_async(GetSensorData.Request(sensor_id='a')).add_done_callback(self.show)

    def show(self, future):
        print(future.result().latest_value)
        {again}
    """
    [words] = robot("self.ask()", methods.format(again="self.ask()"))
    assert "as soon as the last one is answered" in words
    assert robot("self.ask()", methods.format(again="if future.result().latest_value < 1.0: self.ask()")) == []


@pytest.mark.parametrize("end", ["self.timer.cancel()", "self.timer.destroy()", "self.destroy_timer(self.timer)"])
def test_a_timer_that_some_other_callback_ends(robot: Robot, end: str):
    methods = f"""
    def tick(self):
        self.sensor.call_async(GetSensorData.Request(sensor_id='a')).add_done_callback(self.show)

    def show(self, future):
        if future.result().latest_value > 3.0:
            {end}
    """
    assert robot("self.timer = self.create_timer(0.1, self.tick)", methods) == []


# ------------------------------------------------------------------------------------------- numbers in requests


SEND = """
def on_speed(self, message):
    self.speed = message.data

def tick(self):
    self.motor.call_async(SetMotorSpeed.Request(motor_id='left', speed_rpm={value}))
"""
LISTEN = "self.create_subscription(Float64, 'speed', self.on_speed, 10)\n"


@pytest.mark.parametrize("value", ["self.speed", "self.speed * 2.0", "random.uniform(0.0, 1.0)"])
def test_numbers_that_change(robot: Robot, value: str):
    [words] = robot(LISTEN + TICK, SEND.format(value=value))
    assert words == (
        "the service 'set_motor' numbers 10 times a second, and only whether that worked comes back: "
        "use a topic for this data"
    )


@pytest.mark.parametrize("value", ["50.0", "self.get_parameter('speed').value"])
def test_numbers_that_stay(robot: Robot, value: str):
    assert robot(f"self.declare_parameter('speed', 1.0)\n{LISTEN}{TICK}", SEND.format(value=value)) == []


def test_numbers_that_are_sent_seldom_or_on_an_occasion(robot: Robot):
    assert robot(LISTEN + "self.create_timer(2.0, self.tick)", SEND.format(value="self.speed")) == []
    guarded = SEND.replace("    self.motor.call_async", "    if self.speed != load():\n        self.motor.call_async")
    assert robot(LISTEN + TICK, guarded.format(value="self.speed")) == []


def test_numbers_that_are_answered_with_data(robot: Robot):
    interface = "float64 x\n---\nfloat64 y\n"
    methods = """
    def tick(self):
        self.speed += 0.1
        self.map.call_async(Convert.Request(x=self.speed)).add_done_callback(self.show)

    def show(self, future):
        print(future.result().y)
    """
    setup = f"from my_robot_interfaces.srv import Convert\nself.map = self.create_client(Convert, 'map')\n{TICK}"
    assert robot(setup, methods, **{"src/my_robot_interfaces/srv/Convert.srv": interface}) == []


def test_numbers_for_a_service_that_somebody_else_defines(robot: Robot):
    methods = """
    def tick(self):
        self.speed += 0.1
        request = SetEntityState.Request()
        request.state.pose.position.x = self.speed
        self.world.call_async(request)
    """
    setup = "from gazebo_msgs.srv import SetEntityState\nself.world = self.create_client(SetEntityState, 'set')\n"
    assert robot(setup + TICK, methods) == []


def test_a_message_each_time_whose_pace_is_known(robot: Robot):
    methods = """
    def tick(self):
        self.pub.publish(Float64(data=1.0))

    def on_speed(self, message):
        self.motor.call_async(SetMotorSpeed.Request(motor_id='left', speed_rpm=message.data))
    """
    publish = "self.pub = self.create_publisher(Float64, 'speed', 10)\nself.create_timer({period}, self.tick)\n"
    assert len(robot(LISTEN + publish.format(period="0.5"), methods)) == 1
    assert robot(LISTEN + publish.format(period="5.0"), methods) == []
    assert robot(LISTEN, methods) == []


# ------------------------------------------------------------------------------------------------ too many requests


PHOTO = """
def photo(self, request, response):
    time.sleep({seconds})
    return response

def tick(self):
    self.camera.call_async(Trigger.Request())
"""
CAMERA = "self.camera = self.create_client(Trigger, 'photo')\nself.create_service(Trigger, 'photo', self.photo{more})\n"


def test_requests_that_come_faster_than_they_are_answered(findings):
    [found] = findings(CAMERA.format(more="") + TICK, PHOTO.format(seconds=1.0))
    assert found.message == (
        "the timer callback, Robot.tick, sends the service 'photo' a request 10 times a second, and each keeps its "
        "handler for 1 s: the requests pile up"
    )
    assert found.related[-1].message == "the handler sleeps here; it takes 1 s in all"


def test_a_handler_that_keeps_up(robot: Robot):
    assert robot(CAMERA.format(more="") + TICK, PHOTO.format(seconds=0.05)) == []


def test_a_handler_that_runs_beside_itself(robot: Robot):
    several = CAMERA.format(more=", callback_group=ReentrantCallbackGroup()")
    assert robot(several + TICK, PHOTO.format(seconds=1.0)) == []


def test_who_waits_for_the_answer_sends_no_more_meanwhile(robot: Robot):
    methods = PHOTO.format(seconds=1.0).replace(
        "call_async(Trigger.Request())", "call(Trigger.Request(), timeout_sec=5.0)"
    )
    assert robot(CAMERA.format(more="") + TICK, methods) == []


MODES = """
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node
    from std_msgs.msg import String
    from std_srvs.srv import Trigger

    class Manager(Node):
        def __init__(self):
            super().__init__('manager')
            self.modes = self.create_publisher(String, 'mode', 10)
            self.create_service(Trigger, 'state', self.on_state)
            self.create_timer(1.0, lambda: self.modes.publish(String(data='idle')))

        def on_state(self, request, response):
            response.message = 'idle'
            return response

    class Display(Node):
        def __init__(self):
            super().__init__('display')
            self.client = self.create_client(Trigger, 'state')
            self.create_subscription(String, '{topic}', print, 10)
            self.create_timer(1.0, self.ask)

        def ask(self):
            self.client.call_async(Trigger.Request()).add_done_callback(self.on_answer){mark}

        def on_answer(self, future):
            print(future.result().message)

    def main():
        rclpy.init()
        executor = SingleThreadedExecutor()
        executor.add_node(Manager())
        executor.add_node(Display())
        executor.spin()

    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(("topic", "mark"), [("mode", ""), ("battery", "  # here")])
def test_a_server_whose_topic_the_node_hears_anyway(judge: Judge, topic: str, mark: str):
    judge("SRV004", MODES.format(topic=topic, mark=mark))
