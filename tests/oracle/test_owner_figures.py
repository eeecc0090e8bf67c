"""Right owner and phantom nodes: what counts as which."""

from __future__ import annotations

from pathlib import Path

from benchmarks.accuracy.compare import LISTS
from benchmarks.accuracy.owners import owned, phantoms


def made(class_="Talker", name="/talker", line=1, **more):
    classes = [f"node.py:{class_}"] if class_ != "Node" else []
    place = {"file": "node.py", "line": line, "end_line": line}
    return {"class": class_, "node": name, "classes": classes, **place, **more}


def ran(class_="Talker", node="/talker", line=5, phase="main"):
    return {"kind": "publisher", "file": "node.py", "line": line, "class": class_, "node": node, "phase": phase}


def entry(class_="Talker", name="/talker", line=1, endpoints=(5,), **more):
    publishers = [{"file": "node.py", "line": each} for each in endpoints]
    return {"class": class_, "name": name, "file": "node.py", "line": line, "publishers": publishers, **more}


def right(nodes, entities, entries):
    rows = owned({"nodes": nodes, "entities": entities}, {"nodes": entries}, LISTS)
    return [verdict for _, _, verdict in rows]


def test_the_node_itself_is_right():
    assert right([made()], [ran()], [entry()]) == [True]


def test_another_node_is_not():
    assert right([made()], [ran()], [entry(endpoints=()), entry("Helper", "/helper")]) == [False]


def test_what_is_no_node_owns_nothing():
    assert right([made()], [ran()], [entry("Helper", None, is_node=False)]) == [False]


def test_the_class_tells_where_a_name_is_not_known():
    assert right([made(name="/robot_*")], [ran(node="/robot_*")], [entry(name=None)]) == [True]


def test_two_nodes_of_one_class_are_told_apart_by_name():
    nodes, entities = [made(), made(name="/second")], [ran(), ran(node="/second")]
    assert sorted(right(nodes, entities, [entry(), entry(name="/second", endpoints=())])) == [False, True]


def test_a_node_without_a_class_of_its_own_goes_by_name_and_place():
    nodes, entities = [made("Node", "/plain", 3)], [ran("Node", "/plain")]
    assert right(nodes, entities, [entry("main", "/plain", 3)]) == [True]
    assert right(nodes, entities, [entry("main", None, 3)]) == [True]


def test_a_node_that_the_oracle_handed_in_is_not_asked():
    assert right([made()], [ran("Node", "/*")], [entry()]) == []
    assert right([made()], [ran(phase="forced")], [entry()]) == []


def test_each_owner_of_a_line_is_asked():
    nodes = [made(), made("Other", "/other", 2)]
    assert right(nodes, [ran(), ran("Other", "/other")], [entry()]) == [False, True]


SOURCE = """\
from rclpy.node import Node
from framework import Plugin
class Base(Node): pass
class Talker(Base): pass
class Helper:
    def __init__(self, node): node.create_publisher(str, "a", 1)
class Thing(Plugin): pass
def work(node): node.create_timer(1, print)
made = Node("plain")
"""


def phantom(tmp_path: Path, *entries, nodes=()):
    (tmp_path / "node.py").write_text(SOURCE)
    return phantoms({"nodes": list(nodes)}, {"nodes": list(entries)}, tmp_path)


def test_what_the_source_calls_a_node_is_none(tmp_path):
    assert phantom(tmp_path, entry("Talker", line=4), entry("<module>", "/plain", 9)) == []


def test_helpers_functions_and_foreign_bases_are_phantoms(tmp_path):
    shown = phantom(tmp_path, entry("Helper", None, 5), entry("Thing", None, 7), entry("work", None, 8))
    assert shown == ["node.py:5 Helper", "node.py:7 Thing", "node.py:8 work"]


def test_what_is_said_to_be_no_node_is_no_phantom(tmp_path):
    assert phantom(tmp_path, entry("Helper", None, 5, is_node=False)) == []


def test_what_a_run_made_is_a_node(tmp_path):
    assert phantom(tmp_path, entry("Thing", None, 7), nodes=[made("Thing")]) == []
