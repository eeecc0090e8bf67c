"""API002: what a library that is given the node may have put there."""

from __future__ import annotations

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from robot_package import write_robot

NODE = """\
import rclpy
from rclpy.node import Node
{imports}

class Talker({base}):
    def __init__(self):
        super().__init__('talker')
        self.speed = 0
        {given}
        self.create_timer(1.0, self.tick)
        self.create_timer(1.0, self.stop)

    def tick(self):
        print(self.state.name)
        self.start()

def main():
    rclpy.init()
    rclpy.spin(Talker())
"""


@pytest.fixture
def told(tmp_path, monkeypatch):
    """The lines of the node that API002 or EXE006 tells of."""
    monkeypatch.chdir(tmp_path)

    def run(imports: str, given: str, base: str = "Node", **files: str) -> list[str]:
        code = NODE.format(imports=imports, given=given, base=base)
        write_robot(tmp_path, **{"robot/talker.py": code, "robot/__init__.py": "", **files})
        settings = 'select = ["API002", "EXE006"]'
        (tmp_path / "archlint.toml").write_text(settings, encoding="utf-8")
        findings = check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings
        return sorted({code.splitlines()[row.place.line - 1].strip() for row in findings})

    return run


ALL = ["print(self.state.name)", "self.create_timer(1.0, self.stop)", "self.start()"]


@pytest.mark.parametrize(
    ("imports", "given"),
    [
        ("from transitions import Machine", "self.machine = Machine(model=self, states=['a'])"),
        ("from transitions import Machine", "Machine(self, states=['a'])"),
        ("import transitions.extensions as machines", "machines.HierarchicalMachine(self)"),
        ("from transitions import Machine", "machine = Machine()\n        machine.add_model(self)"),
        ("from transitions import Machine", "self.machine = Machine()\n        self.machine.add_model(self)"),
    ],
)
def test_a_node_that_is_the_model_of_a_machine(told, imports: str, given: str):
    assert told(imports, given) == []


def test_a_helper_that_hands_the_node_on(told):
    helper = "from transitions import Machine\n\ndef attach(states, model):\n    Machine(model, states=list(states))\n"
    imports = "from robot.helper import attach"
    assert told(imports, "attach(['a'], self)", **{"robot/helper.py": helper}) == []
    assert told(imports, "attach(['a'], model=self)", **{"robot/helper.py": helper}) == []
    assert told(imports, "attach(self, None)", **{"robot/helper.py": helper}) == ALL


def test_a_base_class_that_hands_itself_on(told):
    model = "from transitions import Machine\n\nclass Model:\n    def begin(self):\n        Machine(model=self)\n"
    files = {"robot/model.py": model}
    assert told("from robot.model import Model", "self.begin()", "Model, Node", **files) == []
    files = {"robot/model.py": model.replace("model=self", "states=[]")}
    assert told("from robot.model import Model", "self.begin()", "Model, Node", **files) == ALL


@pytest.mark.parametrize(
    ("imports", "given"),
    [
        ("", "pass"),
        (
            "from rclpy.action import ActionClient\nfrom nav2_msgs.action import Spin",
            "ActionClient(self, Spin, 'spin')",
        ),
        ("from tf2_ros import Buffer, TransformListener", "TransformListener(Buffer(), self)"),
        ("import threading", "threading.Thread(target=print, args=(self,))"),
        ("from transitions import Machine", "self.machine = Machine(states=['a'])"),  # which is not given the node
        ("from robot.helper import note", "note(self)"),  # the workspace's own
    ],
)
def test_what_gives_a_node_nothing(told, imports: str, given: str):
    assert told(imports, given, **{"robot/helper.py": "def note(node):\n    print(node)\n"}) == ALL


def test_a_static_method_has_no_object_to_give(told):
    imports, given = "import lengths as np", "self.length([1.0])"
    code = NODE.format(imports=imports, given=given, base="Node")
    plain = "    def length(sides):\n        return np.norm(sides)\n\n"
    static = code.replace("def main():", f"    @staticmethod\n{plain}def main():")
    assert told(imports, given, **{"robot/talker.py": static}) == sorted(ALL)
    assert told(imports, given, **{"robot/talker.py": code.replace("def main():", f"{plain}def main():")}) == []


def test_numpy_only_calculates(told):
    assert told("import numpy as np", "np.array(self)") == sorted(ALL)
