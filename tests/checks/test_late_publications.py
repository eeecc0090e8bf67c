"""EXE016: messages that a program publishes once rclpy is shut down."""

from __future__ import annotations

import pytest

from checks.judging import Judge

PROGRAM = """
    import sys
    import threading

    import rclpy
    from geometry_msgs.msg import Twist
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node

    class Driver(Node):
        def __init__(self):
            super().__init__('driver')
            self.publisher = self.create_publisher(Twist, 'cmd_vel', 10)
            self.link = self.connect()
            self.moving = False

        def stop(self):
            self.publisher.publish(Twist())

        def stop_if_moving(self):
            if self.moving:
                self.publisher.publish(Twist())

        def try_to_stop(self):
            try:
                self.publisher.publish(Twist())
            except Exception:
                pass

        def note(self):
            self.get_logger().info('over')

        def tell(self):
            self.link.publish('over')

    def main():
        rclpy.init()
        node = Driver()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        {lines}

    if __name__ == '__main__':
        main()
"""


def program(*lines: str) -> str:
    return PROGRAM.replace("{lines}", "\n        ".join(lines))


SPIN = ("try:", "    rclpy.spin(node)")
CAUGHT = (*SPIN, "except KeyboardInterrupt:", "    pass")


@pytest.mark.parametrize(
    "lines",
    [
        (*SPIN, "except KeyboardInterrupt:", "    node.stop()  # here"),
        (*SPIN, "except KeyboardInterrupt:", "    node.note()", "    node.publisher.publish(Twist())  # here"),
        (*SPIN, "finally:", "    node.stop()  # here", "    rclpy.shutdown()"),
        (*CAUGHT, "node.stop()  # here", "rclpy.try_shutdown()"),
        ("try:", "    executor.spin()", *CAUGHT[2:], "node.stop()  # here"),
        ("try:", "    rclpy.spin(node)", "except (KeyboardInterrupt, ValueError):", "    node.stop()  # here"),
    ],
)
def test_a_message_after_ctrl_c(judge: Judge, lines: tuple[str, ...]):
    """Each of these raises RCLError under rclpy of jazzy."""
    (finding,) = judge("EXE016", program(*lines))
    assert finding.message.startswith("after Ctrl-C ")
    assert finding.message.endswith(
        "the message is not sent: rclpy's own handler of the signal has shut it down before"
    )
    assert "SignalHandlerOptions.NO" in (finding.help or "")


@pytest.mark.parametrize("timer", ["self.create_timer(1.0, self.note)", "pass"])
def test_a_node_that_nothing_wakes(judge: Judge, timer: str):
    """What ends the wait of the executor is not the signal, once rclpy does not handle it."""
    code = program(*SPIN, "finally:", "    node.stop()  # here").replace("self.moving = False", timer)
    (told,) = judge("EXE016", code)
    assert ("; and give the node a timer, without which" in told.help) is (timer == "pass")


@pytest.mark.parametrize("distro", ["Foxy", "Galactic"])
def test_distributions_whose_rclpy_runs_on_after_ctrl_c(judge: Judge, distro: str):
    """Their handler of the signal wakes the executor and shuts nothing down."""
    (judge.folder / "README.md").write_text(f"For ROS 2 {distro}.\n", encoding="utf-8")
    judge("EXE016", program(*SPIN, "finally:", "    node.stop()", "    rclpy.shutdown()"))
    judge("EXE016", program("rclpy.spin_once(node)", "rclpy.shutdown()", "node.stop()  # here"))


def test_a_message_after_the_shutdown(judge: Judge):
    (finding,) = judge("EXE016", program("rclpy.spin_once(node)", "rclpy.shutdown()", "node.stop()  # here"))
    told = "here stop() publishes, which raises an error, and the message is not sent: rclpy is shut down further up"
    assert finding.message == told
    assert [place.message for place in finding.related] == ["stop() publishes here"]


@pytest.mark.parametrize(
    "lines",
    [
        (*SPIN, "except KeyboardInterrupt:", "    node.note()"),
        (*SPIN, "except KeyboardInterrupt:", "    node.tell()"),
        (*SPIN, "except KeyboardInterrupt:", "    node.stop_if_moving()"),
        (*SPIN, "except KeyboardInterrupt:", "    node.try_to_stop()"),
        (*SPIN, "except KeyboardInterrupt:", "    if rclpy.ok():", "        node.stop()"),
        (
            *SPIN,
            "except KeyboardInterrupt:",
            "    try:",
            "        node.stop()",
            "    except Exception:",
            "        pass",
        ),
        (*SPIN, "except ValueError:", "    node.stop()"),
        (*SPIN, "except KeyboardInterrupt:", "    sys.exit(0)", "node.stop()"),
        (*CAUGHT, "rclpy.init()", "node.stop()"),
        ("rclpy.spin(node)", "node.stop()"),
        ("try:", "    rclpy.spin_once(node)", *CAUGHT[2:], "node.stop()"),
        ("node.stop()", "rclpy.shutdown()"),
        (
            "def work():",
            *(f"    {line}" for line in SPIN),
            "    finally:",
            "        node.stop()",
            "threading.Thread(target=work).start()",
        ),
    ],
)
def test_a_message_that_may_be_sent_or_none(judge: Judge, lines: tuple[str, ...]):
    judge("EXE016", program(*lines))


def test_a_program_that_has_its_own_way_with_signals(judge: Judge):
    own = "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)"
    source = program(*SPIN, "except KeyboardInterrupt:", "    node.stop()")
    judge("EXE016", source.replace("rclpy.init()", own))


@pytest.mark.parametrize(("test", "here"), [("True", ""), ("rclpy.ok()", "  # here")])
def test_nothing_comes_behind_a_constructor_that_never_returns(judge: Judge, test: str, here: str):
    text = program(*SPIN, "finally:", f"    node.publisher.publish(Twist()){here}")
    judge("EXE016", text.replace("self.moving = False", f"while {test}:\n                self.note()"))
