"""EXE015: programs that shut rclpy down after Ctrl-C has done so."""

from __future__ import annotations

import pytest

from checks.judging import Judge
from robot_package import manifest

PROGRAM = """
    import sys
    import threading

    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.node import Node

    def main():
        rclpy.init()
        node = Node('robot')
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        {lines}

    if __name__ == '__main__':
        main()
"""
JAZZY = 'distro = "jazzy"\n'


def program(*lines: str) -> str:
    return PROGRAM.replace("{lines}", "\n        ".join(lines))


SPIN = ("try:", "    rclpy.spin(node)")
CAUGHT = (*SPIN, "except KeyboardInterrupt:", "    pass")


@pytest.mark.parametrize(
    "lines",
    [
        (*CAUGHT, "finally:", "    node.destroy_node()", "    rclpy.shutdown()  # here"),
        (*SPIN, "finally:", "    rclpy.shutdown()  # here"),
        (*CAUGHT, "node.destroy_node()", "rclpy.shutdown()  # here"),
        (*CAUGHT, "if node is not None:", "    node.destroy_node()", "rclpy.shutdown()  # here"),
        (*SPIN, "except (KeyboardInterrupt, ValueError):", "    rclpy.shutdown()  # here", "    sys.exit(0)"),
        (*SPIN, "except:", "    print('over')", "rclpy.shutdown()  # here"),
        ("try:", "    while rclpy.ok():", "        executor.spin_once()", *CAUGHT[2:], "rclpy.shutdown()  # here"),
        (*CAUGHT, "if rclpy.ok():", "    node.commands.publish(Twist())", "rclpy.shutdown()  # here"),
        (*CAUGHT, "node.stop_motors()", "rclpy.shutdown()  # here"),
        (
            "def rest():",
            "    print('rests')",
            "def stop():",
            "    rest()",
            *CAUGHT,
            "stop()",
            "rclpy.shutdown()  # here",
        ),
        ("class Arm(Node):", "    pass", *CAUGHT, "Arm.destroy_node(node)", "rclpy.shutdown()  # here"),
        ("if True:", *(f"    {line}" for line in CAUGHT), "    finally:", "        rclpy.shutdown()  # here"),
    ],
)
def test_a_shutdown_that_ctrl_c_comes_to(judge: Judge, lines: tuple[str, ...]):
    """Each of these ends with ``rcl_shutdown already called`` under rclpy of jazzy."""
    (finding,) = judge("EXE015", program(*lines), config=JAZZY)
    assert finding.help == "write rclpy.try_shutdown()"


@pytest.mark.parametrize(
    "lines",
    [
        ("rclpy.spin(node)", "rclpy.shutdown()"),
        (*CAUGHT, "finally:", "    rclpy.try_shutdown()"),
        (*CAUGHT, "finally:", "    if rclpy.ok():", "        rclpy.shutdown()"),
        (*CAUGHT, "try:", "    rclpy.shutdown()", "except Exception:", "    pass"),
        (*SPIN, "except ValueError:", "    pass", "rclpy.shutdown()"),
        (*SPIN, "except KeyboardInterrupt:", "    sys.exit(0)", "rclpy.shutdown()"),
        (*SPIN, "except KeyboardInterrupt:", "    return", "rclpy.shutdown()"),
        (*SPIN, "    rclpy.shutdown()", "except KeyboardInterrupt:", "    pass"),
        ("try:", "    node.get_name()", "finally:", "    rclpy.shutdown()"),
        (
            "def work():",
            *(f"    {line}" for line in SPIN),
            "    finally:",
            "        rclpy.shutdown()",
            "threading.Thread(target=work).start()",
        ),
        (*CAUGHT, "rclpy.init()", "rclpy.shutdown()"),
        # Another line fails before: the publisher's context is gone.
        (*CAUGHT, "finally:", "    node.commands.publish(Twist())", "    rclpy.shutdown()"),
        ("def stop():", "    node.commands.publish(Twist())", *CAUGHT, "stop()", "rclpy.shutdown()"),
        (
            "def drive(speed):",
            "    node.commands.publish(speed)",
            "def stop():",
            "    drive(0)",
            *CAUGHT,
            "stop()",
            "rclpy.shutdown()",
        ),
        # A method without the object that it is for.
        ("class Arm(Node):", "    pass", *CAUGHT, "Arm.destroy_node()", "rclpy.shutdown()"),
    ],
)
def test_a_shutdown_that_is_the_first_or_no_error(judge: Judge, lines: tuple[str, ...]):
    judge("EXE015", program(*lines), config=JAZZY)


SHUT = (*CAUGHT, "finally:", "    rclpy.shutdown()")


@pytest.mark.parametrize(
    "own",
    [
        "signal.signal(signal.SIGINT, signal.default_int_handler); rclpy.init()",
        "rclpy.init(signal_handler_options=SignalHandlerOptions.NO)",
    ],
)
def test_a_program_that_has_its_own_way_with_signals(judge: Judge, own: str):
    judge("EXE015", program(*SHUT).replace("rclpy.init()", own, 1), config=JAZZY)


def test_a_distribution_in_which_nothing_happens(judge: Judge):
    judge("EXE015", program(*SHUT), config='distro = "kilted"\n')


@pytest.mark.parametrize(
    ("cmake", "mark"),
    [
        ("cmake_minimum_required(VERSION 3.8)", "  # here"),
        ("cmake_minimum_required(VERSION 3.5)", ""),  # from the template of Foxy, whose Ctrl-C leaves rclpy as it is
    ],
)
def test_a_workspace_that_names_no_distribution(judge: Judge, cmake: str, mark: str):
    (judge.folder / "package.xml").write_text(manifest(build_type="ament_cmake"), encoding="utf-8")
    (judge.folder / "CMakeLists.txt").write_text(f"{cmake}\nproject(robot)\n", encoding="utf-8")
    for finding in judge("EXE015", program(*SHUT[:-1], SHUT[-1] + mark)):
        assert finding.message.startswith("after Ctrl-C this raises RCLError on Humble and Jazzy:")


@pytest.mark.parametrize(
    ("text", "mark"), [("For ROS 2 Humble.", "  # here"), ("For Jazzy and Kilted.", ""), ("For Foxy.", "")]
)
def test_what_a_readme_says(judge: Judge, text: str, mark: str):
    (judge.folder / "README.md").write_text(text, encoding="utf-8")
    judge("EXE015", program(*SHUT[:-1], SHUT[-1] + mark))


def test_all_programs_are_one_finding(judge: Judge):
    shut = program(*SHUT[:-1], SHUT[-1])
    (finding,) = judge("EXE015", program(*SHUT[:-1], SHUT[-1] + "  # here"), shut, shut, config=JAZZY)
    assert finding.message.endswith("; 2 more programs do the same")
    assert [related.place.file for related in finding.related] == ["node1.py", "node2.py"]


ENDLESS = """
    import rclpy
    from rclpy.node import Node

    FOR_EVER = {for_ever}

    class Player(Node):
        def __init__(self):
            super().__init__('player')
            {starts}

        def play(self):
            while True:
                self.step()
                if not FOR_EVER:
                    break

        def step(self):
            pass

    def main():
        rclpy.init()
        {before}
        try:
            {inside}
            rclpy.spin(node)
        finally:
            rclpy.shutdown(){here}

    main()
"""


@pytest.mark.parametrize(
    ("for_ever", "starts", "before", "inside", "here"),
    [
        (True, "self.play()", "node = Player()", "pass", ""),
        (True, "self.play()", "pass", "node = Player()", "  # here"),  # Ctrl-C comes in the try
        (False, "self.play()", "node = Player()", "pass", "  # here"),
        (True, "self.step()", "node = Player()", "pass", "  # here"),
    ],
)
def test_a_constructor_that_never_returns(
    judge: Judge, for_ever: bool, starts: str, before: str, inside: str, here: str
):
    text = ENDLESS.format(for_ever=for_ever, starts=starts, before=before, inside=inside, here=here)
    judge("EXE015", text, config=JAZZY)
