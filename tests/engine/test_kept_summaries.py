"""What analyses say of single files is kept: after an edit they are asked of the edited file alone."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import pytest

from archlint.analysis import fixed_names, left_over
from archlint.analysis.kept import kept_for_each_file, kept_for_few_files
from archlint.config.settings import load
from archlint.engine import summaries_ahead
from archlint.engine.pipeline import Request, check
from archlint.packaging import missing_imports
from archlint.python_code import absent_members, logger_calls, made_objects, own_calls, time_operators, undefined_names
from archlint.syntax import facts, workers
from archlint.syntax.cache import Store
from archlint.syntax.python.lowering import lower
from archlint.syntax.summaries import Summaries

FILES = {
    "clock.py": """\
import rclpy
from rclpy.node import Node


class Clock(Node):
    def __init__(self):
        super().__init__('clock')
        started = self.get_clock().now()
        self.get_logger().info('since', started)
        if started > 5.0:
            self.get_logger().info(mesage)
""",
    "helper.py": """\
from rclpy.node import Node
from std_msgs.msg import String


class Helper(Node):
    def __init__(self):
        super().__init__('helper')
        self.log = Log()
        self.log.wirte(count)
        self.state = self.create_publisher(String, f'{count}/state', 1)


class Log:
    def write(self, text):
        print(text)
""",
}
WRONG = {"API001", "API002", "API005"}


@pytest.fixture
def workspace(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "home"))
    folder = tmp_path / "src"
    folder.mkdir()
    for name, text in FILES.items():
        (folder / name).write_text(text, "utf-8")
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def findings(workspace) -> Callable[..., list[str]]:
    def run(cached: bool = True, jobs: int = 1) -> list[str]:
        report = check(Request((".",), load(workspace), jobs=jobs, cached=cached))
        return [f"{finding.place} {finding.code} {finding.message}" for finding in report.findings]

    return run


@pytest.fixture
def worked_out(monkeypatch) -> Iterator[list[str]]:
    """The summaries that are made, not read."""
    names: list[str] = []
    made = Summaries._stored_or_made

    def note(self: Summaries, digest: str, name: str, kind: Any, work: Callable[[], Any]) -> Any:
        return made(self, digest, name, kind, lambda: [names.append(name), work()][1])

    monkeypatch.setattr(Summaries, "_stored_or_made", note)
    return names


def test_after_an_edit_only_the_edited_file_is_looked_at(workspace, findings, worked_out):
    first = findings()
    assert {code for line in first for code in WRONG if f" {code} " in line} == WRONG
    for name in set(worked_out):
        assert worked_out.count(name) <= len(FILES)
    worked_out.clear()
    (workspace / "clock.py").write_text(FILES["clock.py"].replace("'clock'", "'watch'"), "utf-8")
    assert findings() == findings(cached=False)
    assert worked_out
    assert len(set(worked_out)) == len(worked_out)


def test_what_is_kept_moves_with_the_lines(workspace, findings):
    findings()
    (workspace / "clock.py").write_text("# a line more\n" + FILES["clock.py"], "utf-8")
    assert findings() == findings(cached=False)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only POSIX can fork")
@pytest.mark.parametrize("cached", [True, False])
def test_processes_say_of_files_what_one_would_say(findings, worked_out, monkeypatch, cached):
    """In a run of several processes, others do what the text of each file decides alone."""
    alone = findings(cached=False)
    monkeypatch.setattr(summaries_ahead, "_WORTH_IT", 0)
    monkeypatch.setattr(workers, "can_fork", lambda waiting=0: True)
    worked_out.clear()
    assert findings(cached, jobs=2) == alone
    assert f"{undefined_names.__name__}._unbound" not in worked_out


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only POSIX can fork")
def test_where_a_process_fails_the_rules_ask_themselves(findings, worked_out, monkeypatch):
    alone = findings(cached=False)
    monkeypatch.setattr(summaries_ahead, "_WORTH_IT", 0)
    monkeypatch.setattr(summaries_ahead, "analyses", None)
    monkeypatch.setattr(workers, "can_fork", lambda waiting=0: True)
    worked_out.clear()
    assert findings(cached=False, jobs=2) == alone
    assert worked_out.count(f"{undefined_names.__name__}._unbound") == len(FILES)


@pytest.mark.parametrize("payload", [b"", b"no such thing", msgspec.msgpack.encode(("another archlint", {"a": {}}))])
def test_what_cannot_be_read_is_made_anew(workspace, findings, worked_out, monkeypatch, payload):
    before = findings()
    read = Store.get_programs
    monkeypatch.setattr(
        Store, "get_programs", lambda self, key: payload if key.startswith("summaries-") else read(self, key)
    )
    worked_out.clear()
    (workspace / "helper.py").write_text(FILES["helper.py"].replace("'helper'", "'aide'"), "utf-8")
    assert len(findings()) == len(before)
    assert worked_out.count(f"{undefined_names.__name__}._unbound") == len(FILES)


def test_a_summary_of_another_form_is_made_anew():
    rows = {"digest": {"lines": msgspec.Raw(msgspec.msgpack.encode("not a list"))}}
    stored = msgspec.msgpack.encode(("", rows))
    summaries = Summaries(lambda: stored, lambda file: "digest")
    assert summaries.of("a.py", "lines", list[int], lambda: [1]) == [1]
    assert summaries.changed
    again = Summaries(summaries.written, lambda file: "digest")
    assert again.of("b.py", "lines", list[int], list) == [1]
    assert not again.changed


@pytest.mark.parametrize(
    "analysis",
    [
        absent_members._of_interfaces,
        fixed_names._variables_in_front,
        left_over._uses,
        logger_calls._given_to_node,
        logger_calls._refused,
        made_objects.calls_of_objects,
        missing_imports._imports,
        own_calls.assigned_attributes,
        time_operators._refused,
    ],
)
@pytest.mark.parametrize("file", FILES)
def test_what_is_read_again_is_what_was_said(analysis, file):
    """Whatever an analysis finds is the same after it was kept."""
    workspace = _Workspace(lower(FILES[file]))
    said = analysis(workspace, file)
    again = _Workspace(lower(""), Summaries(workspace.summaries.written, lambda path: "digest"))
    assert analysis(again, file) == said


class _Workspace:
    def __init__(self, code: facts.Facts, summaries: Summaries | None = None) -> None:
        self.code = code
        self.kept: dict[object, object] = {}
        self.summaries = summaries or Summaries(digest_of=lambda path: "digest")

    def facts_at(self, file: str) -> facts.Facts | None:
        return self.code


@kept_for_each_file
def _words(code: facts.Facts) -> list[str]:
    return sorted(code.names)


@kept_for_few_files
def _imports(code: facts.Facts) -> list[facts.Stmt]:
    return [statement for statement in code.body if isinstance(statement, facts.Import)]


def test_of_what_few_files_have_is_kept_which_files_have_it():
    """What is found may be facts: it is always that of the code of now."""
    workspace = _Workspace(lower("import rclpy"))
    [said] = _imports(workspace, "a.py")
    assert said is workspace.code.body[0]
    again = _Workspace(lower("import rclpy"), Summaries(workspace.summaries.written, lambda path: "digest"))
    assert [*_imports(again, "a.py")] == [again.code.body[0]]
    nothing = _Workspace(lower("rclpy = None"))
    assert not _imports(nothing, "a.py")
    again = _Workspace(lower("import rclpy"), Summaries(nothing.summaries.written, lambda path: "digest"))
    assert not _imports(again, "a.py")


def test_without_a_digest_nothing_is_kept():
    workspace = _Workspace(lower("first"), Summaries())
    assert _words(workspace, "a.py") == ["first"]
    workspace.code = lower("second")
    assert _words(workspace, "a.py") == ["second"]
    assert not workspace.summaries.changed
