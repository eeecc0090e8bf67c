"""What a library can ask of the run that calls it, and how a run goes on with what the library answers."""

from __future__ import annotations

import pytest

from archlint.interpreter.call_site import CallSite
from archlint.interpreter.heap import Store
from archlint.interpreter.interpreter import Interpreter
from archlint.interpreter.library import Library
from archlint.interpreter.machine import Phase
from archlint.interpreter.modules import ModuleIndex
from archlint.interpreter.values import External, Known, Unknown, Value
from interpreting import OUTSIDE, interpret, interpret_in


class Robot(Interpreter):
    """The interpreter, in surroundings that are known."""

    def __init__(self, index: ModuleIndex) -> None:
        super().__init__(index, Store())
        self.library = Surroundings(self)


class Surroundings(Library):
    """Notes which loops go round each call of ``outside.here()``, and knows a variable of the environment."""

    def __init__(self, run: Interpreter) -> None:
        self.run = run
        self.loops: list[list[int]] = []
        """The lines of the loops around each call."""

    def call_function(self, function: External, site: CallSite) -> Value:
        if function.path == "outside.here":
            self.loops.append([place.line for place in self.run.enclosing_loops()])
        return Unknown("from outside")

    def environment(self, name: object) -> Value | None:
        return Known("humble") if name == "ROS_DISTRO" else None


@pytest.mark.parametrize(
    ("code", "loops"),
    [
        ("outside.here()", [[]]),
        ("for _ in outside.items():\n    outside.here()", [[2]]),
        ("while outside.more():\n    for _ in outside.items():\n        outside.here()", [[2, 3]]),
        ("while True:\n    outside.here()\n    break", [[]]),
        ("while True:\n    if outside.here():\n        break", [[2]]),
        ("for _ in (1, 2):\n    outside.here()", [[2], [2]]),
        ("def f():\n    while outside.more():\n        outside.here()\nfor _ in outside.items():\n    f()", [[5, 3]]),
    ],
)
def test_the_loops_around_a_call(code: str, loops: list[list[int]]):
    library = interpret_in(Robot, OUTSIDE + code).run.library
    assert isinstance(library, Surroundings)
    assert library.loops == loops


def test_the_environment():
    interpreted = interpret_in(Robot, "import os\ndistro, home = os.environ['ROS_DISTRO'], os.environ['HOME']")
    assert interpreted.constant("distro") == "humble"
    assert interpreted.reason("home") == "the environment variable HOME"


class TestACallback:
    """Code that runs again and again, in a state that others have left."""

    @pytest.fixture(autouse=True)
    def later(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(Interpreter, "phase", Phase.LATER)

    def test_what_it_counts_in_an_attribute_is_not_known(self):
        interpreted = interpret("class Robot:\n    count = 0\nrobot = Robot()\nrobot.count += 1\nit = robot.count")
        assert interpreted.reason("it") == "the value changes at run time"

    def test_a_loop_over_a_number_ends_it(self):
        assert after("items = [1, 2]\n    for i in len(items):\n        pass") == "raises"
        assert after("for i in range(2):\n        pass") == "returns"

    @pytest.mark.parametrize("call", ["drive()", "drive(1, 2)", "drive(speed=1)", "robot.turn()", "robot.turn(1, 2)"])
    def test_a_call_that_python_refuses_ends_it(self, call: str):
        assert after(call) == "raises"

    @pytest.mark.parametrize("call", ["drive(1)", "robot.turn(1)", "robot.turn(to=1)", "other()", "print(1, 2)"])
    def test_a_call_that_python_may_take_does_not(self, call: str):
        assert after(call) == "returns"

    def test_what_may_not_be_reached_does_not(self):
        assert after("if outside.value():\n        outside.stop() or drive()") == "returns"

    def test_an_attribute_that_is_missing_may_be_set_by_then(self):
        interpreted = interpret("class Robot:\n    pass\nit = hasattr(Robot(), 'arm')")
        assert interpreted.reason("it") == "whether it is already set"


ROBOT = """
import outside

def drive(distance):
    pass

class Robot:
    def turn(self, to):
        pass

robot = Robot()
other = outside.value()
"""


def after(line: str) -> str:
    """How a function ends in which a line stands."""
    interpreted = interpret(f"{ROBOT}\ndef callback():\n    {line}\n    return 'returns'\nit = callback()")
    return "returns" if "returns" in interpreted.options("it") else "raises"
