"""What fails in modules that name nothing of ROS, and that a node imports."""

from __future__ import annotations

import pytest

from checks.judging import Judge

NODE = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import Float32

    from node1 import {imports}

    class Pot:
        def __init__(self):
            self.limit = 95.0
            self.heater = Heater(self)

    class Kettle(Node):
        def __init__(self):
            super().__init__('kettle')
            self.heater = {made}
            self.create_subscription(Float32, 'temperature', self.heat, 10)

        def heat(self, message):
            self.heater.heat(message.data)

    def main():
        rclpy.init()
        rclpy.spin(Kettle())

    if __name__ == '__main__':
        main()
"""


def kettle(imports: str = "Heater", made: str = "Heater()") -> str:
    return NODE.replace("{imports}", imports).replace("{made}", made)


def test_a_name_that_nothing_defines(judge: Judge):
    heater = """
        class Heater:
            def heat(self, temperature):
                print(math.ceil(temperature))  # here
    """
    (finding,) = judge("API005", kettle(), heater)
    assert finding.message == "nothing defines 'math': this line fails with a NameError"


def test_a_call_that_does_not_fit(judge: Judge):
    heater = """
        def clamp(value, low, high):
            return max(low, min(high, value))

        class Heater:
            def __init__(self, pot):
                self.pot = pot

            def heat(self, temperature):
                print(clamp(temperature, 0.0))  # here
    """
    judge("API001", kettle(made="Pot().heater"), heater)


def test_what_the_node_does_not_have(judge: Judge):
    heater = """
        class Heater:
            def __init__(self, pot):
                self.pot = pot

            def heat(self, temperature):
                print(self.pot.limits - temperature)  # here
    """
    (finding,) = judge("API002", kettle(made="Pot().heater"), heater)
    assert finding.message.endswith("did you mean 'limit'?")


def test_what_it_may_be_given_by_somebody_else(judge: Judge):
    """A helper is given objects of several classes: only a slip is sure."""
    heater = """
        class Heater:
            def __init__(self, pot):
                self.pot = pot

            def heat(self, temperature):
                self.pot.whistle()
    """
    judge("API002", kettle(made="Pot().heater"), heater)


def test_a_module_that_only_a_helper_imports(judge: Judge):
    heater = """
        from node2 import curve

        class Heater:
            def heat(self, temperature):
                print(curve(temperature))
    """
    judge("API005", kettle(), heater, "def curve(x):\n    return numpy.interp(x, [0, 1], [0, 1])  # here\n")


@pytest.mark.parametrize(
    "heater",
    [
        """
        def left_over():
            return forgotten()

        class Heater:
            def heat(self, temperature):
                print(temperature)
        """,
        """
        def left_over():
            return left_by_that_one()

        def left_by_that_one():
            return forgotten

        class Heater:
            def heat(self, temperature):
                print(temperature)
        """,
        """
        class Heater:
            def heat(self, temperature):
                print(temperature)

        def try_it():
            Heater().heat(forgotten)

        if __name__ == '__main__':
            try_it()
        """,
    ],
    ids=["nothing names it", "only what nothing names", "what it does as a program"],
)
def test_a_function_to_which_no_code_comes(judge: Judge, heater: str):
    judge("API005", kettle(), heater)


def test_a_module_that_no_node_imports(judge: Judge):
    judge("API005", kettle("Heater"), "class Heater:\n    def heat(self, t):\n        print(t)\n", "print(forgotten)\n")


def test_a_module_of_tests(judge: Judge):
    heater = "class Heater:\n    def heat(self, t):\n        print(t)\n"
    (judge.folder / "test_heater.py").write_text(
        "from node1 import Heater\nprint(rclpy, forgotten)\n", encoding="utf-8"
    )
    judge("API005", kettle(), heater)
