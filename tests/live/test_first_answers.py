"""After any edit of code the first answer has the findings of the whole analysis, and that those of a new one."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.memory import Memory
from archlint.live.buffers import Buffer, Buffers
from archlint.live.workspace import Asked, LiveWorkspace
from server.robot import Robot

BASE = """\
import time

from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Base(Node):
    def __init__(self, name):
        super().__init__(name)
        self.rate = self.get_parameter('rate').value
        self.state = self.create_publisher(String, '/robot/state', 10)
        self.client = self.create_client(Trigger, 'reset')
        self.slow = self.create_service(Trigger, 'slow', self.on_slow)

    def on_slow(self, request, response):
        time.sleep(2.0)
        self.pause()
        return response

    def wait(self):
        while not self.client.wait_for_service(timeout_sec=1.0):
            pass

    def pause(self):
        time.sleep(1.0)
"""

NODE = """\
import rclpy
from std_msgs.msg import String

from robot.base import Base


class {cls}(Base):
    def __init__(self):
        super().__init__('{name}')
        self.ears = self.create_subscription(String, '/heard', self.on_word, 10)
        self.wait()

    def on_word(self, message):
        self.pause()
        rclpy.spin_once(self)
        self.state.publish(message.data)


def main():
    rclpy.init()
    node = {cls}()
    rclpy.spin_until_future_complete(node, node.client.call_async(None))
    rclpy.spin(node)
"""

EDITS = [
    ("'/robot/state'", "'state'"),
    ("'state'", "'/robot/state'"),
    ("time.sleep(1.0)", "time.sleep(0.0)"),
    ("time.sleep(0.0)", "time.sleep(1.0)"),
    ("        self.pause()\n", ""),
    ("        self.wait()\n", "\n"),
    ("        rclpy.spin_once(self)\n", ""),
    ("time.sleep(2.0)", "time.sleep(20.0)"),
    ("time.sleep(20.0)", "time.sleep(0.2)"),
    ("self.on_word, 10", "self.pause, 10"),
    ("message.data)", "message)"),
    ("(Base)", "(rclpy.node.Node)"),
    ("from robot.base import Base", "from robot.base import Base  # of all"),
    ("import rclpy\n", "# A node.\nimport rclpy\n"),
    ("    rclpy.spin(node)\n", ""),
    ("timeout_sec=1.0", ""),
    ("super().__init__(name)", "super().__init__(name)\n        self.declare_parameter('rate', 1)"),
]


@pytest.fixture
def robot(tmp_path: Path) -> Robot:
    robot = Robot(tmp_path)
    (robot.talker.parent / "base.py").write_text(BASE, "utf-8")
    robot.talker.write_text(NODE.format(cls="Talker", name="talker"), "utf-8")
    robot.listener.write_text(NODE.format(cls="Listener", name="listener"), "utf-8")
    return robot


def edits(robot: Robot, seed: int) -> list[Buffers]:
    """What an editor holds after each of some edits, one after the other."""
    chance = random.Random(seed)
    texts = {file: file.read_text("utf-8") for file in sorted(robot.talker.parent.glob("*.py"))}
    states: list[Buffers] = []
    while len(states) < 8:
        file, (old, new) = chance.choice([file for file in texts if texts[file]]), chance.choice(EDITS)
        if old in texts[file]:
            texts[file] = texts[file].replace(old, new, 1)
            states.append({str(path): Buffer(text.encode()) for path, text in texts.items()})
    return states


@pytest.mark.parametrize("seed", range(4))
def test_the_first_answer_after_any_edit_is_the_whole_one(robot: Robot, seed: int) -> None:
    asked = Asked((str(robot.folder),), Settings())
    live = LiveWorkspace(str(robot.folder))
    codes = {finding.code for finding in live.analyse(asked, {}).findings}
    assert codes >= {"EXE001", "PRM003", "NME001", "SRV008", "TMO004", "TOP005"}

    for buffers in edits(robot, seed):
        first, whole = live.first_answer(asked, buffers), live.analyse(asked, buffers)
        assert first is None or first.findings == whole.findings
    assert whole.findings == LiveWorkspace(str(robot.folder)).analyse(asked, buffers).findings


def test_only_nodes_of_edited_code_are_made_again(robot: Robot) -> None:
    asked = Asked((str(robot.folder),), Settings())
    live = LiveWorkspace(str(robot.folder))
    text = robot.listener.read_text("utf-8")
    live.analyse(asked, {})
    once, twice = ({str(robot.listener): Buffer(text.replace("heard", word).encode())} for word in ("word", "words"))
    before = {node.name: node for node in live.analyse(asked, once).systems[0][0].nodes}

    first = live.first_answer(asked, twice)

    assert first is not None
    assert {node.name: node is before[node.name] for node in first.systems[0][0].nodes} == {
        "/listener": False,
        "/talker": True,
    }


def test_rules_that_go_by_program_judge_those_of_edited_code_alone(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = Asked((str(robot.folder),), Settings())
    live = LiveWorkspace(str(robot.folder))
    other = NODE.format(cls="Other", name="other").replace("robot.base import Base", "rclpy.node import Node as Base")
    robot.listener.write_text(other, "utf-8")
    live.analyse(asked, {})
    judged: list[set[str]] = []
    again = Memory._judged_again

    def noting(self, before, system, selected, judge):
        def told(part, codes):
            judged.append({Path(program.file).name for program in part.programs})
            return judge(part, codes)

        return again(self, before, system, selected, told)

    monkeypatch.setattr(Memory, "_judged_again", noting)
    live.first_answer(asked, {str(robot.listener): Buffer(other.replace("'/heard'", "'heard'").encode())})

    assert judged == [{"listener.py"}]
