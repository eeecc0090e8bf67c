"""What a connection is used as, what shows it, and which kind fits: the lesson's table, and its opposites."""

from __future__ import annotations

from pathlib import Path

import pytest

from advice.advised import advised, node
from archlint.advice.model import Advice


def told(advice: Advice) -> tuple[str, str | None]:
    return str(advice.judged.use), advice.judged.fits


# ------------------------------------------------------------------------------------------ the lesson's scenarios


ROBOT = node(
    "robot",
    """
self.camera = self.create_publisher(Image, 'image', 10)
self.battery = self.create_publisher(BatteryState, 'battery', 10)
self.odometry = self.create_publisher(Odometry, 'odom', 10)
self.create_timer(1 / 30, self.see)
self.create_timer(2.0, self.report)
self.create_timer(0.02, self.move)
self.create_service(SetBool, 'enable', self.enable)
self.create_service(Trigger, 'battery_level', self.level)
self.create_service(SetMotorSpeed, 'move_forward', self.forward)
""",
    """
def see(self):
    self.camera.publish(Image())

def report(self):
    self.battery.publish(BatteryState())

def move(self):
    self.odometry.publish(Odometry())

def enable(self, request, response):
    response.success = True
    return response

def level(self, request, response):
    response.message = '80 %'
    return response

def forward(self, request, response):
    response.success = True
    return response
""",
)
PANEL = node(
    "panel",
    """
self.enable = self.create_client(SetBool, 'enable')
self.level = self.create_client(Trigger, 'battery_level')
self.forward = self.create_client(SetMotorSpeed, 'move_forward')
self.create_subscription(Bool, 'button', self.on_button, 10)
""",
    """
def on_button(self, message):
    self.enable.call_async(SetBool.Request(data=True))
    self.level.call_async(Trigger.Request()).add_done_callback(self.show)
    self.forward.call_async(SetMotorSpeed.Request(speed_rpm=1.0)).add_done_callback(self.moved)

def show(self, future):
    self.get_logger().info(future.result().message)

def moved(self, future):
    self.get_logger().info(f'{future.result().success}')
""",
)


def test_the_scenarios_of_the_lesson(tmp_path: Path):
    advice = advised(tmp_path, robot=ROBOT, panel=PANEL)
    assert {name: told(one) for name, one in advice.items()} == {
        "/image": ("stream", "topic"),
        "/battery": ("stream", "topic"),
        "/odom": ("stream", "topic"),
        "/button": ("unknown", None),
        "/enable": ("command", "service"),
        "/battery_level": ("query", "service"),
        "/move_forward": ("command", "service"),
    }
    assert advice["/image"].judged.rate == pytest.approx(30.0)
    assert advice["/button"].judged.reason == "no node here publishes it"
    assert all(one.is_fitting is not False for one in advice.values())


# ------------------------------------------------------------------------------------------------------- services


ASK = """
def tick(self):
    self.client.call_async(GetSensorData.Request(sensor_id='temperature')).add_done_callback(self.show)

def show(self, future):
    print(future.result().latest_value)
"""


@pytest.mark.parametrize(("period", "expected"), [("0.1", ("stream", "topic")), ("5.0", ("query", "service"))])
def test_how_often_decides_whether_a_query_is_a_stream(tmp_path: Path, period: str, expected: tuple[str, str]):
    client = "self.client = self.create_client(GetSensorData, 'query_sensor')\n"
    display = node("display", client + f"self.create_timer({period}, self.tick)", ASK)
    advice = advised(tmp_path, "sensor_node", display=display)["/query_sensor"]
    assert told(advice) == expected
    lines = [evidence.words for evidence in advice.judged.evidence]
    assert lines[1:] == ["the timer is made here", "/display reads latest_value of the answer"]
    if expected[0] == "stream":
        assert advice.judged.instead == "publish the data in /sensor_node, and subscribe to it in /display"
        assert lines[0] == "/display calls it 10 times a second"


def test_set_points_are_published_by_who_has_them(tmp_path: Path):
    setup = "self.motor = self.create_client(SetMotorSpeed, 'set_motor')\nself.create_timer(0.1, self.tick)"
    tick = "def tick(self):\n    self.motor.call_async(SetMotorSpeed.Request(speed_rpm=random.random()))"
    advice = advised(tmp_path, "motor_node", driver=node("driver", setup, tick))["/set_motor"]
    assert told(advice) == ("stream", "topic")
    assert advice.judged.instead == "publish the data in /driver, and subscribe to it in /motor_node"


def test_a_handler_that_takes_long_is_a_task(tmp_path: Path):
    arm = node(
        "arm",
        "self.create_service(Trigger, 'go_home', self.go_home)",
        "def go_home(self, request, response):\n    time.sleep(5.0)\n    response.success = True\n    return response",
    )
    advice = advised(tmp_path, arm=arm)["/go_home"]
    assert told(advice) == ("task", "action")
    assert [evidence.words for evidence in advice.judged.evidence] == [
        "the handler of the service 'go_home' sleeps for 5 s: meanwhile the caller waits and cannot cancel"
    ]


def test_a_command_that_is_repeated(tmp_path: Path):
    setup = "self.lamp = self.create_client(SetBool, 'lamp')\nself.create_timer(0.5, self.tick)"
    tick = "def tick(self):\n    self.lamp.call_async(SetBool.Request(data=True))"
    assert told(advised(tmp_path, lamp=node("lamp", setup, tick))["/lamp"]) == ("command", "service")


def test_the_answers_of_another_service_of_the_same_type_do_not_count(tmp_path: Path):
    setup = "self.start = self.create_client(Trigger, 'start')\nself.level = self.create_client(Trigger, 'level')\n"
    setup += "self.create_subscription(Bool, 'button', self.on_button, 10)"
    methods = """
def on_button(self, message):
    self.start.call_async(Trigger.Request())
    self.level.call_async(Trigger.Request()).add_done_callback(self.show)

def show(self, future):
    self.get_logger().info(future.result().message)
"""
    advice = advised(tmp_path, panel=node("panel", setup, methods))
    assert told(advice["/start"]) == ("command", "service")
    assert told(advice["/level"]) == ("query", "service")


def test_nobody_calls_it(tmp_path: Path):
    advice = advised(tmp_path, "motor_node")["/set_motor"]
    assert (told(advice), advice.judged.reason) == (("unknown", None), "no node here calls it")


def test_who_gets_the_answer_is_not_followed(tmp_path: Path):
    setup = "from elsewhere import take\ntake(self)\nself.client = self.create_client(Trigger, 'start')\n"
    setup += "self.create_subscription(Bool, 'button', self.on_button, 10)"
    panel = node("panel", setup, "def on_button(self, message):\n    self.client.call_async(Trigger.Request())")
    advice = advised(tmp_path, panel=panel)["/start"]
    assert (told(advice), advice.judged.reason) == (("unknown", None), "code that is not followed may use the answer")


# --------------------------------------------------------------------------------------------------------- topics


def test_what_follows_a_stream_is_one(tmp_path: Path):
    setup = "self.pub = self.create_publisher(Float64, 'filtered', 10)\n"
    setup += "self.create_subscription(Float64, 'raw', self.on_raw, 10)"
    advice = advised(tmp_path, filter=node("filter", setup, "def on_raw(self, msg):\n    self.pub.publish(msg)"))
    assert told(advice["/filtered"]) == ("stream", "topic")
    guarded = "def on_raw(self, msg):\n    if msg.data > 1.0:\n        self.pub.publish(msg)"
    advice = advised(tmp_path, filter=node("filter", setup, guarded))
    assert told(advice["/filtered"]) == ("command", "topic")


COMMAND = "self.pub = self.create_publisher(String, 'say', 10)\nself.create_service(Trigger, 'go', self.go)"
GO = "def go(self, request, response):\n    self.pub.publish(String(data='go'))\n    return response\n"


def test_two_topics_that_are_request_and_response(tmp_path: Path):
    boss = node("boss", COMMAND + "\nself.create_subscription(String, 'done', self.on_done, 10)", GO + (
        "\ndef on_done(self, msg):\n    self.get_logger().info(msg.data)"
    ))  # fmt: skip
    worker = node(
        "worker",
        "self.pub = self.create_publisher(String, 'done', 10)\nself.create_subscription(String, 'say', self.on, 10)",
        "def on(self, msg):\n    self.pub.publish(String(data='ok'))",
    )
    advice = advised(tmp_path, boss=boss, worker=worker)["/say"]
    assert told(advice) == ("query", "service")
    assert advice.judged.reason == "each message is answered by one on /done, which is what a service is for"
    logger = node("logger", "self.create_subscription(String, 'done', print, 10)")
    assert told(advised(tmp_path, boss=boss, worker=worker, logger=logger)["/say"]) == ("command", "topic")


def test_a_topic_whose_messages_are_tasks(tmp_path: Path):
    worker = node(
        "worker",
        "self.create_subscription(String, 'say', self.on, 10)",
        "def on(self, msg):\n    time.sleep(3.0)",
    )
    assert told(advised(tmp_path, boss=node("boss", COMMAND, GO), worker=worker)["/say"]) == ("task", "action")


# -------------------------------------------------------------------------------------------------------- actions


SERVE = "self.server = ActionServer(self, Fibonacci, 'count', self.work)"


@pytest.mark.parametrize(
    ("work", "expected"),
    [
        ("goal.succeed()\n    return Fibonacci.Result()", ("command", "service")),
        ("for _ in range(3):\n        goal.publish_feedback(Fibonacci.Feedback())\n    return Fibonacci.Result()",
         ("task", "action")),
        ("time.sleep(1.0)\n    goal.succeed()\n    return Fibonacci.Result()", ("task", "action")),
        ("self.arm.move()\n    goal.succeed()\n    return Fibonacci.Result()", ("unknown", None)),
    ],
    ids=["at once", "with feedback", "with a pause", "by a library"],
)  # fmt: skip
def test_how_goals_are_worked_on(tmp_path: Path, work: str, expected: tuple[str, str | None]):
    advice = advised(tmp_path, counter=node("counter", SERVE, f"def work(self, goal):\n    {work}"))
    assert told(advice["/count"]) == expected


def test_the_server_is_not_here(tmp_path: Path):
    advice = advised(tmp_path, boss=node("boss", "self.client = ActionClient(self, Fibonacci, 'count')"))["/count"]
    assert (told(advice), advice.judged.reason) == (("unknown", None), "the code that works on its goals is not here")


# -------------------------------------------------------------------------------------------------------- systems


def test_a_launch_file_says_how_a_connection_is_made(tmp_path: Path):
    launch = "<launch><node pkg='my_first_package' exec='display' namespace='left'/></launch>"
    display = node("display", "self.pub = self.create_publisher(Bool, 'on', 10)\nself.create_timer(1.0, self.tick)", (
        "def tick(self):\n    self.pub.publish(Bool())"
    ))  # fmt: skip
    advice = advised(tmp_path, display=display, **{"robot.launch.xml": launch})["/left/on"]
    assert told(advice) == ("stream", "topic")
    assert [Path(name).name for name in advice.systems] == ["robot.launch.xml"]
