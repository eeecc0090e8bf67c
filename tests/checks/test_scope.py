"""The scope of a rule says when it is asked, and when two of its findings are one."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from textwrap import dedent

import pytest

from archlint.checks.registry import Options, finding, registered, rule
from archlint.checks.scope import Scope
from archlint.config.options import options_for
from archlint.config.settings import Settings, load
from archlint.engine import findings
from archlint.engine.merging import merged
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding, Place, Related
from archlint.rulebook import pages_folder
from archlint.systems.model import System
from archlint.testing.pages import load_examples
from registering import only

SCOPES = {
    Scope.WORKSPACE: """
        PKG001 PKG002 PKG003 PKG004 PKG005 PKG006 PKG007 PKG008 PKG009 PKG010 PKG011 PKG012 PKG013 PKG014
        PKG015 PRM012
        """,
    Scope.CODE: """
        ACT003 API001 API002 API003 API004 API005 API006 API007 ARC004 CBG001 CBG002 EXE001 EXE002 EXE003 EXE004 EXE005
        EXE006 EXE007 EXE008 EXE009 EXE010 EXE011 EXE012 EXE013 EXE014 EXE015 EXE016 EXE017 GRF002 MSG001 MSG002 MSG003
        MSG004 NME001 NME003 PRM003 PRM006 PRM008 PRM010 PRM011 SRV003 SRV005 SRV007 SRV008 TMO001 TMO002 TMO003 TMO004
        TMO005 TMO006 TOP005 TOP006 TOP007
    """,
    Scope.SYSTEM: """
        ACT001 ACT002 ARC001 ARC002 ARC003 GRF001 GRF003 GRF004 LCH006 LCH008 NME004 OWN001 OWN002 OWN003 PRM002 PRM004
        PRM005 QOS001 QOS002 QOS003 SRV001 SRV002 SRV006 TOP001 TOP002 TOP003 TOP004 TOP008
    """,
    Scope.AS_LAUNCHED: "LCH002 NME002 QOS004 SRV004",
    Scope.LAUNCH_FILE: "LCH001 LCH003 LCH004 LCH005 LCH007 LCH009 LCH010 LCH011 LCH012 LCH013 LCH014 LCH015 PRM009",
    Scope.RUNNING: "GRF005 GRF006 GRF007",
}
"""What the pages say: both ends of a connection, a parameter's value and a node's name depend on what is launched;
a wait, a callback or a manifest does not."""


def test_every_rule_has_the_scope_that_its_page_says():
    found = defaultdict(list)
    for code, one in registered().items():
        found[one.scope].append(code)
    assert dict(found) == {scope: codes.split() for scope, codes in SCOPES.items()}


# --- what the pages' examples show of it


@dataclass
class Judged:
    """What one rule finds of one example, asked of its systems directly: places."""

    code: str
    open: set[Place]
    without_nodes: set[Place]
    launched: set[Place]


@pytest.fixture(scope="module")
def examples(tmp_path_factory: pytest.TempPathFactory) -> list[Judged]:
    """Every rule on the Bad examples of all pages."""
    return [
        row
        for example in load_examples(pages_folder())
        if example.section == "bad"
        and (example.page_code in SCOPES[Scope.WORKSPACE].split() or any("launch" in f for f in example.files))
        for row in _judged(example.write, tmp_path_factory.mktemp("example"))
    ]


def _judged(write, folder: Path) -> Iterator[Judged]:
    with pytest.MonkeyPatch.context() as patch:
        systems: list[System] = []
        patch.chdir(folder)
        patch.setattr(findings, "_rules", lambda _, found, memory: iter(systems.extend(found) or ()))
        write(folder)
        settings = load(folder)
        check(Request((".",), settings, cached=False, jobs=1))
        options = options_for(settings, registered())
        [first, *launched] = systems
        bare = replace(first, nodes=[], programs=[], unowned=[])
        for code, one in registered().items():

            def places(*asked: System, one=one, code=code) -> set[Place]:
                return {found.place for system in asked for found in one(system, options[code])}

            yield Judged(code, places(first), places(bare), places(*launched))


def test_what_is_asked_once_finds_nothing_more_in_a_launched_system(examples: list[Judged]):
    more = {row.code for row in examples if row.launched - row.open}
    assert {"LCH001", "LCH002", "NME004", "PRM004"} <= more
    assert [code for code in more if not registered()[code].scope.of_each_system] == []


def test_what_is_of_the_workspace_needs_no_nodes_and_what_is_of_code_does(examples: list[Judged]):
    found = [row for row in examples if row.open]
    alike = {row.code for row in found if row.open == row.without_nodes}
    others = {"API002", "LCH008", "PRM002"}
    assert alike == {*others, *SCOPES[Scope.WORKSPACE].split()}
    # A launch file in which launch finds nothing makes no system: LCH008 asks the open one for it.  API002 judges the
    # imports of each file, too, beside the calls of its programs, and PRM002 files that are for nodes from elsewhere.
    assert {registered()[code].scope for code in alike - others} == {Scope.WORKSPACE}


# --- when a rule is asked

NODE = """
    import rclpy
    from rclpy.node import Node


    def main():
        rclpy.init()
        rclpy.spin(Node('talker'))


    if __name__ == '__main__':
        main()
"""
PACKAGE = """
    <package format="3"><name>pkg</name><version>0.1.0</version><description>d</description>
    <maintainer email="a@b.org">A</maintainer><license>MIT</license>
    <export><build_type>ament_python</build_type></export></package>
"""
SETUP = """
    from setuptools import setup

    setup(name='pkg', packages=['pkg'], entry_points={'console_scripts': ['talker = pkg.talker:main']})
"""
ALWAYS = '<launch><node pkg="pkg" exec="talker"/></launch>'
EITHER = """
    <launch>
      <arg name="fast"/>
      <node pkg="pkg" exec="talker" if="$(var fast)"/>
      <node pkg="pkg" exec="talker" name="slow" unless="$(var fast)"/>
    </launch>
"""


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A node that one launch file starts, and another under one of two names: nothing decides which."""
    files = {
        "package.xml": PACKAGE,
        "setup.py": SETUP,
        "pkg/__init__.py": "",
        "pkg/talker.py": NODE,
        "launch/always.launch.xml": ALWAYS,
        "launch/either.launch.xml": EITHER,
    }
    for path, text in files.items():
        (tmp_path / path).parent.mkdir(exist_ok=True)
        (tmp_path / path).write_text(dedent(text).lstrip(), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


OPEN, ONCE_EACH, EACH = (
    [(None, ["/talker"])],
    [
        (None, ["/talker"]),
        ("launch/always.launch.xml", ["/talker"]),
        ("launch/either.launch.xml", ["/slow", "/talker"]),
    ],
    [
        (None, ["/talker"]),
        ("launch/always.launch.xml", ["/talker"]),
        ("launch/either.launch.xml", ["/slow"]),
        ("launch/either.launch.xml", ["/talker"]),
    ],
)


@pytest.mark.parametrize(
    ("scope", "expected"),
    [
        (Scope.WORKSPACE, OPEN),
        (Scope.CODE, OPEN),
        (Scope.SYSTEM, EACH),
        (Scope.AS_LAUNCHED, EACH),
        (Scope.LAUNCH_FILE, ONCE_EACH),
        (Scope.RUNNING, ONCE_EACH),
    ],
)
def test_a_rule_is_asked_of_the_systems_that_its_scope_says(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, scope: Scope, expected: list[tuple[str | None, list[str]]]
):
    asked: list[tuple[str | None, list[str]]] = []

    @rule("TOP001", scope=scope)
    def listening(system: System, options: Options) -> Iterator[Finding]:
        asked.append((system.name, sorted(str(node.name) for node in system.nodes)))
        return iter(())

    only(monkeypatch, listening)
    check(Request((".",), Settings(), cached=False, jobs=1))
    assert sorted(asked, key=lambda one: (one[0] or "", one[1])) == expected


def test_what_only_a_launched_system_shows_is_reported(workspace: Path, monkeypatch: pytest.MonkeyPatch):
    @rule("TOP001", scope=Scope.SYSTEM)
    def slow_node(system: System, options: Options) -> Iterator[Finding]:
        for node in system.nodes:
            if node.name == "/slow" and node.launch_place is not None:
                yield finding("TOP001", node.launch_place, "it is slow")

    only(monkeypatch, slow_node)
    [found] = check(Request((".",), Settings(), cached=False, jobs=1)).findings
    assert (found.place.file, found.place.line) == ("launch/either.launch.xml", 4)
    assert found.message == "it is slow (with fast:=false)"


# --- when two findings are one

HERE, THERE, ELSEWHERE = (Place("a.py", line, 1, line, 9) for line in (1, 2, 3))


def _told(scope: Scope, monkeypatch: pytest.MonkeyPatch, *findings: Finding) -> list[tuple[str | None, str]]:
    only(monkeypatch, rule("TOP001", scope=scope)(lambda system, options: iter(())))
    return [(found.system, found.message) for found in merged(findings)]


def _finding(message: str, system: str | None, related: Sequence[Place] = ()) -> Finding:
    found = finding("TOP001", HERE, message, related=[Related(place, "there") for place in related])
    return replace(found, system=system)


@pytest.mark.parametrize("scope", list(Scope))
def test_what_two_systems_show_alike_is_told_once(scope: Scope, monkeypatch: pytest.MonkeyPatch):
    alike = [_finding("it is so", name) for name in (None, "a.launch.py", "b.launch.py")]
    assert _told(scope, monkeypatch, *alike) == [(None, "it is so")]


@pytest.mark.parametrize("scope", list(Scope))
def test_another_message_at_one_place_is_told_where_the_system_is_judged(scope: Scope, monkeypatch: pytest.MonkeyPatch):
    told = _told(scope, monkeypatch, _finding("as /a", None), _finding("as /b", "b.launch.py"))
    once = scope in (Scope.WORKSPACE, Scope.CODE, Scope.AS_LAUNCHED)
    assert told == [(None, "as /a"), *([] if once else [("b.launch.py", "as /b")])]


def test_findings_of_systems_are_one_where_they_lead_to_the_same_places(monkeypatch: pytest.MonkeyPatch):
    told = _told(
        Scope.SYSTEM,
        monkeypatch,
        _finding("as /a", None, [THERE]),
        _finding("as /b", "b.launch.py", [THERE]),
        _finding("as /c", "c.launch.py", [ELSEWHERE]),
    )
    assert told == [(None, "as /a"), ("c.launch.py", "as /c")]


def test_one_system_may_say_two_things_of_a_place(monkeypatch: pytest.MonkeyPatch):
    told = _told(Scope.CODE, monkeypatch, _finding("first", None), _finding("second", None))
    assert told == [(None, "first"), (None, "second")]
