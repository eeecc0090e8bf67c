"""Mistakes in methods that nothing calls, of modules that the programs of their own package use."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check

BRAKE = """\
from rclpy.node import Node


class Brake:
    def __init__(self, node: Node):
        self.node = node

    def press(self):
        self.node.get_logger().info('pressed')

    def force(self, speed):
        if self.odometry > speed:
            return 1.0
        return 0.0
"""
STOP = BRAKE + "\n    def stop(self):\n        return self.force(1.0)\n"
CAR = """\
import rclpy
from rclpy.node import Node

from car.brake import Brake


class Car(Node):
    def __init__(self):
        super().__init__('car')
        self.brake = Brake(self)
        self.timer = self.create_timer(1.0, self.drive)

    def drive(self):
        self.brake.press()


def main():
    rclpy.init()
    rclpy.spin(Car())
"""
SETUP = """\
from setuptools import setup
setup(name='car', packages=['car'], entry_points={'console_scripts': ['drive = car.drive:main']})
"""
LIBRARY = "from setuptools import setup\nsetup(name='car', packages=['car'])\n"


def manifest(name: str, tags: str = "") -> str:
    return (
        f"<package format='3'><name>{name}</name><version>0.1.0</version><description>d</description>"
        f"<maintainer email='kim@example.com'>Kim</maintainer><license>MIT</license><depend>rclpy</depend>{tags}"
        "<export><build_type>ament_python</build_type></export></package>"
    )


OWN = """\

    def force(self, speed):
        return 2.0

    def hold(self):
        return self.force(1.0)
"""
OWN_OF_CAR = CAR.replace("\n\ndef main", f"{OWN}\n\ndef main", 1)
REPLACES = "\n    def force(self, speed):\n        return 2.0\n"
BEHIND_A_RETURN = BRAKE.replace("if self.odometry", "return 0.0\n        if self.odometry")
PASSES_ON = BRAKE.replace("return 1.0", "return self.pedal.force(speed)")
"""A method of the same name of another object, which only this one calls."""
KEEPS = f"\n    strong = force\n{REPLACES}"


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({}, False),
        ({"car/car/drive.py": CAR.replace("press()", "force(3.0)")}, True),
        ({"car/car/brake.py": STOP, "car/car/drive.py": CAR.replace("press()", "stop()")}, True),
        ({"car/car/brake.py": STOP}, False),
        ({"car/car/brake.py": PASSES_ON}, False),
        ({"car/car/brake.py": PASSES_ON, "car/car/drive.py": CAR.replace("press()", "force(3.0)")}, True),
        ({"car/car/drive.py": OWN_OF_CAR}, False),
        ({"car/car/drive.py": OWN_OF_CAR.replace("press()", "force(3.0)")}, True),
        ({"car/setup.py": LIBRARY}, True),
        ({"fleet/package.xml": manifest("fleet", "<depend>car</depend>"), "fleet/setup.py": LIBRARY}, True),
        ({"fleet/package.xml": manifest("fleet"), "fleet/setup.py": LIBRARY}, False),
        ({"car/setup.py": LIBRARY, "car/car/brake.py": f"{BRAKE}{REPLACES}"}, False),
        ({"car/setup.py": LIBRARY, "car/car/brake.py": f"{BRAKE}{KEEPS}"}, True),
        ({"car/setup.py": LIBRARY, "car/car/brake.py": BEHIND_A_RETURN}, False),
    ],
    ids=[
        "left over",
        "called",
        "called by one that is called",
        "led to by what nothing calls",
        "passes on to another method of that name",
        "passes on, and is called",
        "another has a method of that name",
        "another has one, and calls this one, too",
        "a library",
        "another package needs it",
        "another package",
        "replaced by a later one",
        "kept by the body of the class before that",
        "behind a return",
    ],
)
def test_an_attribute_that_a_method_reads_which_nothing_calls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, files: dict[str, str], told: bool
):
    monkeypatch.chdir(tmp_path)
    own = {"car/package.xml": manifest("car"), "car/setup.py": SETUP, "car/car/__init__.py": ""}
    own |= {"car/car/brake.py": BRAKE, "car/car/drive.py": CAR, "archlint.toml": 'select = ["API002"]\n'}
    others = {f"car/car/drive{n}.py": CAR.replace("class Car(", f"class Car{n}(") for n in range(6)}  # no lesson
    for name, text in {**own, **others, **files}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [row.place.line for row in rows if row.place.file == "car/car/brake.py"] == [12] * told


LEFT_OVER = """\

    def gains(self):
        print('/' + self.get_parameter('controller'))
        answer = self.client.call_async(GetParameters.Request())
        return answer.values

    def more(self):
        return self.gains()
"""
SETS_UP = CAR.replace("car.brake import Brake", "rcl_interfaces.srv import GetParameters\nfrom car.brake import Brake")
SETS_UP = SETS_UP.replace(
    "        self.timer", "        self.client = self.create_client(GetParameters, 'gains')\n        self.timer"
)


@pytest.mark.parametrize(("called", "told"), [("self.brake.press()", []), ("self.more()", ["PRM011", "TMO006"])])
def test_a_parameter_and_a_future_in_a_method_that_nothing_calls(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, called: str, told: list[str]
):
    monkeypatch.chdir(tmp_path)
    source = SETS_UP.replace("\n\ndef main", f"{LEFT_OVER}\n\ndef main", 1).replace("self.brake.press()", called)
    own = {"car/package.xml": manifest("car"), "car/setup.py": SETUP, "car/car/__init__.py": ""}
    own |= {"car/car/brake.py": BRAKE, "archlint.toml": 'select = ["PRM011", "TMO006"]\n'}
    others = {f"car/car/drive{n}.py": CAR.replace("class Car(", f"class Car{n}(") for n in range(6)}  # no lesson
    for name, text in {**own, **others, "car/car/drive.py": source}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert sorted(row.code for row in rows if row.place.file == "car/car/drive.py") == told


@pytest.mark.parametrize(
    ("entry", "told"), [("", 0), (", 'brake = car.brake:main'", 1)], ids=["a module of others", "a program"]
)
def test_what_the_author_of_a_module_has_tried_out(tmp_path: Path, monkeypatch, entry: str, told: int):
    files = {
        "package.xml": manifest("car"),
        "setup.py": SETUP.replace(":main']", f":main'{entry}]"),
        "car/__init__.py": "",
        "car/drive.py": CAR,
        "car/brake.py": f"{BRAKE}\n\ndef main():\n    pass\n\n\nif __name__ == '__main__':\n    print(lost)\n",
        "archlint.toml": 'select = ["API005"]\n',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert len(check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings) == told


@pytest.mark.parametrize(
    ("rest", "entry", "told"),
    [
        ("", "", 0),
        ("", ", 'brake = car.brake:main'", 1),
        ("\n\nif __name__ == '__main__':\n    main()\n", "", 0),
        ("\n\nif __name__ == '__main__':\n    main()\n", ", 'brake = car.brake:main'", 1),
        ("\n\nmain()\n", "", 1),
        ("\n\nrun = main\n", "", 1),
    ],
    ids=["nothing calls it", "an entry does", "who tries it out", "the program", "the file", "the file passes it on"],
)
def test_a_main_that_nothing_calls(tmp_path: Path, monkeypatch, rest: str, entry: str, told: int):
    main = "\n\ndef main():\n    print(lost)\n"
    files = {
        "package.xml": manifest("car"),
        "setup.py": SETUP.replace(":main']", f":main'{entry}]"),
        "car/__init__.py": "",
        "car/drive.py": CAR,
        "car/brake.py": BRAKE + main + rest,
        "archlint.toml": 'select = ["API005"]\n',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)

    def labels() -> list[str]:
        report = check(Request((".",), load(tmp_path), cached=False, jobs=1))
        return [finding.severity.label for finding in report.findings]

    assert labels() == ["error"] * told
    if "__main__" in rest:
        (tmp_path / "brake.launch.py").write_text(
            "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n\n\n"
            "def generate_launch_description():\n"
            "    return LaunchDescription([ExecuteProcess(cmd=['python3', '-m', 'car.brake'])])\n",
            encoding="utf-8",
        )
        assert labels() == ["error"]


HELPERS = """\
from rclpy.node import Node


def slow(node: Node, speed):
    return speed * factor


def slower(node: Node, speed):
    return slow(node, speed)
"""
STARTS = """\
def generate_launch_description():
    slow(None, 1.0)
    return launch.LaunchDescription([])
"""
TRIED = HELPERS + "\n\ndef main():\n    pass\n\n\nif __name__ == '__main__':\n    slow(None, 1.0)\n"
TRIED_PROGRAM = SETUP.replace(":main']", ":main', 'try = car.helpers:main']")
USES_HELPERS = CAR.replace("car.brake import Brake", "car.brake import Brake\nfrom car.helpers import slow")


@pytest.mark.parametrize(
    ("files", "told"),
    [
        ({}, False),
        ({"car/drive.py": USES_HELPERS}, False),
        ({"car/drive.py": USES_HELPERS.replace("self.brake.press()", "# slow(self, 1.0)")}, False),
        ({"car/drive.py": USES_HELPERS.replace("self.brake.press()", "slow(self, 1.0)")}, True),
        ({"car/drive.py": USES_HELPERS.replace("import slow", "import slow as halt")}, True),
        ({"car/drive.py": USES_HELPERS.replace("import slow", "import slower\nHOW = [slower]")}, True),
        ({"car/drive.py": USES_HELPERS.replace("self.brake.press()", "getattr(helpers, 'slow')(self, 1.0)")}, True),
        (
            {"start.launch.py": "import launch\n\nPROGRAM = ('helpers', 'slow')\n\n\n" + STARTS.replace("slow", "str")},
            False,
        ),
        ({"start.launch.py": "import launch\nfrom car.helpers import slow\n\n\n" + STARTS}, True),
        ({"car/drive.py": CAR.replace("self.brake.press()", "slow = self.brake.press()")}, False),
        ({"car/drive.py": USES_HELPERS.replace("import slow", "import slower"), "car/helpers.py": TRIED}, False),
        ({"setup.py": TRIED_PROGRAM, "car/drive.py": USES_HELPERS, "car/helpers.py": TRIED}, True),
        ({"car/drive.py": USES_HELPERS, "car/helpers.py": HELPERS.replace("def slow(", "@noted\ndef slow(")}, True),
        ({"setup.py": SETUP.replace(":main']", ":main', 'slow = car.helpers:slow']")}, True),
        ({"setup.py": LIBRARY}, True),
    ],
    ids=[
        "nothing calls it",
        "it is imported",
        "its call is a comment",
        "it is called",
        "it is imported under another name",
        "what calls it is passed on",
        "it is called by its name",
        "a launch file has its name in a text",
        "a launch file calls it",
        "another file has a variable of that name",
        "the author of its module tries it out",
        "its module is a program, too",
        "a decorator may note it",
        "a program",
        "a library",
    ],
)
def test_a_function_that_nothing_calls(tmp_path: Path, monkeypatch, files: dict[str, str], told: bool):
    own = {"package.xml": manifest("car"), "setup.py": SETUP, "car/__init__.py": "", "car/brake.py": BRAKE}
    own |= {"car/drive.py": CAR, "car/helpers.py": HELPERS, "archlint.toml": 'select = ["API005"]\n'}
    for name, text in {**own, **files}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert len([row for row in rows if "'factor'" in row.message]) == told


@pytest.mark.parametrize(("called", "told"), [("press", False), ("steer", True)])
def test_a_slip_in_a_method_that_only_an_uncalled_one_leads_to(tmp_path: Path, monkeypatch, called: str, told: bool):
    brake = BRAKE.replace("self.node = node", "self.odometer = node").replace("self.node.get", "self.odometer.get")
    brake += "\n    def steer(self):\n        return self.force(1.0)\n"
    files = {
        "package.xml": manifest("car"),
        "setup.py": SETUP,
        "car/__init__.py": "",
        "car/drive.py": CAR.replace("brake.press", f"brake.{called}"),
        "car/brake.py": brake.replace("self.odometry", "self.odometre"),
        "archlint.toml": 'select = ["API002"]\n',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [row.meant for row in rows] == ["odometer"] * told


STAMPS = """\
from geometry_msgs.msg import Point
from rclpy.duration import Duration
from rclpy.node import Node


def limit(node: Node, point: Point):
    node.get_clock().sleep_for(Duration(5))


def lift(node: Node):
    point = Point()
    point.z = '1'
    node.create_publisher(Point, 'lift', 10).publish(point)
"""


@pytest.mark.parametrize("called", [(), ("limit",), ("lift",), ("limit", "lift")])
def test_calls_and_values_in_functions_that_nothing_calls(tmp_path: Path, monkeypatch, called: tuple[str, ...]):
    calls = "\n        ".join(f"{name}(self{', None' * (name == 'limit')})" for name in called)
    drive = CAR.replace("car.brake import Brake", "car.brake import Brake\nfrom car.stamps import lift, limit")
    files = {
        "package.xml": manifest("car"),
        "setup.py": SETUP,
        "car/__init__.py": "",
        "car/brake.py": BRAKE,
        "car/drive.py": drive.replace("self.brake.press()", calls or "pass"),
        "car/stamps.py": STAMPS,
        "archlint.toml": 'select = ["API001", "MSG003"]\n',
    }
    for name, text in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [row.place.line for row in rows] == [7] * ("limit" in called) + [12] * ("lift" in called)


LIFT = """\
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Arm:
    def raise_it(self):
        time.sleep(5.0)


class Lift(Node):
    def __init__(self):
        super().__init__('lift')
        self.arm = Arm()
        self.create_subscription(String, 'up', self.on_up, 10)
        self.create_subscription(String, 'down', self.on_down, 10)

    def on_up(self, message):
        self.arm.raise_it()

    def on_down(self, message):
        print(message.text, hieght)


def main():
    rclpy.init()
    {made}


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    ("made", "told"),
    [("rclpy.spin(Lift())", ["EXE003", "MSG001", "API005"]), ("# rclpy.spin(Lift())\n    Arm().raise_it()", [])],
    ids=["made", "the line that makes it is a comment"],
)
def test_a_node_that_its_program_does_not_make(tmp_path: Path, monkeypatch, made: str, told: list[str]):
    (tmp_path / "lift.py").write_text(LIFT.replace("{made}", made), encoding="utf-8")
    (tmp_path / "archlint.toml").write_text('select = ["API005", "EXE003", "MSG001"]\n', encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    rows = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
    assert [row.code for row in rows] == told
