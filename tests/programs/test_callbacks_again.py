"""Which callbacks run again on what others left in attributes: those that have read one of them and not met it yet."""

from __future__ import annotations

from pathlib import Path
from textwrap import indent

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.programs import left_behind

ROBOT = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Task:
    def __init__(self, mode):
        self.mode = mode
        self.done = False


class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        self.mode = 'idle'
        self.task = Task('idle')
        self.create_subscription(String, 'first', self.first, 10)
        self.create_subscription(String, 'second', self.second, 10)
        self.create_subscription(String, 'third', self.third, 10)

    def first(self, msg):
FIRST

    def second(self, msg):
SECOND

    def third(self, msg):
THIRD


rclpy.init()
rclpy.spin(Robot())
"""

CHECKS_MODE = "if self.mode == 'driving':\n    self.create_publisher(String, 'driving', 10)"
CHECKS_TASK = "if self.task.mode == 'driving':\n    self.create_publisher(String, 'driving', 10)"


class Runs:
    """What becomes of a robot with three callbacks: its publishers, and which callbacks run once more, in each turn."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.folder = folder
        self.again: list[list[str]] = []
        real = left_behind.readers

        def readers(*given: object) -> list[object]:
            chosen = real(*given)  # type: ignore[arg-type]
            self.again.append([pending.callback.name for pending in chosen])
            return list(chosen)

        monkeypatch.chdir(folder)
        monkeypatch.setattr(left_behind, "readers", readers)

    def published(self, first: str, second: str, third: str = "pass") -> list[str | None]:
        text = ROBOT
        for name, body in (("FIRST", first), ("SECOND", second), ("THIRD", third)):
            text = text.replace(name, indent(body, "        "))
        (self.folder / "robot.py").write_text(text, encoding="utf-8")
        system = graph(Request((".",), Settings(), cached=False, jobs=1))
        return [end.name for end in system.endpoints if end.kind == "publisher"]


@pytest.fixture
def runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Runs:
    return Runs(tmp_path, monkeypatch)


def test_who_has_read_what_a_later_one_leaves_runs_again(runs: Runs):
    assert runs.published(CHECKS_MODE, "self.mode = 'driving'") == ["/driving"]
    assert runs.again[0] == ["Robot.first"]


def test_who_comes_later_has_met_it(runs: Runs):
    assert runs.published("self.mode = 'driving'", CHECKS_MODE) == ["/driving"]
    assert not any(runs.again)


def test_the_attribute_of_another_object_is_another_one(runs: Runs):
    """``mode`` of the task changes, that of the node does not."""
    assert runs.published(CHECKS_MODE, "self.task.mode = 'driving'") == []
    assert not any(runs.again)


def test_an_object_that_a_callback_makes_for_itself_is_no_news(runs: Runs):
    assert runs.published(CHECKS_TASK, "task = Task('driving')\ntask.done = True", "print(self.task.done)") == []
    assert not any(runs.again)


def test_an_object_that_others_find_is(runs: Runs):
    """The new task is like the one before: that its mode is another one has to be met."""
    assert runs.published(CHECKS_TASK, "self.task = Task('driving')") == ["/driving"]
    assert "Robot.first" in runs.again[0]


def test_so_is_one_in_a_list(runs: Runs):
    looks = CHECKS_TASK.replace("self.task.mode", "self.tasks[-1].mode")
    first = f"if self.tasks:\n{indent(looks, '    ')}"
    assert runs.published(first, "self.tasks.append(Task('driving'))", "self.tasks = [Task('idle')]") == ["/driving"]


def test_a_callback_meets_its_own_state_again(runs: Runs):
    own = "if self.mode == 'driving':\n    self.create_publisher(String, 'driving', 10)\nself.mode = 'driving'"
    assert runs.published(own, "pass") == ["/driving"]
    assert runs.again[0] == ["Robot.first"]


def test_what_one_way_through_main_leaves_another_has_not_met(runs: Runs):
    """Each spin is in a branch of its own: callbacks of the second do not meet what those of the first have left."""
    text = ROBOT.replace("rclpy.spin(Robot())\n", "")
    main = (
        "robot = Robot()\nif rclpy.ok():\n    rclpy.spin(robot)\nelse:\n"
        "    robot.create_subscription(String, 'fourth', robot.fourth, 10)\n    rclpy.spin(robot)\n"
    )
    fourth = "    def fourth(self, msg):\n" + indent(CHECKS_MODE, "        ") + "\n\n\nrclpy.init()"
    text = text.replace("\nrclpy.init()", fourth) + main
    for name, body in (("FIRST", "self.mode = 'driving'"), ("SECOND", "pass"), ("THIRD", "pass")):
        text = text.replace(name, indent(body, "        "))
    (runs.folder / "robot.py").write_text(text, encoding="utf-8")
    system = graph(Request((".",), Settings(), cached=False, jobs=1))
    assert [end.name for end in system.endpoints if end.kind == "publisher"] == ["/driving"]


def test_so_does_who_has_imported_the_module_itself(runs: Runs):
    (runs.folder / "settings.py").write_text("mode = 'idle'\n", encoding="utf-8")
    first = f"import settings\n{CHECKS_MODE.replace('self.mode', 'settings.mode')}"
    assert runs.published(first, "import settings\nsettings.mode = 'driving'") == ["/driving"]
    assert runs.again[0] == ["Robot.first"]


def test_an_object_that_a_callback_has_replaced_may_be_changed_by_another(runs: Runs):
    assert runs.published(f"{CHECKS_TASK}\nself.task = Task('idle')", "self.task.mode = 'driving'") == ["/driving"]


def test_who_has_put_something_else_there_first_has_read_nothing_of_others(runs: Runs):
    assert runs.published(f"self.mode = 'parked'\n{CHECKS_MODE}", "self.mode = 'driving'") == []
    assert not any(runs.again)


def test_who_does_so_on_one_way_only_has(runs: Runs):
    first = f"if msg.data:\n    self.mode = 'parked'\n{CHECKS_MODE}"
    assert runs.published(first, "self.mode = 'driving'") == ["/driving"]
    assert runs.again[0] == ["Robot.first"]


def test_who_does_not_ask_what_leads_to_a_new_object_does_not_find_it(runs: Runs):
    """The task that the first callback asks is its own."""
    first = f"task = Task('idle')\n{CHECKS_TASK.replace('self.task', 'task')}"
    assert runs.published(first, "self.task = Task('driving')") == []
    assert not any(runs.again)


def test_an_object_that_a_callback_puts_in_place_before_it_asks_it_is_no_news_to_itself(runs: Runs):
    assert runs.published(f"self.task = Task('idle')\nself.task.done = True\n{CHECKS_TASK}", "pass") == []
    assert not any(runs.again)


def test_who_waits_for_others_meets_the_module_that_they_have_imported(runs: Runs):
    """The spin inside of the first callback has the second import the module."""
    (runs.folder / "settings.py").write_text("mode = 'idle'\n", encoding="utf-8")
    first = f"import settings\n{CHECKS_MODE.replace('self.mode', 'settings.mode')}"
    first = f"self.create_subscription(String, 'inner', self.second, 10)\nrclpy.spin_once(self)\n{first}"
    assert runs.published(first, "import settings", "import settings\nsettings.mode = 'driving'") == ["/driving"]
