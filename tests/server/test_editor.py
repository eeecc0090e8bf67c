"""What an editor is told, without the protocol around it: several workspaces, fixes, and what goes wrong."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from lsprotocol import types as lsp

from archlint.cli import main
from archlint.monitor import Monitor
from archlint.server.actions import FIX_ALL
from archlint.server.documents import Documents
from archlint.server.editor import Client, Editor, Published
from archlint.server.session import Session, place_of
from server.robot import LISTENER, Robot

PATIENCE = 60.0
"""Seconds; a busy machine is no reason for a test to fail."""
OTHER_TYPE = LISTENER.replace("String", "Float64")


class Heard:
    """What an editor heard last of each file."""

    def __init__(self, *folders: Path) -> None:
        self.shown: dict[str, Published] = {}
        self.logged: list[str] = []
        self._changed = threading.Condition()
        self.editor = Editor(Client(self._publish, self._log, len), pause=0)
        self.editor.set_folders([str(folder) for folder in folders])

    def open(self, file: Path, text: str) -> None:
        self.editor.opened(file.as_uri(), text, 1)

    def codes(self, file: Path) -> list[str]:
        published = self.shown.get(file.as_uri())
        return [] if published is None else [str(one.code) for one in published.diagnostics]

    def wait_until(self, holds: Callable[[], bool]) -> None:
        with self._changed:
            assert self._changed.wait_for(holds, PATIENCE), self.shown

    def _publish(self, published: Published) -> None:
        with self._changed:
            self.shown[published.uri] = published
            self._changed.notify_all()

    def _log(self, message: str) -> None:
        with self._changed:
            self.logged.append(message)
            self._changed.notify_all()


@pytest.fixture
def heard() -> Iterator[Callable[..., Heard]]:
    running: list[Heard] = []

    def start(*folders: Path) -> Heard:
        running.append(Heard(*folders))
        return running[-1]

    yield start
    for each in running:
        each.editor.close()


def test_two_workspaces_are_judged_apart_and_a_folder_that_is_closed_is_cleared(
    heard: Callable[..., Heard], tmp_path: Path
) -> None:
    one, two = Robot(tmp_path / "one"), Robot(tmp_path / "two")
    editor = heard(one.folder, two.folder)
    editor.open(one.listener, OTHER_TYPE)
    editor.open(two.listener, LISTENER.replace("'chatter'", "'/chatter'"))

    editor.wait_until(lambda: editor.codes(one.talker) == ["TOP001"] and editor.codes(two.listener) == ["NME001"])
    assert editor.codes(two.talker) == []

    editor.editor.closed(one.listener.as_uri())
    editor.editor.set_folders([str(two.folder)])
    editor.wait_until(lambda: editor.codes(one.talker) == [])
    assert editor.codes(two.listener) == ["NME001"]


def test_all_safe_fixes_of_a_file_are_one_action_and_an_unsafe_one_says_so(
    heard: Callable[..., Heard], tmp_path: Path
) -> None:
    robot = Robot(tmp_path)
    editor = heard(robot.folder)
    text = LISTENER.replace("'chatter', self.on_word, 10)", "'/chatter', self.on_word, 10)  # archlint: ignore[SRV003]")
    editor.open(robot.listener, text)
    everywhere = lsp.Range(lsp.Position(0, 0), lsp.Position(99, 0))

    [fix_all] = editor.editor.actions(str(robot.listener), everywhere, [FIX_ALL]).result(PATIENCE)
    assert fix_all.kind == FIX_ALL
    [document] = (fix_all.edit or lsp.WorkspaceEdit()).document_changes or []
    assert isinstance(document, lsp.TextDocumentEdit)
    assert [edit.new_text for edit in document.edits if isinstance(edit, lsp.TextEdit)] == [
        "        self.ears = self.create_subscription(String, '/chatter', self.on_word, 10)\n"
    ]

    fixes = editor.editor.actions(str(robot.listener), everywhere, ["quickfix"]).result(PATIENCE)
    preferred = {action.title: action.is_preferred for action in fixes if action.is_preferred is not None}
    assert sorted(preferred.values()) == [False, True]
    [unsafe] = [title for title, safe in preferred.items() if not safe]
    assert unsafe.endswith("(unsafe fix: look at what it changes)")

    shown = editor.shown[robot.listener.as_uri()].diagnostics
    assert [one.code for one in shown if one.tags == [lsp.DiagnosticTag.Unnecessary]] == ["LNT001"]


def test_a_failure_is_logged_and_the_server_goes_on(
    heard: Callable[..., Heard], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = Robot(tmp_path)
    editor = heard(robot.folder)
    with monkeypatch.context() as patch:
        patch.setattr(Session, "analyse", lambda *_: 1 / 0)
        editor.open(robot.listener, OTHER_TYPE)
        editor.wait_until(lambda: bool(editor.logged))
    assert "ZeroDivisionError" in editor.logged[0]

    editor.editor.changed(robot.listener.as_uri(), OTHER_TYPE, 2)
    editor.wait_until(lambda: editor.codes(robot.talker) == ["TOP001"])


def test_the_baseline_of_the_configuration_holds_findings_back(
    heard: Callable[..., Heard], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot = Robot(tmp_path)
    robot.configure('baseline = "known.txt"\n')
    hard_coded = LISTENER.replace("'chatter'", "'/chatter'")
    robot.listener.write_text(hard_coded, "utf-8")
    with monkeypatch.context() as patch:
        patch.chdir(robot.folder)
        assert main(["check", "--write-baseline", "--quiet"]) == 0
    assert "NME001" in (robot.folder / "known.txt").read_text("utf-8")

    editor = heard(robot.folder)
    editor.open(robot.listener, hard_coded.replace("String", "Float64"))

    editor.wait_until(lambda: editor.codes(robot.talker) == ["TOP001"])
    assert editor.codes(robot.listener) == []


def test_the_workspace_of_a_file_is_the_one_around_it(tmp_path: Path) -> None:
    robot = Robot(tmp_path / "robot")
    package = str(robot.manifest.parent)
    lonely = tmp_path / "lonely.py"
    lonely.write_text("", "utf-8")

    sources = str(robot.folder / "src")

    assert place_of(str(robot.talker), []) == (sources, (sources,))
    assert place_of(str(robot.talker), [str(robot.folder)]) == (str(robot.folder), (str(robot.folder),))
    assert place_of(str(robot.talker), [package]) == (sources, (package,))
    assert place_of(str(lonely), []) == (str(tmp_path), (str(lonely),))


def test_a_document_that_is_a_folder_is_none(tmp_path: Path) -> None:
    documents = Documents()
    assert documents.put(tmp_path.as_uri(), "import rclpy\n", 1) is None
    assert documents.put("file:///", "import rclpy\n", 1) is None
    assert not documents.buffers
    assert documents.put((tmp_path / "node.py").as_uri(), "import rclpy\n", 1) == str(tmp_path / "node.py")


def test_a_change_on_the_disk_in_the_midst_of_an_analysis_is_seen_by_the_next(tmp_path: Path) -> None:
    robot = Robot(tmp_path)
    documents = Documents()
    documents.put(robot.listener.as_uri(), OTHER_TYPE, 1)
    session = Session(str(robot.folder), [str(robot.folder)])

    class Configuring(Monitor):
        def judged(self) -> None:
            robot.configure('ignore = ["TOP001"]\n')
            session.look_again()

    [*_, before] = session.analyse(documents.buffers, Configuring())
    [*_, after] = session.analyse(documents.buffers, Monitor())

    assert [finding.code for finding in before.findings] == ["TOP001"]
    assert [finding.code for finding in after.findings] == []
