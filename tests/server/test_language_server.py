"""A real client and a real server: what an editor sees while somebody types in a workspace of two nodes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException

from server.lsp_client import EditorClient
from server.robot import LISTENER, TALKER, Robot

OTHER_TYPE = LISTENER.replace("import String", "import Float64").replace("(String", "(Float64")


@pytest.fixture(scope="module")
def robot(tmp_path_factory: pytest.TempPathFactory) -> Robot:
    return Robot(tmp_path_factory.mktemp("robot"))


@pytest.fixture(scope="module")
def editor(robot: Robot) -> Iterator[EditorClient]:
    """One server for all tests of this file: each closes what it opens."""
    editor = EditorClient(robot.folder, lsp.PositionEncodingKind.Utf16)
    yield editor
    assert editor.leave() == 0
    assert editor.logged == []


@pytest.fixture
def opened(editor: EditorClient, robot: Robot) -> Iterator[EditorClient]:
    editor.open(robot.listener)
    editor.type(robot.listener, OTHER_TYPE)  # something to hear, so that the test begins after the first analysis
    editor.wait_until(lambda: editor.codes(robot.listener) == ["TOP001"] or editor.codes(robot.talker) == ["TOP001"])
    editor.type(robot.listener, LISTENER)
    editor.wait_until(lambda: editor.codes(robot.listener) == [] and editor.codes(robot.talker) == [])
    yield editor
    editor.close(robot.listener)
    editor.wait_until(lambda: editor.codes(robot.listener) == [])


def test_it_counts_as_the_client_does(editor: EditorClient) -> None:
    assert editor.capabilities.position_encoding == lsp.PositionEncodingKind.Utf16


def test_an_edit_that_is_not_saved_breaks_another_file_and_mends_it_again(opened: EditorClient, robot: Robot) -> None:
    opened.type(robot.listener, OTHER_TYPE)

    opened.wait_until(lambda: opened.codes(robot.talker) == ["TOP001"])
    diagnostic = opened.shown(robot.talker, "TOP001")
    assert diagnostic.severity == lsp.DiagnosticSeverity.Error
    assert diagnostic.source == "archlint"
    assert diagnostic.range.start == lsp.Position(8, TALKER.splitlines()[8].index("self.create_publisher"))
    [related] = diagnostic.related_information or []
    assert related.location.uri == robot.listener.as_uri()
    assert related.location.range.start.line == 8
    assert diagnostic.code_description is not None
    assert diagnostic.code_description.href.endswith("TOP001-topic-type-mismatch.md")

    opened.type(robot.listener, LISTENER)
    opened.wait_until(lambda: opened.codes(robot.talker) == [])


def test_half_typed_code_is_one_finding_and_leaves_the_other_file_as_it_was(opened: EditorClient, robot: Robot) -> None:
    opened.type(robot.listener, OTHER_TYPE)
    opened.wait_until(lambda: opened.codes(robot.talker) == ["TOP001"])

    opened.type(robot.listener, f"{OTHER_TYPE}\ndef later(\n")

    opened.wait_until(lambda: opened.codes(robot.listener) == ["LNT002"])
    assert opened.codes(robot.talker) == ["TOP001"]


def test_positions_are_counted_in_utf_16(opened: EditorClient, robot: Robot) -> None:
    # The emoji is one character, and two units of UTF-16.
    text = LISTENER.replace("import String", "import String\nfrom std_srvs.srv import Trigger")
    waits = "        '🤖'; self.calm = self.create_client(Trigger, 'c')\n        '🤖'; self.calm.wait_for_service()\n"
    text = text.replace("        self.ears", f"{waits}        self.ears")

    opened.type(robot.listener, text)

    opened.wait_until(lambda: "TMO001" in opened.codes(robot.listener))
    found = opened.shown(robot.listener, "TMO001").range
    assert found.start == lsp.Position(found.start.line, len("        'XX'; "))
    assert found.end.character == len("        'XX'; self.calm.wait_for_service()")


def test_a_finding_can_be_ignored_where_it_stands(opened: EditorClient, robot: Robot) -> None:
    text = LISTENER.replace("'chatter'", "'/chatter'")
    opened.type(robot.listener, text)
    opened.wait_until(lambda: "NME001" in opened.codes(robot.listener))

    actions = opened.actions(robot.listener, opened.shown(robot.listener, "NME001").range)

    ignore = next(action for action in actions if action.title.startswith("Ignore NME001"))
    assert ignore.kind == lsp.CodeActionKind.QuickFix
    [document] = (ignore.edit or lsp.WorkspaceEdit()).document_changes or []
    assert isinstance(document, lsp.TextDocumentEdit)
    assert document.text_document.version == opened.version(robot.listener)
    [edit] = document.edits
    assert isinstance(edit, lsp.TextEdit)
    assert edit.new_text.endswith("10)  # archlint: ignore[NME001]\n")

    lines = text.splitlines(keepends=True)
    lines[edit.range.start.line : edit.range.end.line] = [edit.new_text]
    opened.type(robot.listener, "".join(lines))
    opened.wait_until(lambda: opened.codes(robot.listener) == [])


def test_a_configuration_counts_at_once_and_a_mistake_in_it_is_shown_in_it(opened: EditorClient, robot: Robot) -> None:
    opened.type(robot.listener, OTHER_TYPE)
    opened.wait_until(lambda: opened.codes(robot.talker) == ["TOP001"])

    configuration = robot.configure('ignore = ["TOP001"]\n')
    opened.changed_on_disk(configuration)
    opened.wait_until(lambda: opened.codes(robot.talker) == [])

    configuration.write_text('ignore = ["TOP001"]\nselekt = []\n', "utf-8")
    opened.changed_on_disk(configuration)
    opened.wait_until(lambda: bool(opened.of(configuration)))
    [mistake] = opened.of(configuration)
    assert mistake.range.start.line == 1
    assert "selekt" in mistake.message
    assert opened.codes(robot.talker) == []  # what was configured before still holds

    configuration.unlink()
    opened.changed_on_disk(configuration)
    opened.wait_until(lambda: opened.codes(robot.talker) == ["TOP001"] and not opened.of(configuration))


def test_a_file_of_no_workspace_and_what_is_no_file_do_no_harm(editor: EditorClient, tmp_path: Path) -> None:
    lonely = tmp_path / "lonely.txt"
    lonely.write_text("hello", "utf-8")
    editor.open(lonely, language="plaintext")

    assert editor.actions(lonely, lsp.Range(lsp.Position(0, 0), lsp.Position(0, 1))) == []
    editor.close(lonely)


def test_a_name_leads_to_its_other_end_and_is_told_of(opened: EditorClient, robot: Robot) -> None:
    document = lsp.TextDocumentIdentifier(robot.listener.as_uri())
    name = lsp.Position(8, LISTENER.splitlines()[8].index("chatter") + 2)

    hover = opened.ask(opened.client.text_document_hover_async(lsp.HoverParams(document, name)))
    assert hover is not None
    assert isinstance(hover.contents, lsp.MarkupContent)
    assert "/chatter" in hover.contents.value

    targets = opened.ask(opened.client.text_document_definition_async(lsp.DefinitionParams(document, name)))
    assert [(target.uri, target.range.start.line) for target in targets or []] == [(robot.talker.as_uri(), 8)]


def test_a_topic_is_renamed_at_both_ends_or_says_why_not(opened: EditorClient, robot: Robot) -> None:
    document = lsp.TextDocumentIdentifier(robot.listener.as_uri())
    name = lsp.Position(8, LISTENER.splitlines()[8].index("chatter") + 2)

    edit = opened.ask(opened.client.text_document_rename_async(lsp.RenameParams(document, name, "words")))
    changes = (edit or lsp.WorkspaceEdit()).document_changes or []
    versions = {change.text_document.uri: change.text_document.version for change in changes}
    assert versions == {robot.listener.as_uri(): opened.version(robot.listener), robot.talker.as_uri(): None}

    with pytest.raises(JsonRpcException, match="no name of ROS"):
        opened.ask(opened.client.text_document_rename_async(lsp.RenameParams(document, lsp.Position(0, 0), "words")))


def test_names_are_completed_while_they_are_typed(opened: EditorClient, robot: Robot) -> None:
    typed = LISTENER.replace("'chatter', self", "'chat', self")
    opened.type(robot.listener, typed)
    place = lsp.Position(8, typed.splitlines()[8].index("chat") + len("chat"))
    params = lsp.CompletionParams(lsp.TextDocumentIdentifier(robot.listener.as_uri()), place)

    rows = opened.ask(opened.client.text_document_completion_async(params))

    assert isinstance(rows, list)
    edits = {row.label: row.text_edit for row in rows}
    assert edits["chatter"] == lsp.TextEdit(lsp.Range(lsp.Position(8, place.character - 4), place), "chatter")
