"""``fixtures/launched``: every final name of a fleet, as its launch files and sources say it."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config.settings import Settings
from archlint.engine.pipeline import Request, graph
from archlint.systems.model import Node, System

FIXTURE = Path(__file__).parents[2] / "fixtures" / "launched"


@pytest.fixture
def fleet(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(FIXTURE)

    def start(**arguments: str) -> System:
        launch = "src/patrol/launch/fleet.launch.py"
        given = tuple(arguments.items())
        return graph(Request((".",), Settings(), cached=False, jobs=1, launch=launch, launch_arguments=given))

    return start


def endpoints(system: System, name: str) -> list[tuple[str, str | None]]:
    return [(endpoint.kind, endpoint.name) for endpoint in one(system, name).endpoints]


def one(system: System, name: str) -> Node:
    (found,) = [node for node in system.nodes if node.name == name]
    return found


def test_nodes_have_the_name_and_the_namespaces_that_surround_them(fleet):
    assert [node.name for node in fleet().nodes] == [
        "/north/base/wheels",  # renamed by the XML file, in its namespace under the one that the group pushes
        "/north/scanner",  # no name in the launch file: that of the source
        "/recorder",  # after both groups: their namespaces have ended with them
        "/south/base/wheels",
        "/south/scanner",
        "/tools/bag",
    ]


def test_a_parameter_file_reaches_the_node_whose_namespace_its_key_has(fleet):
    system = fleet()
    assert endpoints(system, "/north/scanner") == [("publisher", "/north/front/scan")]
    assert endpoints(system, "/south/scanner") == [("publisher", "/south/scan")]


def test_a_remapping_leads_out_of_the_namespace_and_a_private_name_follows_the_new_name(fleet):
    system = fleet()
    assert endpoints(system, "/north/base/wheels") == [
        ("publisher", "/north/base/wheels/state"),
        ("subscriber", "/north/front/scan"),
    ]
    assert endpoints(system, "/south/base/wheels") == [
        ("publisher", "/south/base/wheels/state"),
        ("subscriber", "/south/scan"),
    ]


def test_the_robots_share_no_topic(fleet):
    names: dict[str, set[str | None]] = {"north": set(), "south": set()}
    for node in fleet().nodes:
        robot = (node.name or "").split("/")[1]
        if robot in names:
            names[robot] |= {endpoint.name for endpoint in node.endpoints}
    assert names["north"] and names["south"] and not names["north"] & names["south"]


def test_the_recorder_hears_both_robots(fleet):
    assert endpoints(fleet(), "/recorder") == [
        ("subscriber", "/north/base/wheels/state"),
        ("subscriber", "/south/base/wheels/state"),
    ]


def test_a_node_from_elsewhere_is_there_with_its_remapping(fleet):
    bag = one(fleet(), "/tools/bag")
    assert bag.external and bag.started is not None
    assert [(remap.source.text, remap.target.text) for remap in bag.started.remaps] == [("events/write_split", "split")]


def test_an_argument_decides_the_condition(fleet):
    assert [node.name for node in fleet(record="false").nodes] == [
        "/north/base/wheels",
        "/north/scanner",
        "/south/base/wheels",
        "/south/scanner",
    ]
