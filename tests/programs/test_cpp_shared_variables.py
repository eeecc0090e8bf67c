"""Variables at the top of a file of C++: what a function assigns to one, every file reads that has it."""

from __future__ import annotations

import pytest
from tests.programs.test_cpp_declared import names, publish

LOAD = """
void load(rclcpp::Node & node) {
  node.declare_parameter<std::string>("topic", "scan");
  node.get_parameter("topic", topic);
}
"""


def test_a_function_of_the_file_that_defines_it_reads_a_parameter_into_it() -> None:
    header = "extern std::string topic; void load(rclcpp::Node & node);"
    assert names(header, f"std::string topic; {LOAD}", "load(*this); " + publish("topic")) == ["/scan"]


def test_a_reader_has_what_it_holds_at_that_time() -> None:
    header = "extern std::string topic; void load(rclcpp::Node & node);"
    source = f'std::string topic = "first"; {LOAD}'
    assert names(header, source, publish("topic") + " load(*this); " + publish("topic")) == ["/first", "/scan"]


def test_what_is_assigned_on_one_of_two_paths_is_one_of_two() -> None:
    header = "extern std::string topic; void load(bool simulated);"
    source = 'std::string topic = "scan"; void load(bool simulated) { if (simulated) topic = "scan_raw"; }'
    asked = 'load(declare_parameter<int>("number", 0) > std::rand()); ' + publish("topic")
    assert names(header, source, asked) == ["/scan", "/scan_raw"]


def test_the_file_that_defines_it_reads_what_others_assign() -> None:
    header = "extern std::string topic; std::string topic_of(const std::string & part);"
    source = """
    std::string topic = "first";
    std::string topic_of(const std::string & part) { return topic + "/" + part; }
    """
    assert names(header, source, 'topic = "second"; ' + publish('topic_of("a")')) == ["/second/a"]


@pytest.mark.parametrize("written", ["", "inline "])
def test_a_function_of_the_header_assigns_to_a_variable_of_the_header(written: str) -> None:
    header = f'{written}std::string topic = "first"; inline void load() {{ topic = "scan"; }}'
    assert names(header, "", publish("topic") + " load(); " + publish("topic")) == ["/first", "/scan"]


def test_another_source_assigns_to_a_variable_of_the_header() -> None:
    header = 'inline std::string topic = "first"; void load();'
    source = 'void load() { topic = "scan"; }'
    assert names(header, source, "load(); " + publish("topic")) == ["/scan"]


def test_a_variable_of_a_namespace() -> None:
    header = "namespace topics { extern std::string scan; void load(); }"
    inside = 'namespace topics { std::string scan = "first"; void load() { scan = "second"; } }'
    outside = 'std::string topics::scan = "first"; void topics::load() { scan = "second"; }'
    for source in (inside, outside):
        assert names(header, source, "topics::load(); " + publish("topics::scan")) == ["/second"]


def test_variables_of_one_name_in_two_namespaces() -> None:
    header = """
    namespace left { extern std::string topic; void load(); }
    namespace right { extern std::string topic; void load(); }
    """
    source = """
    namespace left { std::string topic = "a"; void load() { topic = "b"; } }
    namespace right { std::string topic = "c"; void load() { topic = "d"; } }
    """
    asked = publish("left::topic", "right::topic")
    assert names(header, source, asked) == ["/a", "/c"]
    assert names(header, source, "left::load(); " + asked) == ["/b", "/c"]
    assert names(header, source, 'right::topic = "e"; ' + asked) == ["/a", "/e"]


def test_a_function_fills_one_that_it_is_given() -> None:
    header = "extern std::string topic; void load();"
    source = """
    std::string topic = "first";
    static void fill(std::string & name) { name = "second"; }
    void load() { fill(topic); }
    """
    assert names(header, source, "load(); " + publish("topic")) == ["/second"]


def test_a_variable_that_nothing_here_defines() -> None:
    header = "extern std::string topic;"
    assert names(header, "", publish("topic")) == [None]
    assert names(header, "", 'topic = "scan"; ' + publish("topic")) == ["/scan"]


def test_a_source_has_a_variable_of_that_name_of_its_own() -> None:
    header = 'namespace topics { inline std::string scan = "first"; } void load();'
    source = 'static std::string scan; void load() { scan = "second"; }'
    assert names(header, source, "load(); " + publish("topics::scan")) == ["/first"]
