"""What a variable of C++ holds: in inner blocks, through references, in copies, and where a character changes.

A name that is not followed is not known (``None``); a wrong one would be worse.
"""

from __future__ import annotations

import re

import pytest
from tests.cpp_nodes import graph

SOURCE = """
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"
struct Config { std::string topic = "scan"; int depth = 3; };
void by_value(std::string t) { t = "wrong"; t += "/x"; }
void by_value_struct(Config c) { c.topic = "wrong"; }
void by_value_vector(std::vector<std::string> v) { v.push_back("wrong"); v[0] = "wrong"; }
void by_ref(std::string & t) { t = "right"; }
void by_ref_struct(Config & c) { c.topic = "right"; }
void by_pointer(Config * c) { c->topic = "right"; }
void by_ref_vector(std::vector<std::string> & v) { v[0] = "right"; }
void by_const(const Config & c) { }
std::string changed(std::string t) { t += "/right"; return t; }
class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") { %s }
  void inner(std::string topic) { topic = "wrong"; }
  std::string topic_ = "scan";
  Config config_;
};
int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
"""


def published(statements: str) -> list[str | None]:
    """The names that a node publishes whose constructor does this; ``publish(name)`` makes a publisher."""
    written = re.sub(r"publish\((.*?)\);", r"create_publisher<std_msgs::msg::String>(\1, 1);", statements)
    [node] = graph({"src/robot.cpp": SOURCE % written})["nodes"]
    return list({end["name"] for end in node["publishers"]})


@pytest.mark.parametrize(
    ("statements", "name"),
    [
        ('std::string t = "scan"; { std::string t = "wrong"; } publish(t);', "/scan"),
        ('std::string t = "wrong"; { std::string t = "scan"; publish(t); }', "/scan"),
        ('std::string t = "scan"; if (std::rand() > 2) { std::string t = "wrong"; t += "x"; } publish(t);', "/scan"),
        ('std::string t = "scan"; if (std::string t = "wrong"; t.empty()) { } publish(t);', "/scan"),
        ('std::string t = "scan"; for (std::string t : {"a", "b"}) { } publish(t);', "/scan"),
        ('std::string t = "scan"; for (int i = 0; i < 2; i++) { std::string t = "wrong"; } publish(t);', "/scan"),
        ('int i = 7; for (int i = 0; i < 2; i++) { } publish("t" + std::to_string(i));', "/t7"),
        ('std::string t = "scan"; while (rclcpp::ok()) { std::string t = "wrong"; } publish(t);', "/scan"),
        ('std::string t = "scan"; auto f = []() { std::string t = "wrong"; }; f(); publish(t);', "/scan"),
        ('std::string t = "scan"; auto f = [](std::string t) { t = "wrong"; }; f("a"); publish(t);', "/scan"),
        (
            'std::string t = "scan"; try { std::string t = "a"; } catch (...) { std::string t = "b"; } publish(t);',
            "/scan",
        ),
        ('std::string t = "scan"; switch (3) { case 3: { std::string t = "wrong"; break; } } publish(t);', "/scan"),
        ('std::string t = "scan"; { std::string u = t; std::string t = "wrong"; publish(u);}', "/scan"),
        ('topic_ = "scan"; { std::string topic_ = "wrong"; } publish(topic_);', "/scan"),
        ('std::string t = "scan"; { std::string t = "a"; { std::string t = "b"; } t += "c"; } publish(t);', "/scan"),
        ('std::string t = "wrong"; { t = "scan"; } publish(t);', "/scan"),
        ('auto t = std::string("scan"); { auto t = std::string("wrong"); } publish(t);', "/scan"),
    ],
)
def test_a_variable_hides_another(statements: str, name: str | None) -> None:
    assert published(statements) == [name]


@pytest.mark.parametrize(
    ("statements", "name"),
    [
        ('std::string t = "scan"; by_value(t); publish(t);', "/scan"),
        ("Config c; by_value_struct(c); publish(c.topic);", "/scan"),
        ('std::vector<std::string> v{"scan"}; by_value_vector(v); publish(v[0]);', "/scan"),
        ('std::vector<std::string> v{"scan"}; by_value_vector(v); for (auto & t : v) publish(t);', "/scan"),
        ('std::string t = "scan"; by_ref(t); publish(t);', "/right"),
        ("Config c; by_ref_struct(c); publish(c.topic);", "/right"),
        ('std::vector<std::string> v{"scan"}; by_ref_vector(v); publish(v[0]);', "/right"),
        ("Config c; by_pointer(&c); publish(c.topic);", "/right"),
        ('std::string t = "scan"; auto u = changed(t); publish(t);', "/scan"),
        ('std::string t = "scan"; auto u = changed(t); publish(u);', "/scan/right"),
        ('std::string t = "scan"; inner(t); publish(t);', "/scan"),
        ("by_value_struct(config_); publish(config_.topic);", "/scan"),
        ('Config c; auto f = [](Config d) { d.topic = "wrong"; }; f(c); publish(c.topic);', "/scan"),
        ('std::string t = "scan"; auto f = [t]() mutable { t = "wrong"; }; f(); publish(t);', "/scan"),
        ('std::string t = "scan"; auto f = [&t]() { t = "right"; }; f(); publish(t);', "/right"),
        ('std::string t = "scan"; auto f = [&]() { t = "right"; }; f(); publish(t);', "/right"),
        ('std::string t = "scan"; auto f = [t, this]() { publish(t); }; t = "wrong"; f();', "/scan"),
    ],
)
def test_what_a_function_is_given(statements: str, name: str | None) -> None:
    assert published(statements) == [name]


@pytest.mark.parametrize(
    ("statements", "name"),
    [
        ('std::string a = "scan"; std::string b = "right"; std::string & r = a; r = b; publish(a);', "/right"),
        (
            'std::string a = "scan"; std::string b = "right"; std::string & r = a; r = b; b = "wrong"; publish(r);',
            "/right",
        ),
        ('std::string a = "scan"; std::string & r = a; a = "right"; publish(r);', "/right"),
        ('std::string a = "scan"; std::string & r = a; r += "/right"; publish(a);', "/scan/right"),
        ('std::string a = "scan"; auto & r = a; r.append("/right"); publish(a);', "/scan/right"),
        ('Config a; Config b; b.topic = "right"; Config & r = a; r = b; publish(a.topic);', "/right"),
        ('Config a; Config b; b.topic = "right"; Config & r = a; r = b; r.topic = "x"; publish(b.topic);', "/right"),
        ('auto & r = config_; r.topic = "right"; publish(config_.topic);', "/right"),
        ('auto & r = topic_; r = "right"; publish(topic_);', "/right"),
        ('std::string & r = config_.topic; r = "right"; publish(config_.topic);', None),
        ('std::string a = "scan"; const auto & r = a; a = "right"; publish(r);', "/right"),
        ('std::vector<std::string> v{"scan"}; auto & r = v[0]; r = "right"; publish(v[0]);', None),
        ('std::vector<Config> v(1); auto & r = v[0]; r.topic = "right"; publish(v[0].topic);', None),
        ('std::vector<std::string> v{"scan"}; v.back() = "right"; publish(v[0]);', "/right"),
        ('std::vector<std::string> v{"scan"}; v.front() += "right"; publish(v[0]);', "/scanright"),
        ('std::vector<std::string> v{"scan"}; v.at(0) = "right"; publish(v[0]);', "/right"),
        ('std::string a = "scan"; std::string * r = &a; *r = "right"; publish(a);', None),
        ('std::string a = "scan"; auto r = &a; r->append("/right"); publish(a);', None),
        (
            'Config a; Config b; b.topic = "right"; Config * r = &a; r = &b; r->topic = "wrong"; publish(a.topic);',
            "/scan",
        ),
    ],
)
def test_a_reference_or_a_pointer(statements: str, name: str | None) -> None:
    assert published(statements) == [name]


@pytest.mark.parametrize(
    ("statements", "name"),
    [
        ("std::string t = \"scan\"; t[0] = 'x'; publish(t);", None),
        ("std::string t = \"scan\"; t.at(0) = 'x'; publish(t);", None),
        ("topic_[0] = 'x'; publish(topic_);", None),
        ("std::string t = \"scan\"; t.front() = 'x'; publish(t);", None),
        ("std::string t = \"scan\"; t.back() = 'x'; publish(t);", None),
        ('std::string t = "scan"; for (auto & c : t) { c = std::toupper(c); } publish(t);', None),
        (
            "std::string t = \"sc.an\"; for (size_t i = 0; i < 5; i++) { if (t[i] == '.') t[i] = '_'; } publish(t);",
            None,
        ),
        ('std::string t = "scan"; std::transform(t.begin(), t.end(), t.begin(), ::toupper); publish(t);', None),
        ("std::string t = \"sc.an\"; std::replace(t.begin(), t.end(), '.', '_'); publish(t);", None),
        ('std::string t = "scan"; std::reverse(t.begin(), t.end()); publish(t);', None),
        ("std::string t = \"scan\"; t.erase(std::remove(t.begin(), t.end(), 'a'), t.end()); publish(t);", None),
        ('std::string a = "scan"; std::string b = "right"; std::swap(a, b); publish(a);', "/right"),
        ('std::string a = "scan"; std::string b = "right"; a.swap(b); publish(b);', "/scan"),
        ('char t[20] = "scan"; strcat(t, "/right"); publish(t);', "/scan/right"),
    ],
)
def test_a_text_is_changed_in_places(statements: str, name: str | None) -> None:
    assert published(statements) == [name]


@pytest.mark.parametrize(
    ("statements", "name"),
    [
        ('Config a; Config b = a; b.topic = "wrong"; publish(a.topic);', "/scan"),
        ('Config a; Config b; b = a; b.topic = "wrong"; publish(a.topic);', "/scan"),
        ('Config a; Config b; a.topic = "right"; b = a; publish(b.topic);', "/right"),
        ('Config a; Config b; b = a; a.topic = "wrong"; publish(b.topic);', "/scan"),
        ('Config a; a.topic = "right"; config_ = a; a.topic = "wrong"; publish(config_.topic);', "/right"),
        ('Config a; a = config_; a.topic = "wrong"; publish(config_.topic);', "/scan"),
        ('Config a; a = {"right", 2}; publish(a.topic);', None),
        ('Config a; a = Config{"right", 2}; publish(a.topic);', "/right"),
        ('config_ = Config{"right", 2}; publish(config_.topic);', "/right"),
        ('std::vector<Config> v(2); Config a; v[0] = a; a.topic = "wrong"; publish(v[0].topic);', None),
        ('std::vector<Config> v(2); Config a = v[0]; a.topic = "wrong"; publish(v[0].topic);', None),
        ('std::map<std::string, Config> m; Config a; m["x"] = a; a.topic = "wrong"; publish(m["x"].topic);', "/scan"),
        ('std::vector<std::string> v{"scan"}; auto w = v; w[0] = "wrong"; publish(v[0]);', "/scan"),
        (
            'std::vector<std::string> v{"scan"}; std::vector<std::string> w; w = v; w[0] = "wrong"; publish(v[0]);',
            "/scan",
        ),
        (
            'std::map<std::string, std::string> v{{"a", "scan"}}; auto w = v; w["a"] = "wrong"; publish(v["a"]);',
            "/scan",
        ),
        ('std::array<std::string, 2> v{"scan", "b"}; auto w = v; w[0] = "wrong"; publish(v[0]);', "/scan"),
        ('std::string v[2] = {"scan", "b"}; v[0] = "right"; publish(v[0]);', "/right"),
    ],
)
def test_a_copy_is_changed_for_itself(statements: str, name: str | None) -> None:
    assert published(statements) == [name]
