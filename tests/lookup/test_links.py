"""Which places of a file lead to others."""

from __future__ import annotations

from archlint.lookup.links import links
from archlint.lookup.texts import Texts
from lookup.asking import Editor


def shown(editor: Editor, name: str) -> list[str]:
    texts = Texts(editor.text_of)
    rows = links(editor.index, texts, editor.path(name))
    return [f"{row.place.line} {texts.at(row.place)} -> {editor.shown([row.target])[0]}" for row in rows]


def test_of_a_launch_file_in_xml(launched: Editor):
    assert shown(launched, "robot.launch.xml") == [
        "4 scanner -> scanner.py:17 main",
        "5 $(find-pkg-share patrol)/config/patrol.yaml -> patrol.yaml:1",
        "8 driver -> driver.py:16 main",
    ]


def test_of_a_launch_file_in_python(launched: Editor):
    assert shown(launched, "fleet.launch.py") == [
        "11 robot.launch.xml -> robot.launch.xml:1",
        "28 recorder -> recorder.py:16 main",
    ]


def test_of_a_setup_file(launched: Editor):
    assert shown(launched, "setup.py") == [
        "25 scanner = patrol.scanner:main -> scanner.py:17 main",
        "26 driver = patrol.driver:main -> driver.py:16 main",
        "27 recorder = patrol.recorder:main -> recorder.py:16 main",
    ]


def test_of_types_that_are_here(lesson: Editor):
    assert shown(lesson, "motor_node.py") == [
        "3 SetMotorSpeed -> SetMotorSpeed.srv:1",
        "11 SetMotorSpeed -> SetMotorSpeed.srv:1",
    ]


def test_not_of_standard_types(launched: Editor):
    assert shown(launched, "driver.py") == []


def test_not_where_the_text_has_changed(launched: Editor):
    file = launched.path("robot.launch.xml")
    launched.buffers[file] = (launched.text_of(file) or "").replace('exec="driver"', 'exec="pilot!"')
    try:
        assert [row[0] for row in shown(launched, "robot.launch.xml")] == ["4", "5"]
    finally:
        launched.buffers.clear()
