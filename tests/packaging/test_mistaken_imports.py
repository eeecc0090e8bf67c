"""Imports of interfaces from a package that is nowhere."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding

MANIFEST = (
    '<package format="3"><name>{name}</name><version>0.1.0</version><description>Doors</description>'
    '<maintainer email="a@example.org">A</maintainer><license>MIT</license>'
    "<export><build_type>{build}</build_type></export></package>"
)


def interfaces(name: str, listed: str) -> str:
    """A CMakeLists.txt that generates interfaces."""
    generate = f"rosidl_generate_interfaces(${{PROJECT_NAME}} {listed})"
    return f"project({name})\nfind_package(rosidl_default_generators REQUIRED)\n{generate}\nament_package()\n"


FILES = {
    "interfaces/package.xml": MANIFEST.format(name="robot_interfaces", build="ament_cmake"),
    "interfaces/CMakeLists.txt": interfaces("robot_interfaces", '"msg/Door.msg" "msg/Lamp.msg"'),
    "interfaces/msg/Door.msg": "bool open\n",
    "interfaces/msg/Lamp.msg": "bool on\n",
    "robot/package.xml": MANIFEST.format(name="robot", build="ament_python"),
    "robot/setup.py": "from setuptools import setup\nsetup(name='robot', packages=['robot'])\n",
    "robot/robot/__init__.py": "",
}
Said = Callable[..., list[Finding]]


@pytest.fixture
def said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Said:
    """What API006 says of a file of one package with some lines, where another package defines Door and Lamp."""
    monkeypatch.chdir(tmp_path)

    def run(lines: str, **more: str) -> list[Finding]:
        own = {"robot/robot/node.py": f"import rclpy\n{lines}\n", "archlint.toml": 'select = ["API006"]\n'}
        for name, text in {**FILES, **own, **more}.items():
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run


def test_interfaces_of_a_package_that_is_nowhere(said: Said) -> None:
    (finding,) = said("from home_interfaces.msg import Door, Lamp")
    assert (
        finding.message == "there is no package home_interfaces: the import fails; the module is robot_interfaces.msg"
    )
    assert finding.help == "write `from robot_interfaces.msg import …`"
    assert (finding.place.file, finding.place.line) == ("robot/robot/node.py", 2)


def test_a_package_that_is_nowhere_is_told_once(said: Said) -> None:
    """PKG001 has nothing to add to a line of which it is known what was meant."""
    both = {"archlint.toml": 'select = ["API006", "PKG001"]\n'}

    def codes(lines: str) -> list[str]:
        return [row.code for row in said(lines, **both) if "home_interfaces" in row.message]

    assert codes("from home_interfaces.msg import Door") == ["API006"]
    assert codes("from home_interfaces.msg import Window") == ["PKG001"]


@pytest.mark.parametrize(
    ("lines", "more"),
    [
        ("from home_interfaces.msg import Door, Window", {}),  # not all of them are here
        ("from home_interfaces.msg import Door\nfrom home_interfaces.srv import Open", {}),
        ("from home_interfaces.msg import Door", {"Dockerfile": "RUN git clone https://example.org/home_interfaces\n"}),
        ("from home_interfaces.msg import Door", {"robot.repos": "repositories:\n  home_interfaces:\n    type: git\n"}),
        (
            "from home_interfaces.msg import Door",
            {
                "doors/package.xml": MANIFEST.format(name="doors", build="ament_cmake"),
                "doors/CMakeLists.txt": "project(doors)\nfind_package(home_interfaces REQUIRED)\nament_package()\n",
            },
        ),
        ("from robot_interfaces.msg import Door", {}),
        ("from sensor_msgs.msg import Imu", {}),
    ],
)
def test_interfaces_that_another_repository_may_have(said: Said, lines: str, more: dict[str, str]) -> None:
    assert said(lines, **more) == []


def test_names_that_two_packages_define(said: Said) -> None:
    other = {
        "house/package.xml": MANIFEST.format(name="house_interfaces", build="ament_cmake"),
        "house/CMakeLists.txt": interfaces("house_interfaces", '"msg/Door.msg"'),
        "house/msg/Door.msg": "bool open\n",
    }
    assert said("from home_interfaces.msg import Door", **other) == []
