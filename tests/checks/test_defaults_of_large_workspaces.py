"""What OWN001, SRV008, TOP001 and NME001 leave to lessons and to options, and what makes one finding."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Severity
from checks.judging import Judge
from robot_package import manifest, write_files

HEAD = """
import rclpy
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Odometry
from rclpy.node import Node
from std_msgs.msg import Float32, String
"""
MAIN = "\n\ndef main():\n    rclpy.init()\n    rclpy.spin({name}())\n\n\nif __name__ == '__main__':\n    main()\n"
IDLE = "\n\nclass {name}(Node):\n    def __init__(self):\n        super().__init__('{name}')\n"
IDLES = {f"idle{number}": HEAD + IDLE.format(name=f"Idle{number}") for number in range(5)}
"""What makes a workspace too large for a lesson, although no launch file starts it."""
SPEAKER = """

class {name}(Node):
    def __init__(self):
        super().__init__('{name}')
        self.out = self.create_publisher({type}, '{topic}', 10)
        {on}

    def tick(self, message=None):
        {guard}self.out.publish({type}())
"""
ALWAYS = "self.create_timer(0.1, self.tick)"


def speaker(name: str, type_: str, topic: str, on: str = ALWAYS, guard: str = "") -> str:
    return HEAD + SPEAKER.format(name=name, type=type_, topic=topic, on=on, guard=guard)


def findings(folder: Path, config: str, launches: dict[str, str], nodes: dict[str, str]) -> list[Finding]:
    """What is said of a package with these nodes and launch files, each of which starts the nodes that it names."""
    scripts = ", ".join(f"'{name} = robot.{name}:main'" for name in nodes)
    files = {
        "package.xml": manifest(),
        "setup.py": "from setuptools import setup\nsetup(name='robot', packages=['robot'], "
        "data_files=[('share/robot/launch', ['launch/a.launch.xml', 'launch/b.launch.xml'])], "
        f"entry_points={{'console_scripts': [{scripts}]}})\n",
        "robot/__init__.py": "",
        "archlint.toml": config,
    }
    for name, names in launches.items():
        started = "".join(f"<node pkg='robot' exec='{each}'/>" for each in names.split())
        files[f"launch/{name}.launch.xml"] = f"<launch>{started}</launch>\n"
    for name, text in nodes.items():
        files[f"robot/{name}.py"] = text + MAIN.format(name=name.title())
    write_files(folder, files)
    return check(Request((".",), load(folder), cached=False, jobs=1)).findings


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("type_", "topic", "others", "option", "told"),
    [
        ("String", "words", {}, "", [Severity.INFO]),
        ("String", "words", IDLES, "", []),
        ("String", "words", IDLES, "[rules.OWN001]\ntexts = true\n", [Severity.INFO]),
        ("String", "robot_mode", IDLES, "", [Severity.WARNING]),
        ("Float32", "depth", IDLES, "", [Severity.WARNING]),
    ],
)
def test_texts_that_stand_for_themselves(
    folder: Path, type_: str, topic: str, others: dict[str, str], option: str, told: list[Severity]
):
    nodes = {"one": speaker("One", type_, topic), "two": speaker("Two", type_, topic)}
    rows = findings(folder, f'select = ["OWN001"]\n{option}', {"a": "one two"}, {**nodes, **others})
    assert [row.severity for row in rows] == told


@pytest.mark.parametrize(
    ("guard", "others", "option", "told"),
    [
        ("", IDLES, "", 1),
        ("if self.free: ", {}, "", 1),
        ("if self.free: ", IDLES, "", 0),
        ("if self.free: ", IDLES, "[rules.OWN001]\noccasions = true\n", 1),
    ],
)
def test_who_publishes_under_a_condition_may_have_its_turn(
    folder: Path, guard: str, others: dict[str, str], option: str, told: int
):
    nodes = {"one": speaker("One", "Twist", "cmd_vel"), "two": speaker("Two", "Twist", "cmd_vel", guard=guard)}
    assert len(findings(folder, f'select = ["OWN001"]\n{option}', {"a": "one two"}, {**nodes, **others})) == told


GOAL = "self.create_subscription(PoseStamped, '{}', self.tick, 10)"


@pytest.mark.parametrize(
    ("topic", "told"),
    [("planner/goal", 0), ("replan_request", 0), ("pose", 1)],
)
def test_who_answers_a_goal_speaks_on_an_occasion(folder: Path, topic: str, told: int):
    """The other one sends again and again only until it has something better to do."""
    nodes = {
        "one": speaker("One", "PoseStamped", "waypoint", on=GOAL.format(topic)),
        "two": speaker("Two", "PoseStamped", "waypoint", guard="if self.starts: "),
        "asker": speaker("Asker", "PoseStamped", topic),
    }
    assert len(findings(folder, 'select = ["OWN001"]', {"a": "one two asker"}, nodes)) == told


def test_who_is_not_seen_to_publish_may_do_so_on_request(folder: Path):
    """The pages of a web server, say: nothing here calls what publishes."""
    unseen = "import web\n" + speaker("One", "Float32", "depth", on="web.serve(lambda: self.tick())")
    nodes = {"one": unseen.replace("self.out.publish", "web.run and self.out.publish")}
    nodes["two"] = speaker("Two", "Float32", "depth", on="web.serve(self)")
    assert findings(folder, 'select = ["OWN001"]', {"a": "one two"}, nodes) == []


HEARER = """

class {name}(Node):
    def __init__(self):
        super().__init__('{name}')
        self.create_subscription({type}, 'odom', print, 10)
"""


def test_one_line_that_disagrees_with_several_nodes_is_one_finding(folder: Path):
    nodes = {
        "planner": HEAD + HEARER.format(name="Planner", type="PoseStamped"),
        "aligner": HEAD + HEARER.format(name="Aligner", type="Odometry"),
        "bridge": speaker("Bridge", "Odometry", "odom"),
        **IDLES,
    }
    launches = {"a": "planner aligner", "b": "planner bridge"}
    [finding] = findings(folder, 'select = ["TOP001"]', launches, nodes)
    assert finding.place.file == "robot/planner.py"
    assert "publishes it as nav_msgs/msg/Odometry" in finding.message
    assert {related.place.file for related in finding.related} == {"robot/aligner.py", "robot/bridge.py"}


HANDLER = """
    import time
    import rclpy
    from rclpy.node import Node
    from std_srvs.srv import Trigger


    class Gripper(Node):
        def __init__(self):
            super().__init__('gripper')
            self.create_service(Trigger, '{name}', self.grab)

        def grab(self, request, response):
            while self.moves():
                time.sleep(0.05){here}
            return response


    def main():
        rclpy.init()
        rclpy.spin(Gripper())


    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("name", "others", "told"),
    [
        ("gripper/grab", list(IDLES.values()), True),
        ("gripper/grab_blocking", list(IDLES.values()), False),
        ("gripper/unblock", list(IDLES.values()), True),
        ("gripper/grab_blocking", [], True),
    ],
)
def test_a_service_whose_name_says_that_its_callers_wait(judge: Judge, name: str, others: list[str], told: bool):
    judge("SRV008", HANDLER.format(name=name, here="  # here" if told else ""), *others)


@pytest.mark.parametrize(("packages", "told"), [(1, 1), (2, 0)])
def test_more_packages_with_programs_make_up_a_robot(folder: Path, packages: int, told: int):
    """Be it that no node is seen in those others."""
    node = speaker("One", "Float32", "/robot/depth")
    for number in range(packages):
        name = f"driver{number}"
        scripts = f"entry_points={{'console_scripts': ['{name} = {name}.main:main']}}"
        other = {
            "package.xml": manifest(name),
            "setup.py": f"from setuptools import setup\nsetup(name='{name}', {scripts})\n",
        }
        write_files(folder / name, {**other, f"{name}/main.py": "def main():\n    pass\n"})
    here = folder / "robot"
    scripts = "entry_points={'console_scripts': ['one = robot.one:main']}"
    own = {"package.xml": manifest(), "setup.py": f"from setuptools import setup\nsetup(name='robot', {scripts})\n"}
    write_files(here, {**own, "robot/one.py": node + MAIN.format(name="One")})
    (folder / "archlint.toml").write_text('select = ["NME001"]\n')
    assert len(check(Request((".",), load(folder), cached=False, jobs=1)).findings) == told
