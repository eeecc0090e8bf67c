"""Programs whose callbacks start more callbacks: what ends by itself is followed, what does not is cut, and said."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.programs import roots
from archlint.render.json import unresolved
from archlint.systems.model import System

CUT = "its program has too much code to follow all of it"

OWN_CLASS = """\
import rclpy
from rclpy.node import Node


class Child(Node):
    def __init__(self):
        super().__init__('child')
        self.create_timer(1.0, self.tick)

    def tick(self):
        Child()


def main():
    rclpy.init()
    rclpy.spin(Child())


if __name__ == '__main__':
    main()
"""

RESTARTED = """\
import rclpy
from rclpy.node import Node
from std_srvs.srv import Trigger


class Manager(Node):
    def __init__(self):
        super().__init__('manager')
        self.create_service(Trigger, 'restart', self.restart)

    def restart(self, request, response):
        rclpy.spin(Manager())
        return response


def main():
    rclpy.init()
    rclpy.spin(Manager())


if __name__ == '__main__':
    main()
"""

EACH_OTHER = """\
import rclpy
from rclpy.node import Node


class Ping(Node):
    def __init__(self):
        super().__init__('ping')
        self.create_timer(1.0, self.tick)

    def tick(self):
        Pong()


class Pong(Node):
    def __init__(self):
        super().__init__('pong')
        self.create_timer(1.0, self.tick)

    def tick(self):
        Ping()


def main():
    rclpy.init()
    rclpy.spin(Ping())


if __name__ == '__main__':
    main()
"""

THREADS = """\
import threading

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Worker:
    def __init__(self, node):
        self.node = node

    def work(self):
        self.node.create_publisher(String, 'work', 10)
        threading.Thread(target=Worker(self.node).work).start()


def main():
    rclpy.init()
    node = Node('boss')
    threading.Thread(target=Worker(node).work).start()
    rclpy.spin(node)


if __name__ == '__main__':
    main()
"""

FLEET = """\
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    def __init__(self, number):
        super().__init__(f'robot{number}')
        self.create_subscription(String, f'order{number}', self.on_order, 10)
        self.timer = self.create_timer(1.0, self.tick)

    def tick(self):
        self.timer.cancel()
        self.timer = self.create_timer(2.0, self.tick)

    def on_order(self, order):
        self.create_subscription(String, 'more', self.on_order, 10)


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    for number in range(40):
        executor.add_node(Robot(number))
    executor.spin()


if __name__ == '__main__':
    main()
"""


def system_of(folder: Path, source: str) -> System:
    (folder / "node.py").write_text(source)
    return pipeline.graph(pipeline.Request((str(folder),), Settings(), cached=False, jobs=1))


@pytest.fixture
def ran(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the callbacks that ran."""
    names: list[str] = []
    call = roots.enter_root

    def noted(run, module):
        names.append(run.context.name)
        call(run, module)

    monkeypatch.setattr(roots, "enter_root", noted)
    return names


@pytest.mark.parametrize(
    ("source", "names"),
    [
        (OWN_CLASS, ["/child"]),
        (RESTARTED, ["/manager"]),
        (EACH_OTHER, ["/ping", "/pong"]),
        (THREADS, ["/boss"]),
    ],
)
def test_a_callback_that_starts_itself_again_is_cut_and_the_graph_says_so(
    tmp_path: Path, ran: list[str], source: str, names: list[str]
):
    system = system_of(tmp_path, source)

    assert [node.name for node in system.nodes] == names
    assert {row["reason"] for row in unresolved(system)} == {CUT}
    assert len(ran) < 100


def test_a_fleet_made_in_a_loop_and_timers_that_set_themselves_again_are_followed_to_their_end(tmp_path: Path):
    system = system_of(tmp_path, FLEET)

    assert len(system.nodes) == 40
    assert unresolved(system) == []


def test_a_program_with_more_callbacks_than_are_followed_says_so(
    tmp_path: Path, ran: list[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(roots, "ROOTS", 20)

    system = system_of(tmp_path, FLEET)

    assert {row["reason"] for row in unresolved(system)} == {CUT}
    assert ran.count("Robot.on_order") + ran.count("Robot.tick") == 20


def test_the_statements_of_all_callbacks_together_are_bounded(
    tmp_path: Path, ran: list[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr("archlint.interpreter.machine.PROGRAM_STEPS", 10)
    monkeypatch.setattr(roots, "EXTRA_STEPS", 10)
    source = FLEET.replace("self.timer.cancel()", "\n        ".join(["self.timer.cancel()"] * 30))

    system = system_of(tmp_path, source)

    assert {row["reason"] for row in unresolved(system)} == {CUT}
    assert ran.count("Robot.tick") == 2  # one in each of the two programs that the file comes to: class and main
