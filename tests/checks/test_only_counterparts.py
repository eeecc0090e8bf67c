"""TOP004: the only two topics of a type that have one side only, with names of the same words."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import check
from archlint.engine.request import Request
from checks.judging import Judge

PUMP = """
from rclpy.node import Node
from {package}.msg import {type}

class Pump(Node):
    def __init__(self):
        super().__init__('pump')
        self.pub = self.create_publisher({type}, '{name}', 10)
        self.create_timer(1.0, self.check)

    def check(self):
        self.pub.publish({type}())

    def more(self):
        pass
"""
PANEL = """
from rclpy.node import Node
from {package}.msg import {type}

class Panel(Node):
    def __init__(self):
        super().__init__('panel')
        self.create_subscription({type}, '{name}', self.show, 10){mark}

    def show(self, message):
        self.get_logger().info(f'{{message}}')
"""


def both(published: str, read: str, type_: str = "std_msgs/Bool", mark: str = "") -> tuple[str, str]:
    package, _, name = type_.partition("/")
    return (
        PUMP.format(package=package, type=name, name=published),
        PANEL.format(package=package, type=name, name=read, mark=mark),
    )


@pytest.mark.parametrize(
    ("published", "read"),
    [
        ("pump_emergency_stop", "emergency_stop"),
        ("emergency_stop", "pump_emergency_stop"),
        ("tank_filled_done", "has_tank_filled"),
        ("tank_level_topic", "tanklevel"),
    ],
)
def test_names_of_the_same_words(judge: Judge, published: str, read: str):
    (finding,) = judge("TOP004", *both(published, read, mark="  # here"))
    assert finding.message == (
        f"no node publishes '/{read}', and no node subscribes to '/{published}', which /pump publishes with the same "
        f"type; did you mean '/{published}'?"
    )


def test_the_same_words_suffice_for_any_type(judge: Judge):
    judge("TOP004", *both("cost_map", "costmap_topic", "nav_msgs/OccupancyGrid", mark="  # here"))


@pytest.mark.parametrize(
    ("published", "read", "type_"),
    [
        ("pump_emergency_stop", "stop", "std_msgs/Bool"),  # one word says little
        ("nav_cmd_vel", "cmd_vel", "geometry_msgs/Twist"),  # others command, too
        ("emergency_stop_done", "emergency_stop", "std_msgs/Bool"),  # a command, and its report
        ("2_emergency_stop", "emergency_stop", "std_msgs/Bool"),
        ("left/emergency_stop", "right/pump_emergency_stop", "std_msgs/Bool"),
        ("water_level", "oil_pressure", "std_msgs/Bool"),
        ("tank_to_pump", "pump_to_tank", "std_msgs/Bool"),
    ],
)
def test_names_of_two_topics(judge: Judge, published: str, read: str, type_: str):
    judge("TOP004", *both(published, read, type_))


@pytest.mark.parametrize(
    "more",
    [
        "self.create_publisher(Bool, 'full', 10).publish(Bool())",  # a third one of the type
        "self.get_logger().info('emergency_stop')",  # written elsewhere
        "somewhere.watch(self)",  # more of it is elsewhere
    ],
)
def test_others_may_be_meant(judge: Judge, more: str):
    other = f"""
        import somewhere
        from rclpy.node import Node
        from std_msgs.msg import Bool

        class Other(Node):
            def __init__(self):
                super().__init__('other')
                {more}
        """
    pump, panel = both("pump_emergency_stop", "emergency_stop")
    if "watch" in more:
        pump, other = f"import somewhere\n{pump.replace('pass', more)}".replace("1.0, self.check", "1.0, self.more"), ""
    judge("TOP004", pump, panel, other)


MANIFEST = """<package format="3"><name>{name}</name><version>0.0.1</version><description>d</description>
<maintainer email="a@b.c">a</maintainer><license>MIT</license><depend>rclpy</depend><depend>std_msgs</depend>
<export><build_type>ament_python</build_type></export></package>
"""


def in_two_packages(folder: Path, published: str, read: str) -> list[str]:
    for name, source in zip(("tank", "bridge"), both(published, read), strict=True):
        package = folder / name
        (package / name).mkdir(parents=True)
        (package / "package.xml").write_text(MANIFEST.format(name=name), encoding="utf-8")
        (package / name / "__init__.py").touch()
        (package / name / "node.py").write_text(source.lstrip(), encoding="utf-8")
    (folder / "archlint.toml").write_text('select = ["TOP004"]', encoding="utf-8")
    report = check(Request((str(folder),), load(folder), cached=False, jobs=1))
    return [finding.message.partition(",")[0] for finding in report.findings]


def test_packages_that_do_not_depend_on_each_other(tmp_path: Path):
    """What runs together no package says; that the workspace has no other topic of the kind does."""
    assert in_two_packages(tmp_path / "one", "pump_emergency_stop", "emergency_stop") == [
        "no node publishes '/emergency_stop'"
    ]
    assert in_two_packages(tmp_path / "two", "water_level", "oil_pressure") == []
