"""Answers about names in the words of the protocol."""

from __future__ import annotations

from pathlib import Path

from lsprotocol import types as lsp

from archlint.config.settings import Settings
from archlint.live.buffers import Buffer
from archlint.live.workspace import Asked, LiveWorkspace
from archlint.server.diagnostics import Shown
from archlint.server.names import Names
from archlint.server.uris import Addresses
from server.robot import LISTENER, TALKER, Robot


def names(robot: Robot, **buffers: str) -> Names:
    held = {str(getattr(robot, name)): Buffer(text.encode()) for name, text in buffers.items()}
    snapshot = LiveWorkspace(str(robot.folder)).analyse(Asked((str(robot.folder),), Settings()), held)
    return Names(Shown(snapshot, Addresses({}), len), snapshot.indexes)


def test_a_type_is_completed_with_its_import(tmp_path: Path) -> None:
    robot = Robot(tmp_path)
    typed = LISTENER.replace("(String, 'chatter'", "(Boo, 'chatter'")
    position = lsp.Position(8, typed.splitlines()[8].index("Boo") + len("Boo"))

    rows = names(robot, listener=typed).completions(str(robot.listener), position)

    [wanted] = [row for row in rows if row.detail == "std_msgs/msg/Bool"]
    end = lsp.Position(2, len("from std_msgs.msg import String"))
    assert wanted.additional_text_edits == [lsp.TextEdit(lsp.Range(end, end), ", Bool")]


def test_the_nodes_of_a_parameter_file(tmp_path: Path) -> None:
    robot = Robot(tmp_path)
    declared = "        self.declare_parameter('rate', 1.0)\n        self.words"
    robot.talker.write_text(TALKER.replace("        self.words", declared))
    params = robot.folder / "src/robot/config/params.yaml"
    params.parent.mkdir()
    params.write_text("ta\n")

    rows = names(robot).completions(str(params), lsp.Position(0, 2))

    assert [row.label for row in rows] == ["/talker"]
