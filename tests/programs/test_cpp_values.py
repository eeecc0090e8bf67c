"""Containers, texts, optional values, packs and types of C++'s standard library."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph, graph_of

STRING = "std_msgs::msg::String"


def names(statements: str) -> list[str | None]:
    """What a node publishes whose constructor does this."""
    [node] = graph_of(statements)
    return sorted(end["name"] or "?" for end in node["publishers"])


def publish(name: str, depth: str = "1") -> str:
    return f"create_publisher<{STRING}>({name}, {depth});"


@pytest.mark.parametrize(
    "filled",
    [
        'std::map<std::string, int> all; all.emplace("a", 1); all.insert({"b", 2});',
        'std::map<std::string, int> all; all.insert_or_assign("a", 1); all.insert(std::make_pair("b", 2));',
        'std::vector<std::pair<std::string, int>> all; all.emplace_back("a", 1); all.push_back({"b", 2});',
    ],
)
def test_pairs_that_are_put_into_a_container(filled: str) -> None:
    [node] = graph_of(f"{filled} for (const auto & [name, depth] : all) {{ {publish('name', 'depth')} }}")
    assert {(end["name"], end["qos"]["depth"]) for end in node["publishers"]} == {("/a", 1), ("/b", 2)}


@pytest.mark.parametrize(
    "filled",
    [
        'std::set<std::string> all; all.insert("a"); all.emplace("b");',
        'std::vector<std::string> all{"a"}; all.insert(all.end(), "b");',
        'std::vector<std::string> all{"a"}, more{"b"}; std::copy(more.begin(), more.end(), std::back_inserter(all));',
    ],
)
def test_texts_that_are_put_into_a_container(filled: str) -> None:
    assert names(f"{filled} for (const auto & name : all) {{ {publish('name')} }}") == ["/a", "/b"]


def test_what_an_algorithm_puts_into_a_container() -> None:
    filled = """
    std::vector<std::string> parts{"a", "b"}, all;
    std::transform(parts.begin(), parts.end(), std::back_inserter(all), [](const auto & part) { return "in/" + part; });
    """
    assert names(f"{filled} for (const auto & name : all) {{ {publish('name')} }}") == ["/in/a", "/in/b"]
    open_ = "std::set<std::string> all; std::ranges::sort_copy(other, std::inserter(all, all.end()));"
    assert names(f"{open_} for (const auto & name : all) {{ {publish('name')} }}") == ["?"]


def test_objects_that_are_put_into_a_container_without_their_class() -> None:
    filled = 'struct Row { std::string name; int depth; }; std::vector<Row> rows; rows.push_back({"a", 2});'
    [node] = graph_of(f"{filled} for (const auto & row : rows) {{ {publish('row.name', 'row.depth')} }}")
    assert [(end["name"], end["qos"]["depth"]) for end in node["publishers"]] == [("/a", 2)]


@pytest.mark.parametrize(
    ("written", "name"),
    [
        ('std::optional<std::string>("a").value_or("b")', "/a"),
        ('std::optional<std::string>().value_or("b")', "/b"),
        ('std::string("/ns/a").substr(1)', "/ns/a"),
        ('std::string("/ns/a").substr(1, 2)', "/ns"),
        ('std::string("a").append("/b")', "/a/b"),
        ('fmt::format("{}/{:02d}/{name}", "a", 3, fmt::arg("name", "b"))', "/a/03/b"),
        ('fmt::format(FMT_STRING("{}/a"), "b")', "/b/a"),
        ('[]() { char name[]{"a"}; return std::string(name); }()', "/a"),
    ],
)
def test_texts(written: str, name: str) -> None:
    assert names(publish(written)) == [name]


def test_what_an_optional_value_holds_decides() -> None:
    declared = 'std::optional<std::string> some = "a", none = std::nullopt;'
    used = f"if (some.has_value()) {{ {publish('*some')} }} if (none.has_value()) {{ {publish('none.value()')} }}"
    assert names(declared + used) == ["/a"]


def test_a_number_that_a_stream_writes_in_another_way() -> None:
    assert names(f'std::ostringstream text; text << "a" << std::hex << 180; {publish("text.str()")}') == ["?"]


def test_values_that_are_taken_apart() -> None:
    declared = """
    struct Row { std::string name; int depth; };
    auto [first, depth] = Row{"a", 3};
    std::string second; int other;
    std::tie(second, other) = std::make_pair("b", 4);
    std::string third; std::tie(third, std::ignore) = std::make_pair("c", 5);
    """
    [node] = graph_of(declared + publish("first", "depth") + publish("second", "other") + publish("third"))
    assert {(end["name"], end["qos"]["depth"]) for end in node["publishers"]} == {("/a", 3), ("/b", 4), ("/c", 1)}


def test_the_type_of_a_message() -> None:
    declared = f"{STRING} message; "
    made = 'create_publisher<decltype(message)>("a", 1); create_publisher<std::decay_t<decltype(message)>>("b", 1);'
    [node] = graph_of(declared + made)
    assert {(end["name"], end["type"]) for end in node["publishers"]} == {
        ("/a", "std_msgs/msg/String"),
        ("/b", "std_msgs/msg/String"),
    }


PACKS = """
#include "rclcpp/rclcpp.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    open("a", "b");
    make<std_msgs::msg::Int32>("c", 7);
    std::apply([this](auto... names) { open(names...); }, std::make_tuple("d", "e"));
  }
  template <typename... Names> void open(Names... names) { (add(names), ...); }
  void add(const std::string & name) { create_publisher<std_msgs::msg::String>(name, 1); }
  template <typename T, typename... Arguments> auto make(Arguments &&... arguments) {
    return create_publisher<T>(std::forward<Arguments>(arguments)...);
  }
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_parameter_packs() -> None:
    [node] = graph({"src/robot.cpp": PACKS})["nodes"]
    ends = {end["name"]: (end["type"], end["qos"]["depth"]) for end in node["publishers"]}
    assert ends == {
        **{f"/{name}": ("std_msgs/msg/String", 1) for name in "abde"},
        "/c": ("std_msgs/msg/Int32", 7),
    }


def test_a_field_of_a_base_from_elsewhere_may_be_the_node() -> None:
    source = """
    #include "rclcpp/rclcpp.hpp"
    #include "rqt_gui_cpp/plugin.h"
    class Panel : public rqt_gui_cpp::Plugin {
      void initPlugin(qt_gui_cpp::PluginContext & context) override;
    };
    void Panel::initPlugin(qt_gui_cpp::PluginContext & context) {
      node_->create_publisher<std_msgs::msg::String>("panel", 10);
    }
    """
    [node] = graph({"src/panel.cpp": source})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/panel"]


CLEANED = """
#include "rclcpp/rclcpp.hpp"
std::string clean(const std::string & name) {
  std::string text = name;
  size_t at = text.find("//");
  while (at != std::string::npos) {
    text.erase(at, 1);
    at = text.find("//", at);
  }
  return text;
}
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    create_publisher<std_msgs::msg::String>(clean("a/b"), 1);
    create_publisher<std_msgs::msg::String>(clean("a//c"), 1);
  }
};
int main(int argc, char ** argv) { rclcpp::init(argc, argv); rclcpp::spin(std::make_shared<Robot>()); }
"""


def test_a_text_that_is_searched_until_nothing_is_there() -> None:
    [node] = graph({"src/robot.cpp": CLEANED})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/a/b", None]


def test_a_part_of_a_parameter_depends_on_the_parameter() -> None:
    [node] = graph_of(publish('declare_parameter<std::string>("topic", "/ns/a").substr(1)'))
    [end] = node["publishers"]
    assert (end["name"], end["resolution"], end["parameter"]) == ("/ns/a", "parameter", "topic")


@pytest.mark.parametrize(
    ("default", "reliability"),
    [
        ("RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT", "system_default"),
        ("RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT", "best_effort"),
        ("1", "reliable"),
    ],
)
def test_a_parameter_holds_the_number_of_a_policy(default: str, reliability: str) -> None:
    made = f'const int qos = declare_parameter<int>("qos", {default});'
    [node] = graph_of(f"{made} {publish('name', 'rclcpp::QoS(1).reliability((rmw_qos_reliability_policy_t)qos)')}")
    [end] = node["publishers"]
    assert end["qos"]["reliability"] == reliability
    assert [(row["name"], row["type"]) for row in node["parameters"]] == [("qos", "integer")]


LOOKED_UP = 'std::map<std::string, std::string> all{{"left", "l"}, {"right", "r"}}; std::string side = "left";'


@pytest.mark.parametrize(
    ("statements", "found"),
    [
        (f"auto found = all.find(side); if (found != all.end()) {{ {publish('found->second')} }}", ["/l"]),
        (f'const auto found = all.find("right"); {publish("found->second + found->first")}', ["/rright"]),
        (f"auto found = all.find(side); found = all.begin(); {publish('found->second')}", ["?"]),
        (f'auto found = all.find(side); side = "right"; {publish("found->second")}', ["?"]),
        (f'auto found = side.find("e"); {publish("side.substr(found)")}', ["/eft"]),
    ],
)
def test_what_a_map_has_for_a_key(statements: str, found: list[str]) -> None:
    assert names(f"{LOOKED_UP} {statements}") == found


NAMES = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    names_ = {{"left", "l"}, {"right", "r"}};
    create_publisher<std_msgs::msg::String>(names_.at("right"), 1);
    create_publisher<std_msgs::msg::String>(names_["left"], 1);
  }
private:
  std::map<std::string, std::string> names_;
};
"""


def test_a_field_is_given_the_items_of_a_map() -> None:
    [node] = graph({"src/robot.cpp": NAMES})["nodes"]
    assert sorted(end["name"] for end in node["publishers"]) == ["/l", "/r"]


def test_the_type_of_a_parameter_whose_default_is_negative() -> None:
    [node] = graph_of('declare_parameter("low", -0.5); declare_parameter("first", -3);')
    rows = [(row["name"], row["type"], row["default"]) for row in node["parameters"]]
    assert rows == [("low", "double", -0.5), ("first", "integer", -3)]


def test_the_numbers_that_the_library_has_names_for() -> None:
    [node] = graph_of('declare_parameter("turn", M_PI / 2); declare_parameter("back", -M_PI);')
    rows = [(row["name"], row["type"], round(row["default"], 3)) for row in node["parameters"]]
    assert rows == [("turn", "double", 1.571), ("back", "double", -3.142)]


def test_the_type_that_is_written_decides_about_a_parameter() -> None:
    """``declare_parameter<double>`` converts a whole number, and has its type where the default is not known."""
    lines = [
        "int one = 1; double read = measured();",
        'declare_parameter<double>("rate", one);',
        'declare_parameter<double>("speed", read);',
        'declare_parameter<int>("count", counted());',
        'declare_parameter<int>("last", one);',
        'declare_parameter("other", measured());',
    ]
    [node] = graph_of("\n".join(lines))
    rows = {row["name"]: (row["type"], row["default"]) for row in node["parameters"]}
    assert rows == {
        "rate": ("double", 1.0),
        "speed": ("double", None),
        "count": ("integer", None),
        "last": ("integer", 1),
        "other": (None, None),
    }
