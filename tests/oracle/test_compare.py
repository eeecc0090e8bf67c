"""Scores: what counts as found, right, missed and wrong."""

from __future__ import annotations

from benchmarks.accuracy.compare import compare

QOS = {"history": "keep_last", "depth": 10, "reliability": "reliable", "durability": "volatile"}


def seen(name, line=1, **more):
    return {
        "kind": "publisher", "file": "node.py", "line": line, "name": name, "type": "std_msgs/msg/String",
        "qos": QOS, "phase": "main", **more,
    }  # fmt: skip


def read(name, line=1, resolution="exact", **more):
    return {
        "file": "node.py", "line": line, "name": name, "resolution": resolution,
        "type": "std_msgs/msg/String", "qos": QOS, **more,
    }  # fmt: skip


def score(entities, publishers, unresolved=()):
    graph = {"nodes": [{"name": "/n", "publishers": publishers}], "unresolved": list(unresolved)}
    return compare({"entities": entities}, graph)


def test_all_right():
    result = score([seen("/a")], [read("/a")])
    total = result.total
    assert (total.entities, total.found, total.right_name, total.right_type, total.right_qos) == (
        1,
        1,
        1,
        1,
        1,
    )
    assert result.misses == result.wrong == []


def test_a_pattern_is_a_miss_and_not_wrong():
    result = score([seen("/a/b")], [read("/*/b", resolution="partial")])
    assert (result.total.found, result.total.right_name, result.total.wrong_sites) == (1, 0, 0)
    assert result.misses == ["node.py:1 publisher /a/b: name is /*/b (partial)"]


def test_another_name_is_wrong():
    result = score([seen("/a")], [read("/b")])
    assert result.total.wrong_sites == 1
    assert result.wrong == ["node.py:1 publisher: the run gives /a, read as /b"]


def test_one_of_several_names_is_not_wrong():
    result = score([seen("/a")], [read("/a"), read("/b")])
    assert (result.total.right_name, result.total.wrong_sites) == (1, 0)


def test_an_unresolved_endpoint_is_found():
    result = score([seen("/a")], [], [{"kind": "publisher", "file": "node.py", "line": 1, "reason": "a file"}])
    assert (result.total.found, result.total.right_name) == (1, 0)


def test_nothing_there_is_not_found():
    result = score([seen("/a", line=3)], [read("/a", line=4)])
    assert result.total.found == 0
    assert result.unseen == ["node.py:4 publisher /a"]


def test_a_name_that_the_run_does_not_know_is_not_asked():
    result = score([seen(None, pattern="/*/a")], [read("/b")])
    assert (result.total.named, result.total.wrong_sites) == (0, 0)


def test_each_entity_is_held_to_the_endpoint_of_its_name():
    lasting = {**QOS, "durability": "transient_local"}
    result = score([seen("/a"), seen("/b", qos=lasting)], [read("/a"), read("/b", qos=QOS)])
    assert (result.total.profiled, result.total.right_qos) == (2, 1)


def test_test_code_is_left_out():
    assert score([seen("/a", file="test/test_node.py")], []).total.entities == 0
