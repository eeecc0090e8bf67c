"""API003: base classes whose constructor never runs, as Node stands before them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.node import Node

    class Machine:
        {level}
        def __init__(self):
            self.automatic = False

        def switch(self):
            self.automatic = not self.automatic

    class Robot({bases}):  {here}
        {constructor}

        def tick(self):
            {line}

    def main():
        rclpy.init()
        rclpy.spin(Robot({arguments}))
"""
INIT = "def __init__(self):\n            super().__init__('robot')\n            self.create_timer(1.0, self.tick)"


def _node(**parts: str) -> str:
    given = {
        "bases": "Node, Machine",
        "constructor": INIT,
        "line": "self.switch()",
        "arguments": "",
        "level": "limit = 3",
    }
    return NODE.format(**{"here": "", **given, **parts})


@pytest.mark.parametrize(
    "parts",
    [
        {},
        {"line": "print(self.automatic)"},
        {"constructor": "", "arguments": "'robot'"},
    ],
)
def test_a_base_behind_the_node(judge: Judge, parts: dict[str, str]):
    (finding,) = judge("API003", _node(here="# here", **parts))
    assert finding.message == (
        "Machine.__init__() never runs: Node stands before it and calls no other constructor, so that a Robot has no "
        "'automatic'"
    )
    assert finding.help == "call Machine.__init__(self) after super().__init__(…)"


@pytest.mark.parametrize(
    "parts",
    [
        {"constructor": INIT + "\n            Machine.__init__(self)"},
        {"constructor": INIT + "\n            super(Node, self).__init__()"},
        {"constructor": INIT + "\n            self.automatic = True"},
        {"level": "automatic = False"},
        {"line": "self.automatic = True; self.switch()"},
        {"line": "self.setup()\n\n        def setup(self):\n            self.automatic = True"},
        {"bases": "Machine"},
        {"level": "def __getattr__(self, name):\n            return 0\n"},
    ],
)
def test_an_attribute_that_is_there_all_the_same(judge: Judge, parts: dict[str, str]):
    judge("API003", _node(**parts))


def test_what_no_method_reads_is_not_missed(judge: Judge):
    judge("API003", _node(line="pass").replace("self.automatic = not self.automatic", "print('switch')"))


def test_a_base_that_nobody_knows(judge: Judge):
    judge(
        "API003",
        _node()
        .replace("class Machine:", "class Machine(Base):")
        .replace("import rclpy", "import rclpy\n    from motors import Base", 1),
    )


def test_a_derived_class_that_calls_it(judge: Judge):
    derived = """
    class Better(Robot):
        def __init__(self):
            super().__init__()
            Machine.__init__(self)
    """
    judge("API003", _node() + derived)
