"""What is followed of programs that hold more than names: tables, in comprehensions."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint import session
from archlint.config import Settings
from archlint.program.run import Run

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

    system = session.graph(session.Request((str(tmp_path),), Settings(), cached=False))

    assert sorted(system.topics) == ["/after", "/lane1", "/lane2"]
    assert evaluated[0] < 100_000  # of 40,000 points, with some five expressions each
