"""API002: members that an enum of the workspace does not have."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import enum
    from enum import Enum, IntEnum, auto

    import rclpy
    from rclpy.node import Node

    class Mode({base}):
        DRIVE = 1
        STOP = auto()

        def label(self):
            return self.name

    class Robot(Node):
        class State(Enum):
            IDLE = 0
            SORTING = 1

        def __init__(self):
            super().__init__('robot')
            {line}

    def main():
        rclpy.init()
        rclpy.spin(Robot())

    if __name__ == '__main__':
        main()
"""


def source(line: str, base: str = "IntEnum") -> str:
    return NODE.replace("{line}", line).replace("{base}", base)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("self.state = self.State.RED", "enum State has no 'RED': this line fails with an AttributeError"),
        (
            "self.mode = Mode.DRIV",
            "enum Mode has no 'DRIV': this line fails with an AttributeError; did you mean 'DRIVE'?",
        ),
    ],
)
def test_a_member_that_is_not_there(judge: Judge, line: str, message: str):
    (finding,) = judge("API002", source(f"{line}  # here"))
    assert finding.message == message


@pytest.mark.parametrize("base", ["enum.Enum", "enum.Flag", "Enum"])
def test_every_kind_of_enum(judge: Judge, base: str):
    judge("API002", source("self.mode = Mode.PARK  # here", base))


@pytest.mark.parametrize(
    "line",
    [
        "self.mode = Mode.DRIVE.value",
        "self.labels = [Mode.label(mode) for mode in Mode.__members__.values()]",
        "self.state = self.State.IDLE.name",
        "self.mode = Mode.PARK if hasattr(Mode, 'PARK') else Mode.STOP",
        "Mode.first = Mode.DRIVE; print(Mode.first)",
    ],
)
def test_members_that_are_there_or_may_be(judge: Judge, line: str):
    judge("API002", source(line))


@pytest.mark.parametrize("base", ["Base", "str, Enum", "Enum, metaclass=Meta"])
def test_a_class_that_may_have_more(judge: Judge, base: str):
    judge("API002", source("self.mode = Mode.PARK", base))


def test_a_body_that_makes_names(judge: Judge):
    made = "DRIVE = 1\n        locals()['PARK'] = 2"
    judge("API002", source("self.mode = Mode.PARK").replace("DRIVE = 1", made))


def test_a_derived_class_with_its_own_enum(judge: Judge):
    derived = """
    class Sorter(Robot):
        class State(Enum):
            RED = 2
    """
    judge("API002", source("self.state = self.State.RED") + derived)


def test_an_enum_of_another_file(judge: Judge):
    judge(
        "API002",
        source("self.mode = Gear.PARK  # here").replace("import enum\n", "import enum\n    from node1 import Gear\n"),
        "from enum import Enum\n\nclass Gear(Enum):\n    FIRST = 1\n",
    )


def test_a_try_that_expects_it(judge: Judge):
    tried = """try:
                self.mode = Mode.PARK
            except AttributeError:
                self.mode = Mode.STOP"""
    judge("API002", source(tried))


# ----------------------------------------------------------------------------------------------- any other class

CLASSES = """
    from typing import NamedTuple

    import rclpy
    from rclpy.node import Node

    class Part:
        kind = 0

    class Arm(Part):
        length = 3
        width: float

        def __init__(self):
            self.reach = 1

        @classmethod
        def make(cls):
            cls.made = 3
            return cls()

        def count(self):
            type(self).counted = 4

    class Pair(NamedTuple):
        left: int

    class Kind(type):
        pass

    class Odd(metaclass=Kind):
        pass

    class Open(Unknown):
        pass

    class Set:
        pass

    Set.later = 3

    class Robot(Node):
        RATE = 3

        def __init__(self):
            super().__init__('robot')
            self.arm = Arm()
            self.timer = self.create_timer(1.0, self.tick)

        def tick(self):
            {line}

    def main():
        rclpy.init()
        rclpy.spin(Robot())

    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "print(Arm.lenght)",
            "class Arm has no 'lenght': this line fails with an AttributeError; did you mean 'length'?",
            "write length",
        ),
        ("print(Arm.PATH_SPACE)", "class Arm has no 'PATH_SPACE': this line fails with an AttributeError", ""),
        (
            "print(Arm.reach)",
            "class Arm has no 'reach': this line fails with an AttributeError",
            "methods assign self.reach: write the variable that holds an object of the class",
        ),
        ("print(Robot.arm)", "class Robot has no 'arm': this line fails with an AttributeError", ""),
    ],
)
def test_what_a_class_does_not_have(judge: Judge, line: str, message: str, help: str):
    (finding,) = judge("API002", CLASSES.replace("{line}", f"{line}  # here"))
    assert finding.message == message
    assert not help or finding.help == help


@pytest.mark.parametrize(
    "line",
    [
        "print(Arm.length, Arm.kind, Arm.width, Arm.make, Arm.made, Arm.counted, Arm.__name__, Arm.mro())",
        "print(Pair.left, Pair.nothing, Odd.nothing, Open.nothing, Set.later, Robot.RATE, Robot.create_timer)",
        "print(Arm.nothing if hasattr(Arm, 'nothing') else 0)",
        "Arm.nothing = 3; print(Arm.nothing)",
        "Arm = self.arm; print(Arm.reach)",
    ],
)
def test_what_a_class_has_or_may_have(judge: Judge, line: str):
    judge("API002", CLASSES.replace("{line}", line))
