"""Sub-nodes of C++.  Source of what is expected: ``extend_name_with_sub_namespace`` of ``rclcpp/node_impl.hpp``."""

from __future__ import annotations

import pytest
from tests.cpp_nodes import graph_of

CREATE = 'create_publisher<std_msgs::msg::String>("%s", 10);'


@pytest.mark.parametrize(("written", "name"), [("x", "/arm/x"), ("/x", "/x"), ("~/x", "/robot/x")])
def test_relative_names_are_below_the_sub_node(written: str, name: str) -> None:
    [node] = graph_of('auto arm = create_sub_node("arm"); arm->' + CREATE % written)
    assert (node["name"], [end["name"] for end in node["publishers"]]) == ("/robot", [name])
    assert node["complete"]


def test_a_sub_node_of_a_sub_node() -> None:
    [node] = graph_of('auto hand = create_sub_node("arm")->create_sub_node("hand"); hand->' + CREATE % "x")
    assert [end["name"] for end in node["publishers"]] == ["/arm/hand/x"]


def test_all_share_the_parameters_of_the_node() -> None:
    [node] = graph_of('auto arm = create_sub_node("arm"); arm->declare_parameter("gain", 1.0);')
    assert [parameter["name"] for parameter in node["parameters"]] == ["gain"]


def test_a_sub_node_whose_name_is_not_known() -> None:
    [node] = graph_of("auto arm = create_sub_node(acme::name()); arm->" + CREATE % "x" + CREATE % "y")
    assert [end["name"] for end in node["publishers"]] == ["/*/x", "/y"]
