"""What one analysis has followed is used by all that come after it, and none of them changes it."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.live.buffers import Buffer
from archlint.live.snapshot import Snapshot
from archlint.live.workspace import Asked, LiveWorkspace
from archlint.model.encoding import encode
from archlint.programs.followed import Followed
from archlint.programs.kept import KeptPrograms
from archlint.programs.keys import ProgramKey
from server.robot import Robot

BASE = """\
from rclpy.node import Node
from std_msgs.msg import String


class Base(Node):
    def announce(self, topic):
        self.extra = self.create_publisher(String, topic, 10)
"""
TALKER = """\
import rclpy

from robot.base import Base


class Talker(Base):
    def __init__(self):
        super().__init__('talker')


def main():
    rclpy.init()
    node = Talker()
    node.announce('called')
    rclpy.spin(node)
"""
LISTENER = """\
import rclpy
from std_msgs.msg import String

from robot.base import Base


class Listener(Base):
    def __init__(self):
        super().__init__('listener')


class Ears:
    def __init__(self, node: Listener):
        self.heard = node.create_subscription(String, 'heard', print, 10)


def main():
    rclpy.init()
    rclpy.spin(Listener())
"""
SCRIPT = """\
import rclpy
from rclpy.node import Node

if __name__ == '__main__':
    rclpy.init()
    rclpy.spin(Node('by_hand'))
"""


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    """A robot whose programs are not left as they were followed: ``Ears`` is given to the listener, nobody there calls
    ``announce``, and no package installs the script."""
    robot = Robot(tmp_path)
    (robot.talker.parent / "base.py").write_text(BASE, "utf-8")
    (robot.talker.parent / "script.py").write_text(SCRIPT, "utf-8")
    robot.talker.write_text(TALKER, "utf-8")
    robot.listener.write_text(LISTENER, "utf-8")
    return robot


def nodes_of(snapshot: Snapshot) -> dict[str | None, tuple[list[str | None], tuple[str, ...]]]:
    """What each node creates by name, and what starts it, by the name of the node."""
    [[system, *_]] = snapshot.systems
    blueprints = [node.blueprint for node in system.nodes if node.blueprint is not None]
    return {
        node.name.text: ([creation.name.text for creation in node.creations], (*node.executables, *node.scripts))
        for node in blueprints
    }


def test_programs_stay_as_they_were_followed(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    known: list[tuple[KeptPrograms, Followed, bytes]] = []
    get = KeptPrograms.get

    def noting(kept: KeptPrograms, key: ProgramKey, late: bool) -> Followed | None:
        followed = get(kept, key, late)
        if followed is not None:
            known.append((kept, followed, encode(kept.parts_of(followed))))
        return followed

    monkeypatch.setattr(KeptPrograms, "get", noting)
    asked, live = Asked((str(robot.folder),), Settings()), LiveWorkspace(str(robot.folder))
    nodes = nodes_of(live.analyse(asked, {}))
    assert nodes == {
        "talker": (["called"], ("talker",)),
        "listener": (["heard"], ("listener",)),
        "by_hand": ([], ("src/robot/robot/script.py",)),
    }
    for number in range(3):
        edited = Buffer(f"{TALKER}\nNUMBER = {number}\n".encode())
        assert nodes_of(live.analyse(asked, {str(robot.talker): edited})) == nodes

    assert all(encode(kept.parts_of(followed)) == then for kept, followed, then in known)
    assert len({id(followed) for _, followed, _ in known}) < len(known)
