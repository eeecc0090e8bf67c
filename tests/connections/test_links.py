"""A link goes from whoever sends to whoever takes it in, be that data or a request."""

from __future__ import annotations

from archlint.connections.links import links
from systems.builders import action_client, action_server, client, node, publisher, service, subscriber, system


def words(*nodes) -> list[str]:
    return [link.words() for link in links(system(*nodes))]


def test_data_goes_from_the_publisher_to_each_subscription():
    assert words(
        node("/lidar", publisher("/scan")),
        node("/mapper", subscriber("/scan")),
        node("/guard", subscriber("/scan")),
    ) == [
        "/lidar publishes '/scan' and /guard subscribes to it",
        "/lidar publishes '/scan' and /mapper subscribes to it",
    ]


def test_a_request_goes_from_the_client_to_the_server():
    assert words(node("/arm", service("/home")), node("/panel", client("/home"))) == [
        "/panel calls the service '/home' and /arm serves it"
    ]
    assert words(node("/base", action_server("/dock")), node("/planner", action_client("/dock"))) == [
        "/planner calls the action '/dock' and /base serves it"
    ]


def test_no_link_leads_back_to_the_same_node():
    assert words(node("/filter", publisher("/points"), subscriber("/points"))) == []


def test_tests_are_no_part_of_the_system():
    assert words(node("/lidar", publisher("/scan")), node("/probe", subscriber("/scan"), test=True)) == []
