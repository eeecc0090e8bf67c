"""Nodes, parameters, interfaces and launch files."""

from __future__ import annotations

import pytest

from archlint.comparing.compare import compare
from archlint.comparing.graphs import UnreadableGraph, read_graph
from small_systems import changes, end, node, parameter, system, told

TALKER = node("/talker", publishers=[end("/words")])


def test_a_node_that_is_new():
    found = told(system(), system(TALKER))
    assert found[0] == "safe added node /talker: nothing that was there is touched"
    assert found[1].startswith("safe added publisher /words")


def test_a_node_that_others_need_is_gone():
    listener = node("/listener", subscribers=[end("/words")])
    assert told(system(TALKER, listener), system(listener)) == [
        "breaking removed node /talker: others still use /words",
        "breaking removed publisher /words: /listener still subscribes to it, and no node here offers it",
    ]


def test_a_node_of_the_same_class_has_another_name():
    [change] = changes(system(TALKER), system({**TALKER, "name": "/speaker"}))
    assert (change.status, change.before, change.after, change.impact) == ("renamed", "/talker", "/speaker", "risky")


def test_two_nodes_of_a_class_may_be_either():
    pair = [{**TALKER, "name": name} for name in ("/left", "/right", "/front", "/back")]
    found = changes(system(*pair[:2]), system(*pair[2:]))
    assert {change.status for change in found if change.subject == "node"} == {"removed", "added"}


@pytest.mark.parametrize(
    ("overrides", "impact"), [(["rate"], "breaking"), ([], "risky")], ids=["a file sets it", "no file sets it"]
)
def test_a_parameter_is_gone(overrides, impact):
    before = system(node("/talker", parameters=[parameter("rate", 1.0)]))
    after = system(node("/talker", parameters=[parameter("speed", 1.0)], overrides=overrides))
    assert [(c.impact, c.status, c.name) for c in changes(before, after)] == [
        (impact, "removed", "rate"),
        ("safe", "added", "speed"),
    ]


def test_type_and_default_of_a_parameter():
    before = system(node("/talker", parameters=[parameter("rate", 1, "integer")]))
    after = system(node("/talker", parameters=[parameter("rate", 2.0)]))
    assert [(c.impact, c.aspect, c.before, c.after) for c in changes(before, after)] == [
        ("breaking", "type", "integer", "double"),
        ("risky", "default", "1", "2.0"),
    ]


def interface(*fields: tuple[str, str], constants: tuple[tuple[str, str, int], ...] = ()) -> dict:
    return {
        "name": "robot/msg/State",
        "file": "robot/msg/State.msg",
        "fields": [{"section": "message", "name": name, "type": type, "line": 1} for type, name in fields],
        "constants": [
            {"section": "message", "name": name, "type": type, "line": 1, "value": value}
            for type, name, value in constants
        ],
    }


@pytest.mark.parametrize(
    ("after", "expected"),
    [
        (interface(("bool", "on")), ["breaking removed speed"]),
        (interface(("bool", "on"), ("float32", "speed")), ["breaking changed speed"]),
        (interface(("bool", "on"), ("float64", "speed"), ("string", "name")), ["risky added name"]),
        (interface(("float64", "speed"), ("bool", "on")), ["risky changed robot/msg/State"]),
        (
            interface(("bool", "on"), ("float64", "speed"), constants=(("uint8", "IDLE", 0),)),
            ["safe added IDLE"],
        ),
    ],
)
def test_fields(after, expected):
    before = interface(("bool", "on"), ("float64", "speed"))
    found = changes(system(interfaces=[before]), system(interfaces=[after]))
    assert [f"{c.impact} {c.status} {c.name}" for c in found] == expected


def test_an_interface_that_a_node_uses_is_gone():
    user = node("/talker", publishers=[end("/state", "robot/msg/State")])
    assert told(system(user, interfaces=[interface()]), system(user)) == [
        "breaking removed interface robot/msg/State: /talker still uses it"
    ]


def argument(name: str, default: str | None, *choices: str) -> dict:
    return {
        "name": name,
        "required": default is None,
        "default": default,
        "choices": list(choices),
        "file": "robot.launch.py",
        "line": 4,
    }


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        ([], [argument("sim", "false")], ["safe added"]),
        ([], [argument("sim", None)], ["breaking added"]),
        ([argument("sim", "false")], [], ["risky removed"]),
        ([argument("sim", "false")], [argument("sim", None)], ["breaking changed"]),
        ([argument("sim", "false")], [argument("sim", "true")], ["risky changed"]),
        ([argument("mode", "a", "a", "b")], [argument("mode", "a", "a")], ["breaking changed"]),
        ([argument("mode", "a", "a")], [argument("mode", "a", "a", "b")], ["safe changed"]),
    ],
)
def test_launch_arguments(before, after, expected):
    old, new = (system(name="robot.launch.py", launch_arguments=rows) for rows in (before, after))
    assert [f"{change.impact} {change.status}" for change in changes(old, new)] == expected


def test_a_remapping_moves_an_end():
    old, new = (
        node("/talker", publishers=[end(name, written="words")], remappings=[{"from": "words", "to": name}])
        for name in ("/left", "/right")
    )
    found = changes(system(old, name="robot.launch.py"), system(new, name="robot.launch.py"))
    assert [(c.subject, c.status, c.before, c.after) for c in found] == [
        ("publisher", "renamed", "/left", "/right"),
        ("remapping", "changed", "/left", "/right"),
    ]


def test_what_one_edit_does_in_two_systems_is_one_change():
    """In the launch file the node is in a namespace, and another one listens there."""
    launched = {**node("/arm/talker", publishers=[end("/arm/words", written="words")]), "class": "Talker"}
    listener = node("/arm/listener", subscribers=[end("/arm/words", written="words")])
    before = [system(TALKER), system(launched, listener, name="arm.launch.py")]
    after = [system(node("/talker")), system({**launched, "publishers": []}, listener, name="arm.launch.py")]
    [change] = compare(before, after).changes
    assert (change.impact, change.name, change.others) == ("breaking", "/arm/words", ("/words",))
    assert change.systems == ("arm.launch.py", None)


def test_a_launched_node_has_the_names_of_its_launch_files():
    """The code no longer writes the namespace, and the launch file gives it: nothing has another name."""
    launched = [node("/talker", publishers=[end("/arm/words", written=name)]) for name in ("/arm/words", "words")]
    alone = [{**launched[0]}, node("/talker", publishers=[end("/words", resolution="parameter", parameter="topic")])]
    alone[0]["publishers"] = [end("/arm/words", resolution="parameter", parameter="topic")]
    before, after = (
        [system(every), system(started, name="arm.launch.py")] for every, started in zip(alone, launched, strict=True)
    )
    assert compare(before, after).changes == ()
    assert [change.status for change in compare(before[:1], after[:1]).changes] == ["renamed"]


def test_launch_files_come_and_go():
    found = compare([system(), system(name="old.launch.py")], [system(), system(name="new.launch.py")]).changes
    assert [(c.status, c.name, c.impact) for c in found] == [
        ("removed", "old.launch.py", "risky"),
        ("added", "new.launch.py", "safe"),
    ]


# --- saved graphs


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("{", "it is not JSON"),
        ("[]", "it is not what `archlint graph --format json` writes"),
        ('{"version": 1}', "it is not what `archlint graph --format json` writes"),
        ('{"version": 0, "nodes": []}', "it has version 0 of the graph, and this archlint reads version 1"),
        ('{"version": 1, "nodes": []}', "an older archlint wrote it"),
    ],
)
def test_files_that_are_no_graph(text, why):
    with pytest.raises(UnreadableGraph, match=why):
        read_graph(text.encode())
