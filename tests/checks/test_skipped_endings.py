"""EXE017: what stands behind a spin that Ctrl-C ends with an exception."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
    import json
    import threading

    import numpy as np
    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node


    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
            self.way = []
            self.timer = self.create_timer(1.0, self.tick)

        def tick(self):
            {tick}

        def stop(self):
            self.publisher.publish(Twist())

        def save(self):
            if self.way:
                self.write('way.json')

        def write(self, name):
            with open(name, 'w') as file:
                json.dump(self.way, file)

        def show(self):
            with open('way.json') as file:
                print(file.read())

        {further}


    def save_way(node):
        np.save('way.npy', node.way)


    def run(node):
        rclpy.spin(node)
        node.save()


    def main():
        rclpy.init()
        node = Driver()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        {lines}


    if __name__ == '__main__':
        main()
"""


def _program(*lines: str, tick: str = "self.way.append(1)", further: str = "") -> str:
    return PROGRAM.replace("{lines}", "\n        ".join(lines)).replace("{tick}", tick).replace("{further}", further)


SPIN = "rclpy.spin(node)"
HERE = "  # here"
END = ("node.destroy_node()", "rclpy.shutdown()")


def _once(*lines: str) -> str:
    """The program without the function ``run()``, which ends like it."""
    before, _, rest = _program(*lines).partition("    def run(node):")
    return before + rest[rest.index("    def main():") :]


@pytest.mark.parametrize(
    "lines",
    [
        (SPIN, f"node.save(){HERE}", *END),
        (SPIN, *END, f"node.save(){HERE}"),
        (SPIN, f"node.stop(){HERE}", *END),
        (SPIN, f"node.publisher.publish(Twist()){HERE}", *END),
        (SPIN, f"save_way(node){HERE}", *END),
        (SPIN, f"np.save('way.npy', node.way){HERE}", *END),
        (SPIN, f"with open('way.json', 'w') as file:{HERE}", "    json.dump(node.way, file)", *END),
        ("executor.spin()", f"node.save(){HERE}", *END),
        ("while rclpy.ok():", "    rclpy.spin_once(node)", f"node.stop(){HERE}", *END),
        ("while rclpy.ok():", "    rclpy.spin_once(node)", "    if node.way: break", "node.stop()", *END),
        ("while rclpy.ok():", "    try: rclpy.spin_once(node)", "    except ValueError: pass", "node.stop()", *END),
        ("while not node.way:", "    rclpy.spin_once(node)", "node.stop()", *END),
        (SPIN, *END),
        (SPIN, "node.show()", *END),
        ("try:", f"    {SPIN}", "finally:", "    node.save()"),
        ("try:", f"    {SPIN}", "    node.save()", "except KeyboardInterrupt:", "    node.save()"),
        ("rclpy.spin_once(node)", "node.save()", *END),
        (SPIN, "return", "node.save()"),
    ],
)
def test_lines_behind_a_spin(judge: Judge, lines: tuple[str, ...]):
    judge("EXE017", _once(*lines))


def test_what_is_said_of_it(judge: Judge):
    (finding,) = judge("EXE017", _once(SPIN, f"node.save(){HERE}"))
    assert finding.message == (
        "save(), which writes a file, is not run after Ctrl-C: the spin on line 48 ends with a KeyboardInterrupt then"
    )
    assert finding.help == "put it in the finally of a try around the spin"
    assert [row.place.line for row in finding.related] == [48, 29]


@pytest.mark.parametrize(
    ("distro", "more"),
    [
        ("foxy", ""),
        ("galactic", ""),
        (
            "humble",
            ", and start with rclpy.init(signal_handler_options=SignalHandlerOptions.NO): rclpy runs on until then",
        ),
    ],
)
def test_what_mends_it_where_the_end_publishes(judge: Judge, distro: str, more: str):
    (judge.folder / "README.md").write_text(f"For ROS 2 {distro.title()}.\n", encoding="utf-8")
    (finding,) = judge("EXE017", _once(SPIN, f"node.stop(){HERE}"))
    assert finding.help == "put it in the finally of a try around the spin" + more


def test_a_method_of_a_node_that_replaces_one_of_rclpy(judge: Judge):
    further = "def destroy_node(self):\n            self.stop()\n            super().destroy_node()"
    source = _program(SPIN, f"node.destroy_node(){HERE}", further=further)
    judge("EXE017", source.replace("    def run(node):\n        rclpy.spin(node)\n        node.save()\n", ""))


def test_a_program_that_ends_itself(judge: Judge):
    """The spin returns once a callback has shut rclpy down."""
    judge("EXE017", _program(SPIN, "node.save()", tick="rclpy.shutdown()"))


def test_a_spin_in_a_thread(judge: Judge):
    judge("EXE017", _program("threading.Thread(target=run, args=(node,)).start()"))
