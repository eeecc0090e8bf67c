"""Texts and containers of C++ that a call changes in place."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph, graph_of

STRING = "std_msgs::msg::String"
FIELD = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
%s
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s create_publisher<std_msgs::msg::String>(topic_, 1); }
private:
  std::string topic_ = "scan";
  std::vector<std::string> more_{"a"};
};
"""


def names(statements: str) -> list[str | None]:
    """What a node publishes whose constructor does this."""
    [node] = graph_of(statements)
    return sorted(end["name"] or "?" for end in node["publishers"])


def of_field(statements: str, before: str = "") -> list[str | None]:
    """What a node publishes that does this to a field, whose type its method does not see."""
    [node] = graph({"src/robot.cpp": FIELD % (before, statements)})["nodes"]
    return [end["name"] for end in node["publishers"]]


@pytest.mark.parametrize(
    ("change", "name"),
    [
        ('append("/raw")', "/scan/raw"),
        ("push_back('s')", "/scans"),
        ('assign("map")', "/map"),
        ('insert(0, "arm/")', "/arm/scan"),
        ("pop_back()", "/sca"),
        ("erase(0, 1)", "/can"),
        ("erase(2)", "/sc"),
        ('replace(0, 1, "z")', None),
        ('insert(2, "z")', None),
        ('append("z", 1)', None),
        ("resize(2)", None),
        ("swap(other)", None),
    ],
)
def test_a_text_is_changed(change: str, name: str | None) -> None:
    assert of_field(f"topic_.{change};") == [name]
    local = f'std::string topic = "scan"; topic.{change}; create_publisher<{STRING}>(topic, 1);'
    assert names(local) == [name or "?"]


def test_a_text_that_a_loop_changes_is_not_known() -> None:
    assert of_field("while (std::rand() > 5) { topic_.pop_back(); }") != ["/scan"]
    loops = ("while (topic.back() == 'n') { topic.pop_back(); }", "do { topic.pop_back(); } while (std::rand() > 5);")
    for loop in loops:
        made = f'std::string topic = "scan"; {loop} create_publisher<{STRING}>(topic, 1);'
        assert names(made) == ["?"]


def test_a_text_that_is_one_of_two() -> None:
    assert of_field('if (std::rand() > 5) { topic_ = "map"; } topic_.append("/raw");') == ["/map/raw", "/scan/raw"]
    assert of_field('if (std::rand() > 5) { topic_ = "map"; } topic_.insert(0, "x/");') == ["/x/map", "/x/scan"]


def test_a_text_of_the_file() -> None:
    before = 'std::string base = "base"; void extend() { base.append("/arm"); }'
    assert of_field("extend(); topic_ = base;", before) == ["/base/arm"]


def test_a_stream_is_given_another_text() -> None:
    made = 'std::stringstream text; text << "a"; text.str(""); text << "b" << 1;'
    assert names(f"{made} create_publisher<{STRING}>(text.str(), 1);") == ["/b1"]


@pytest.mark.parametrize(
    ("changed", "name"),
    [
        ("std::swap(first, second);", "/b"),
        ('std::exchange(first, "c");', "/c"),
        ("first.swap(second);", "/b"),
    ],
)
def test_variables_are_exchanged(changed: str, name: str) -> None:
    assert names(f'std::string first = "a", second = "b"; {changed} create_publisher<{STRING}>(first, 1);') == [name]


def test_a_text_is_copied_into_an_array() -> None:
    made = 'char name[20] = "a"; std::strcpy(name, "b"); char other[20]; strncpy(other, "c", sizeof(other));'
    assert names(f"{made} create_publisher<{STRING}>(name, 1); create_publisher<{STRING}>(other, 1);") == ["/b", "/c"]


@pytest.mark.parametrize(
    "filled",
    [
        'std::vector<std::string> more{"a", "b"}, all; all.insert(all.end(), more.begin(), more.end());',
        'std::vector<std::string> more{"a", "b"}, all{"c"}; all.assign(more.cbegin(), more.cend());',
        'std::vector<std::string> more{"a", "b"}, all; copy(more.begin(), more.end(), back_inserter(all));',
    ],
)
def test_the_items_of_another_container_are_put_into_one(filled: str) -> None:
    assert names(f"{filled} for (const auto & name : all) {{ create_publisher<{STRING}>(name, 1); }}") == ["/a", "/b"]


@pytest.mark.parametrize(
    "filled",
    [
        "copy(std::istream_iterator<std::string>(given), std::istream_iterator<std::string>(), back_inserter(all));",
        'boost::split(all, given, boost::is_any_of(","));',
        "fill(all);",
        "all.assign(given.begin(), given.begin() + 2);",
    ],
)
def test_a_container_that_something_else_fills_may_hold_anything(filled: str) -> None:
    made = f"std::vector<std::string> all; {filled} if (!all.empty()) {{ create_publisher<{STRING}>(all[0], 1); }}"
    assert names(made) == ["?"]


def test_a_container_that_has_items_keeps_them() -> None:
    made = 'std::vector<std::string> all{"a"}; RCLCPP_INFO(get_logger(), "%zu", all.size()); show(all);'
    assert names(f"{made} for (const auto & name : all) {{ create_publisher<{STRING}>(name, 1); }}") == ["/a"]


POINTER = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
class Driver {
public:
  void open() {
    node_.reset(new rclcpp::Node("driver"));
    node_->create_publisher<std_msgs::msg::String>("scan", 1);
  }
  std::shared_ptr<rclcpp::Node> node_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  Driver driver;
  driver.open();
  rclcpp::spin(driver.node_);
}
"""


def test_a_pointer_holds_what_it_is_given_anew() -> None:
    [node] = graph({"src/robot.cpp": POINTER})["nodes"]
    assert (node["name"], [end["name"] for end in node["publishers"]]) == ("/driver", ["/scan"])


def test_a_pointer_of_a_function_holds_what_it_is_given_anew() -> None:
    made = "std::unique_ptr<Names> all; all.reset(new Names()); create_publisher<std_msgs::msg::String>(all->scan, 1);"
    [node] = graph({"src/robot.cpp": FIELD % ('struct Names { std::string scan = "scan"; };', made)})["nodes"]
    assert [end["name"] for end in node["publishers"]] == ["/scan", "/scan"]


def test_a_timer_that_is_started_anew_is_the_same() -> None:
    made = 'auto timer = create_wall_timer(1s, [] {}); timer->reset(); topic_ = "map";'
    assert of_field(made) == ["/map"]


@pytest.mark.parametrize(
    ("loop", "found"),
    [
        ('for (auto & name : all) { name = "arm/" + name; }', ["/arm/a", "/arm/b"]),
        ('for (std::string & name : all) { name += "/raw"; }', ["/a/raw", "/b/raw"]),
        ('for (auto & name : all) { name.insert(0, "arm/"); }', ["?"]),
        ('for (auto & name : all) { if (name == "a") continue; name = "arm/" + name; }', ["?"]),
        ('for (auto name : all) { name = "arm/" + name; }', ["/a", "/b"]),
        ("for (const auto & name : all) { if (name == other) { use(name); } }", ["/a", "/b"]),
    ],
)
def test_a_loop_changes_the_items_that_it_goes_through(loop: str, found: list[str]) -> None:
    made = f'std::vector<std::string> all{{"a", "b"}}; std::string other; {loop}'
    assert names(f"{made} for (const auto & name : all) {{ create_publisher<{STRING}>(name, 1); }}") == found


@pytest.mark.parametrize(
    ("made", "first", "second"),
    [
        ("auto other = qos;", "reliable", "best_effort"),
        ("rclcpp::QoS other = qos;", "reliable", "best_effort"),
        ("rclcpp::QoS other(qos);", "reliable", "best_effort"),
        ("auto & other = qos;", "best_effort", "best_effort"),
    ],
)
def test_a_copy_of_a_profile_is_changed_for_itself(made: str, first: str, second: str) -> None:
    published = f'create_publisher<{STRING}>("a", qos); create_publisher<{STRING}>("b", other);'
    [node] = graph_of(f"rclcpp::QoS qos(10); {made} other.best_effort(); {published}")
    ends = sorted(node["publishers"], key=lambda end: end["name"])
    assert [end["qos"]["reliability"] for end in ends] == [first, second]


CONFIGURED = 'struct Base { int depth = 3; }; struct Config : Base { std::string topic = "scan"; };'


@pytest.mark.parametrize(
    ("made", "name", "depth"),
    [
        ('auto other = config; other.topic = "map"; other.depth = 4;', "/scan", 3),
        ('Config other = config; other.topic = "map"; other.depth = 4;', "/scan", 3),
        ('auto & other = config; other.topic = "map"; other.depth = 4;', "/map", 4),
    ],
)
def test_a_copy_of_an_object_is_changed_for_itself(made: str, name: str, depth: int) -> None:
    statements = f"Config config; {made} create_publisher<{STRING}>(config.topic, config.depth);"
    [node] = graph({"src/robot.cpp": FIELD % (CONFIGURED, statements)})["nodes"]
    found = {(end["name"], end["qos"]["depth"]) for end in node["publishers"]}
    assert found == {(name, depth), ("/scan", 1)}  # the latter is that of the field


def test_a_pointer_that_is_copied_leads_to_the_same() -> None:
    made = (
        'auto config = std::make_shared<Config>(); auto other = config; other->topic = "map"; topic_ = config->topic;'
    )
    assert of_field(made, CONFIGURED) == ["/map"]


def test_a_container_of_objects_holds_copies() -> None:
    opened = f"node->create_publisher<{STRING}>(row.topic, 2);"
    rows = f"{CONFIGURED} void open(rclcpp::Node * node, const Config & row) {{ {opened} }}"
    made = """
    std::vector<Config> all; Config row;
    row.topic = "a"; all.push_back(row);
    row.topic = "b"; all.push_back(row);
    for (const auto & each : all) { open(this, each); }
    """
    [node] = graph({"src/robot.cpp": FIELD % (rows, made)})["nodes"]
    assert sorted(end["name"] for end in node["publishers"]) == ["/a", "/b", "/scan"]


@pytest.mark.parametrize(
    ("kind", "made"),
    [("std::shared_ptr<Config>", "std::make_shared<Config>()"), ("Config *", "new Config()")],
)
def test_a_container_of_pointers_holds_the_same(kind: str, made: str) -> None:
    filled = f"""
    std::vector<{kind}> all; auto row = {made};
    all.push_back(row); row->topic = "b";
    for (const auto & each : all) {{ topic_ = each->topic; }}
    """
    assert of_field(filled, CONFIGURED) == ["/b"]
