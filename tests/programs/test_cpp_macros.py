"""Macros of C++ that take arguments."""

from __future__ import annotations

from tests.cpp_nodes import graph

ROBOT = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
%s
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s }
  std::string topic_;
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""
STRING = "std_msgs::msg::String"


def names(macros: str, statements: str, header: str = "") -> list[str | None]:
    """What the robot publishes, whose macros stand in its file, or in a header."""
    files = {"src/robot.cpp": ROBOT % (macros, statements), "src/macros.hpp": f"#pragma once\n{header}\n"}
    [node] = graph(files)["nodes"]
    assert all(end["type"] == "std_msgs/msg/String" for end in node["publishers"])
    return sorted(end["name"] or "?" for end in node["publishers"])


def test_a_macro_that_creates() -> None:
    macros = "#define PUB(T, name) create_publisher<T>(name, 10)"
    assert names(macros, f'PUB({STRING}, "a"); auto b = PUB({STRING}, "b");') == ["/a", "/b"]


def test_a_macro_that_joins_names_and_makes_texts_of_them() -> None:
    macros = f"""#define OPEN(name) \\
  auto name##_pub = create_publisher<{STRING}>(#name "/out", 10)"""
    assert names(macros, "OPEN(left); OPEN(right);") == ["/left/out", "/right/out"]


def test_a_macro_of_several_statements() -> None:
    first, second = (f"create_publisher<{STRING}>({name}, 1);" for name in ("n", "n TAIL"))
    macros = f'#define TAIL "/tail"\n#define BOTH(n) do {{ {first} {second} }} while (0)'
    assert names(macros, 'BOTH("a");') == ["/a", "/a/tail"]


def test_macros_of_a_header() -> None:
    header = """
    #define ADVERTISE(node, T, name) (node)->create_publisher<T>((name), rclcpp::QoS(3))
    #define DECLARE(variable, name, value) variable = declare_parameter(#name, value)
    #define OUT(name) "out/" #name
    """
    used = f'DECLARE(topic_, topic, "state"); ADVERTISE(this, {STRING}, topic_); ADVERTISE(this, {STRING}, OUT(b));'
    assert names('#include "macros.hpp"', used, header) == ["/out/b", "/state"]


def test_a_macro_that_is_defined_twice_is_not_known() -> None:
    macros = """
    #ifdef SIMULATION
    #define TOPIC(name) "sim/" name
    #else
    #define TOPIC(name) "real/" name
    #endif
    """
    assert names(macros, f'create_publisher<{STRING}>(TOPIC("a"), 1);') == ["?"]


def test_macros_in_a_circle_end() -> None:
    macros = "#define A(x) B(x)\n#define B(x) A(x)"
    assert names(macros, f'create_publisher<{STRING}>(A("a"), 1);') == ["?"]


def test_a_macro_with_another_number_of_arguments_is_a_call() -> None:
    assert names("#define A(x, y) x", f'create_publisher<{STRING}>(A("a"), 1);') == ["?"]
