"""API002: methods of a node that code looks into instead of calling them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.node import Node

    class Battery(Node):
        def __init__(self):
            super().__init__('battery')
            self.create_timer(1.0, self.check)

        def check(self):
            {line}  # here

    def main():
        rclpy.init()
        rclpy.spin(Battery())

    if __name__ == '__main__':
        main()
"""


@pytest.mark.parametrize(
    ("line", "message", "help"),
    [
        (
            "self.get_logger.info('checking')",
            "'get_logger' is a method of a node that is not called, and has no 'info': this line fails with an "
            "AttributeError",
            "write self.get_logger().info",
        ),
        (
            "started = self.get_clock.now()",
            "'get_clock' is a method of a node that is not called, and has no 'now': this line fails with an "
            "AttributeError",
            "write self.get_clock().now",
        ),
        (
            "limit = self.get_parameter.value",
            "'get_parameter' is a method of a node that is not called, and has no 'value': this line fails with an "
            "AttributeError",
            "write self.get_parameter(…).value",
        ),
    ],
)
def test_a_method_that_is_looked_into(judge: Judge, line: str, message: str, help: str):
    (finding,) = judge("API002", NODE.replace("{line}", line))
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "line",
    [
        "self.get_logger().info('checking')",
        "print(self.get_logger.__doc__)",
        "log = self.get_logger",
        "self.publishers.close()",
        "self.executor.wake()",
    ],
)
def test_what_a_method_has_and_what_is_no_method(judge: Judge, line: str):
    judge("API002", NODE.replace("{line}  # here", line))


def test_all_of_a_file_are_one_finding(judge: Judge):
    twice = "self.get_logger.info('checking')  # here\n            self.get_logger.warning('empty')"
    (finding,) = judge("API002", NODE.replace("{line}  # here", twice))
    assert finding.message.endswith("; another call in this file does the same")


def test_a_class_that_has_its_own_under_the_name(judge: Judge):
    own = "self.get_logger = Logger()\n            self.get_logger.info('checking')"
    judge("API002", NODE.replace("{line}  # here", own))


def test_a_class_derived_from_it_may_have_its_own(judge: Judge):
    derived = """
    class Loud(Battery):
        @property
        def get_logger(self):
            return Logger()
    """
    judge("API002", NODE.replace("{line}  # here", "self.get_logger.info('checking')") + derived)


def test_a_class_whose_base_is_not_known(judge: Judge):
    source = NODE.replace("from rclpy.node import Node", "from robots import Node")
    judge("API002", source.replace("{line}  # here", "self.get_logger.info('checking')"))


def test_a_try_that_expects_it(judge: Judge):
    tried = """try:
                self.get_logger.info('checking')
            except AttributeError:
                pass"""
    judge("API002", NODE.replace("{line}  # here", tried))


@pytest.mark.parametrize("other", ["from tree import Node", "from tree import *", "from rclpy.lifecycle import Node"])
def test_the_last_of_two_classes_of_one_name_is_the_base(judge: Judge, other: str):
    source = NODE.replace("import rclpy\n", f"{other}\n    import rclpy\n", 1)
    judge("API002", source.replace("{line}", "self.get_logger.info('checking')"))


@pytest.mark.parametrize(
    "imports",
    ["from rclpy.node import Node\n    from tree import Node", "from rclpy.node import Node\n    from tree import *"],
)
def test_a_class_that_replaces_that_of_rclpy(judge: Judge, imports: str):
    source = NODE.replace("from rclpy.node import Node", imports, 1)
    judge("API002", source.replace("{line}  # here", "self.get_logger.info('checking')"))


FUNCTION = """
    import rclpy
    from rclpy.node import Node

    class Helper:
        def __init__(self, node):
            self.node = node

        def help(self):
            {line}  # here

    def main():
        rclpy.init()
        node = Node('battery')
        try:
            rclpy.spin(node)
        except ValueError:
            {line}  # here
"""


@pytest.mark.parametrize(
    ("inside", "outside", "message", "help"),
    [
        (
            "pass",
            "node.get_logger.info('stopped')",
            "'get_logger' is a method of a node that is not called, and has no 'info': this line fails with an "
            "AttributeError",
            "write node.get_logger().info",
        ),
        (
            "self.node.get_logger.info('stopped')",
            "pass",
            "'get_logger' is a method of a node that is not called, and has no 'info': this line fails with an "
            "AttributeError",
            "write self.node.get_logger().info",
        ),
        (
            "return self.node.get_clock().now.to_msg()",
            "pass",
            "'now' is a method of a clock that is not called, and has no 'to_msg': this line fails with an "
            "AttributeError",
            "write self.node.get_clock().now().to_msg",
        ),
        (
            "pass",
            "print(node.get_clock.now())",
            "'get_clock' is a method of a node that is not called, and has no 'now': this line fails with an "
            "AttributeError",
            "write node.get_clock().now",
        ),
    ],
)
def test_a_method_of_a_node_in_a_variable(judge: Judge, inside: str, outside: str, message: str, help: str):
    source = FUNCTION.replace("{line}  # here", inside + ("  # here" if inside != "pass" else ""), 1)
    source = source.replace("{line}  # here", outside + ("  # here" if outside != "pass" else ""))
    (finding,) = judge("API002", source)
    assert (finding.message, finding.help) == (message, help)


@pytest.mark.parametrize(
    "line",
    [
        "node.get_logger().info('stopped')",
        "print(node.get_clock().now().to_msg(), node.get_clock().now().nanoseconds)",
        "now = node.get_clock().now",
        "print(now.to_msg())",
        "print(node.get_logger.__name__)",
    ],
)
def test_methods_in_variables_that_are_called(judge: Judge, line: str):
    judge("API002", FUNCTION.replace("{line}  # here", "pass", 1).replace("{line}  # here", line))


def test_an_object_that_is_given_a_logger_under_the_name(judge: Judge):
    source = FUNCTION.replace("{line}  # here", "self.node.get_logger.info('stopped')", 1)
    own = """
    class Plain:
        def __init__(self, logger):
            self.get_logger = logger
    """
    judge("API002", source.replace("{line}  # here", "pass") + own)
