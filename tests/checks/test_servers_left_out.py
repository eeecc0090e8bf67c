"""SRV001: servers with a private name, and servers that a launch file leaves out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from learners import PACKAGE, Learned, complete

SERVER = """\
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Motor(Node):
    def __init__(self):
        super().__init__('motor')
        self.create_service(Trigger, '{name}', self.start)

    def start(self, request, response):
        return response


def main():
    rclpy.init()
    rclpy.spin(Motor())
"""
CLIENT = """\
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Control(Node):
    def __init__(self):
        super().__init__('control')
        self.client = self.create_client(Trigger, '{name}')


def main():
    rclpy.init()
    rclpy.spin(Control())
"""
Found = Callable[..., list[str]]


def launch(*nodes: str) -> str:
    return f"<launch>{''.join(nodes)}</launch>"


def started(name: str, inner: str = "") -> str:
    return f'<node pkg="my_first_package" exec="{name}">{inner}</node>'


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Found:
    """What SRV001 says of a motor, its client and launch files."""
    monkeypatch.chdir(tmp_path)

    def run(server: str, client: str, *launches: str, more: str = "") -> list[str]:
        workspace = Learned("", "")
        workspace.files[f"{PACKAGE}my_first_package/motor.py"] = SERVER.format(name=server)
        workspace.files[f"{PACKAGE}my_first_package/control.py"] = CLIENT.format(name=client)
        if more:
            other = CLIENT.format(name="other").replace("control", more)
            workspace.files[f"{PACKAGE}my_first_package/{more}.py"] = other
        for number, text in enumerate(launches):
            workspace.files[f"{PACKAGE}launch/robot{number}.launch.xml"] = text
        complete(workspace, [])
        workspace.write(tmp_path)
        (tmp_path / "archlint.toml").write_text('select = ["SRV001"]', "utf-8")
        return [words(finding) for finding in check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings]

    return run


def words(finding: Finding) -> str:
    return finding.message.partition("no node offers it")[2]


@pytest.mark.parametrize("launches", [(), (launch(started("motor"), started("control")),)], ids=["none", "both"])
def test_a_private_name(found: Found, launches: tuple[str, ...]):
    meant = ": the request never gets a response; did you mean '/motor/start'?"
    assert found("~/start", "start", *launches) == [meant]


def test_a_private_name_that_the_client_writes_in_full(found: Found):
    assert found("~/start", "motor/start") == []
    assert found("~/start", "~/start") == []


def test_a_private_name_that_launch_files_remap(found: Found):
    remapped = launch(started("motor", '<remap from="~/start" to="start"/>'), started("control"))
    assert found("~/start", "start", remapped) == []
    assert found("~/start", "start", launch(started("control"))) == []


def test_a_server_that_the_launch_file_leaves_out(found: Found):
    said = ", since this launch file starts all nodes of their package but /motor: the request never gets a response"
    assert found("start", "start", launch(started("control"))) == [said]
    assert found("start", "start", launch(started("control"), started("motor"))) == []


def test_a_server_that_another_launch_file_starts(found: Found):
    assert found("start", "start", launch(started("control")), launch(started("motor"))) == []


def test_another_node_of_the_package_is_left_out_too(found: Found):
    assert found("start", "start", launch(started("control")), more="panel") == []
    assert len(found("start", "start", launch(started("control"), started("panel")), more="panel")) == 1


def test_a_launch_file_with_a_node_from_elsewhere(found: Found):
    assert found("start", "start", launch(started("control"), '<node pkg="other" exec="driver"/>')) == []
