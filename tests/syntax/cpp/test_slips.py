"""Slips in C++ functions that no compiler takes, and good code that the grammar does not understand."""

from __future__ import annotations

import pytest

from archlint.syntax.cpp.lowering import lower

CODE = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")%s
  {
    count_ = 1;
    %s
    last_ = 2;
  }
};
"""


def told(statement: str, initialised: str = "") -> list[tuple[int, str]]:
    """What is told of a constructor, with the lines."""
    problems = lower((CODE % (initialised, statement)).encode()).problems
    return [(problem.line, problem.message.partition(": this does")[0]) for problem in problems]


@pytest.mark.parametrize(
    ("statement", "line", "message"),
    [
        ("rclcpp::shutdown():", 8, "'rclcpp::shutdown():' is not understood here"),
        ("start()\n    stop();", 8, "';' is missing behind this"),
        ("publisher_->publish(message)", 9, "'last_' is not understood here, as a ';' is missing in front of it"),
        ("rclcpp::Rate rate(10)\n    rate.sleep();", 8, "';' is missing behind this"),
        ("drive(speed turn);", 8, "'drive(speed turn)' is not understood here"),
        ("drive(speed, , turn);", 8, "',' is not understood here"),
        ("double speed = 1,5;", 8, "',5' is not understood here"),
        ("auto data = message - >data;", 8, "'>' is not understood here"),
        ("[INFO] [1700000000.123] [talker]: it runs", 8, "a line of a log stands in the code"),
        ("[talker-1] [WARN] [1700000000.123] [talker]: slow", 8, "a line of a log stands in the code"),
        ('RCLCPP_INFO(get_logger() "it runs");', 8, "'get_logger()' is not understood here"),
        ("timer_ = create_wall_timer(500ms std::bind(&Talker::talk, this));", 8, "'500ms' is not understood here"),
        ("speed = ;", 8, "';' is not understood here"),
        ("int limits[] = {1, 2 3};", 8, "'3' is not understood here"),
    ],
)
def test_a_slip_in_a_function(statement, line, message):
    assert told(statement) == [(line, message)]


def test_a_comma_that_is_missing_among_fields():
    assert told("", ", count_(1) last_(2)") == [(5, "'count_(1)' is not understood here")]


@pytest.mark.parametrize(
    "statement",
    [
        'RCLCPP_INFO(get_logger(), "%" PRId64, count_);',
        "SCOPE_EXIT(count_ = 0;);",
        "DEBUG_CALL(show(count_);)",
        "connect(box, SIGNAL(changed(double)), this, SLOT(note(double)));",
        "auto goal = typename Action::Goal();",
        "(object_->*callback_)(message);",
        "return !this->operator==(other);",
        "const Transform &transform(grid->transform());",
        "auto value = decltype(count_)(1);",
        "foreach (auto & item, items) { show(item); }",
        "emit changed(count_);",
        "every(const Item & item, items)\n      show(item);",
        "for (const auto & item : items)\n      const auto twice = item * 2;",
        "#if FAST\n    count_ = 2;\n#else\n    count_ = 3;\n#endif",
        'auto text = "shutdown():";  // shutdown():',
        "DEBUG_CALL(show(count_);)\n    /* prints\n    [INFO] [1700000000.123] [talker]: it runs */",
    ],
)
def test_what_a_compiler_takes(statement):
    assert told(statement) == []


def test_the_marks_of_a_merge():
    merge = "\n<<<<<<< HEAD\n    count_ = 2;\n=======\n    count_ = 3;\n>>>>>>> 1a2b3c4"
    assert told(merge) == [(9, "the marks of a merge are left in this file: it does not compile")]
