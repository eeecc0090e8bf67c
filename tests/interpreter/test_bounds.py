"""What is followed of programs that hold more than names: tables, in comprehensions."""

from __future__ import annotations

import tracemalloc
from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine import pipeline
from archlint.interpreter.values import ITEMS
from archlint.libraries.run import Run

SOURCE = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

POINTS = [{points}]


class Path(Node):
    def __init__(self):
        super().__init__('path')
        for name in [f'lane{{n}}' for n in (1, 2)]:
            self.create_publisher(String, name, 10)
        moved = []
{moves}
        self.create_publisher(String, 'after', 10)


def main():
    rclpy.init()
    rclpy.spin(Path())


if __name__ == '__main__':
    main()
"""


def test_tables_of_numbers_cost_little_and_hide_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    evaluated, evaluate = [0], Run.evaluate

    def counted(run, expression):
        evaluated[0] += 1
        return evaluate(run, expression)

    monkeypatch.setattr(Run, "evaluate", counted)
    points = ", ".join(f"({n}.5, {n})" for n in range(400))
    moves = "\n".join(f"        moved.append([(x + {n}, y) for x, y in POINTS])" for n in range(100))
    (tmp_path / "node.py").write_text(SOURCE.format(points=points, moves=moves))

    system = pipeline.graph(pipeline.Request((str(tmp_path),), Settings(), cached=False))

    assert sorted(system.topics) == ["/after", "/lane1", "/lane2"]
    assert evaluated[0] < 100_000  # of 40,000 points, with some five expressions each


GROWING = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Grower(Node):
    def __init__(self):
        super().__init__('grower')
        name = 'a'
        {grow}
        self.create_publisher(String, name, 10)
        self.create_publisher(String, 'after', 10)


def main():
    rclpy.init()
    rclpy.spin(Grower())


if __name__ == '__main__':
    main()
"""


@pytest.mark.parametrize(
    "grow",
    [
        "for _ in range(60): name = name + name",
        "for _ in range(60): name = f'{name}{name}'",
        "for _ in range(60): name = '%s%s' % (name, name)",
        "for _ in range(60): name = name.replace('a', 'aa')",
        "for _ in range(60): name = name.join([name, name, name])",
        "name = name.ljust(10 ** 11, 'a')",
        "name = '%99999999999d' % 3",
        "name = f'{3:>99999999999}'",
        "name = 3\n        for _ in range(60): name = name * name",
        "name = 10 ** 64\n        for _ in range(9): name = name ** 64",
    ],
)
def test_a_value_that_grows_without_end_is_not_known_and_costs_no_memory(tmp_path: Path, grow: str):
    (tmp_path / "node.py").write_text(GROWING.replace("{grow}", grow))
    tracemalloc.start()
    try:
        system = pipeline.graph(pipeline.Request((str(tmp_path),), Settings(), cached=False, jobs=1))
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()

    assert [endpoint.name for node in system.nodes for endpoint in node.endpoints] == ["/after", None]
    assert peak < 100_000_000


FILLING = """\
import rclpy
from geometry_msgs.msg import Point
from rclpy.node import Node
from std_msgs.msg import String


class Reach(Node):
    def __init__(self):
        super().__init__('reach')
        limit = self.declare_parameter('limit', 3).value
        near, far = [], []
        for x in range(12):
            for y in range(12):
                for z in range(12):
                    (near if self.measured() < limit else far).append(Point(x=float(x), z=float(z)))
                    if self.measured() < limit:
                        near.append(Point(x=float(x), y=float(y)))
                    else:
                        far.append(Point(x=float(x), y=float(y)))
        self.create_publisher(String, f'after{len(near) and ""}', 10)


def main():
    rclpy.init()
    rclpy.spin(Reach())


if __name__ == '__main__':
    main()
"""


def test_lists_that_nested_loops_fill_are_joined_cheaply(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    looked_at, join_items = [0], ITEMS.join

    def counted(found):
        looked_at[0] += sum(len(items.values) for items in found)
        return join_items(found)

    monkeypatch.setattr(ITEMS, "join", counted)
    (tmp_path / "node.py").write_text(FILLING)

    system = pipeline.graph(pipeline.Request((str(tmp_path),), Settings(), cached=False))

    assert [node.name for node in system.nodes] == ["/reach"]
    assert looked_at[0] < 2_000_000  # 1,728 rounds with two lists; 512 joins of up to twice 512 items each


def test_joining_large_lists_counts_as_work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    branches = "".join(
        f"        if self.flag({n}):\n            moved[{n}] = n\n        else:\n            moved.append({n})\n"
        for n in range(40)
    )
    text = SOURCE.format(points="", moves=f"        moved = list(range(500))\n        n = self.get_clock()\n{branches}")
    (tmp_path / "path.py").write_text(text)
    monkeypatch.chdir(tmp_path)

    def topics() -> list[str | None]:
        made = pipeline.graph(pipeline.Request((".",), Settings(), cached=False, jobs=1))
        return [endpoint.name for endpoint in made.nodes[0].endpoints]

    assert topics() == ["/after", "/lane1", "/lane2"]
    monkeypatch.setattr("archlint.interpreter.machine.WORK_OF_A_STEP", 0.1)
    assert topics() == ["/lane1", "/lane2"]


GRID = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Planner(Node):
    def __init__(self):
        super().__init__('planner')
        self.wide = self.declare_parameter('wide').value
        self.nearest((0, 0))
        self.create_publisher(String, 'after', 10)

    def nearest(self, cell):
        x, y = cell
        for r in range(1, 30):
            for dy in range(-r, r + 1):
                for dx in range(-r, r + 1):
                    if self.wide[x + dx, y + dy]:
                        return (x + dx, y + dy)
        return None


def main():
    rclpy.init()
    rclpy.spin(Planner())


if __name__ == '__main__':
    main()
"""


def test_a_search_that_may_return_from_each_round_of_its_loops_ends_soon(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    evaluated, evaluate = [0], Run.evaluate

    def counted(run, expression):
        evaluated[0] += 1
        return evaluate(run, expression)

    monkeypatch.setattr(Run, "evaluate", counted)
    (tmp_path / "node.py").write_text(GRID)

    system = pipeline.graph(pipeline.Request((str(tmp_path),), Settings(), cached=False))

    assert sorted(system.topics) == ["/after"]
    assert evaluated[0] < 20_000  # of 37,000 rounds, with some ten expressions each
