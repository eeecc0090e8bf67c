"""The Python API: what it answers, and that it does nothing else."""

from __future__ import annotations

import doctest
import os
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import FrozenInstanceError
from pathlib import Path
from textwrap import dedent

import pytest

import archlint
from archlint import ArchlintError, Severity, api
from archlint.cli import main
from archlint.render import json as graph_json
from archlint.systems.nodes import Endpoint

ROOT = Path(__file__).parents[2]
FIXTURES = ROOT / "fixtures"
TALKER = """
    import rclpy
    from rclpy.node import Node
    from std_msgs.msg import String


    class Talker(Node):
        def __init__(self):
            super().__init__('talker')
            self.create_publisher(String, 'bad name', 10)


    def main():
        rclpy.init()
        rclpy.spin(Talker())
"""


@pytest.fixture
def talker(tmp_path: Path) -> Path:
    (tmp_path / "talker.py").write_text(dedent(TALKER))
    return tmp_path


def test_the_examples_of_the_page_are_true(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(ROOT)
    outcome = doctest.testfile(str(ROOT / "docs" / "api.md"), module_relative=False, optionflags=doctest.ELLIPSIS)
    assert outcome.attempted > 15
    assert outcome.failed == 0


def test_what_a_system_holds_is_shown_in_a_line(talker: Path):
    [system] = archlint.load(talker).systems()
    [node] = system.nodes
    assert repr((system, node, *node.endpoints)) == (
        "(<System of all code: 1 nodes>, <Node /talker: 1 endpoints>, <Endpoint publisher /bad name of /talker>)"
    )


def test_a_graph_has_the_arguments_of_its_launch_file_and_the_interfaces_of_the_workspace(talker: Path):
    (talker / "launch").mkdir()
    (talker / "launch" / "it.launch.xml").write_text("<launch><arg name='speed' default='2'/></launch>")
    (talker / "msg").mkdir()
    (talker / "msg" / "Speed.msg").write_text("uint8 FAST=2\nuint8 value\n")
    (talker / "package.xml").write_text("<package><name>robot</name></package>")
    graph = archlint.load(talker, launch=talker / "launch" / "it.launch.xml").graph()
    assert [(argument.name, argument.default) for argument in graph.launch_arguments] == [("speed", "2")]
    [interface] = graph.interfaces
    assert interface.name == "robot/msg/Speed"
    assert [field.name for field in interface.fields] == ["value"]
    assert [(constant.name, constant.value) for constant in interface.constants] == [("FAST", 2)]


def test_a_name_of_the_package_is_that_of_the_api():
    for name in archlint._OF_API:
        assert getattr(archlint, name) is getattr(api, name)
        assert name in api.__all__
    with pytest.raises(AttributeError, match="no attribute 'lod'"):
        archlint.lod  # noqa: B018


def test_importing_archlint_imports_nothing_of_it():
    code = "import sys, archlint; print(*(name for name in sys.modules if name.startswith('archlint')))"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    command = [sys.executable, "-c", code]
    assert (
        subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=True).stdout == "archlint\n"
    )


def test_a_finding_is_where_the_command_line_has_it(talker: Path, monkeypatch: pytest.MonkeyPatch, capsys):
    found = archlint.load(talker).check()
    monkeypatch.chdir(talker)
    assert main(["check", "--format", "concise", "--no-cache", "--quiet"]) == 1
    said = capsys.readouterr().out
    assert [f"{one.place.file}:{one.place.line}:{one.place.column}" for one in found.findings] == [
        line.partition(": ")[0] for line in said.splitlines()
    ]
    assert [(one.code, one.place.line) for one in found.findings if one.severity == Severity.ERROR] == [("NME002", 10)]
    assert found.fails()


def test_a_check_neither_prints_nor_writes(talker: Path, capfd: pytest.CaptureFixture[str]):
    before = os.getcwd(), sys.getrecursionlimit(), dict(os.environ), sorted(talker.rglob("*"))
    workspace = archlint.load(talker)
    workspace.check()
    workspace.graph()
    assert (os.getcwd(), sys.getrecursionlimit(), dict(os.environ), sorted(talker.rglob("*"))) == before
    assert capfd.readouterr() == ("", "")


def test_the_next_check_sees_what_has_been_edited(talker: Path):
    workspace = archlint.load(talker)
    assert workspace.check().fails()
    (talker / "talker.py").write_text(dedent(TALKER).replace("bad name", "good_name"))
    assert not workspace.check().fails()


def _places(workspace: str) -> list[tuple[str, str, int]]:
    found = archlint.load(FIXTURES / workspace).check().findings
    return [(one.code, one.place.file, one.place.line) for one in found]


def test_the_working_directory_decides_nothing(monkeypatch: pytest.MonkeyPatch):
    here = _places("broken_system")
    monkeypatch.chdir(FIXTURES / "broken_system" / "src")
    assert _places("broken_system") == here
    assert "src/my_first_package/my_first_package/control_node.py" in {file for _, file, _ in here}


def test_two_threads_give_what_each_gives_alone():
    names = ["broken_system", "launched", "broken_system", "lesson_extended"]
    alone = {name: _places(name) for name in set(names)}
    with ThreadPoolExecutor(len(names)) as pool:
        assert list(pool.map(_places, names)) == [alone[name] for name in names]


def test_a_fix_holds_edits_of_the_file_wherever_one_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    monkeypatch.chdir(tmp_path)
    found = archlint.load(FIXTURES / "antipattern_4_hardcoded_names").check().findings
    fix = next(one.fix for one in found if one.code == "NME001")
    assert fix is not None
    lines = (FIXTURES / "antipattern_4_hardcoded_names" / fix.edits[-1].place.file).read_text().splitlines()
    place = fix.edits[-1].place
    assert "/sensor/raw" in lines[place.line - 1][place.column - 1 : place.end_column - 1]


# --- patterns and places of the configuration


def test_patterns_are_for_the_folder_of_the_configuration(talker: Path, monkeypatch: pytest.MonkeyPatch):
    (talker / "tools").mkdir()
    (talker / "talker.py").rename(talker / "tools" / "talker.py")
    (talker / "archlint.toml").write_text('[per-file-ignores]\n"tools/*" = ["NME002"]\n')
    monkeypatch.chdir(FIXTURES)
    for path in (talker, talker / "tools", talker / "tools" / "talker.py"):
        assert "NME002" not in {one.code for one in archlint.load(path).check().findings}, path
    assert "NME002" in {one.code for one in archlint.load(talker, isolated=True).check().findings}


def test_a_contract_is_placed_from_the_folder_too(talker: Path, monkeypatch: pytest.MonkeyPatch):
    contract = '[[contracts]]\nname = "talks"\nkind = "require"\ntopic = "/chatter"\npublisher = "/talker"\n'
    (talker / "archlint.toml").write_text(contract)
    monkeypatch.chdir(FIXTURES)
    [found] = [one for one in archlint.load(talker).check().findings if one.code == "ARC003"]
    assert (found.place.file, found.place.line) == ("archlint.toml", 1)


# --- graphs and systems


@pytest.mark.parametrize("name", ["forms", "launched", "alternatives", "broken_system"])
def test_a_graph_has_every_field_of_the_json(name: str):
    """A key that the JSON has and the classes have not is refused, and so is the other way round."""
    for system in archlint.load(FIXTURES / name).systems():
        graph = api.graph_of(system)
        document = graph_json.document(system)
        assert [node.name for node in graph.nodes] == [node["name"] for node in document["nodes"]]
        assert len(graph.unresolved) == len(document["unresolved"])


def test_what_a_launch_file_starts():
    launch = FIXTURES / "launched" / "src" / "patrol" / "launch" / "fleet.launch.py"
    workspace = archlint.load(FIXTURES / "launched", launch=launch)
    [system] = workspace.systems()
    assert system.name == launch.relative_to(FIXTURES / "launched").as_posix()
    assert workspace.graph().system == system.name
    assert {node.launched_by for node in workspace.graph().nodes} == {system.name}


def test_nothing_of_a_graph_can_be_changed(talker: Path):
    graph = archlint.load(talker).graph()
    for part in (graph, graph.nodes[0], graph.nodes[0].publishers[0]):
        with pytest.raises(AttributeError):
            part.name = "other"
    with pytest.raises(FrozenInstanceError):
        archlint.load(talker).check().findings = ()
    assert graph == archlint.load(talker).graph()


def test_the_graph_of_networkx(talker: Path):
    graph = archlint.load(talker.parent / talker.name).networkx()
    assert ("node", "/talker") in graph
    ends: list[Endpoint] = [edge["endpoint"] for *_, edge in graph.edges(data=True)]
    assert [str(end.kind) for end in ends] == ["publisher"]


# --- errors


@pytest.mark.parametrize(
    ("ask", "message", "file", "line"),
    [
        (lambda folder: archlint.load(folder / "none"), "no such file or directory", None, None),
        (lambda folder: archlint.load(folder, launch="none.launch.py"), "no such launch file", None, None),
        (lambda folder: archlint.load(folder, config="a.toml", isolated=True), "exclude each other", None, None),
        (lambda folder: archlint.load(folder, config=folder / "none.toml"), "cannot be read", "none.toml", None),
        (lambda folder: archlint.load(folder / "wrong"), "unknown rule `NME999`", "archlint.toml", 2),
        (lambda folder: archlint.load(folder / "empty").check(), "nothing to check", None, None),
        (lambda folder: archlint.load(folder / "empty").graph(), "nothing to check", None, None),
    ],
    ids=["path", "launch", "both", "config", "rule", "check", "graph"],
)
def test_there_is_one_error(
    ask: Callable[[Path], object], message: str, file: str | None, line: int | None, talker: Path
):
    (talker / "wrong").mkdir()
    (talker / "wrong" / "archlint.toml").write_text('\nselect = ["NME999"]\n')
    (talker / "empty").mkdir()
    with pytest.raises(ArchlintError, match=message) as raised:
        ask(talker)
    assert (raised.value.file and Path(raised.value.file).name, raised.value.line) == (file, line)
    assert message in raised.value.message
