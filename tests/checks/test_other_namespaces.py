"""SRV001: a client that asks in another namespace for what only one server of the workspace offers."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from learners import PACKAGE, Learned, complete

NODE = """\
import rclpy
from my_robot_interfaces.srv import SetMotorSpeed
from rclpy.node import Node
from std_srvs.srv import Trigger


class {cls}(Node):
    def __init__(self):
        super().__init__('{name}')
        {line}

    def drive(self):
        self.motor.call_async({type}.Request())

    def set(self, request, response):
        return response


def main():
    rclpy.init()
    rclpy.spin({cls}())
"""


def client(name: str, type_: str = "SetMotorSpeed", node: str = "control") -> str:
    line = f"self.motor = self.create_client({type_}, '{name}'); self.create_timer(5.0, self.drive)"
    return NODE.format(cls=node.title(), name=node, line=line, type=type_)


def server(*names: str, type_: str = "SetMotorSpeed", node: str = "motor") -> str:
    lines = "\n        ".join(f"self.create_service({type_}, '{name}', self.set)" for name in names)
    return NODE.format(cls=node.title(), name=node, line=lines, type=type_)


def launch(*nodes: tuple[str, str]) -> str:
    rows = (f'<node pkg="my_first_package" exec="{name}" {more}/>' for name, more in nodes)
    return f"<launch>{''.join(rows)}</launch>"


def found(folder: Path, monkeypatch: pytest.MonkeyPatch, starts: str = "", **modules: str) -> list[Finding]:
    files = {f"{PACKAGE}my_first_package/{name}.py": text for name, text in modules.items()}
    if starts:
        files[f"{PACKAGE}launch/robot.launch.xml"] = starts
    workspace = Learned("namespaces", "robot", files)
    complete(workspace, [])
    workspace.write(folder)
    (folder / "archlint.toml").write_text('select = ["SRV001"]\n', encoding="utf-8")
    monkeypatch.chdir(folder)
    return check(Request((".",), load(folder), cached=False, jobs=1)).findings


@pytest.mark.parametrize(
    ("asked", "served", "meant"),
    [
        ("robot/set_motor", "set_motor", "/set_motor"),
        ("/robot1/set_motor", "/set_motor", "/set_motor"),
        ("set_motor", "/robot1/set_motor", "/robot1/set_motor"),
        ("/left/set_motor", "/right/set_motor", "/right/set_motor"),
        ("robot/set_motor", "~/set_motor", "/motor/set_motor"),
    ],
)
def test_nobody_else_can_offer_it(tmp_path, monkeypatch, asked: str, served: str, meant: str):
    [finding] = found(tmp_path, monkeypatch, control=client(asked), motor=server(served))
    assert finding.place.file.endswith("control.py")
    assert finding.message.endswith(f"the request never gets a response; did you mean '{meant}'?")
    assert [row.message for row in finding.related] == ["/motor has this one"]
    assert finding.help == "use the same name at both ends, or remap one in the launch file"


def test_a_launch_file_that_gives_one_of_them_a_namespace(tmp_path, monkeypatch):
    starts = launch(("control", 'namespace="robot1"'), ("motor", 'namespace="robot2"'))
    [finding] = found(tmp_path, monkeypatch, starts, control=client("set_motor"), motor=server("set_motor"))
    assert "did you mean '/robot2/set_motor'?" in finding.message


@pytest.mark.parametrize(
    ("starts", "modules"),
    [
        ("", {"control": client("set_motor"), "motor": server("set_motor")}),
        ("", {"control": client("robot/set_motor"), "motor": server("set_motor", "robot/set_motor")}),
        ("", {"control": client("robot/set_motor"), "motor": server("set_motor", "stop_motor")}),
        ("", {"control": client("robot/set_motor", "Trigger"), "motor": server("set_motor", type_="Trigger")}),
        ("", {"control": client("robot/go"), "motor": server("set_motor")}),
        (
            "",
            {
                "control": client("robot/set_motor"),
                "motor": server("set_motor"),
                "helper": "from my_robot_interfaces.srv import SetMotorSpeed\n\n\ndef serve(node, name):\n    pass\n",
            },
        ),
        (
            launch(("control", ""), ("motor", 'namespace="robot"')),
            {"control": client("robot/set_motor"), "motor": server("set_motor")},
        ),
        (launch(("motor", "")), {"control": client("robot/set_motor"), "motor": server("set_motor")}),
    ],
    ids=[
        *("the same", "both names", "two servers", "a type that others know", "another name", "other code names it"),
        *("the launch file joins them", "started otherwise"),
    ],
)
def test_somebody_may_offer_it(tmp_path, monkeypatch, starts: str, modules: dict[str, str]):
    assert found(tmp_path, monkeypatch, starts, **modules) == []


def test_a_server_that_another_client_asks(tmp_path, monkeypatch):
    """The robot has several clients: that one of them finds the server says that its name is right."""
    other = client("set_motor", node="panel")
    modules = {"control": client("robot/set_motor"), "panel": other, "motor": server("set_motor")}
    assert found(tmp_path, monkeypatch, **modules) == []
