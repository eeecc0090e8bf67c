"""API005: local variables that are read where they have no value."""

from __future__ import annotations

import pytest

from archlint.finding import Severity
from checks.judging import Judge

NODE = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String

limit = 3


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.sub = self.create_subscription(String, 'chatter', self.hear, 10)

    def hear(self, message):
{body}


def main():
    rclpy.init()
    rclpy.spin(Talker())


main()
"""


def _node(*lines: str) -> str:
    return NODE.format(body="\n".join(f"        {line}" for line in lines))


def test_an_except_that_goes_on_to_the_read(judge: Judge):
    (finding,) = judge(
        "API005",
        _node(
            "try:",
            "    value = float(message.data)",
            "except ValueError:",
            "    self.get_logger().warning('no number')",
            "print(value)  # here",
        ),
    )
    assert finding.severity is Severity.WARNING
    assert finding.message == (
        "'value' has no value here where line 15 has failed, since the except on line 16 goes on: this line fails with "
        "an UnboundLocalError then"
    )
    assert finding.help == "return in that except, or give value a value there"
    assert [row.place.line for row in finding.related] == [15, 16]


def test_a_loop_goes_on_with_its_next_round(judge: Judge):
    lines = ("while True:", "    try:", "        value = float(message.data)", "    except ValueError:", "        pass")
    (finding,) = judge("API005", _node(*lines, "    print(value)  # here"))
    assert finding.help == "continue in that except, or give value a value there"


def test_no_constructor_returns_early(judge: Judge):
    lines = ("try:", "    port = open('port')", "except OSError:", "    pass", "print(port)  # here", "self.sub = ")
    source = NODE.replace("self.sub = ", "\n        ".join(lines))
    (finding,) = judge("API005", source.format(body="        pass"))
    assert finding.help == "raise in that except, or give port a value there"


def test_the_first_read_behind_an_except_is_in_a_loop(judge: Judge):
    lines = ("try:", "    value = float(message.data)", "except ValueError:", "    pass", "for _ in range(3):")
    judge("API005", _node(*lines, "    print(value)  # here", "print(value)"))


@pytest.mark.parametrize(("ends", "mark"), [("raise error", ""), ("print(error)", "  # here")])
def test_an_except_that_calls_what_always_raises(judge: Judge, ends: str, mark: str):
    lines = ("try:", "    value = float(message.data)", "except ValueError as error:", "    give_up(error)")
    give_up = f"\n\ndef give_up(error):\n    if 'busy' in str(error):\n        raise RuntimeError('busy')\n    {ends}\n"
    judge("API005", _node(*lines, f"print(value){mark}") + give_up)


MEASURE = """


def measure(text):
    try:
        return float(text), 1.0
    except {caught}:
        print('no number')
        return {otherwise}
"""


@pytest.mark.parametrize(
    ("caught", "otherwise", "mark"),
    [
        ("ValueError", "0.0, 0.0", ""),
        ("Exception", "0.0, 0.0", ""),
        ("KeyError", "0.0, 0.0", "  # here"),
        ("ValueError", "None", "  # here"),
        ("ValueError", "float('nan'), limit", "  # here"),
    ],
    ids=["the same", "whatever happens", "another", "what cannot be unpacked", "which may fail itself"],
)
def test_an_except_for_what_the_call_that_is_tried_catches_itself(judge: Judge, caught: str, otherwise: str, mark: str):
    lines = ("try:", "    mean, spread = measure(message.data)", "except ValueError:", "    print('no number')")
    helper = MEASURE.format(caught=caught, otherwise=otherwise)
    judge("API005", _node(*lines, f"print(mean + spread){mark}") + helper)


def test_two_variables_of_one_line_are_one_finding(judge: Judge):
    lines = ("if message.data:", "    low, high = 1, 2", "else:", "    print(low, high)  # here")
    (finding,) = judge("API005", _node(*lines))
    assert finding.message == (
        "'low' gets a value only in another branch of this function: this line fails with an UnboundLocalError; "
        "another variable has none, either"
    )


@pytest.mark.parametrize(
    ("handler", "told"),
    [
        ("except NameError:", 0),
        ("except (UnboundLocalError, ValueError):", 0),
        ("except:", 0),
        ("except Exception:", 0),
        ("except ValueError:", 1),
    ],
)
def test_a_read_in_a_try_that_expects_no_value(judge: Judge, handler: str, told: int):
    lines = (
        "try:",
        "    value = float(message.data)",
        "except ValueError:",
        "    try:",
        "        print(value)",
        f"    {handler}",
        "        pass",
    )
    assert len(judge("API005", _node(*lines).replace("print(value)", f"print(value){'  # here' * told}"))) == told


def test_all_that_one_except_leaves_without_a_value(judge: Judge):
    lines = (
        "try:",
        "    a, b = message.data.split()",
        "except ValueError:",
        "    pass",
        "print(a)  # here",
        "print(b)",
    )
    (finding,) = judge("API005", _node(*lines))
    assert finding.message.endswith("; another variable has none, either")


def test_a_value_that_comes_only_later(judge: Judge):
    (finding,) = judge("API005", _node("print(limit)  # here", "limit = 5"))
    assert finding.severity is Severity.ERROR
    assert finding.message == (
        "'limit' gets a value only later in this function: this line fails with an UnboundLocalError"
    )


def test_a_value_that_is_made_of_itself(judge: Judge):
    (finding,) = judge("API005", _node("first = first[0]  # here", "print(first)"))
    assert finding.message == (
        "nothing gives 'first' a value before this line, which reads it first: it fails with an UnboundLocalError"
    )
    assert (finding.help, finding.related) == ("give first a value before", ())


def test_a_value_that_only_another_branch_gives(judge: Judge):
    branches = ("if message.data:", "    for i in range(3):", "        print(i)", "else:", "    print(i)  # here")
    (finding,) = judge("API005", _node(*branches))
    assert finding.message == (
        "'i' gets a value only in another branch of this function: this line fails with an UnboundLocalError"
    )
    assert finding.help == "give i a value in this branch, too"
    assert [row.place.line for row in finding.related] == [15]


TRIED = ("try:", "    a = float(message.data)", "except ValueError:")
NOTES = ("except Exception as e:", "    print(e)")


@pytest.mark.parametrize(
    "lines",
    [
        ("while True:", *(f"    {line}" for line in TRIED), "        print('no')", "    print(a)  # here"),
        (*TRIED, "    exit", "if limit:", "    print(limit)", "return a  # here"),
        ("with open('a') as file:", "    print(text)  # here", "    text = file.read()"),
        (*TRIED, "    print('no')", "try:", "    print(a)", *NOTES, "return a  # here"),
        (*TRIED, "    print('no')", *("try:", "    print(a)  # here", "except ValueError as e:", "    print(e)")),
        (*("try:", *(f"    {line}" for line in TRIED), "        print('no')"), "    print(a)  # here", *NOTES),
    ],
)
def test_other_ways_to_a_variable_without_a_value(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))


@pytest.mark.parametrize(
    "lines",
    [
        (*TRIED, "    return", "print(a)"),
        (*TRIED, "    raise", "print(a)"),
        (*TRIED, "    a = 0.0", "print(a)"),
        (*TRIED, "    print('no')", "else:", "    print(a)"),
        ("a = None", *TRIED, "    print('no')", "print(a)"),
        ("good = True", *TRIED, "    good = False", "if good:", "    print(a)"),
        ("good = True", *TRIED, "    good = False", "print(good and a)"),
        ("while True:", *(f"    {line}" for line in TRIED), "        continue", "    print(a)"),
        ("for _ in range(3):", *(f"    {line}" for line in TRIED), "        break", "    print(a)"),
        ("try:", "    a = None", "    print(float(message.data))", "except ValueError:", "    pass", "print(a)"),
        ("try:", "    a = float(message.data)", "except KeyboardInterrupt:", "    pass", "print(a)"),
        ("try:", "    a = Talker()", "except rclpy.exceptions.ROSInterruptException:", "    pass", "print(a)"),
        (
            "import time",
            "try:",
            "    a = time.time()",
            "    float(message.data)",
            "except ValueError:",
            "    pass",
            "print(a)",
        ),
        (
            "import socket",
            "try:",
            "    a = socket.socket(socket.AF_INET)",
            "    a.connect(message.data)",
            "except OSError:",
            "    print('no')",
            "print(a)",
        ),
        (
            "try:",
            "    a = String()",
            "    a.data = str(float(message.data))",
            "except ValueError:",
            "    pass",
            "print(a)",
        ),
        (
            "from pathlib import Path",
            "try:",
            "    a = Path(message.data).resolve()",
            "except OSError:",
            "    print('no')",
            "print(a)",
        ),
        ("try:", "    a = Talker()", "except Exception:", "    print('no')", "finally:", "    a.destroy_node()"),
        ("try:", "    import numpy as a", "except ImportError:", "    print('no')", "print(a)"),
        (*TRIED, "    print('no')", "try:", "    print(a)", *NOTES),
    ],
)
def test_a_try_after_which_the_variable_has_a_value_or_may_not_be_read(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))


@pytest.mark.parametrize(
    "lines",
    [
        ("global limit", "print(limit)", "limit = 5"),
        ("for _ in range(2):", "    if _:", "        print(a)", "    a = 5"),
        ("print([a for a in range(3)])", "a = 5"),
        ("print(lambda: a)", "a = 5"),
        ("def show():", "    print(a)", "a = 5", "show()"),
        ("if message.data:", "    a = 5", "print(a)"),
        ("if (a := message.data):", "    print(a)"),
        ("a: int", "a = 5", "print(a)"),
        ("for a in range(3):", "    print(a)"),
        ("with open('a') as a:", "    print(a)"),
        ("a = b = 5", "print(a, b)"),
    ],
)
def test_what_has_a_value_or_may_have_one(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))


@pytest.mark.parametrize(("caught", "mark"), [("", ""), (" BaseException", ""), (" Exception", "  # here")])
def test_an_except_for_everything_is_for_the_end_of_the_program(judge: Judge, caught: str, mark: str) -> None:
    """By then the variable has its value, as a rule."""
    judge(
        "API005",
        f"""
        import rclpy


        def main():
            rclpy.init()
            try:
                node = rclpy.create_node('robot')
                rclpy.spin(node)
            except{caught}:
                print('stopped')
                node.destroy_node(){mark}
                rclpy.shutdown()


        main()
        """,
    )


def test_where_it_would_have_got_a_value_is_in_the_same_try(judge: Judge):
    (finding,) = judge(
        "API005",
        _node(
            "if limit:",
            "    try:",
            "        value = float(message.data)",
            "    except ValueError:",
            "        return",
            "    print(value)",
            "    return",
            "try:",
            "    value = int(message.data)",
            "except ValueError:",
            "    self.get_logger().warning('no number')",
            "print(value)  # here",
        ),
    )
    assert [row.place.line for row in finding.related] == [22, 23]


@pytest.mark.parametrize(("above", "mark"), [("import serial", ""), ("from serial import SerialException", "  # here")])
def test_an_except_for_what_nothing_defines_fails_itself(judge: Judge, above: str, mark: str) -> None:
    judge(
        "API005",
        f"""
        import rclpy
        {above}


        def read(port):
            try:
                value = port.next()
            except SerialException:{"" if mark else "  # here"}
                print('no number')
            return value{mark}
        """,
    )


@pytest.mark.parametrize("line", ["Talker = Talker()  # here", "rclpy.spin(Talker)  # here"])
def test_a_variable_that_hides_a_class_of_the_file(judge: Judge, line: str):
    source = NODE.replace("{body}", "        pass").replace("rclpy.spin(Talker())", f"{line}\n    Talker = 1")
    (told,) = judge("API005", source)
    assert told.message.startswith("'Talker' is a variable in this function and has no value yet")
    assert told.help == "give the variable another name: it hides the class Talker of this file"


PHASES = """
import math

import rclpy

first = second = False
math.tau = 3


def hear(scan):
    if not first:  # here
        first = scan > 3
    if first and not second:
        second = True
    elif third:
        third = False


def look(scan):
    global first, third
    first, third = scan, None


def count(scan):
    if scan:
        amount = 3
    else:
        print(amount)  # here


def measure(scan):
    global second
    print(second)
    second = scan
"""


def test_variables_of_the_file_that_a_function_does_not_declare_global(judge: Judge):
    own, branch = judge("API005", PHASES)
    assert own.help == "write `global first, second, third` at the beginning of hear()"
    assert own.message == (
        "'first' gets a value only later in this function: this line fails with an UnboundLocalError; 2 more variables "
        "have none, either"
    )
    assert branch.help == "give amount a value in this branch, too"


def test_the_first_read_of_a_call_is_told(judge: Judge):
    (finding,) = judge("API005", _node("print(", "    value[0],  # here", "    value[1],", ")", "value = [1]"))
    assert finding.help == "give value a value before"


CHOICE = ("if message.data == 'left':", "    side = 1", "elif message.data == 'right':", "    side = 2", "else:")
WARNS = "    self.get_logger().warning('neither')"


def test_a_branch_that_goes_on_to_the_read(judge: Judge):
    (finding,) = judge("API005", _node(*CHOICE, WARNS, "print(side)  # here"))
    assert finding.severity is Severity.WARNING
    assert finding.message == (
        "'side' has no value here where line 19 has run, since that branch goes on: this line fails with an "
        "UnboundLocalError then"
    )
    assert finding.help == "give side a value in that branch, or before the if"
    assert [row.place.line for row in finding.related] == [15, 19]


@pytest.mark.parametrize(
    "lines",
    [
        (*CHOICE, WARNS, "for number in range(3):", "    print(number)", "print(side)  # here"),
        ("if message.data:", WARNS, "else:", "    side = 1", "print(side)  # here"),
        ("if message.data:", "    side = 1", "elif self.sub:", WARNS, "else:", "    side = 2", "print(side)  # here"),
        (*CHOICE, "    pass", "print(side)  # here"),
        (*(line.replace("message.data", "self.side") for line in CHOICE), "    pass", "print(side)"),  # its own state
        (*(line.replace("message.data", "self.side") for line in CHOICE), WARNS, "print(side)  # here"),
        (*CHOICE, WARNS, "    return", "print(side)"),
        (*CHOICE, "    raise ValueError(message.data)", "print(side)"),
        (*CHOICE, "    self.parser.error('neither')", "print(side)"),
        (*CHOICE, "    self.print_usage()", "print(side)"),
        (*CHOICE[:-1], "print(side)"),  # nobody says that there is anything else
        (*CHOICE, WARNS, "if message.data:", "    print(side)"),
        (*CHOICE, WARNS, "if not message.data:", "    return", "print(side)"),
        (*CHOICE, WARNS, "print(message.data and side)"),
        ("side = 0", *CHOICE, WARNS, "print(side)"),
        (*CHOICE, WARNS, "try:", "    print(side)", "except UnboundLocalError:", "    pass"),
        (*CHOICE, WARNS, "print('side' in locals() and side, side)"),
        ("if message.data not in ('left', 'right'):", "    return", *CHOICE, WARNS, "print(side)"),
        ("for _ in range(2):", *(f"    {line}" for line in (*CHOICE, WARNS, "print(side)"))),  # the round before has
    ],
)
def test_branches_and_what_follows(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))


def test_a_branch_that_a_constant_switches_off(judge: Judge):
    lines = ("if USE_LIDAR:", "    side = 1", "else:", WARNS, "print(side)")
    judge("API005", _node(*lines).replace("limit = 3", "USE_LIDAR = True"))


def test_a_branch_that_calls_what_always_raises(judge: Judge):
    refuse = "\n\ndef refuse(text):\n    raise ValueError(text)\n"
    judge("API005", _node(*CHOICE, "    refuse(message.data)", "print(side)") + refuse)


def test_a_function_beside_one_that_asks_for_variables(judge: Judge):
    """And a method that is only called like ``exec()``, as that of Qt is."""
    beside = "\n\ndef show(app):\n    return app.exec() if 'app' in locals() else None\n"
    judge("API005", _node(*CHOICE, WARNS, "print(side)  # here", "print(heigth)  # here") + beside)


@pytest.mark.parametrize(
    "lines",
    [
        ("if (value := message.data) is not None:", "    print(value)", "else:", "    value = ''"),
        ("word = (value := message.data) + value", "value = word"),
        ("print(value)  # here", "if (value := message.data):", "    pass"),
    ],
)
def test_a_variable_that_an_expression_assigns(judge: Judge, lines: tuple[str, ...]):
    judge("API005", _node(*lines))
