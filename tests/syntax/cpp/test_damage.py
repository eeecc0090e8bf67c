"""C++ that cannot be right, or was not understood where it creates something, is told; odd code is not."""

from __future__ import annotations

import re

import pytest

from archlint.syntax.cpp.lowering import lower

NODE = """\
#include "rclcpp/rclcpp.hpp"
namespace demo {
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    pub_ = create_publisher<std_msgs::msg::String>("chatter", 10);
    if (get_parameter("fast").as_bool()) {
      sub_ = create_subscription<std_msgs::msg::String>("orders", 10, [this](String m) { take(m); });
    }
  }
private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
}  // namespace demo
int main(int argc, char ** argv) { rclcpp::spin(std::make_shared<demo::Talker>()); }
"""


def told(source: str) -> list[str]:
    """What is told of a file, with the words that stand at the place."""
    lines = source.splitlines()
    return [
        re.sub(r"( is missing from the graph|,).*", "", problem.message)
        + f" @ {line_from(lines, problem.line, problem.column)}"
        for problem in lower(source.encode()).problems
    ]


def line_from(lines: list[str], line: int, column: int) -> str:
    return lines[line - 1][column - 1 :][:12]


def changed(before: str, after: str) -> str:
    assert NODE.count(before) == 1
    return NODE.replace(before, after)


def test_a_whole_node_is_fine() -> None:
    assert told(NODE) == []


@pytest.mark.parametrize(
    ("before", "after", "what"),
    [
        ("m) { take(m); });\n    }\n  }", "m) { take(m); });\n    }", "'{' is never closed @ {"),
        ('"chatter", 10);', '"chatter", 10;', "'(' is never closed @ (\"chatter\", "),
        ('argv) { rclcpp::spin(std::make_shared<demo::Talker>()); }', "argv) {", "'{' is never closed @ {"),
        ('("fast").as_bool())', '("fast").as_bool()))', "'{' is never closed @ {"),
        ('"orders", 10, [this]', '"orders", 10, [this', "'[' is never closed @ [this(String"),
        ('"chatter", 10', '"chatter, 10', "'(' is never closed @ (\"chatter, 1"),
        ("/rclcpp.hpp\"\n", "/rclcpp.hpp\"\n/* never ends\n", "") ,
    ],
)  # fmt: skip
def test_brackets_that_do_not_match_are_certain_damage(before: str, after: str, what: str) -> None:
    assert told(changed(before, after)) == ([what] if what else [])
    assert not any(problem.partly for problem in lower(changed(before, after).encode()).problems)


@pytest.mark.parametrize(
    ("before", "after", "what"),
    [
        ("create_publisher<std_msgs", "create_publisher std_msgs", ["the call of create_publisher @ create_publi"]),
        ('Node("talker")\n  {', 'Node("talker")\n', ["the call of create_publisher @ create_publi"]),
        ("SharedPtr pub_;", "SharedPtr pub_", []),
    ],
)
def test_what_creates_something_in_code_that_is_not_understood_is_told(
    before: str, after: str, what: list[str]
) -> None:
    source = changed(before, after)
    assert told(source) == what
    assert all(problem.partly for problem in lower(source.encode()).problems)


def test_the_class_of_a_node_that_is_not_understood_is_told() -> None:
    source = """\
class Listener : public rclcpp::Node { public: Listener() : Node("a") { sub_ = create_subscription<S>("x", 1, cb); }
private: rclcpp::Subscription<std_msgs::msg::Int64>::SharedPtr sub_
};
int main(int argc, char ** argv) { rclcpp::spin(std::make_shared<Listener>()); }
"""
    assert told(source) == ["the class Listener @ Listener : p"]


@pytest.mark.parametrize("parameters", ["typename A, ", "typename A, int B = 2, typename C, "])
def test_a_class_behind_a_template_without_an_end_is_told(parameters: str) -> None:
    source = 'class Talker : public rclcpp::Node { Talker() : Node("a") { create_publisher<S>("x", 1); } };\n'
    assert told(f"template<{parameters}\n{source}") == ["the class Talker @ Talker : pub"]
    assert told(f"template<{parameters}typename T>\n{source}int x MACRO;\n") == []
    assert told(f"template<{parameters}\nclass Other : public Base {{ int a; }};\n") == []


def test_a_statement_outside_of_all_functions_is_none() -> None:
    source = "void make(rclcpp::Node & n)\n  if (n.ok()) { n.create_wall_timer(100ms, tick); }\n"
    assert told(source) == ["the call of create_wall_timer @ create_wall_"]


@pytest.mark.parametrize(
    "source",
    [
        pytest.param(changed("public:", "Q_OBJECT\npublic slots:"), id="macros-without-semicolons"),
        pytest.param(changed("class Talker", "class [[gnu::visibility(\"default\")]] MY_API Talker"), id="attributes"),
        pytest.param(changed("pub_ = ", 'RCLCPP_INFO(l, "%" PRIu64 "(", 1); pub_ = '), id="a-bracket-in-a-text"),
        pytest.param(changed("pub_ = ", "int n = 1'000; char c = '('; pub_ = "), id="digits-in-groups"),
        pytest.param(changed("pub_ = ", 'auto s = R"x(}}} ")x"; pub_ = '), id="a-raw-text"),
        pytest.param("#define BEGIN {\n#define END }\nvoid f() BEGIN rclcpp::ok(); END\n", id="brackets-in-macros"),
        pytest.param("#ifdef A\nvoid f() {\n#else\nvoid g() {\n#endif\n ok() foo; }\n", id="one-of-two-branches"),
        pytest.param("namespace a {\nclass B : public rclcpp::Node { int x MACRO; };\n", id="closed-elsewhere"),
        pytest.param("void f() { g() MACRO h(); }\n}  // opened in the header\nvoid f();\n", id="opened-elsewhere"),
        pytest.param('// create_publisher<(\nauto s = "create_client(" MACRO;\n', id="in-comments-and-texts"),
        pytest.param('TEST_CASE("it talks")\n{\n  auto p = node->create_publisher<A>("a", 1);\n}\n', id="of-a-macro"),
        pytest.param("template <class T> auto create_client(T t) MACRO { return t; }\n", id="a-function-of-that-name"),
    ],
)  # fmt: skip
def test_code_that_only_the_grammar_does_not_understand_is_fine(source: str) -> None:
    assert told(source) == []


def test_one_line_tells_of_all_that_a_file_loses() -> None:
    source = changed("create_publisher<std_msgs", "create_publisher std_msgs")
    (problem,) = lower(source.replace("create_subscription<std", "create_subscription std").encode()).problems
    start = "the call of create_publisher is missing from the graph"
    assert problem.message == f"{start} (1 more of this file, too): the code there is not understood"
