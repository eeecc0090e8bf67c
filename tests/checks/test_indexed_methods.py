"""API002: methods of which code takes an item instead of calling them."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.node import Node

    class Ferry(Node):
        def __init__(self):
            super().__init__('ferry')
            self.piers = [1.0, 2.0]
            self.create_timer(1.0, self.sail)
            {made}

        def sail(self):
            {line}  # here

        def sail_to(self, pier):
            self.get_logger().info(f'{pier}')

    def main():
        rclpy.init()
        rclpy.spin(Ferry())

    if __name__ == '__main__':
        main()
"""


def ferry(line: str, made: str = "pass") -> str:
    return NODE.replace("{line}", line).replace("{made}", made)


@pytest.mark.parametrize(
    ("line", "method", "defined"),
    [
        ("self.sail_to[self.piers[0]]", "sail_to", [14]),
        ("self.sail_to(self.sail_to[0])", "sail_to", [14]),
        ("rate = self.get_parameter['rate']", "get_parameter", []),
        ("self.declare_parameter['rate', 1.0]", "declare_parameter", []),
    ],
)
def test_a_method_of_which_an_item_is_taken(judge: Judge, line: str, method: str, defined: list[int]):
    (finding,) = judge("API002", ferry(line))
    assert finding.message == (
        f"'{method}' is a method that is not called, and has no items: this line fails with a TypeError"
    )
    assert finding.help == f"write self.{method}(…)"
    assert [related.place.line for related in finding.related] == defined


@pytest.mark.parametrize(
    ("line", "made"),
    [
        ("self.sail_to(self.piers[0])", "pass"),
        ("self.piers[0]", "pass"),
        ("self.sail_to[0]", "self.sail_to = [self.sail]"),
        ("self.get_parameter['rate']", "self.get_parameter = {'rate': 1.0}"),
        ("self.get_parameters(['rate'])[0]", "pass"),
    ],
    ids=["called", "a list", "a list in its place", "a dict in the place of one of a node", "of what it returns"],
)
def test_what_has_items(judge: Judge, line: str, made: str):
    judge("API002", ferry(line, made).replace("  # here", ""))


def test_a_decorated_method_may_be_anything(judge: Judge):
    source = ferry("self.sail_to[0]").replace("  # here", "")
    judge("API002", source.replace("def sail_to(self, pier)", "@property\n        def sail_to(self)"))


def test_a_derived_class_may_have_a_list_under_the_name(judge: Judge):
    derived = """
    class Cable(Ferry):
        sail_to = [1.0]
    """
    judge("API002", ferry("self.sail_to[0]").replace("  # here", "") + derived)


def test_a_try_that_expects_it(judge: Judge):
    tried = "try:\n                self.sail_to[0]\n            except TypeError:\n                pass"
    judge("API002", ferry(tried).replace("  # here", ""))
