"""EXE003, EXE004, EXE007 and SRV008: what keeps the thread of a callback."""

from __future__ import annotations

import textwrap
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Severity
from checks.callbacks import ON_ONE_THREAD, ON_SEVERAL_THREADS, Run, codes, source
from robot_package import SETUP, TALKER, write_robot

ALONE = "self.create_timer(5.0, self.tick)\n"
TIMER = "self.create_subscription(Empty, 'beside', print, 10)\n" + ALONE


def timer(body: str) -> str:
    return f"def tick(self):\n    {body}\n"


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        pytest.param("time.sleep(1.0)", ["EXE003"], id="a sleep"),
        pytest.param("time.sleep(0.01)", [], id="a moment"),
        pytest.param("[time.sleep(0.01) for _ in range(9)]", [], id="a few moments"),
        pytest.param("for _ in range(9):\n        time.sleep(0.01)", [], id="a few moments in a loop"),
        pytest.param("for _ in range(90):\n        time.sleep(0.01)", ["EXE003"], id="many moments in a loop"),
        pytest.param("for each in self.few:\n        time.sleep(0.05)", [], id="a moment for each of two"),
        pytest.param(
            "for each in self.few.values():\n        time.sleep(0.3)", ["EXE003"], id="longer for each of two"
        ),
        pytest.param("for each in self.many:\n        time.sleep(0.05)", ["EXE003"], id="a moment for each of many"),
        pytest.param("for byte in self.pause:\n        time.sleep(0.001)", [], id="a pause between bytes"),
        pytest.param("for step in self.pause:\n        time.sleep(0.5)", ["EXE003"], id="a pause between steps"),
        pytest.param("time.sleep(self.pause)", ["EXE003"], id="nobody knows how long"),
        pytest.param("subprocess.run(['make'])", ["EXE003"], id="a process"),
        pytest.param("import fcntl; fcntl.flock(self.file, fcntl.LOCK_EX)", [], id="a file lock"),
        pytest.param("subprocess.run(['sudo', 'shutdown', '-h', 'now'])", [], id="the end"),
        pytest.param("subprocess.run('/sbin/reboot', shell=True)", [], id="the end of all as a text"),
        pytest.param("subprocess.run(['systemctl', 'poweroff'])", [], id="the end by systemd"),
        pytest.param("subprocess.run(['sudo', 'shutdown', '-c'])", ["EXE003"], id="no end"),
        pytest.param("subprocess.run(['systemctl', 'restart', 'reboot'])", ["EXE003"], id="a unit of that name"),
        pytest.param("subprocess.run(['make'], timeout=9.0)", ["EXE003"], id="a process with a limit"),
        pytest.param("subprocess.check_output(['ping'], timeout=0.1)", [], id="a process for a moment"),
        pytest.param("input('go on? ')", ["EXE003"], id="the keyboard"),
        pytest.param("self.create_client(Trigger, 'a').wait_for_service", [], id="no call"),
    ],
)
def test_what_counts_as_slow(run: Run, body: str, expected: list[str]):
    fields = "self.pause = load_pause()\nself.few = {}\nself.few['left'] = 1\nself.few['right'] = 2\n"
    fields += "self.many = ['left']\nself.many.append('right')\n"
    found = codes(run(source(fields + TIMER, timer(body))))
    assert [code for code in found if code != "EXE005"] == expected


@pytest.mark.parametrize(
    ("call", "severity"),
    [
        ("subprocess.run(['pactl', 'set-sink-volume', self.sink, '50%'], check=True)", []),
        ("subprocess.run(['systemctl', '--quiet', 'is-active', 'robot'])", []),
        ("subprocess.check_output(['/sbin/iwconfig', 'wlan0'])", []),
        ("subprocess.check_output(['lsusb'])", []),
        ("subprocess.run('i2cset -y 1 0x{:02x} 0x00'.format(self.sink), shell=True)", []),
        ("subprocess.run('ip -4 addr show', shell=True)", []),
        ("subprocess.run(['pkill', '-9', '-f', 'driver'], timeout=5)", []),
        ("subprocess.run(['nmcli', '-t', 'device', 'show'])", []),
        ("for command in (['iwgetid'], ['iw', 'dev']):\n        if subprocess.run(command): break", []),
        ("for command in (['iwgetid'], ['make']):\n        if subprocess.run(command): break", ["warning"]),
        ("subprocess.run('echo goal > log/goal.txt', shell=True)", []),
        ("subprocess.run(f'echo \"{self.sink[0].name}\" '\n        f'> log/{self.sink}', shell=True)", []),
        ("subprocess.run(['touch', 'done'])", []),
        ("import os; os.system('ros2 run map map &')", []),
        ("import os; os.system('ros2 run map ' + self.sink + ' > /dev/null 2>&1 &')", []),
        ("import os; os.system(f'ros2 run map {self.sink} & ')", []),
        ("import os; os.system('(' + self.sink + ' &) && sleep 0.3')", []),
        ("import os; os.system('(' + self.sink + ' &) && sleep 3')", ["warning"]),
        ("import os; os.system('(' + self.sink + ') && sleep 0.3')", ["warning"]),
        ("import os; os.system('ros2 run map map')", ["warning"]),
        ("import os; os.system('ros2 run map map & make')", ["warning"]),
        ("import os; os.system('ros2 run map map & ' + self.sink)", ["warning"]),
        ("subprocess.run(f'{self.sink} echo goal', shell=True)", ["warning"]),
        ("subprocess.run('echo goal; make', shell=True)", ["warning"]),
        ("subprocess.run('echo goal && sleep 5', shell=True)", ["warning"]),
        ("subprocess.run('echo $(make)', shell=True)", ["warning"]),
        ("subprocess.run('echo y | apt upgrade', shell=True)", ["warning"]),
        ("subprocess.run(['ip', 'monitor'])", ["warning"]),
        ("subprocess.run(['nmcli', 'device', 'wifi', 'rescan'])", ["warning"]),
        ("subprocess.run(['systemctl', 'restart', 'pactl'])", ["warning"]),
        ("for _ in self.sink:\n        subprocess.run(['pactl', 'list'])", ["warning"]),
    ],
)
def test_a_command_of_milliseconds_keeps_nobody_waiting(run: Run, call: str, severity: list[str]):
    waits = [one for one in run(source("self.sink = load_pause()\n" + TIMER, timer(call))) if one.code == "EXE003"]
    assert [one.severity.label for one in waits] == severity


@pytest.mark.parametrize(
    ("command", "expected"),
    [("xacro {request} -o robot.urdf", []), ("/opt/xacro model", []), ("make {request}", ["EXE003"])],
)
def test_a_handler_needs_the_file_that_a_command_makes(run: Run, command: str, expected: list[str]):
    """In a group of its own, the others would go on beside what it changes."""
    serves = "self.create_service(Trigger, 'reset', self.reset)\nself.create_subscription(Empty, 'go', self.go, 1)\n"
    reset = f"def reset(self, request, response):\n    subprocess.run(f'{command}', shell=True)\n    return response\n"
    text = source(serves, reset + "\ndef go(self, message):\n    self.get_logger().info(str(message))\n")
    assert codes(run(text)) == expected


def test_what_takes_time_is_told_and_not_the_command_before_it(run: Run):
    """However many processes are ended, the pause after them is what costs time."""
    ends = "def end(self, names):\n    for name in names:\n        subprocess.run(['pkill', '-f', name])\n\n"
    restart = "def restart(self):\n    self.end(load())\n    time.sleep(0.5)\n\n"
    text = source(TIMER, ends + restart + timer("self.restart()"))
    [wait] = [found for found in run(text) if found.code == "EXE003"]
    assert "sleeps for 0.5 s" in wait.message and "another function" in wait.message


@pytest.mark.parametrize(("limit", "expected"), [("1.0", []), ("5.0", ["EXE003"])])
def test_a_callback_may_look_for_a_server_for_a_second(run: Run, limit: str, expected: list[str]):
    method = timer(f"if self.client.wait_for_service(timeout_sec={limit}): self.get_logger().info('there')")
    assert codes(run(source("self.client = self.create_client(Trigger, 'check')\n" + TIMER, method))) == expected


def test_a_dialogue_in_the_terminal_is_information(run: Run):
    beside = TIMER + "self.create_subscription(Empty, 'stop', print, 10)\n"
    [found] = run(source(beside, timer("input('where to? ')")))
    assert found.severity is Severity.INFO
    [found] = run(source(beside, timer("input('where to? ')\n    time.sleep(2.0)")))
    assert found.severity is Severity.WARNING


def test_a_short_sleep_is_long_for_a_short_period(run: Run):
    [found] = run(source("self.create_timer(0.02, self.tick)\n", timer("time.sleep(0.05)")))
    assert found.code == "EXE003" and "longer than its period of 0.02 s" in found.message


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("if read():\n        time.sleep(0.3)", []),  # a key that bounces
        ("if read():\n        time.sleep(1.5)", ["EXE003"]),
        ("time.sleep(0.3)", ["EXE003"]),  # then the period is never kept
    ],
)
def test_a_short_sleep_now_and_then_where_nobody_waits(run: Run, body: str, expected: list[str]):
    assert codes(run(source("self.create_timer(0.02, self.tick)\n", timer(body)))) == expected


@pytest.mark.parametrize(("seconds", "expected"), [(0.2, []), (0.5, []), (0.6, ["EXE003"])])
def test_a_moment_is_not_worth_a_word(run: Run, seconds: float, expected: list[str]):
    others = TIMER + "self.create_subscription(Empty, 'stop', print, 10)\n"
    assert codes(run(source(others, timer(f"time.sleep({seconds})")))) == expected


def test_a_loop_makes_a_long_sleep_of_short_ones(run: Run):
    body = "while self.moving():\n        time.sleep(0.02)"
    assert codes(run(source(TIMER, timer(body) + "\ndef moving(self):\n    return read()\n"))) == ["EXE003"]


@pytest.mark.parametrize(
    ("after", "expected"),
    [
        ("break", []),
        ("return", []),
        ("raise RuntimeError('stuck')", []),
        ("if item:\n                break", ["EXE003"]),
        ("continue", ["EXE003"]),
        ("pass", ["EXE003"]),
        ("for part in item:\n                break", ["EXE003"]),
    ],
)
def test_what_is_always_left_is_no_loop(run: Run, after: str, expected: list[str]):
    method = timer(
        f"for item in self.items:\n        if item:\n            self.pause()\n            {after}\n\n"
        "def pause(self):\n    time.sleep(0.05)\n"
    )
    assert codes(run(source("self.items = load()\n" + TIMER, method))) == expected


def test_the_sleeps_of_a_loop_that_is_known_are_summed_up(run: Run):
    body = "for each in self.sides:\n        time.sleep(0.5)"
    [found] = run(source("self.sides = ('left', 'right')\n" + TIMER, timer(body)))
    assert "sleeps for 0.5 s in each iteration of a loop, up to 1 s in all" in found.message


@pytest.mark.parametrize(
    ("test", "in_all"),
    [
        ("attempt < 3", 3),
        ("attempt != 3", 3),
        ("attempt >= 2", 2),
        ("attempt > 1 and attempt < 3", 4),  # which is not looked into
        ("read()", 4),
    ],
)
def test_a_loop_that_does_not_sleep_in_each_round(run: Run, test: str, in_all: int):
    body = f"for attempt in range(4):\n        if {test}:\n            time.sleep(0.5)"
    [found] = run(source(TIMER, timer(body)))
    assert f"sleeps for 0.5 s in each iteration of a loop, up to {in_all * 0.5:g} s in all" in found.message
    other = body.replace(test, "attempt == 3").replace("time.sleep", "read()\n        else:\n            time.sleep")
    [found] = run(source(TIMER, timer(other)))
    assert "up to 1.5 s in all" in found.message


START = """
def begin(self):
    {first}
    self.start()

def start(self):
    if not self.client.wait_for_service(timeout_sec=10.0):
        return
    self.get_logger().info('started')

def stop(self):
    self.timer.cancel()
"""


@pytest.mark.parametrize(
    ("first", "expected"),
    [
        pytest.param("pass", ["EXE003"], id="again and again"),
        pytest.param("self.timer.cancel()", [], id="cancelled before"),
        pytest.param("self.destroy_timer(self.timer)", [], id="destroyed before"),
        pytest.param("self.stop()", [], id="cancelled in a method"),
        pytest.param("if self.count_publishers('a'): self.timer.cancel()", ["EXE003"], id="perhaps cancelled"),
        pytest.param("self.start(); self.timer.cancel()", ["EXE003"], id="too late"),
    ],
)
def test_a_timer_that_has_ended_itself_has_no_next_turn(run: Run, first: str, expected: list[str]):
    create = "self.client = self.create_client(Trigger, 'a')\nself.timer = self.create_timer(2.0, self.begin)\n"
    found = [one for one in run(source(create, START.format(first=first))) if one.code == "EXE003"]
    assert [one.code for one in found] == expected
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    assert codes(run(source(create + beside, START.format(first=first)))) == expected


@pytest.mark.parametrize(
    ("first", "expected"),
    [
        ("if self.timer:\n        self.timer.cancel()", []),
        ("if self.timer is not None:\n        self.destroy_timer(self.timer)", []),
        ("if self.client.service_is_ready():\n        self.timer.cancel()", ["EXE003"]),
    ],
)
def test_a_timer_is_ended_if_there_is_one(run: Run, first: str, expected: list[str]):
    """Whoever starts it anew for the next time: the wait is one of many, and only if the server is absent."""
    create = "self.client = self.create_client(Trigger, 'a')\nself.timer = self.create_timer(2.0, self.begin)\n"
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    assert codes(run(source(create + beside, START.format(first=first)))) == expected


@pytest.mark.parametrize(
    ("wait", "missed", "expected"),
    [
        ("if not self.client.wait_for_service(timeout_sec=2.0)", "self.timer.cancel()\n        return", []),
        ("if not self.client.wait_for_service(timeout_sec=2.0)", "return", ["EXE003"]),
        ("if self.client.wait_for_service(timeout_sec=2.0)", "self.timer.cancel()", ["EXE003"]),
    ],
)
def test_a_timer_that_gives_up_at_a_miss(run: Run, wait: str, missed: str, expected: list[str]):
    """It waits in vain once, and never again."""
    create = "self.client = self.create_client(Trigger, 'a')\nself.timer = self.create_timer(2.0, self.begin)\n"
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    begin = f"\ndef begin(self):\n    {wait}:\n        {missed}\n    self.get_logger().info('started')\n"
    assert codes(run(source(create + beside, begin))) == expected


@pytest.mark.parametrize(
    ("guard", "expected"),
    [
        ("if hasattr(self, 'timer'):\n        self.timer.cancel()", []),
        ("self.timer.cancel()", []),
        ("if hasattr(self, 'other'):\n        self.timer.cancel()", ["EXE003"]),
        ("pass", ["EXE003"]),
    ],
)
def test_a_process_of_a_timer_that_has_ended(run: Run, guard: str, expected: list[str]):
    """The map is saved once, at the end."""
    create = "self.timer = self.create_timer(2.0, self.finish)\n"
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    finish = f"\ndef finish(self):\n    {guard}\n    subprocess.run(['map_saver'])\n"
    assert codes(run(source(create + beside, finish))) == expected


@pytest.mark.parametrize(
    ("way", "pause", "expected"),
    [
        ("if load():\n        self.sync()", "0.02", []),
        ("if load():\n        self.sync()", "0.05", ["EXE003"]),
        ("self.sync()", "0.02", ["EXE003"]),
    ],
)
def test_a_helper_that_costs_a_timer_a_turn_now_and_then(run: Run, way: str, pause: str, expected: list[str]):
    create = "self.create_timer(0.05, self.tick)\nself.create_subscription(Empty, 'beside', print, 10)\n"
    sync = f"\ndef sync(self):\n    for _ in range(3):\n        time.sleep({pause})\n"
    assert codes(run(source(create, timer(way) + sync))) == expected


OPENS = """
def drive(self):
    if self.port is None:
        {line}
        time.sleep({pause})
    self.port.write(b'1')


def open_gripper(self):
    self.port = self.opened[1]


def open_port(self):
    return self.opened[2]
"""


@pytest.mark.parametrize(
    ("line", "pause", "expected"),
    [
        ("self.port = serial.Serial('/dev/ttyACM0', 115200)", "2.0", []),
        ("self.port = self.open_port()", "0.5", []),
        ("self.port.open()", "0.5", []),
        ("self.port = serial.Serial('/dev/ttyACM0', 115200)", "5.0", ["EXE003"]),
        ("self.port = self.opened[0]", "2.0", ["EXE003"]),
        ("self.open_gripper()", "2.0", ["EXE003"]),
    ],
)
def test_a_device_that_starts_when_it_is_opened(run: Run, line: str, pause: str, expected: list[str]):
    create = "self.port, self.opened = None, open_all()\nself.timer = self.create_timer(1.0, self.drive)\n"
    create += "self.create_subscription(Empty, 'beside', print, 10)\n"
    assert codes(run(source(create, OPENS.format(line=line, pause=pause)))) == expected


ENDLESS = """
def tick(self):
    while not self.client.wait_for_service(timeout_sec=2.0):
        {body}
    self.client.call_async(Trigger.Request())
"""


@pytest.mark.parametrize(("body", "expected"), [("print('waiting')", ["TMO004"]), ("break", ["EXE003"])])
def test_a_loop_that_only_the_server_ends_is_told_as_that(run: Run, body: str, expected: list[str]):
    """Each wait in it has a limit, the loop has none."""
    create = "self.client = self.create_client(Trigger, 'a')\n" + TIMER
    assert codes(run(source(create, ENDLESS.format(body=body)))) == expected


RESTARTS = """
def tick(self):
    {}

def startAll(self):
    subprocess.run(['ros2', 'launch', 'robot', 'all.launch.py'])

def send_with_reconnect(self):
    if send():
        return
    self.open_port()
    time.sleep(0.5)

def open_port(self):
    self.port = open_serial()
"""


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("if not alive():\n        self.get_logger().warn('restarting the stack')\n        time.sleep(3.0)", []),
        ("if not alive():\n        self.get_logger().info('the stack is away')\n        time.sleep(3.0)", ["EXE003"]),
        ("self.get_logger().info('restarting the stack')\n    time.sleep(3.0)", ["EXE003"]),
        ("if not alive():\n        restart_stack()\n        time.sleep(3.0)", []),
        ("if not alive():\n        restrain()\n        time.sleep(3.0)", ["EXE003"]),
        ("self.send_with_reconnect()", []),
        ("if not alive():\n        self.get_logger().info('restarting')\n        self.startAll()", []),
        ("if not alive():\n        self.startAll()", ["EXE003"]),
    ],
)
def test_what_has_failed_is_brought_up_again_now_and_then(run: Run, body: str, expected: list[str]):
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    assert codes(run(source(TIMER + beside, RESTARTS.replace("{}", body)))) == expected


CHECKPOINT = """
def stop(self, message):
    self.save()
    {end}

def tick(self):
    self.save()

def save(self):
    subprocess.run(load(), check=False)
"""


@pytest.mark.parametrize("end", ["raise SystemExit", "sys.exit()", "pass"])
def test_of_several_callbacks_one_that_goes_on_is_named(run: Run, end: str):
    """After the other one, nothing is left that would have to wait."""
    create = "self.create_subscription(Empty, 'stop', self.stop, 10)\nself.create_timer(60.0, self.tick)\n"
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    text = source(create + beside, CHECKPOINT.replace("{end}", end))
    [wait] = [found for found in run(f"import sys\n{text}") if found.code == "EXE003"]
    assert ("Robot.tick" in wait.message) == (end != "pass")
    only = source(create.partition("\n")[0] + f"\n{beside}", CHECKPOINT.replace("{end}", end))
    assert ("EXE003" in codes(run(f"import sys\n{only}"))) == (end == "pass")


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        pytest.param("time.sleep(2.0)\n    self.timer.cancel()", [], id="cancelled after"),
        pytest.param(
            "if self.count_publishers('a'):\n        time.sleep(2.0)\n        self.timer.cancel()",
            [],
            id="in the same branch",
        ),
        pytest.param("time.sleep(2.0)\n    self.finish()", [], id="in a method"),
        pytest.param("time.sleep(2.0)", ["EXE003"], id="again and again"),
        pytest.param(
            "time.sleep(2.0)\n    if self.count_publishers('a'): self.timer.cancel()",
            ["EXE003"],
            id="perhaps cancelled",
        ),
        pytest.param("time.sleep(2.0)\n    self.other.cancel()", ["EXE003"], id="another timer"),
    ],
)
def test_a_timer_that_sleeps_and_ends_itself_sleeps_once(run: Run, body: str, expected: list[str]):
    create = (
        "self.create_subscription(Empty, 'beside', print, 10)\nself.timer = self.create_timer(0.5, self.tick)\n"
        "self.other = self.create_timer(9.0, print)\n"
    )
    finish = "\ndef finish(self):\n    self.timer.cancel()\n"
    assert [code for code in codes(run(source(create, timer(body) + finish))) if code == "EXE003"] == expected


PATROL = """
def begin(self):
    {first}
    self.send()

def send(self):
    if not self.client.wait_for_service(timeout_sec=5.0):
        return
    self.client.call_async(Trigger.Request()).add_done_callback(self.done)

def done(self, future):
    {then}
"""


@pytest.mark.parametrize(
    ("first", "then", "expected"),
    [
        pytest.param("pass", "pass", ["EXE003"], id="one wait"),
        pytest.param("if not self.client.wait_for_service(timeout_sec=1.0): return", "pass", [], id="found before"),
        pytest.param("if not self.client.service_is_ready(): return", "pass", [], id="ready before"),
        pytest.param("if self.client.wait_for_service(timeout_sec=1.0) is False: return", "pass", [], id="compared"),
        pytest.param("if not (self.patient and self.client.service_is_ready()): return", "pass", [], id="and more"),
        pytest.param("if not (self.patient or self.client.service_is_ready()): return", "pass", ["EXE003"], id="or"),
        pytest.param("if self.client.service_is_ready(): return", "pass", ["EXE003"], id="the other way round"),
        pytest.param("if not self.client.service_is_ready(): print()", "pass", ["EXE003"], id="it goes on anyway"),
        pytest.param("if not self.other.service_is_ready(): return", "pass", ["EXE003"], id="another server"),
        pytest.param("if not self.client.service_is_ready(): return", "self.send()", [], id="it has answered"),
        pytest.param("if not self.client.service_is_ready(): return", "self.timer = self.create_timer(1.0, self.send)",
                     ["EXE003"], id="later"),
    ],
)  # fmt: skip
def test_a_second_wait_for_the_same_server_costs_nothing(run: Run, first: str, then: str, expected: list[str]):
    create = "self.client = self.create_client(Trigger, 'a')\nself.other = self.create_client(Trigger, 'b')\n"
    create += "self.patient = load_patience()\n"
    found = codes(run(source(create + TIMER.replace("tick", "begin"), PATROL.format(first=first, then=then))))
    assert [code for code in found if code == "EXE003"] == expected


def test_a_callback_alone_in_its_group_holds_up_nobody_under_several_threads(run: Run):
    apart = "self.create_timer(5.0, self.tick, callback_group=MutuallyExclusiveCallbackGroup())\n"
    assert codes(run(source(apart, timer("time.sleep(1.0)"), ON_SEVERAL_THREADS))) == []
    assert codes(run(source(TIMER, timer("time.sleep(1.0)"), ON_SEVERAL_THREADS))) == ["EXE003"]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        pytest.param("time.sleep(0.9)", [], id="less than a second"),
        pytest.param("for _ in range(3):\n        time.sleep(0.9)", ["EXE003"], id="several times"),
        pytest.param("subprocess.run(['make'])", [], id="a process, for nobody knows how long"),
    ],
)
def test_the_next_message_may_wait_for_a_moment_or_for_work(run: Run, body: str, expected: list[str]):
    listens = "self.create_subscription(Empty, 'say', self.on_text, 10)\n"
    method = f"def on_text(self, message):\n    {body}\n"
    assert codes(run(source(listens, method))) == expected
    beside = listens + "self.create_subscription(Empty, 'stop', print, 10)\n"
    assert codes(run(source(beside, method))) == ["EXE003"]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        pytest.param(["if self.state == 'OPEN':", "    SLEEP", "    self.state = 'DONE'"], [], id="a state"),
        pytest.param(["if self.closed:", "    return", "SLEEP", "self.closed = True"], [], id="once"),
        pytest.param(["if self.state == 'OPEN':", "    self.open()"], [], id="a state with a method of its own"),
        pytest.param(["if self.state == 'OPEN':", "    SLEEP"], ["EXE003"], id="a state forever"),
        pytest.param(["SLEEP", "self.state = 'DONE'"], ["EXE003"], id="in each state"),
        pytest.param(
            ["if self.state == 'OPEN':", "    SLEEP", "    if self.hot:", "        self.state = 'DONE'"],
            ["EXE003"],
            id="a state that is left some day",
        ),
        pytest.param(
            ["if self.state == 'OPEN':", "    self.state = 'OPEN'", "    SLEEP"], ["EXE003"], id="a state that was set"
        ),
        pytest.param(["if self.closed:", "    return", "self.closed = True", "SLEEP"], [], id="once, said before"),
        pytest.param(
            ["if self.closed:", "    return", "self.closed = True", "SLEEP", "if self.hot:", "    self.closed = False"],
            ["EXE003"],
            id="busy meanwhile",
        ),
        pytest.param(["if self.left:", "    SLEEP", "    self.left -= 1"], ["EXE003"], id="a counter"),
    ],
)
def test_a_timer_may_sleep_in_a_state_that_it_leaves(run: Run, lines: list[str], expected: list[str]):
    create = "self.state = load_state()\nself.closed = load_state()\nself.hot = load_state()\nself.left = 9\n" + ALONE
    body = "\n    ".join(lines).replace("SLEEP", "time.sleep(6.0)")
    opens = "\ndef open(self):\n    time.sleep(6.0)\n    self.state = 'DONE'\n"
    assert codes(run(source(create, timer(body) + opens))) == expected
    beside = create + "self.create_service(Trigger, 'stop', print)\n"
    assert codes(run(source(beside, timer(body) + opens))) == ["EXE003"]


def test_what_holds_up_nobody_else_is_information(run: Run):
    listens = "self.create_subscription(Empty, 'stop', self.on_stop, 10)\n"
    [alone] = run(source(listens, "def on_stop(self, message):\n    time.sleep(2.0)\n"))
    assert alone.severity is Severity.INFO and "its next message has to wait" in alone.message
    [late] = run(source(ALONE, timer("time.sleep(6.0)")))
    assert late.severity is Severity.INFO and "longer than its period of 5 s" in late.message
    beside = listens + ALONE
    [found] = run(source(beside, timer("time.sleep(1.0)") + "\ndef on_stop(self, message):\n    pass\n"))
    assert found.severity is Severity.WARNING and "no other callback of the node runs in the meantime" in found.message


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("time.sleep(1.0)", []),
        ("time.sleep(message.pause)", []),
        ("while message.pause:\n        time.sleep(message.pause)", ["EXE003"]),
        ("time.sleep(1.5)", ["EXE003"]),
        ("subprocess.run(['make'])", []),
        ("self.client.wait_for_service(timeout_sec=5.0)", []),
        ("self.create_client(Trigger, 'check').wait_for_service(timeout_sec=5.0)", ["EXE003"]),
    ],
)
def test_the_next_message_of_a_node_with_no_other_work_may_be_late(run: Run, line: str, expected: list[str]):
    setup = "self.client = self.create_client(Trigger, 'check')\nself.create_subscription(Empty, 'go', self.go, 10)\n"
    method = f"def go(self, message):\n    {line}\n"
    assert [one for one in codes(run(source(setup, method))) if one == "EXE003"] == expected
    beside = run(source(setup + "self.create_subscription(Empty, 'stop', print, 10)\n", method))
    assert "EXE003" in codes(beside)


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        pytest.param(["self.brake()", "raise RuntimeError('stuck')"], [], id="it ends with an exception"),
        pytest.param(["self.brake()", "if self.hot:", "    raise RuntimeError('hot')"], ["EXE003"], id="perhaps"),
        pytest.param(
            ["try:", "    self.brake()", "    raise RuntimeError('stuck')", "except RuntimeError:", "    pass"],
            ["EXE003"],
            id="caught",
        ),
        pytest.param(["if self.hot:", "    raise RuntimeError('hot')", "self.brake()"], ["EXE003"], id="before"),
    ],
)
def test_what_a_callback_does_last_before_it_raises(run: Run, lines: list[str], expected: list[str]):
    brake = "\ndef brake(self):\n    time.sleep(0.7)\n"
    text = source("self.hot = load_state()\n" + TIMER, timer("\n    ".join(lines)) + brake)
    assert [code for code in codes(run(text)) if code == "EXE003"] == expected


@pytest.mark.parametrize(
    ("imported", "project", "told"),
    [("camera_sdk", True, 0), ("camera_sdk", False, 1), ("robot.third_party.camera_sdk", True, 1)],
    ids=["a copy of a library", "code of the package", "the copy itself"],
)
def test_a_wait_in_a_library_that_pip_may_have_installed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, imported: str, project: bool, told: int
):
    text = f"from {imported}.device import grab\n" + source(TIMER, timer("grab()"))
    texts = {"third_party/camera_sdk/device": "import time\n\n\ndef grab():\n    time.sleep(2.0)\n", "talker": text}
    files = {f"robot/{name}.py": text for name, text in texts.items()}
    files |= {"robot/third_party/pyproject.toml": "[project]\nname = 'camera_sdk'\n"} if project else {}
    write_robot(tmp_path, **files)
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert len([one for one in found if one.code == "EXE003"]) == told


def test_a_wait_in_a_helper_of_another_package_is_told_where_it_is_called(tmp_path, monkeypatch):
    manifest = (
        "<package format='3'><name>{0}</name><version>1.0.0</version><description>d</description>"
        "<maintainer email='a@b.org'>a</maintainer><license>MIT</license><depend>rclpy</depend>{1}"
        "<export><build_type>ament_python</build_type></export></package>"
    )
    setup = "from setuptools import setup\nsetup(name='{0}', packages=['{0}']{1})\n"
    entry = ", entry_points={'console_scripts': ['robot = robot.robot:main']}"
    files = {
        "pauses/package.xml": manifest.format("pauses", ""),
        "pauses/setup.py": setup.format("pauses", ""),
        "pauses/pauses/__init__.py": "import time\n\n\ndef pause():\n    time.sleep(2.0)\n",
        "robot/package.xml": manifest.format("robot", "<depend>pauses</depend>"),
        "robot/setup.py": setup.format("robot", entry),
        "robot/robot/__init__.py": "",
        "robot/robot/robot.py": "from pauses import pause\n" + source(TIMER, timer("pause()")),
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    [slow] = [one for one in found if one.code == "EXE003"]
    line = files["robot/robot/robot.py"].splitlines().index("        pause()") + 1
    assert (slow.place.file, slow.place.line) == ("robot/robot/robot.py", line)
    assert ("pauses/pauses/__init__.py", "it waits here") in [(one.place.file, one.message) for one in slow.related]

    other = {name.replace("robot", "other"): text.replace("robot.robot", "other.other") for name, text in files.items()}
    other["other/package.xml"] = manifest.format("other", "<depend>pauses</depend>")
    other["other/setup.py"] = setup.format("other", entry.replace("robot", "other"))
    for name, text in other.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    found = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [one.place.file for one in found if one.code == "EXE003"] == ["pauses/pauses/__init__.py"]


CHAIN = """
def go(self, message):
    if self.states.wait_for_service(timeout_sec=5.0):
        self.states.call_async(Trigger.Request()).add_done_callback(self.told)

def told(self, future):
    self.finish(future.result())

def finish(self, state):
    if self.end.wait_for_service(timeout_sec=5.0):
        self.end.call_async(Trigger.Request()).add_done_callback(self.finished)

def finished(self, future):
    self.get_logger().info('done')
"""


@pytest.mark.parametrize(
    ("more", "expected"),
    [
        ("", []),
        ("self.create_subscription(Empty, 'stop', print, 10)\n", ["EXE003"]),
        ("self.create_timer(5.0, self.get_name)\n", ["EXE003"]),
    ],
)
def test_a_node_in_which_all_comes_of_one_callback_may_look_for_servers(run: Run, more: str, expected: list[str]):
    create = "self.states = self.create_client(Trigger, 'states')\nself.end = self.create_client(Trigger, 'end')\n"
    listens = "self.create_subscription(Empty, 'go', self.go, 10)\n"
    assert [code for code in codes(run(source(create + listens + more, CHAIN))) if code == "EXE003"] == expected


GO_ON = """
def go(self):
    if self.client.wait_for_service(timeout_sec=5.0):
        self.client.call_async(Trigger.Request()).add_done_callback(self.done)

def done(self, future):
    self.timer = self.create_timer(5.0, self.go)
    self.client.call_async(Trigger.Request()).add_done_callback(self.counted)

def counted(self, future):
    self.get_logger().info('again')
"""


@pytest.mark.parametrize(("more", "expected"), [("", []), ("self.create_service(Trigger, 'b', print)", ["EXE003"])])
def test_what_a_callback_asks_for_after_it_has_waited_does_not_wait(run: Run, more: str, expected: list[str]):
    create = f"self.client = self.create_client(Trigger, 'a')\nself.timer = self.create_timer(5.0, self.go)\n{more}\n"
    assert [one.code for one in run(source(create, GO_ON)) if one.code == "EXE003"] == expected


RELAY = """
def go(self, message):
    {wait}
    self.client.send_goal_async(Fibonacci.Goal(), feedback_callback=self.told).add_done_callback(self.taken)

def told(self, feedback):
    self.get_logger().info('on the way')

def taken(self, future):
    future.result().get_result_async().add_done_callback(self.ended)

def ended(self, future):
    self.get_logger().info('there')
"""


@pytest.mark.parametrize(
    ("wait", "more", "severity"),
    [
        ("if not self.client.wait_for_server(timeout_sec=5.0): return", "", None),
        # The feedback of the goal before comes, and has to wait.
        ("time.sleep(5.0)", "", Severity.WARNING),
        (
            "if not self.client.wait_for_server(timeout_sec=5.0): return",
            "self.create_subscription(Empty, 'stop', print, 10)\n",
            Severity.WARNING,
        ),
    ],
)
def test_a_server_that_is_not_there_gives_no_feedback(run: Run, wait: str, more: str, severity: Severity | None):
    setup = (
        "self.client = ActionClient(self, Fibonacci, 'count')\nself.create_subscription(Empty, 'goal', self.go, 10)\n"
    )
    found = [one for one in run(source(setup + more, RELAY.format(wait=wait))) if one.code == "EXE003"]
    assert [one.severity for one in found] == ([] if severity is None else [severity])


TOUR = """
def go(self):
    self.client.send_goal_async(Fibonacci.Goal()).add_done_callback(self.taken)

def taken(self, future):
    future.result().get_result_async().add_done_callback(self.ended)

def ended(self, future):
    self.get_logger().info('there')
    time.sleep(3.0)
    {then}
"""
ON_TOUR = ON_ONE_THREAD.replace("rclpy.spin(Robot())", "robot = Robot()\n    {start}\n    rclpy.spin(robot)")


@pytest.mark.parametrize(
    ("then", "start", "more", "expected"),
    [
        ("self.go()", "robot.go()", "", []),  # no goal is on its way meanwhile
        ("self.go()", "robot.go()", "self.create_subscription(Empty, 'stop', print, 10)\n", ["EXE003"]),
        ("self.go()", "for _ in range(3): robot.go()", "", ["EXE003"]),
    ],
)
def test_a_pause_between_the_goals_of_a_sequence(run: Run, then: str, start: str, more: str, expected: list[str]):
    create = "self.client = ActionClient(self, Fibonacci, 'count')\n" + more
    text = source(create, TOUR.replace("{then}", then), ON_TOUR.replace("{start}", start))
    assert [found.code for found in run(text) if found.code == "EXE003"] == expected


def test_a_parameter_callback_has_no_group_that_it_could_be_given(run: Run):
    slow = "for param in params:\n        time.sleep(1.0)\n    return SetParametersResult(successful=True)"
    method = f"def on_set(self, params):\n    {slow}\n\n"
    text = source(TIMER + "self.add_on_set_parameters_callback(self.on_set)\n", method + timer("pass"))
    [found] = run("from rcl_interfaces.msg import SetParametersResult\n" + text)
    assert found.code == "EXE003" and found.help == "store the new value, return, and continue from a timer"


def test_a_timer_that_is_all_there_is_may_be_late(run: Run):
    assert codes(run(source(ALONE, timer("time.sleep(1.0)")))) == []
    assert codes(run(source(ALONE, timer("subprocess.run(['make'])")))) == []


@pytest.mark.parametrize(
    ("beside", "severity"),
    [
        pytest.param("self.create_publisher(Empty, 'out', 10)", None, id="a publisher"),
        pytest.param("self.create_client(Trigger, 'check')", None, id="a client"),
        pytest.param("bring_up(self)", Severity.INFO, id="nobody knows"),
        pytest.param("self.listener = TransformListener(Buffer(), self)", Severity.WARNING, id="a listener"),
        pytest.param("self.create_service(Trigger, 'stop', print)", Severity.WARNING, id="a service"),
        pytest.param("self.create_timer(1.0, print)", Severity.INFO, id="a timer that seldom runs"),
        pytest.param("self.create_timer(0.1, print)", Severity.WARNING, id="a timer that often runs"),
        pytest.param("bring_up(self)\nself.create_timer(0.1, print)", Severity.WARNING, id="it, and what nobody knows"),
    ],
)
def test_somebody_has_to_wait(run: Run, beside: str, severity: Severity | None):
    found = run(source(f"{ALONE}{beside}\n", timer("time.sleep(1.0)")))
    assert [one.severity for one in found if one.code == "EXE003"] == ([] if severity is None else [severity])


@pytest.mark.parametrize(
    ("beside", "body", "expected"),
    [
        pytest.param(ALONE, "time.sleep(6.0)", [], id="nothing else"),
        pytest.param(ALONE + "self.create_timer(1.0, print)", "time.sleep(6.0)", [], id="a timer that seldom runs"),
        pytest.param(TIMER, "input('where to? ')", [], id="a dialogue"),
        pytest.param(ALONE + "bring_up(self)", "load(); time.sleep(6.0)", [], id="nobody knows"),
        pytest.param(
            ALONE + "self.create_timer(0.1, print)", "load(); time.sleep(6.0)", ["EXE003"], id="an often timer"
        ),
        pytest.param(ALONE + "self.create_timer(0.1, print)", "print(1); time.sleep(6.0)", [], id="in place of work"),
        pytest.param(
            ALONE + "self.create_timer(0.1, print)",
            "self.sent = True; time.sleep(6.0)",
            ["EXE003"],
            id="it keeps something",
        ),
        pytest.param(TIMER, "input('where to? ')\n    time.sleep(2.0)", ["EXE003"], id="a dialogue, and a sleep"),
    ],
)
def test_what_delays_nothing_that_matters_is_told_in_a_lesson_and_on_demand(
    run: Run, tmp_path: Path, beside: str, body: str, expected: list[str]
):
    others = "".join(f"    rclpy.create_node('part_{number}')\n" for number in range(5))
    large = ON_ONE_THREAD.replace("    rclpy.spin", f"{others}    rclpy.spin")
    assert codes(run(source(beside, timer(body), large))) == expected
    assert codes(run(source(beside, timer(body)))) == ["EXE003"]
    (tmp_path / "archlint.toml").write_text("[rules.slow-callback]\nalone = true\n", encoding="utf-8")
    assert codes(run(source(beside, timer(body), large))) == ["EXE003"]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["self.speak('good bye')", "time.sleep(3.0)"], []),
        (["sounddevice.play(load())", "sounddevice.wait()", "time.sleep(0.5)"], []),
        (["self.show('good bye')", "time.sleep(3.0)"], ["EXE003"]),
        (["self.speak('good bye')", "subprocess.run(['make'])"], ["EXE003"]),
    ],
)
def test_a_pause_after_words_that_are_spoken(run: Run, tmp_path: Path, lines: list[str], expected: list[str]):
    text = source(TIMER, "import sounddevice\n" + timer("\n    ".join(lines)))
    assert codes(run(text)) == expected
    (tmp_path / "archlint.toml").write_text("[rules.slow-callback]\nalone = true\n", encoding="utf-8")
    assert codes(run(text)) == ["EXE003"]


@pytest.mark.parametrize(
    ("does", "expected"), [("self.voice.publish(String(data=words))", ["EXE003"]), ("engine.runAndWait()", [])]
)
def test_who_has_another_node_speak_waits_for_no_words(run: Run, does: str, expected: list[str]):
    methods = timer("self.speak('stop')\n    time.sleep(3.0)") + f"\ndef speak(self, words):\n    {does}\n"
    setup = "self.voice = self.create_publisher(String, 'voice', 10)\n"
    assert codes(run(source(setup + TIMER, methods))) == expected


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["self.arm.publish(Empty())", "time.sleep(2.0)", "self.arm.publish(Empty())"], []),
        (["time.sleep(2.0)", "self.arm.publish(Empty())"], ["EXE003"]),
        (["self.arm.publish(Empty())", "time.sleep(2.0)", "self.hand.publish(Empty())"], ["EXE003"]),
    ],
)
def test_moves_with_pauses_that_delay_nothing_else(run: Run, tmp_path: Path, lines: list[str], expected: list[str]):
    setup = "self.arm = self.create_publisher(Empty, 'arm', 10)\nself.hand = self.create_publisher(Empty, 'hand', 10)\n"
    setup += "self.create_subscription(Empty, 'go', self.go, 10)\n"
    method = "def go(self, message):\n    " + "\n    ".join(lines) + "\n"
    assert codes(run(source(setup, method))) == expected
    beside = setup + "self.create_subscription(Empty, 'stop', print, 10)\n"
    assert codes(run(source(beside, method))) == ["EXE003"]
    (tmp_path / "archlint.toml").write_text("[rules.slow-callback]\nalone = true\n", encoding="utf-8")
    assert codes(run(source(setup, method))) == ["EXE003"]


@pytest.mark.parametrize(
    ("pause", "late", "expected"),
    [
        ("0.001", "raise TimeoutError", []),
        ("0.001", "break", ["EXE003"]),
        ("0.5", "raise TimeoutError", ["EXE003"]),
    ],
)
def test_a_device_that_answers_at_once_or_is_broken(run: Run, pause: str, late: str, expected: list[str]):
    lines = ["start = time.time()", "while self.port.waiting() < 9:", f"    time.sleep({pause})"]
    lines += ["    if time.time() - start > 10:", f"        {late}"]
    assert codes(run(source(TIMER, timer("\n    ".join(lines))))) == expected


ATTEMPTS = """
{loop}:
        try:
            self.load()
            {left}
        except OSError:
            {count}
            time.sleep({pause})
"""


@pytest.mark.parametrize(
    ("loop", "left", "count", "pause", "expected"),
    [
        ("for _ in range(5)", "break", "pass", "0.5", []),
        ("while tries < 5", "return", "tries += 1", "0.5", []),
        ("while True", "break", "pass", "0.5", ["EXE003"]),  # without an end
        ("for _ in range(5)", "pass", "pass", "0.5", ["EXE003"]),  # each of five may fail
        ("for _ in range(5)", "break", "pass", "3.0", ["EXE003"]),
    ],
)
def test_the_pauses_between_a_few_attempts(run: Run, loop: str, left: str, count: str, pause: str, expected: list[str]):
    body = "tries = 0\n    " + ATTEMPTS.format(loop=loop, left=left, count=count, pause=pause).strip()
    assert codes(run(source(TIMER, timer(body) + "\ndef load(self):\n    open_bus()\n"))) == expected


CAMERA = """
    for attempt in range({rounds}):
        camera = open_camera(attempt)
        {check}
        time.sleep({pause})
"""


@pytest.mark.parametrize(
    ("rounds", "check", "pause", "expected"),
    [
        ("3", "if camera.isOpened():\n            break", "0.2", []),
        ("3", "if camera.isOpened():\n            return", "0.2", []),
        ("20", "if camera.isOpened():\n            break", "0.2", ["EXE003"]),  # four seconds in all
        ("3", "if self.stopped:\n            break", "0.2", ["EXE003"]),  # the pauses are what it is for
        ("3", "if camera.isOpened():\n            camera.grab()", "0.2", ["EXE003"]),  # in each round
    ],
)
def test_the_pauses_until_something_is_there(run: Run, rounds: str, check: str, pause: str, expected: list[str]):
    body = CAMERA.format(rounds=rounds, check=check, pause=pause).strip()
    assert codes(run(source("self.stopped = False\n" + TIMER, timer(body)))) == expected


TWO_STEPS = """
def begin(self, message):
    if not self.client.wait_for_service(timeout_sec={first}):
        return
    self.client.call_async(Trigger.Request()).add_done_callback(self.go_on)

def go_on(self, future):
    if not self.other.wait_for_service(timeout_sec={then}):
        return
    self.other.call_async(Trigger.Request())
"""


@pytest.mark.parametrize(
    ("first", "then", "lines"),
    [("2.0", "2.0", []), ("2.0", "3.0", [1]), ("3.0", "2.0", [0])],
)
def test_a_short_look_for_a_server_that_is_there_as_a_rule(run: Run, first: str, then: str, lines: list[int]):
    """Each is over at once where the server is there, and no timer repeats it."""
    create = "self.client = self.create_client(Trigger, 'a')\nself.other = self.create_client(Trigger, 'b')\n"
    create += "self.create_subscription(Empty, 'go', self.begin, 10)\n" + TIMER.replace(ALONE, "")
    text = source(create, TWO_STEPS.format(first=first, then=then))
    waits = [number for number, line in enumerate(text.splitlines(), 1) if "wait_for_service(timeout" in line]
    assert [finding.place.line for finding in run(text) if finding.code == "EXE003"] == [waits[row] for row in lines]


@pytest.mark.parametrize(
    ("start", "again", "expected"),
    [
        ("self.open_port()", "if self.port is None:\n        self.open_port()", []),
        ("self.open_port()", "self.open_port()", ["EXE003"]),  # in each turn
        ("self.port = None", "if self.port is None:\n        self.open_port()", []),  # it starts when it is opened
    ],
)
def test_a_device_that_is_opened_again_as_at_the_start(run: Run, start: str, again: str, expected: list[str]):
    opens = "\ndef open_port(self):\n    self.port = connect()\n    time.sleep(2.0)\n"
    assert codes(run(source(f"{start}\n{TIMER}", timer(again) + opens))) == expected


CONNECTS = """
def connect(self):
    while True:
        try:
            self.permit()
            self.port = open_port()
            return
        except OSError:
            {pause}

def permit(self):
    subprocess.run(['make'])
"""


@pytest.mark.parametrize(
    ("start", "pause", "told"),
    [
        ("self.port = None", "time.sleep(2.0)", "time.sleep(2.0)"),
        ("self.connect()", "time.sleep(2.0)", ""),
        ("self.port = None", "print('again')", "subprocess.run(['make'])"),
    ],
    ids=["the loop is told", "what is opened again as at the start", "no pause"],
)
def test_a_process_in_a_loop_that_tries_again_and_again(run: Run, start: str, pause: str, told: str):
    again = timer("if self.port is None:\n        self.connect()") + CONNECTS.format(pause=pause)
    text = source(f"{start}\n{TIMER}", again)
    lines = [text.splitlines()[row.place.line - 1].strip() for row in run(text) if row.code == "EXE003"]
    assert lines == [told] * bool(told)


LISTENS = """
self.buffer = Buffer()
self.listener = TransformListener(self.buffer, self)
self.nav = ActionClient(self, Fibonacci, 'count')
self.create_subscription(Empty, 'go', self.go, 10)
"""
LOOKS = "self.buffer.lookup_transform('map', 'base', rclpy.time.Time())"
SERVER = "self.nav.wait_for_server(timeout_sec=5.0)"


@pytest.mark.parametrize(
    ("first", "then", "more", "expected"),
    [
        pytest.param(LOOKS, SERVER, "", [], id="it has looked by then"),
        pytest.param(LOOKS, "self.drive()", f"def drive(self):\n    {SERVER}\n", [], id="in a function of its own"),
        pytest.param(SERVER, LOOKS, "", ["EXE003"], id="it looks afterwards"),
        pytest.param("pass", SERVER, "", ["EXE003"], id="nobody looks, for all that is seen"),
        pytest.param(LOOKS, SERVER, f"def where(self):\n    return {LOOKS}\n", ["EXE003"], id="somebody else looks"),
        pytest.param(LOOKS, SERVER, "def buffers(self):\n    return [self.buffer]\n", ["EXE003"], id="it is passed on"),
        pytest.param(f"if message: {LOOKS}", SERVER, "", ["EXE003"], id="it may not have looked"),
        pytest.param(LOOKS, f"while True: {SERVER}", "", ["EXE003"], id="it looks again and again"),
    ],
)
def test_the_transforms_that_only_the_waiting_callback_reads(run: Run, first: str, then: str, more: str, expected):
    method = f"def go(self, message):\n    {first}\n    {then}\n\n{more}"
    assert [code for code in codes(run(source(LISTENS, method))) if code == "EXE003"] == expected


def test_an_action_alone_holds_up_its_own_cancelling(run: Run):
    create = "self.server = ActionServer(self, Fibonacci, 'count', self.execute{})\n"
    [found] = [one for one in run(source(create.format(", cancel_callback=print"), EXECUTE)) if one.code == "EXE003"]
    assert found.severity is Severity.WARNING and "timer" not in found.help
    assert "EXE003" not in codes(run(source(create.format(""), EXECUTE)))


def test_what_wants_more_threads_is_said_once(run: Run):
    """The group and the callback that holds up all others have one cause."""
    create = (
        "group = ReentrantCallbackGroup()\nself.create_subscription(Empty, 'stop', print, 10)\n"
        "self.server = ActionServer(self, Fibonacci, 'count', self.execute, callback_group=group)\n"
    )
    assert codes(run(source(create, EXECUTE))) == ["EXE003"]
    quick = "def execute(self, goal):\n    goal.succeed()\n    return Fibonacci.Result()\n"
    assert codes(run(source(create, quick))) == ["CBG002"]


def test_a_transition_may_take_its_time(run: Run):
    text = source(
        "self.create_subscription(Empty, 'stop', print, 10)\n",
        "def on_configure(self, state):\n    time.sleep(2.0)\n    return TransitionCallbackReturn.SUCCESS\n",
    )
    managed = text.replace(
        "from rclpy.node import Node\n",
        "from rclpy.lifecycle import LifecycleNode as Node\nfrom rclpy.lifecycle import TransitionCallbackReturn\n",
    )
    assert codes(run(managed)) == []


def test_a_handler_may_look_for_a_server_for_a_limited_time(run: Run):
    create = "self.client = self.create_client(Trigger, 'check')\nself.create_service(Trigger, 'go', self.go)\n"
    method = (
        "def go(self, request, response):\n    response.success = self.client.wait_for_service(timeout_sec=5.0)\n"
        "    return response\n"
    )
    assert codes(run(source(create + TIMER, method + "\n" + timer("pass")))) == []
    asks = method.replace("    return", "    self.client.call(Trigger.Request())\n    return")
    assert codes(run(source(create + TIMER, asks + "\n" + timer("pass")))) == ["SRV003"]
    shared = asks.replace("def handle(self, request, response):", "def handle(self, request=None, response=None):")
    assert "SRV003" in codes(run(source(create + TIMER, shared + "\n" + timer("self.handle()"))))
    assert "EXE003" not in codes(run(source(create + TIMER, shared + "\n" + timer("self.handle()"))))


def test_a_node_beside_it_on_the_same_executor_is_held_up(run: Run):
    main = ON_SEVERAL_THREADS.replace("MultiThreadedExecutor()", "SingleThreadedExecutor()").replace(
        "    executor.spin()",
        "    other = rclpy.create_node('other')\n    other.create_timer(1.0, print)\n    executor.add_node(other)\n"
        "    executor.spin()",
    )
    [found] = run(source(TIMER, timer("time.sleep(1.0)"), main))
    assert found.severity is Severity.WARNING


def test_a_handler_is_not_told_to_go_on_later(run: Run):
    create = "self.create_service(Trigger, 'go', self.go)\n" + TIMER
    method = timer("pass") + "\ndef go(self, request, response):\n    subprocess.run(['make'])\n    return response\n"
    [found] = run(source(create, method))
    group = "give this callback its own callback group"
    assert found.code == "EXE003" and found.help == f"spin the node with a MultiThreadedExecutor, and {group}"
    [threads] = run(source(create, method, ON_SEVERAL_THREADS))
    assert threads.code == "EXE003" and threads.help == group


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["self.port.write(b'AT')", "time.sleep(0.7)", "return self.port.read(9)"], []),
        (["self.port.write(b'AT')", "time.sleep(0.7)", "if self.port.in_waiting: return self.port.readline()"], []),
        (["self.port.write(b'AT')", "time.sleep(2.0)", "return self.port.read(9)"], ["EXE003"]),
        (["self.port.write(b'AT')", "time.sleep(0.7)", "return self.file.read(9)"], ["EXE003"]),
        (["self.port.read(9)", "time.sleep(0.7)", "self.port.write(b'AT')"], ["EXE003"]),
        (["if self.seen is None:", "    time.sleep(0.7)", "    return", "self.port.write(b'AT')"], []),
        (["if self.seen is None:", "    time.sleep(0.7)", "self.port.write(b'AT')"], ["EXE003"]),
        (["if self.seen is not None:", "    time.sleep(0.7)", "    return", "self.port.write(b'AT')"], ["EXE003"]),
    ],
)
def test_pauses_for_a_device_or_for_what_has_not_arrived(run: Run, lines: list[str], expected: list[str]):
    create = "self.port = open_port()\nself.seen = load_seen()\nself.file = load_file()\n" + TIMER
    create += "self.create_subscription(Empty, 'stop', self.on_stop, 10)\n"
    stops = "\ndef on_stop(self, message):\n    self.port.close()\n"
    text = source(create.replace("1.0", "3.0").replace("5.0", "3.0"), timer("\n    ".join(lines)) + stops)
    assert [code for code in codes(run(text)) if code == "EXE003"] == expected


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        ("subprocess.run(['make'], timeout=10)", []),
        ("subprocess.run(['make'], timeout=60)", ["EXE003"]),
        ("subprocess.run(['make'], timeout=6)\n    subprocess.run(['cmake'], timeout=6)", ["EXE003"]),
        ("for _ in (1, 2):\n        subprocess.run(['make'], timeout=6)", ["EXE003"]),
    ],
)
def test_a_handler_may_wait_a_short_time_for_the_command_that_it_tells_of(run: Run, command: str, expected: list[str]):
    create = "self.create_service(Trigger, 'go', self.go)\n" + TIMER
    method = timer("pass") + f"\ndef go(self, request, response):\n    {command}\n    return response\n"
    assert codes(run(source(create, method))) == expected
    assert codes(run(source(TIMER, timer(command)))) == ["EXE003"]


def test_a_client_that_is_made_here_has_found_nobody_yet(run: Run):
    create = "self.create_subscription(Empty, 'go', self.go, 10)\n"
    method = (
        "def go(self, message):\n    client = self.create_client(Trigger, 'check')\n    client.wait_for_service({})\n"
    )
    for limit, code in (("timeout_sec=5.0", "EXE003"), ("", "TMO001")):
        [found] = [one for one in run(source(create, method.format(limit))) if one.code == code]
        assert found.help.startswith("create the client in the constructor")


def test_a_handler_that_tries_three_times_takes_as_long_as_all_of_them(run: Run):
    create = "self.create_service(Trigger, 'go', self.go)\n"
    body = (
        "def go(self, request, response):\n    for attempt in range(3):\n        time.sleep({})\n    return response\n"
    )
    [found] = run(source(create, body.format("1.0")))
    assert found.code == "SRV008" and "sleeps for 3 s in all, in a loop: meanwhile the caller waits" in found.message
    [grows] = run(source(create, body.format("1.0 * (attempt + 1)")))
    assert "for a time that depends on the loop: meanwhile the caller waits" in grows.message


EXECUTE = """
def execute(self, goal_handle):
    for _ in range(goal_handle.request.order):
        time.sleep(0.5)
    goal_handle.succeed()
    return Fibonacci.Result()
"""
SERVER = "self.server = ActionServer(self, Fibonacci, 'count', self.execute)\n"


def test_an_execute_callback_may_sleep_under_several_threads(run: Run):
    assert codes(run(source(SERVER, EXECUTE, ON_SEVERAL_THREADS))) == []
    beside = SERVER.rstrip("\n") + "\nself.create_timer(1.0, print)\n"
    assert codes(run(source(beside, EXECUTE, ON_ONE_THREAD))) == ["EXE003"]
    assert codes(run(source(SERVER, EXECUTE, ""))) == []


def test_a_thread_of_its_own_may_sleep(run: Run):
    assert codes(run(source("threading.Thread(target=self.tick).start()\n", timer("time.sleep(1.0)")))) == []


def test_a_service_that_sleeps_should_be_an_action(run: Run):
    method = """
    def handle(self, request, response):
        self.drive()
        return response

    def drive(self):
        time.sleep(3.0)
    """
    [found] = run(source("self.create_service(Trigger, 'home', self.handle)\n", method))
    assert found.code == "SRV008"
    assert [r.message for r in found.related][2] == "Robot.handle calls Robot.drive here"


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        pytest.param("time.sleep(0.2)", [], id="a moment"),
        pytest.param("time.sleep(0.4)\n    time.sleep(0.5)", [], id="two moments"),
        pytest.param("time.sleep(0.9)\n    time.sleep(1.2)", ["SRV008"], id="too many moments"),
        pytest.param("for _ in range(3):\n        time.sleep(0.2)", [], id="a few moments in a loop"),
        pytest.param("for _ in range(30):\n        time.sleep(0.2)", ["SRV008"], id="many moments in a loop"),
        pytest.param("while self.moves():\n        time.sleep(0.05)", ["SRV008"], id="until something has happened"),
        pytest.param("for _ in port_bytes():\n        time.sleep(0.001)", [], id="a pause between bytes"),
        pytest.param("for block in port_blocks():\n        time.sleep(0.1)", [], id="a pause between blocks"),
        pytest.param("for block in port_blocks():\n        time.sleep(1.5)", ["SRV008"], id="a long one"),
        pytest.param("while self.port.in_waiting > 0:\n        time.sleep(0.05)", [], id="until a port is read empty"),
        pytest.param(
            "for attempt in range(3):\n        try:\n            read()\n            break\n        except OSError:\n"
            "            time.sleep(1.0 * (attempt + 1))",
            [],
            id="before the next attempt",
        ),
        pytest.param(
            "for _ in range(60):\n        if self.moves():\n            break\n        time.sleep(1.0)",
            ["SRV008"],
            id="up to a minute",
        ),
        pytest.param(
            "if request.data:\n        time.sleep(0.7)\n    else:\n        time.sleep(0.6)", [], id="one or the other"
        ),
    ],
)
def test_nobody_writes_an_action_for_a_moment(run: Run, body: str, expected: list[str]):
    method = f"def handle(self, request, response):\n    {body}\n    return response\n"
    method += "\ndef moves(self):\n    return read()\n"
    assert codes(run(source("self.create_service(SetBool, 'home', self.handle)\n", method))) == expected


COUNTED = """
def handle(self, request, response):
    self.known = self.wait({given})
    return response

def wait(self, timeout):
    tries = 1
    while {test}:
        if self.moves():
            return True
        {body}
    return False

def moves(self):
    return read()
"""


@pytest.mark.parametrize(
    ("given", "test", "body", "expected"),
    [
        ("3.0", "timeout > 0.0", "time.sleep(0.02)\n        timeout -= 0.02", []),
        ("0.0", "timeout < 3.0", "time.sleep(0.1)\n        timeout = timeout + 0.1", []),
        (
            "3.0",
            "not self.moves()",
            "if tries > 5:\n            return 0\n        tries += 1\n        time.sleep(0.5)",
            [],
        ),
        # Some attempts with hardly a pause in between, however many: as many as make a second are known to be so.
        ("read()", "timeout > 0", "time.sleep(0.01)\n        timeout -= 1", []),
        ("read()", "True", "time.sleep(0.01)\n        timeout -= 1\n        if timeout == 0:\n            break", []),
        ("read()", "tries < 5000", "time.sleep(0.01)\n        tries += 1", ["SRV008"]),
        ("read()", "timeout > 0", "time.sleep(0.5)\n        timeout -= 1", ["SRV008"]),
        ("30.0", "timeout > 0.0", "time.sleep(0.02)\n        timeout -= 0.02", ["SRV008"]),
        ("3.0", "timeout > 0.0", "time.sleep(0.02)", ["SRV008"]),
        ("3.0", "timeout > 0.0", "time.sleep(0.02)\n        timeout += 0.02", ["SRV008"]),
        ("3.0", "timeout > 0.0", "time.sleep(0.02)\n        if read():\n            timeout -= 0.02", ["SRV008"]),
        ("read()", "timeout > 0.0", "time.sleep(0.02)\n        timeout -= 0.02", ["SRV008"]),
        (
            "3.0",
            "timeout > 0.0",
            "time.sleep(0.02)\n        timeout -= self.get_parameter('p').value",
            ["SRV008", "PRM003"],
        ),
    ],
)
def test_a_loop_that_counts_its_rounds_ends(run: Run, given: str, test: str, body: str, expected: list[str]):
    method = COUNTED.replace("{given}", given).replace("{test}", test).replace("{body}", body)
    assert codes(run(source("self.create_service(Trigger, 'home', self.handle)\n", method))) == expected


STEPS = """
def toggle(self):
    {toggle}

def handle(self, request, response):
    self.open()
    self.grip()
    self.lift()
    return response

def open(self):
    if self.simulated:
        time.sleep(2.0)
        return True
    return read()

def grip(self):
    if {grip}:
        time.sleep(1.0)
        return True
    return read()

def lift(self):
    if self.simulated:
        if read():
            time.sleep(3.0)
"""


@pytest.mark.parametrize(
    ("grip", "more", "said"),
    [
        ("self.simulated", "", "sleeps for 6 s in all"),
        ("not self.simulated", "", "sleeps for 5 s in all"),
        ("read()", "", "sleeps for 5 s in all"),
        ("self.simulated", "self.simulated = read()", "sleeps for 6 s in all"),
        ("self.simulated", "self.toggle()", "sleeps for 3 s in all"),  # it may change in between
    ],
)
def test_what_the_same_condition_leads_to_adds_up(run: Run, grip: str, more: str, said: str):
    create = (
        "self.declare_parameter('simulated', True)\nself.simulated = self.get_parameter('simulated').value\n"
        f"{more}\nself.create_service(Trigger, 'home', self.handle)\n"
    )
    toggle = "self.simulated = read()" if "toggle" in more else "pass"
    [found] = run(source(create, STEPS.replace("{grip}", grip).replace("{toggle}", toggle)))
    assert found.code == "SRV008" and said in found.message


@pytest.mark.parametrize(("seconds", "expected"), [("1.9", []), ("2.0", ["SRV008"]), ("2.5", ["SRV008"])])
def test_a_short_pause_that_is_known_is_no_reason_for_an_action(run: Run, seconds: str, expected: list[str]):
    method = f"def handle(self, request, response):\n    time.sleep({seconds})\n    return response\n"
    assert codes(run(source("self.create_service(Trigger, 'home', self.handle)\n", method))) == expected


@pytest.mark.parametrize(
    ("pause", "severity", "advice"),
    [
        ("time.sleep(2.0)\n    time.sleep(1.0)", Severity.INFO, "wait for what the pause is for"),
        ("time.sleep(5.0)", Severity.WARNING, "make it an action"),
        ("while self.moves():\n        time.sleep(0.5)", Severity.WARNING, "make it an action"),
    ],
)
def test_short_pauses_are_information(run: Run, pause: str, severity: Severity, advice: str):
    method = f"def handle(self, request, response):\n    {pause}\n    return response\n"
    [found] = run(source("self.create_service(Trigger, 'home', self.handle)\n", method))
    assert (found.code, found.severity) == ("SRV008", severity)
    assert (found.help or "").startswith(advice)


MANY_NODES = "".join(
    f"\n\nclass Idle{n}(Node):\n    def __init__(self):\n        super().__init__('i{n}')\n" for n in range(5)
)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("time.sleep(3.0)", []),
        ("time.sleep(request.data)", []),
        ("time.sleep(5.0)", []),  # in place of work
        ("self.get_logger().info(str(request.data)); time.sleep(5.0); response.success = True", []),
        ("move(request.data); time.sleep(5.0)", ["SRV008"]),
        ("while self.moves():\n        time.sleep(0.5)", ["SRV008"]),
        (
            "begin = time.time()\n    while self.moves():\n        passed = time.time() - begin\n"
            "        if passed > self.limit():\n            break\n        time.sleep(0.5)",
            [],
        ),
        ("for _ in range(self.tries()):\n        if self.opens(): break\n        time.sleep(self.pause())", []),
        ("for _ in range(self.tries()):\n        self.opens()\n        time.sleep(self.pause())", ["SRV008"]),
    ],
)
def test_short_pauses_are_for_lessons(run: Run, tmp_path: Path, body: str, expected: list[str]):
    method = f"def handle(self, request, response):\n    {body}\n    return response\n"
    text = source("self.create_service(SetBool, 'home', self.handle)\n", method) + MANY_NODES
    assert codes(run(text)) == expected
    (tmp_path / "archlint.toml").write_text("[rules.long-running-service]\npauses = true\n", encoding="utf-8")
    assert codes(run(text)) == ["SRV008"]


DEEP = """
def handle(self, request, response):
    self.task()
    return response

def task(self):
    self.path()

def path(self):
    self.pose()

def pose(self):
    {}

def wait(self):
    while self.moves():
        time.sleep(1.0)
"""


@pytest.mark.parametrize(("call", "line"), [("self.wait()", "self.task()"), ("pass", None)])
def test_a_wait_far_down_is_told_where_the_handler_starts_it(run: Run, call: str, line: str | None):
    text = source("self.create_service(Trigger, 'home', self.handle)\n", DEEP.format(call))
    found = [one for one in run(text) if one.code == "SRV008"]
    assert [text.splitlines()[one.place.line - 1].strip() for one in found] == ([] if line is None else [line])
    assert all(one.related[-1].message == "it waits here" for one in found)


GRAB = """
def grab(self, request, response):
    try:
        if not self.low and not self.high:
            time.sleep(1.0)
            self.drive()
            self.high = True
        elif not self.low and self.high:
            time.sleep(0.5)
            self.drive()
            self.low = True
        elif self.low and self.high:
            response.success = False
    except OSError as error:
        response.message = str(error)
    return response

def drive(self):
    {drive}
"""


@pytest.mark.parametrize(
    ("drive", "said"),
    [
        ("time.sleep(2.5)", "sleeps for 3.5 s in all"),
        ("if read():\n        time.sleep(2.5)\n        return\n    time.sleep(3.0)", "sleeps for 4 s in all"),
        ("if read():\n        time.sleep(2.5)\n    time.sleep(3.0)", "sleeps for 6.5 s in all"),
    ],
)
def test_the_longest_of_branches_that_exclude_each_other_counts(run: Run, drive: str, said: str):
    create = "self.low = False\nself.high = False\nself.create_service(Trigger, 'grab', self.grab)\n"
    [found] = run(source(create, GRAB.replace("{drive}", drive)))
    assert found.code == "SRV008" and said in found.message


@pytest.mark.parametrize(
    ("seconds", "group", "expected"),
    [
        ("5.0", "ReentrantCallbackGroup()", []),
        ("20.0", "ReentrantCallbackGroup()", ["SRV008"]),
        ("5.5", "None", ["SRV008"]),
    ],
)
def test_loops_with_a_limit_may_run_beside_the_others(run: Run, seconds: str, group: str, expected: list[str]):
    create = f"self.create_service(Trigger, 'arm', self.arm, callback_group={group})\n"
    method = (
        "def arm(self, request, response):\n    self.wait('a')\n    end = time.time() + 8.0\n"
        "    while read() and time.time() < end:\n        time.sleep(0.1)\n    return response\n\n"
        f"def wait(self, mode):\n    end = time.time() + {seconds}\n"
        "    while not read(mode) and time.time() < end:\n        time.sleep(0.1)\n"
    )
    assert codes(run(source(create, method, ON_SEVERAL_THREADS))) == expected


def test_a_short_pause_that_blocks_nobody_is_no_finding(run: Run):
    apart = "self.create_service(Trigger, 'home', self.handle, callback_group=ReentrantCallbackGroup())\n"
    method = "def handle(self, request, response):\n    time.sleep({})\n    return response\n"
    assert codes(run(source(apart, method.format(3.0), ON_SEVERAL_THREADS))) == []
    assert codes(run(source(apart, method.format(6.0), ON_SEVERAL_THREADS))) == ["SRV008"]
    assert "SRV008" in codes(run(source(apart, method.format(3.0))))


@pytest.mark.parametrize(
    ("flag", "sets", "can_cancel"),
    [("cancelled", "True", True), ("cancelled", "False", False), ("there", "True", False)],
    ids=["a service that stops it", "a service that does not", "what it waits for"],
)
def test_another_service_may_stop_a_loop(run: Run, flag: str, sets: str, can_cancel: bool):
    create = f"self.there = load()\nself.{flag} = load()\nself.create_timer(1.0, self.look)\n"
    create += "self.create_service(Trigger, 'home', self.home, callback_group=ReentrantCallbackGroup())\n"
    create += "self.create_service(Trigger, 'other', self.other)\n"
    methods = (
        f"def home(self, request, response):\n    while not self.there:\n        if self.{flag}: break\n"
        "        time.sleep(0.1)\n    return response\n\n"
        f"def other(self, request, response):\n    self.{flag} = {sets}\n    return response\n\n"
        f"def look(self):\n    self.there = load()\n    self.{flag} = load()\n"
    )
    [found] = [one for one in run(source(create, methods, ON_SEVERAL_THREADS)) if one.code == "SRV008"]
    assert found.message.endswith("and cannot cancel") is not can_cancel


def test_the_request_may_say_how_long(run: Run):
    create = "self.create_service(AddTwoInts, 'pulse', self.pulse)\n"
    method = "def pulse(self, request, response):\n    {}\n    return response\n"
    imports = "from std_srvs.srv import SetBool, Trigger\n"

    def found(body: str) -> tuple[str, Severity]:
        text = source(create, method.format(body))
        [one] = run(text.replace(imports, imports + "from example_interfaces.srv import AddTwoInts\n"))
        return one.message, one.severity

    for body in ("time.sleep(request.a / 10)", "pause = request.a / 10\n    time.sleep(pause)"):
        message, severity = found(body)
        assert severity is Severity.INFO and "for as long as the request says: the caller cannot cancel" in message
    message, severity = found("time.sleep(load())")
    assert severity is Severity.WARNING and "without knowing for how long" in message


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("time.sleep(request.a)\ntime.sleep(0.25)", "for as long as the request says"),
        ("time.sleep(request.a)\ntime.sleep(1.25)", "without knowing for how long"),
        ("time.sleep(request.a)\ntime.sleep(load())", "without knowing for how long"),
        ("time.sleep(min(request.a, 0.5))", ""),
        ("time.sleep(max(0.0, min(float(request.a) / 10, 0.9)))", ""),
        ("time.sleep(min(request.a, 5.0))", "sleeps for up to 5 s"),
        ("if request.a > 5:\n    return response\ntime.sleep(request.a)", "sleeps for up to 5 s"),
        ("if request.a > 5:\n    print()\ntime.sleep(request.a)", "for as long as the request says"),
        ("time.sleep(min(request.a, request.b))", "for as long as the request says"),
        ("pause = abs(request.a) / 100 if abs(request.a) < 5 else 0.05\ntime.sleep(pause)", ""),
        ("if abs(request.a) < 5:\n    pause = abs(request.a) / 100\nelse:\n    pause = 0.05\ntime.sleep(pause)", ""),
        ("if request.a > 5:\n    pause = 0.1\nelse:\n    pause = request.a * 0.1\ntime.sleep(pause)", ""),
        (
            "if request.a < 5:\n    request.a = request.b\n    pause = request.a / 100\nelse:\n    pause = 0.05\n"
            "time.sleep(pause)",
            "for as long as the request says",
        ),
        (
            "if abs(request.a) < 5:\n    pause = 0.05\nelse:\n    pause = abs(request.a) / 100\ntime.sleep(pause)",
            "for as long as the request says",
        ),
    ],
)
def test_what_is_known_of_the_time_that_a_request_asks_for(run: Run, body: str, said: str):
    create = "self.create_service(AddTwoInts, 'pulse', self.pulse)\n"
    method = f"def pulse(self, request, response):\n{textwrap.indent(body, '    ')}\n    return response\n"
    imports = "from std_srvs.srv import SetBool, Trigger\n"
    text = source(create, method).replace(imports, imports + "from example_interfaces.srv import AddTwoInts\n")
    found = run(text)
    assert len(found) == (1 if said else 0)
    assert all(one.code == "SRV008" and said in one.message for one in found)


FRESH = """
def look(self, request, response):
    {call}
    return response

def fresh(self, name, limit=1.0):
    deadline = time.monotonic() + max(limit, 0.1)
    while time.monotonic() < deadline{until}:
        time.sleep(0.05)
"""


@pytest.mark.parametrize(
    ("call", "until", "severity"),
    [
        pytest.param("self.fresh('front', request.b or 5)", "", Severity.INFO, id="by position"),
        pytest.param("self.fresh('front', limit=request.b)", "", Severity.INFO, id="by keyword"),
        pytest.param("b = request.b\n    self.fresh('front', b)", "", Severity.INFO, id="in a variable"),
        pytest.param("self.fresh('front', request.b)", " and not self.seen", Severity.INFO, id="or something else"),
        pytest.param("self.fresh('front', request.b)", " or not self.seen", Severity.WARNING, id="or longer"),
        pytest.param("self.fresh(request.a, load())", "", Severity.WARNING, id="another field for something else"),
    ],
)
def test_the_request_may_say_how_long_to_watch_the_clock(run: Run, call: str, until: str, severity: Severity):
    text = source("self.create_service(AddTwoInts, 'look', self.look)\n", FRESH.format(call=call, until=until))
    [found] = run("from example_interfaces.srv import AddTwoInts\n" + text)
    assert (found.code, found.severity) == ("SRV008", severity)
    assert ("for up to as long as the request says" in found.message) is (severity is Severity.INFO)


@pytest.mark.parametrize(
    ("service", "seconds", "told"),
    [
        pytest.param("gripper/set", 1.5, None, id="short, with an action for it"),
        pytest.param("gripper/set", 30.0, "send a goal to the action 'gripper/command'", id="long, with an action"),
        pytest.param("lift/set", 30.0, "make it an action", id="an action for something else"),
        pytest.param("set", 30.0, "make it an action", id="no folder"),
    ],
)
def test_a_node_may_have_an_action_for_the_same_thing(run: Run, service: str, seconds: float, told: str | None):
    create = (
        f"self.create_service(Trigger, '{service}', self.put)\n"
        "self.server = ActionServer(self, Fibonacci, 'gripper/command', self.execute)\n"
    )
    method = f"def put(self, request, response):\n    time.sleep({seconds})\n    return response\n"
    ends = "\ndef execute(self, goal):\n    goal.succeed()\n    return Fibonacci.Result()\n"
    found = run(source(create + "self.create_publisher(Empty, 'state', 10)\n", method + ends))
    assert [told in one.help for one in found if told is not None] == ([] if told is None else [True])
    assert len(found) == (told is not None)
    everything = create.replace(f"'{service}'", "'robot/set'").replace("'gripper/command'", "'robot/command'")
    assert len(run(source(everything, method + ends))) == (seconds > 2.0)
    more = "self.create_service(Trigger, 'robot/stop', print)\n"
    assert ("SRV008" in codes(run(source(everything + more, method + ends)))) is (seconds > 2.0)


@pytest.mark.parametrize(
    ("service", "action", "same"),
    [
        ("arm/press_button", "arm/pick_motion_action_server", False),
        ("arm/fixed_distance_move", "arm/pick", False),
        ("arm/pick_up", "arm/pick_object", True),
        ("arm/press_button", "arm/command", True),
    ],
)
def test_an_action_whose_name_speaks_of_something_else(run: Run, service: str, action: str, same: bool):
    create = f"self.create_service(Trigger, '{service}', self.put)\n"
    create += f"self.server = ActionServer(self, Fibonacci, '{action}', self.execute)\n"
    methods = "def put(self, request, response):\n    time.sleep(30.0)\n    return response\n"
    methods += "\ndef execute(self, goal):\n    goal.succeed()\n    return Fibonacci.Result()\n"
    [found] = run(source(create + "self.create_publisher(Empty, 'state', 10)\n", methods))
    assert (f"send a goal to the action '{action}'" in (found.help or "")) is same


@pytest.mark.parametrize(
    ("leaves", "expected"),
    [
        ("frame = self.camera.read()\n        if frame is not None:\n            return frame", []),
        ("if self.arrived:\n            return response", ["SRV008"]),
        ("frame = self.camera.read()\n        if self.arrived:\n            return response", ["SRV008"]),
    ],
)
def test_a_loop_that_returns_with_what_it_reads_seldom_waits(run: Run, leaves: str, expected: list[str]):
    create = "self.arrived = load()\nself.create_service(Trigger, 'look', self.look)\n"
    method = (
        "def look(self, request, response):\n    time.sleep(0.2)\n    self.wait(response)\n    return response\n\n"
        "def wait(self, response):\n    start = time.time()\n    while time.time() - start < 8.0:\n"
        f"        {leaves}\n        time.sleep(0.05)\n    return None\n"
    )
    found = run(source(create, method))
    assert codes(found) == expected
    assert all("sleeps for up to 8.2 s in all" in one.message for one in found)


def test_a_loop_may_watch_the_clock(run: Run):
    create = "self.create_service(Trigger, 'home', self.home)\n"
    method = (
        "def home(self, request, response):\n    end = time.time() + 30.0\n"
        "    while read() and time.time() < end:\n        time.sleep(0.1)\n    return response\n"
    )
    [found] = run(source(create, method))
    assert found.code == "SRV008" and "meanwhile the caller waits and cannot cancel" in found.message


@pytest.mark.parametrize(
    ("before", "test", "expected"),
    [
        ("start = time.monotonic()", "time.monotonic() - start < 1.5", ""),
        ("start = time.monotonic()", "time.monotonic() - start < self.LIMIT and read()", ""),
        ("start = time.monotonic()", "1.5 > time.monotonic() - start", ""),
        ("end = time.time() + 1.5", "time.time() < end", ""),
        ("start = time.time()", "time.time() - start < 3.0", ""),
        ("start = time.time()", "time.time() - start < 6.0", "sleeps for up to 6 s in all, in a loop"),
        ("end = time.time() + 20.0", "time.time() < end", "sleeps for up to 20 s in all, in a loop"),
        ("start = time.time()", "time.time() - start < self.limit", "in each iteration of a loop"),
        ("end = time.time() + 1.5", "time.time() < end or read()", "in each iteration of a loop"),
        ("start = time.time()", "time.time() - start > 1.5", "in each iteration of a loop"),
        ("end = time.time() + max(0.1, self.PARAMETER)", "time.time() < end", ""),
        ("end = time.time() + max(8.0, self.PARAMETER)", "time.time() < end", "sleeps for up to 8 s in all, in a loop"),
        ("end = time.time() + max(0.1, self.limit)", "time.time() < end", "in each iteration of a loop"),
    ],
)
def test_a_loop_may_watch_the_clock_for_a_moment(run: Run, before: str, test: str, expected: str):
    create = "self.limit = load()\nself.create_service(Trigger, 'home', self.home)\n"
    create += "self.PARAMETER = self.declare_parameter('wait', 0.2).value\n"
    method = (
        "LIMIT = 1.5\n\n"
        f"def home(self, request, response):\n    {before}\n    while {test}:\n        time.sleep(0.02)\n"
        "    return response\n"
    )
    found = run(source(create, method))
    assert [one.code for one in found] == (["SRV008"] if expected else [])
    assert all(expected in one.message for one in found)
    assert all(one.severity is Severity.WARNING for one in found)


ROUNDS_OF_ROS = """
def home(self, request, response):
    start = self.get_clock().now()
    while rclpy.ok():
        elapsed = {elapsed}
        if elapsed > 4.0:
            break
        time.sleep(0.05)
    return response
"""


@pytest.mark.parametrize(
    ("elapsed", "codes"),
    [
        ("(self.get_clock().now() - start).nanoseconds * 1e-9", []),
        ("(self.get_clock().now() - start).nanoseconds / 1e9", []),
        ("(self.get_clock().now() - start).nanoseconds", ["SRV008"]),  # four nanoseconds: nobody meant that
        ("read() - start", ["SRV008"]),
    ],
)
def test_a_loop_may_watch_the_clock_of_the_node(run: Run, elapsed: str, codes: list[str]):
    create = "self.create_service(Trigger, 'home', self.home)\n"
    found = run(source(create, ROUNDS_OF_ROS.format(elapsed=elapsed)))
    assert [one.code for one in found] == codes


def test_the_long_handlers_of_a_node_are_one_finding(run: Run):
    create = "".join(f"self.create_service(Trigger, '{name}', self.{name})\n" for name in ("home", "park", "pose"))
    handler = "def {}(self, request, response):\n    time.sleep({})\n    return response\n\n"
    [found] = run(
        source(create, handler.format("home", 9.0) + handler.format("park", 8.0) + handler.format("pose", 0.1))
    )
    assert found.message.endswith("the caller waits and cannot cancel; another handler of the node takes long, too")
    assert any("the service 'park' sleeps for 8 s" in related.message for related in found.related)


def test_a_handler_is_told_where_it_takes_long(run: Run):
    method = """
    def handle(self, request, response):
        time.sleep(0.5)
        while read():
            time.sleep(0.05)
        return response
    """
    [found] = run(source("self.create_service(SetBool, 'home', self.handle)\n", method))
    assert "sleeps for 0.05 s in each iteration of a loop" in found.message


MAKES = """
    def tick(self):
        time.sleep(1.0)
        time.sleep(2.0)
        self.make()

    def make(self):
        subprocess.run(['make'])
        time.sleep(3.0)
    """


def test_the_waits_that_one_callback_gets_to_are_one_finding(run: Run):
    [found] = run(source(TIMER, MAKES))
    assert found.code == "EXE003"
    assert "sleeps for 3 s, and blocks at another line of Robot.make" in found.message
    assert found.message.endswith("; it waits in another function, too")
    assert [one.message for one in found.related if one.message.startswith("here it")] == [
        "here it waits for a process in subprocess.run()",
        "here it waits in sleep(), too",
        "here it sleeps for 1 s",
    ]


def test_lines_that_wait_for_other_things_do_not_do_the_same(run: Run):
    [told] = run(source(TIMER, MAKES.replace("time.sleep(2.0)", "input()")))
    assert "waits for keyboard input, and blocks at another line of Robot.tick: " in told.message


def test_what_is_allowed_at_one_place_leaves_the_others(run: Run):
    [found] = run(source(TIMER, MAKES.replace("time.sleep(2.0)", "time.sleep(2.0)  # archlint: ignore[EXE003]")))
    assert "sleeps for 3 s, and blocks at another line of Robot.make" in found.message and "too" not in found.message


def test_the_callbacks_of_one_node_are_one_finding(run: Run):
    timers = TIMER + "self.create_timer(7.0, self.tock)\n"
    tock = "def tock(self):\n    time.sleep(2.0)\n"
    [found] = run(source(timers, timer("time.sleep(1.0)") + "\n" + tock))
    assert found.code == "EXE003" and found.message.endswith("; another callback of the node waits, too")
    assert "Robot.tock, sleeps for 2 s" in found.message  # the longest
    assert "here Robot.tick waits in sleep(), too" in [row.message for row in found.related]
    [alone] = run(source(timers, timer("pass") + "\n" + tock))
    assert "too" not in alone.message


ASKS = """
def list_all(self, request, response):
    self.session.get('http://robot/list')
    return response

def add(self, request, response):
    self.post('http://robot/add')
    return response

def post(self, url):
    self.session.post(url)
"""


def test_a_callback_that_waits_for_the_network_and_sleeps_is_one_finding(run: Run):
    methods = """
    def tick(self):
        time.sleep(2.0)
        self.post()

    def post(self):
        self.session.post('http://robot/add')
    """
    [found] = run("import requests\n" + source("self.session = requests.Session()\n" + TIMER, methods))
    assert found.message.endswith("; it waits in another function, too")


@pytest.mark.parametrize("method", ["put", "patch", "delete", "head", "request"])
def test_a_session_waits_in_each_of_its_methods(run: Run, method: str):
    create = "self.session = requests.Session()\n" + TIMER
    [found] = run("import requests\n" + source(create, timer(f"self.session.{method}('http://robot/a', 'b')")))
    assert f"waits for the network in requests.Session.{method}()" in found.message


def test_a_node_that_waits_for_the_network_in_each_handler_is_one_finding(run: Run):
    create = (
        "self.session = requests.Session()\nself.create_service(Trigger, 'list', self.list_all)\n"
        "self.create_service(Trigger, 'add', self.add)\nself.create_timer(5.0, print)\n"
    )
    [found] = run("import requests\n" + source(create, ASKS))
    assert found.code == "EXE003" and found.message.endswith("; another callback of the node waits, too")
    assert "here Robot.add waits in post(), too" in [row.message for row in found.related]
    assert found.help.startswith("spin the node with a MultiThreadedExecutor")


@pytest.mark.parametrize(("seconds", "expected"), [("0.2", []), ("6.0", ["SRV008"])])
def test_threads_help_the_node_and_not_the_caller(run: Run, seconds: str, expected: list[str]):
    setup = "self.create_service(Trigger, 'home', self.handle, callback_group=ReentrantCallbackGroup())\n"
    method = f"def handle(self, request, response):\n    time.sleep({seconds})\n    return response\n"
    assert codes(run(source(setup, method, ON_SEVERAL_THREADS))) == expected


RATE = "self.rate = self.create_rate(10)\n" + TIMER


def test_a_rate_needs_a_second_thread(run: Run):
    assert codes(run(source(RATE, timer("self.rate.sleep()"), ON_ONE_THREAD))) == ["EXE004"]
    assert codes(run(source(RATE, timer("self.rate.sleep()"), ON_SEVERAL_THREADS))) == []


def test_a_rate_in_main_is_no_callback(run: Run):
    main = """
    def main():
        rclpy.init()
        robot = Robot()
        threading.Thread(target=rclpy.spin, args=(robot,), daemon=True).start()
        rate = robot.create_rate(2)
        while rclpy.ok():
            rate.sleep()


    if __name__ == '__main__':
        main()
    """
    assert codes(run(source("pass", "def tick(self):\n    pass\n", main))) == []


LOOKUP = """
def tick(self):
    self.buffer.lookup_transform('map', 'base', rclpy.time.Time(), {timeout})
"""
TF = """
self.buffer = Buffer()
self.listener = TransformListener(self.buffer, self{more})
self.create_timer(5.0, self.tick)
"""


@pytest.mark.parametrize(
    ("timeout", "more", "main", "expected"),
    [
        pytest.param("timeout=Duration(seconds=1.0)", "", ON_ONE_THREAD, ["EXE007"], id="by keyword"),
        pytest.param("Duration(seconds=1)", "", ON_ONE_THREAD, ["EXE007"], id="by position"),
        pytest.param("timeout=Duration(nanoseconds=0)", "", ON_ONE_THREAD, [], id="no wait"),
        pytest.param("", "", ON_ONE_THREAD, [], id="no timeout"),
        pytest.param("Duration(seconds=1)", "", ON_SEVERAL_THREADS, [], id="several threads"),
        pytest.param(
            "Duration(seconds=1)", ", spin_thread=True", ON_ONE_THREAD, ["EXE007"], id="a thread without a node"
        ),
        pytest.param("Duration(seconds=1)", ", spin_thread=True", ON_SEVERAL_THREADS, [], id="several, and a thread"),
    ],
)
def test_a_lookup_cannot_wait_for_what_its_own_thread_brings(
    run: Run, timeout: str, more: str, main: str, expected: list[str]
):
    text = source(TF.replace("{more}", more), LOOKUP.replace("{timeout}", timeout), main)
    assert codes(run(text)) == expected


def test_a_thread_of_its_own_helps_a_listener_with_a_node_of_its_own(run: Run):
    """rclpy.spin(node) takes a node from the executor in the listener's thread, as a real rclpy does."""
    lookup = LOOKUP.replace("{timeout}", "Duration(seconds=1)")
    (found,) = run(source(TF.replace("{more}", ", spin_thread=True"), lookup))
    assert "spin_thread=True does not help" in found.message
    of_its_own = TF.replace("self{more}", "Node('listener'), spin_thread=True")
    assert run(source(of_its_own, lookup)) == []


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        ("if isinstance(self.arm, Mock):\n        return response", []),
        ("if isinstance(self.arm, (str, Mock)):\n        return response", []),
        ("if not isinstance(self.arm, Mock):\n        return response", ["SRV008"]),
        ("if isinstance(self.arm, Other):\n        return response", ["SRV008"]),
        ("if isinstance(self.arm, Mock):\n        self.ready = True", ["SRV008"]),
    ],
)
def test_what_a_test_of_the_type_rules_out_is_not_called(run: Run, test: str, expected: list[str]):
    create = """
    try:
        self.arm = Arm()
    except OSError:
        self.arm = Mock()
    self.create_service(Trigger, 'move', self.move)
    """
    method = f"def move(self, request, response):\n    {test}\n    self.arm.move()\n    return response\n"
    mock = "class Other:\n    pass\n\n\nclass Mock:\n    def move(self):\n        time.sleep(5.0)\n\n\n"
    text = source(create, method).replace("class Robot", f"from arms import Arm\n\n\n{mock}class Robot", 1)
    assert codes(run(text)) == expected


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("try:\n        send()\n    except OSError:\n        self.close()\n        raise", []),
        ("try:\n        send()\n    except OSError:\n        self.close()\n        rclpy.shutdown()", []),
        ("try:\n        send()\n    finally:\n        self.close()\n        self.destroy_node()", []),
        ("try:\n        send()\n    except OSError:\n        self.close()", []),
        ("try:\n        send()\n    except OSError:\n        self.close()\n        if read():\n            raise", []),
        (
            "for _ in range(9):\n        try:\n            send()\n        except OSError:\n            self.close()",
            ["EXE003"],
        ),
        (
            "while not self.sent:\n        try:\n            self.sent = send()\n        except OSError:\n"
            "            self.close()",
            ["EXE003"],
        ),
        ("try:\n        send()\n    except OSError:\n        while read():\n            self.close()", ["EXE003"]),
        ("try:\n        send()\n        self.close()\n    except OSError:\n        pass", ["EXE003"]),
        ("try:\n        send()\n    finally:\n        self.close()", ["EXE003"]),
        (
            "try:\n        send()\n    except OSError:\n        self.close()\n        raise\n    self.close()",
            ["EXE003"],
        ),
    ],
)
def test_who_fails_may_take_time_to_recover(run: Run, body: str, expected: list[str]):
    close = "\ndef close(self):\n    subprocess.run(['stop'])\n"
    assert codes(run(source(TIMER, timer(body) + close))) == expected


@pytest.mark.parametrize(
    ("loop", "expected"),
    [
        ("for register in (1, 2):", []),
        ("for register in range(2):", []),
        ("for register in (1, 2, 3, 4, 5, 6):", ["EXE003"]),
        ("for register in self.registers:", ["EXE003"]),
        ("while read():", ["EXE003"]),
    ],
)
def test_how_often_the_loop_of_a_caller_goes_round(run: Run, loop: str, expected: list[str]):
    method = timer(f"{loop}\n        self.ask()\n\ndef ask(self):\n    time.sleep(0.1)\n")
    assert codes(run(source("self.registers = load()\n" + TIMER, method))) == expected


@pytest.mark.parametrize(
    ("end", "expected"),
    [
        ("self.process.terminate()\n    self.process.wait(timeout=5)", []),
        ("self.process.terminate()\n    self.process.wait()", []),
        ("self.process.kill()\n    self.process.wait()", []),
        ("self.other.kill()\n    self.process.wait()", ["EXE003"]),
        ("import os, signal; os.kill(self.process.pid, signal.SIGINT)\n    self.process.wait(timeout=5)", []),
        ("import os, signal; os.kill(self.process.pid, signal.SIGINT)\n    self.process.wait()", []),
        ("import os; os.kill(self.process.pid, 9)\n    self.process.wait()", []),
        ("import os; os.kill(self.process.pid, 0)\n    self.process.wait(timeout=5)", ["EXE003"]),
        (
            "import os, signal; os.killpg(os.getpgid(self.process.pid), signal.SIGTERM)\n"
            "    self.process.wait(timeout=5)",
            [],
        ),
        (
            "import os, signal; os.killpg(os.getpgid(self.other.pid), signal.SIGTERM)\n"
            "    self.process.wait(timeout=5)",
            ["EXE003"],
        ),
        (
            "import os, signal; group = os.getpgid(self.process.pid)\n    os.killpg(group, signal.SIGINT)\n"
            "    self.process.wait(timeout=5)",
            [],
        ),
        (
            "import os, signal; group = os.getpgid(self.process.pid)\n"
            "    for number in (signal.SIGINT, signal.SIGTERM):\n"
            "        os.killpg(group, number)\n        self.process.wait(timeout=5)",
            [],
        ),
        (
            "import os, signal; group = os.getpgid(self.other.pid)\n    os.killpg(group, signal.SIGINT)\n"
            "    self.process.wait(timeout=5)",
            ["EXE003"],
        ),
        (
            "import os; group = os.getpgid(self.process.pid)\n    os.killpg(group, 0)\n"
            "    self.process.wait(timeout=5)",
            ["EXE003"],
        ),
        ("self.process.wait(timeout=5)", ["EXE003"]),
        ("self.process.wait(timeout=5)\n    self.process.kill()", ["EXE003"]),
        ("self.other.terminate()\n    self.process.wait(timeout=5)", ["EXE003"]),
        (
            "if self.process.poll() is None:\n        self.process.terminate()\n    self.process.wait(timeout=5)",
            [],
        ),
        (
            "try:\n        self.process.terminate()\n    finally:\n        self.process.wait(timeout=5)",
            [],
        ),
        (
            "if self.process.poll():\n        self.process.terminate()\n"
            "    else:\n        self.process.wait(timeout=5)",
            ["EXE003"],
        ),
    ],
)
def test_a_process_that_is_told_to_end_may_take_a_moment(run: Run, end: str, expected: list[str]):
    setup = "self.process = subprocess.Popen(['play'])\nself.other = subprocess.Popen(['sing'])\n" + TIMER
    assert codes(run(source(setup, timer(end)))) == expected


@pytest.mark.parametrize(
    ("end", "expected"),
    [
        ("self.process.wait(timeout=5)\n    rclpy.shutdown()", []),
        ("self.process.wait(timeout=5)\n    self.destroy_node()", []),
        ("self.process.wait(timeout=5)\n    self.other.destroy_node()", ["EXE003"]),
        ("if self.process.poll() is None:\n        self.process.wait(timeout=5)\n    rclpy.shutdown()", []),
        ("self.process.wait(timeout=5)\n    if self.done:\n        rclpy.shutdown()", ["EXE003"]),
        ("self.process.wait(timeout=5)\n    if self.more:\n        return\n    rclpy.shutdown()", ["EXE003"]),
        ("if self.more:\n        return\n    self.process.wait(timeout=5)\n    rclpy.shutdown()", []),
        ("self.process.wait()\n    rclpy.shutdown()", ["EXE003"]),  # the stop command waits for as long as it plays
    ],
)
def test_a_node_that_shuts_down_after_it_waited_holds_nothing_up(run: Run, end: str, expected: list[str]):
    setup = "self.process = subprocess.Popen(['play'])\n" + TIMER
    assert codes(run(source(setup, timer(end)))) == expected


@pytest.mark.parametrize(
    ("lines", "severity"),
    [
        (("time.sleep(3.0)", "self.create_subscription(Empty, 'stop', self.on_stop, 10)"), []),
        (("self.create_subscription(Empty, 'stop', self.on_stop, 10)", "time.sleep(3.0)"), [Severity.WARNING]),
    ],
)
def test_what_is_made_after_a_sleep_does_not_wait_for_it(run: Run, lines: tuple[str, str], severity: list[Severity]):
    method = timer("\n    ".join(lines)) + "\ndef on_stop(self, message):\n    pass\n"
    assert [one.severity for one in run(source(ALONE, method)) if one.code == "EXE003"] == severity


@pytest.mark.parametrize(("module", "expected"), [("robot", ["EXE003"]), ("other", [])])
def test_a_script_that_its_package_does_not_install(run: Run, tmp_path: Path, module: str, expected: list[str]):
    setup = f"setup(name='demo', entry_points={{'console_scripts': ['run = {module}:main']}})"
    (tmp_path / "package.xml").write_text("<package format='3'><name>demo</name><version>0.1.0</version></package>")
    (tmp_path / "setup.py").write_text(f"from setuptools import setup\n{setup}\n")
    (tmp_path / "other.py").write_text("def main():\n    print('up')\n")
    found = run(source(TIMER, timer("time.sleep(1.0)")))
    assert [one.code for one in found if one.code == "EXE003"] == expected


def test_the_lookups_that_a_callback_gets_to_in_a_class_are_one_finding(run: Run):
    lookup = """
    def tick(self):
        if not self.buffer.can_transform('map', 'base', rclpy.time.Time(), timeout=Duration(seconds=0.2)):
            return
        self.buffer.lookup_transform('map', 'base', rclpy.time.Time(), timeout=Duration(seconds=0.2))
        self.look()

    def look(self):
        self.buffer.lookup_transform('map', 'tool', rclpy.time.Time(), timeout=Duration(seconds=0.2))
    """
    [first] = run(source(TF.replace("{more}", ""), lookup))
    assert first.code == "EXE007"
    asked = [one.place.line for one in first.related if one.message == "it looks up a transform here, too"]
    assert asked == [first.place.line + 2, first.place.line + 6]


def test_the_lookups_of_two_callbacks_of_a_class_are_one_finding(run: Run):
    """One executor with more threads cures both."""
    lookups = """
    def tick(self):
        self.buffer.lookup_transform('map', 'base', rclpy.time.Time(), timeout=Duration(seconds=0.2))

    def hear(self, message):
        self.buffer.lookup_transform('map', 'tool', rclpy.time.Time(), timeout=Duration(seconds=0.2))
    """
    more = "self.create_subscription(Empty, 'go', self.hear, 10)"
    [first] = run(source(TF.replace("{more}", "") + more, lookups))
    asked = [one.place.line for one in first.related if one.message == "it looks up a transform here, too"]
    assert asked == [first.place.line + 3]


@pytest.mark.parametrize(
    ("test", "expected"),
    [
        ("stop and not problems", []),
        ("not problems and stop", []),
        ("not (problems or not stop)", []),
        ("not problems or stop", ["SRV008"]),
        ("not problems", ["SRV008"]),
    ],
)
def test_a_sleep_behind_a_flag_that_the_handler_turns_off(run: Run, test: str, expected: list[str]):
    """It does not matter whether what is known stands before what is not."""
    methods = f"""
        def check(self, *, stop=True):
            problems = []
            if not self.get_clock():
                problems.append('no clock')
            if {test}:
                time.sleep(5.0)

        def handle(self, request, response):
            self.check(stop=False)
            return response
    """
    assert codes(run(source("self.create_service(Trigger, 'start', self.handle)\n", methods))) == expected


POLLS = """
def serve(self, request, response):
    self.wait({limit})
    time.sleep(0.4)
    return response

def wait(self, limit):
    start = time.monotonic()
    while rclpy.ok():
        if {ends}:
            break
        time.sleep(0.01)
"""


@pytest.mark.parametrize(
    ("limit", "ends", "expected"),
    [
        pytest.param("2.0", "time.monotonic() - start >= limit", [], id="a limit that is passed"),
        pytest.param("2.0", "limit < time.monotonic() - start", [], id="the other way round"),
        pytest.param("2.0", "self.arrived or time.monotonic() - start >= limit", [], id="or something else"),
        pytest.param("60.0", "time.monotonic() - start >= limit", ["SRV008"], id="a long one"),
        pytest.param("2.0", "self.arrived and time.monotonic() - start >= limit", ["SRV008"], id="not by itself"),
        pytest.param("2.0); self.wait(60.0", "time.monotonic() - start >= limit", ["SRV008"], id="once for longer"),
    ],
)
def test_a_loop_in_a_helper_ends_after_the_limit_it_is_given(run: Run, limit: str, ends: str, expected: list[str]):
    create = "self.arrived = load()\nself.create_service(Trigger, 'serve', self.serve)\n"
    assert codes(run(source(create, POLLS.format(limit=limit, ends=ends)))) == expected


def test_the_place_is_in_the_handler_itself_if_it_sleeps_there(run: Run):
    body = "def again(self):\n    time.sleep(1.0)\n\ndef serve(self, request, response):\n    self.again()\n"
    body += "    time.sleep(2.0)\n    self.again()\n    return response\n"
    text = source("self.create_service(Trigger, 'serve', self.serve)\n", body)
    [found] = run(text)
    assert (found.code, found.place.line) == ("SRV008", text.splitlines().index("        time.sleep(2.0)") + 1)


MORE_THREADS = """
import rclpy
from rclpy.executors import MultiThreadedExecutor
from robot import Robot


def main():
    rclpy.init()
    executor = MultiThreadedExecutor()
    executor.add_node(Robot())
    executor.spin()


if __name__ == '__main__':
    main()
"""
APART = "self.create_timer(5.0, self.tick, callback_group=MutuallyExclusiveCallbackGroup())\n"


@pytest.mark.parametrize(
    ("create", "elsewhere", "severity"),
    [
        pytest.param(APART, MORE_THREADS, Severity.INFO, id="another program has more threads for it"),
        pytest.param(APART, "", Severity.WARNING, id="there is no other program"),
        pytest.param(ALONE, MORE_THREADS, Severity.WARNING, id="its group holds others up there, too"),
    ],
)
def test_a_class_that_another_program_spins_with_several_threads(
    run: Run, tmp_path: Path, create: str, elsewhere: str, severity: Severity
):
    (tmp_path / "more_threads.py").write_text(elsewhere, encoding="utf-8")
    beside = "self.create_subscription(Empty, 'beside', print, 10)\n"
    [found] = [one for one in run(source(beside + create, timer("time.sleep(1.0)"))) if one.code == "EXE003"]
    assert found.severity is severity


READS = """
def read(self, request, response):
    for protocol in {protocols}:
        if self.ask(protocol):
            break
    return response

def ask(self, protocol):
    end = time.monotonic() + {limit}
    while time.monotonic() < end:
        if receive(protocol):
            return True
        time.sleep(0.005)
    return False
"""


@pytest.mark.parametrize(
    ("protocols", "limit", "expected"),
    [("self.order()", "0.15", []), ("range(100)", "0.15", ["SRV008"]), ("self.order()", "30.0", ["SRV008"])],
)
def test_a_for_of_a_caller_around_a_loop_with_a_limit(run: Run, protocols: str, limit: str, expected: list[str]):
    methods = READS.replace("{protocols}", protocols).replace("{limit}", limit)
    methods += "\ndef order(self):\n    return load()\n"
    assert codes(run(source("self.create_service(Trigger, 'read', self.read)\n", methods))) == expected


RECONNECTS = """
def tick(self):
    {send}

def reconnect(self):
    while not self.connect():
        time.sleep(5.0)

def connect(self):
    return read()
"""


@pytest.mark.parametrize(
    ("send", "expected"),
    [("if not send():\n        self.reconnect()", []), ("self.reconnect()", ["EXE003"])],
)
def test_a_lesson_is_not_about_a_rare_reconnection(run: Run, send: str, expected: list[str]):
    """Nothing waits but the callback's own next turn."""
    assert codes(run(source("self.create_timer(1.0, self.tick)\n", RECONNECTS.replace("{send}", send)))) == expected


@pytest.mark.parametrize(
    ("beside", "seconds", "expected"),
    [
        ("", "0.1", []),
        ("", "5.0", ["EXE007"]),
        ("self.create_subscription(Empty, 'stop', print, 10)\n", "0.1", ["EXE007"]),
    ],
)
def test_a_node_that_only_looks_up_waits_for_itself_alone(run: Run, beside: str, seconds: str, expected: list[str]):
    """In a large workspace; whoever learns hears of it anyway."""
    lookup = LOOKUP.replace("{timeout}", f"Duration(seconds={seconds})")
    text = source(TF.replace("{more}", "") + beside, lookup)
    assert codes(run(text + MANY_NODES)) == expected
    assert codes(run(text)) == ["EXE007"]


def test_steps_that_a_caller_goes_through_have_no_known_end(run: Run):
    methods = (
        "def home(self, request, response):\n    for step in load():\n        self.move(step)\n    return response\n\n"
        "def move(self, step):\n    time.sleep(0.2)\n"
    )
    [found] = run(source("self.create_service(Trigger, 'home', self.home)\n", methods) + MANY_NODES)
    assert found.code == "SRV008" and found.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("then", "expected"),
    [("sys.exit(0)", []), ("return", ["EXE003"]), ("if read():\n        sys.exit(0)", ["EXE003"])],
)
def test_the_next_program_takes_over(run: Run, then: str, expected: list[str]):
    """Nothing of this one goes on."""
    body = f"import os, sys\n    os.system('ros2 run robot next')\n    {then}"
    assert codes(run(source(TIMER, timer(body)))) == expected


@pytest.mark.parametrize(
    ("then", "expected"),
    [
        ("self.get_logger().info('bye')\n    exit()", []),
        ("if read():\n        sys.exit(0)", ["EXE003"]),
        ("self.get_logger().info('again')", ["EXE003"]),
    ],
)
def test_a_pause_before_the_end_of_the_program(run: Run, then: str, expected: list[str]):
    """Nothing is left that would have to wait."""
    others = TIMER + "self.create_subscription(Empty, 'stop', print, 10)\n"
    body = f"import sys\n    if read():\n        self.end()\n\ndef end(self):\n    time.sleep(0.6)\n    {then}"
    assert codes(run(source(others, timer(body)))) == expected


STOP = """
for _ in range({rounds}):
        self.pub.publish(Empty())
        time.sleep(0.05)
    {then}
"""


@pytest.mark.parametrize(
    ("rounds", "then", "expected"),
    [
        (12, "print('over')\n    rclpy.shutdown()", []),
        (12, "raise SystemExit", []),
        (12, "print('over')", ["EXE003"]),
        (12, "if read():\n        rclpy.shutdown()", ["EXE003"]),
        (100, "rclpy.shutdown()", ["EXE003"]),
    ],
)
def test_the_last_commands_before_ros_ends(run: Run, rounds: int, then: str, expected: list[str]):
    """The robot is to stop, and no other callback is wanted any more."""
    others = TIMER + "self.pub = self.create_publisher(Empty, 'stop', 10)\n"
    assert codes(run(source(others, timer(STOP.format(rounds=rounds, then=then).strip())))) == expected


GOAL = """
def go(self):
    self.client.send_goal_async(Fibonacci.Goal()).add_done_callback(self.on_answer)

def on_answer(self, future):
    subprocess.run(['make'])
    self.go()
"""


@pytest.mark.parametrize(("beside", "expected"), [("", []), ("self.create_timer(0.1, print)\n", ["EXE003"])])
def test_an_answer_in_a_node_that_only_asks(run: Run, beside: str, expected: list[str]):
    """In a large workspace; whoever learns hears of it as information."""
    create = f"self.client = ActionClient(self, Fibonacci, 'count')\n{beside}self.go()\n"
    text = source(create, GOAL)
    assert codes(run(text + MANY_NODES)) == expected
    [found] = run(text)
    assert found.severity is (Severity.WARNING if expected else Severity.INFO)
    assert expected or "but its next answer has to wait" in found.message


TURNS = """
def execute(self, goal_handle):
    time.sleep(1.0)
    {spin}
    goal_handle.succeed()
    return Fibonacci.Result()
"""


@pytest.mark.parametrize(
    ("spin", "expected"),
    [("while read():\n        rclpy.spin_once(self)", ["EXE001"]), ("print()", ["EXE003"])],
    ids=["a spin", "none"],
)
def test_a_goal_that_spins_needs_threads_anyway(run: Run, spin: str, expected: list[str]):
    beside = SERVER + "self.create_subscription(Empty, 'odom', print, 10)\n"
    found = run(source(beside, TURNS.replace("{spin}", spin), ON_ONE_THREAD))
    assert codes(found) == expected
    assert "MultiThreadedExecutor" in (found[0].help or "")


LOOKS = """
def load(self, request, response):
    for slot in read():
        if self.look(slot) is None:
            break
    return response

def look(self, slot):
    for _ in range({times}):
        seen = ask(slot)
        if seen:
            return seen
        time.sleep(0.5)
    return None
"""


@pytest.mark.parametrize(("times", "expected"), [(3, []), (60, ["SRV008"])])
def test_a_few_attempts_for_each_of_something(run: Run, times: int, expected: list[str]):
    """The first is to work."""
    methods = LOOKS.replace("{times}", str(times))
    assert codes(run(source("self.create_service(Trigger, 'load', self.load)\n", methods))) == expected


@pytest.mark.parametrize(
    ("name", "seconds", "told"),
    [
        ("startTest", 0.1, 0),
        ("test_start", 0.1, 0),
        ("start", 0.1, 1),
        ("startTest", 0.5, 1),
        ("latest", 0.1, 1),  # a word that only ends like one
    ],
)
def test_a_brief_pause_in_a_program_that_tries_something_out(findings, name: str, seconds: float, told: int):
    ends = "self.create_timer(0.01, self.tick)\n        self.create_subscription(String, 'a', print, 10)\n"
    tick = f"\n    def tick(self):\n        time.sleep({seconds})\n"
    text = "import time\n" + TALKER.replace("self.create_publisher(String, 'chatter', 10)\n", ends + tick)
    files = {
        "setup.py": SETUP.replace("robot.talker", f"robot.{name}"),
        f"robot/{name}.py": text,
        "robot/talker.py": "",
    }
    assert len(findings("EXE003", **files)) == told


MENU = """
def menu():
    while True:
        {line}


def main():
    rclpy.init()
    node = Robot()
    {before}
    rclpy.spin(node)


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("line", "before", "expected"),
    [
        ("print('which?')", "menu()", []),
        ("print('which?')", "pass", ["EXE003"]),
        ("if load(): break", "menu()", ["EXE003"]),
        ("print('which?')", "if load(): menu()", ["EXE003"]),
    ],
)
def test_a_node_that_no_call_comes_to_spin(run: Run, line: str, before: str, expected: list[str]):
    main = MENU.format(line=line, before=before)
    assert [code for code in codes(run(source(TIMER, timer("time.sleep(1.0)"), main))) if code == "EXE003"] == expected
