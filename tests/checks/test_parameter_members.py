"""PRM010: members of a ParameterValue that a parameter's type does not set."""

from __future__ import annotations

import pytest

from checks.judging import Judge
from robot_package import node

NODE = """
from rclpy.node import Node
from rclpy.parameter import Parameter
from rcl_interfaces.msg import ParameterDescriptor

class Robot(Node):
    def __init__(self):
        super().__init__('robot')
        {declare}
        {read}
"""
VALUE = "self.get_parameter('it').get_parameter_value()"


@pytest.mark.parametrize(
    ("given", "member", "message"),
    [
        ("1000", "double_value", "'double_value' is always 0.0 here: the parameter 'it' is an integer"),
        ("1.5", "integer_value", "'integer_value' is always 0 here: the parameter 'it' is a double"),
        ("'a'", "string_array_value", "'string_array_value' is always empty here: the parameter 'it' is a string"),
        ("[1.5]", "double_value", "'double_value' is always 0.0 here: the parameter 'it' is a double array"),
        ("True", "integer_value", "'integer_value' is always 0 here: the parameter 'it' is a bool"),
        ("[]", "double_value", "'double_value' is always 0.0 here: the parameter 'it' is a byte array"),
        (
            "Parameter.Type.BYTE_ARRAY",
            "double_array_value",
            "'double_array_value' is always empty here: the parameter 'it' is a byte array",
        ),
        ("Parameter.Type.STRING", "bool_value", "'bool_value' is always False here: the parameter 'it' is a string"),
    ],
)
def test_a_member_of_another_type(judge: Judge, given: str, member: str, message: str):
    read = f"self.it = {VALUE}.{member}  # here"
    (finding,) = judge("PRM010", NODE.format(declare=f"self.declare_parameter('it', {given})", read=read))
    assert finding.message == message


def test_a_value_that_is_read_as_it_is_declared(judge: Judge):
    declare = "self.it = self.declare_parameter('it', 5).get_parameter_value().double_value  # here"
    judge("PRM010", NODE.format(declare=declare, read="pass"))


@pytest.mark.parametrize(
    ("declare", "read"),
    [
        ("self.declare_parameter('it', 1000)", f"{VALUE}.integer_value"),
        ("self.declare_parameter('it', [1, 2])", f"{VALUE}.integer_array_value"),
        ("self.declare_parameter('it', [])", f"{VALUE}.integer_array_value"),  # empty, as the default is
        ("self.declare_parameter('it', 1000)", f"{VALUE}.type"),
        ("self.declare_parameter('it', self.default())", f"{VALUE}.double_value"),
        ("self.declare_parameter('it', 1, ParameterDescriptor(dynamic_typing=True))", f"{VALUE}.double_value"),
        ("self.declare_parameter('it')", f"{VALUE}.double_value"),
        ("self.declare_parameter('other', 1)", f"{VALUE}.double_value"),
    ],
)
def test_a_member_that_may_be_right(judge: Judge, declare: str, read: str):
    judge("PRM010", NODE.format(declare=declare, read=f"self.it = {read}"))


def test_a_value_for_which_the_code_raises(judge: Judge):
    """With what is read now, the node starts."""
    read = f"""self.it = {VALUE}.double_value  # here
        if self.it and self.speed:
            raise ValueError('one of the two')"""
    (told,) = judge("PRM010", NODE.format(declare="self.declare_parameter('it', 60)", read=read))
    assert told.help == "declare it with 0.0, which the code has so far: line 10 may raise an exception for 60"


@pytest.mark.parametrize(
    ("given", "help"),
    [
        ("40.5", "declare it with 60.0: what is set from outside is a double, too"),
        ("40", "read integer_value, or get_parameter('it').value, which has the right type"),
    ],
)
def test_a_parameter_that_a_launch_file_sets(findings, given: str, help: str):
    code = NODE.format(declare="self.declare_parameter('it', 60)", read=f"self.it = {VALUE}.double_value")
    main = "\n\ndef main():\n    import rclpy\n    rclpy.init()\n    rclpy.spin(Robot())\n"
    launch = node(f'<param name="it" value="{given}"/>')
    (told,) = findings("PRM010", launch, **{"robot/talker.py": code + main})
    assert told.help == help


def test_parameters_of_a_file_that_are_read_in_the_same_way_are_one_finding(judge: Judge):
    declare = "self.declare_parameter('it', 1000)\n        self.declare_parameter('other', 1000)"
    reads = f"self.it = {VALUE}.double_value  # here\n        self.again = {VALUE}.double_value"
    other = "self.other = self.get_parameter('other').get_parameter_value().double_value"
    (told,) = judge("PRM010", NODE.format(declare=declare, read=f"{reads}\n        {other}"))
    assert told.message.endswith("; another line reads it where their parameters do not set it, too")
    assert [row.message for row in told.related] == [
        "it is declared here",
        "it is read here, too",
        "'double_value' is always 0.0 here: the parameter 'other' is an integer",
    ]


CPP = """
#include <rclcpp/rclcpp.hpp>

class Robot : public rclcpp::Node
{{
public:
  Robot() : Node("robot")
  {{
    declare_parameter("name", "left");
    this->declare_parameter<double>("rate", 10.0);
    declare_parameter("count", 5);
    {read}
  }}
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}}
"""


@pytest.mark.parametrize(
    ("read", "column", "message", "help"),
    [
        (
            'get_parameter("name").as_int();',
            27,
            "'as_int()' throws an exception here: the parameter 'name' is a string",
            "as_string(), or declare it with an integer",
        ),
        (
            'this->get_parameter("rate").as_int();',
            33,
            "'as_int()' throws an exception here: the parameter 'rate' is a double",
            "as_double(), or declare it with an integer",
        ),
        (
            'get_parameter("count").get_value<double>();',
            28,
            "'get_value<double>()' throws an exception here: the parameter 'count' is an integer",
            "as_int(), or declare it with a double",
        ),
        (
            'declare_parameter<std::float_t>("p", 1); get_parameter("p").as_int();',
            65,
            "'as_int()' throws an exception here: the parameter 'p' is a double",
            "as_double(), or declare it with an integer",
        ),
        (
            'auto rate = get_parameter("rate"); int r = rate.as_int();',
            53,
            "'as_int()' throws an exception here: the parameter 'rate' is a double",
            "as_double(), or declare it with an integer",
        ),
    ],
)
def test_a_method_of_rclcpp_for_another_type(findings, read: str, column: int, message: str, help: str):
    (told,) = findings("PRM010", **{"src/robot.cpp": CPP.format(read=read)})
    assert (told.place.line, told.place.column) == (12, column)
    assert told.message == message
    assert told.help == f"write {help}"


@pytest.mark.parametrize(
    "read",
    [
        'get_parameter("name").as_string();',
        'get_parameter("rate").get_value<float>();',
        'get_parameter("count").get_value<int64_t>();',
        'get_parameter("count").get_value<Count>();',
        'get_parameter("other").as_int();',
        'declare_parameter<std::float_t>("gain", 1); get_parameter("gain").as_double();',
        'declare_parameter<Gain>("gain", 1); get_parameter("gain").as_double();',  # an alias of any type
        'declare_parameter<unsigned int>("size", 1.0); get_parameter("size").as_int();',
        'get_parameter("rate").get_value<std::double_t>();',
        'rclcpp::Parameter p = get_parameter("rate"); p.as_double();',
        'auto p = get_parameter("rate"); { auto p = get_parameter("count"); p.as_int(); }',
        'int count; get_parameter("count", count);',
    ],
)
def test_a_method_of_rclcpp_for_the_type(findings, read: str):
    assert findings("PRM010", **{"src/robot.cpp": CPP.format(read=read)}) == []


OVERLOADS = """
#include <rclcpp/rclcpp.hpp>

std::string setting(rclcpp::Node & node, const std::string & name, const std::string & fallback)
{{
  node.declare_parameter(name, fallback);
  return node.get_parameter(name).as_string();
}}

double setting(rclcpp::Node & node, const std::string & name, double fallback)
{{
  node.declare_parameter(name, fallback);
  return node.get_parameter(name).as_double();
}}

bool setting(rclcpp::Node & node, const std::string & name, bool fallback)
{{
  node.declare_parameter(name, fallback);
  return node.get_parameter(name).{read};
}}

class Robot : public rclcpp::Node
{{
public:
  Robot() : Node("robot")
  {{
    const std::string side = "left";
    setting(*this, "side", side);
    setting(*this, "rate", 10.0);
    setting(*this, "is_real", true);
  }}
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}}
"""


def test_an_overload_is_chosen_by_the_type_of_its_argument(findings):
    assert findings("PRM010", **{"src/robot.cpp": OVERLOADS.format(read="as_bool()")}) == []
    (told,) = findings("PRM010", **{"src/robot.cpp": OVERLOADS.format(read="as_int()")})
    assert told.message == "'as_int()' throws an exception here: the parameter 'is_real' is a bool"


SHARED = """
#include <rclcpp/rclcpp.hpp>

template <typename T>
struct Setting
{{
  Setting(const std::string & name, rclcpp::Node & node, T fallback)
  {{
    node.declare_parameter(name, fallback);
    {read}
  }}

  T value;
}};

class Robot : public rclcpp::Node
{{
public:
  Robot() : Node("robot"), rate("rate", *this, 10.0), limit("limit", *this, 1.5) {{}}

  Setting<double> rate;
  Setting<double> limit;
}};

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}}
"""


def test_code_that_several_parameters_share_is_one_finding(findings):
    (told,) = findings("PRM010", **{"src/robot.cpp": SHARED.format(read="value = node.get_parameter(name).as_int();")})
    assert told.message == "'as_int()' throws an exception here: the parameter 'rate' is a double"
    assert [row.message for row in told.related] == [
        "it is declared here",
        "it reads 'limit', too, which is declared here",
    ]


@pytest.mark.parametrize(
    "read",
    [
        "if constexpr (std::is_same<T, int>::value) { value = node.get_parameter(name).as_int(); }",
        "if constexpr (std::is_same_v<T, double>) {} else { value = node.get_parameter(name).as_int(); }",
        "if constexpr (std::is_same_v<T, double>) {} else if constexpr (IS_INT<T>) "
        "{ value = node.get_parameter(name).as_int(); }",
        "if constexpr (IS_DOUBLE<T>) value = 1; else value = node.get_parameter(name).as_int();",
        "if constexpr (IS_DOUBLE<T>) { if (fallback > 0) { value = 1; } } else if (fallback > 0) "
        "{ check(); value = node.get_parameter(name).as_int(); }",
        "auto p = node.get_parameter(name); if (p.get_type() == rclcpp::PARAMETER_INTEGER) { value = p.as_int(); }",
        "if (node.get_parameter(name).get_type() == rclcpp::PARAMETER_INTEGER) "
        "{ value = node.get_parameter(name).as_int(); }",
    ],
)
def test_a_branch_that_a_type_chooses(findings, read: str):
    assert findings("PRM010", **{"src/robot.cpp": SHARED.format(read=read)}) == []


@pytest.mark.parametrize(
    "read",
    [
        "if constexpr (IS_DOUBLE<T>) { check(); } value = node.get_parameter(name).as_int();",
        "if constexpr (IS_DOUBLE<T>) check(); value = node.get_parameter(name).as_int();",
        "if (is_old()) {} else { value = node.get_parameter(name).as_int(); }",
    ],
)
def test_code_behind_a_branch_that_a_type_chooses(findings, read: str):
    assert len(findings("PRM010", **{"src/robot.cpp": SHARED.format(read=read)})) == 1
