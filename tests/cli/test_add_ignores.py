"""``--add-ignores``: what is found now is suppressed where it stands, and nothing else changes."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from archlint.cli import main

FIXTURE = Path(__file__).parents[2] / "fixtures" / "broken_system"
MOTOR = Path("src/my_first_package/my_first_package/motor_node.py")


@pytest.fixture(autouse=True)
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    shutil.copytree(FIXTURE, tmp_path / "ws")
    monkeypatch.chdir(tmp_path / "ws")
    return tmp_path / "ws"


def check(capsys: pytest.CaptureFixture[str], *words: str) -> tuple[int, list[str], str]:
    status = main(["check", "--no-cache", "--format", "concise", *words])
    out = capsys.readouterr()
    return status, out.out.splitlines(), out.err


def test_what_is_found_is_suppressed_and_nothing_is_left_over(capsys: pytest.CaptureFixture[str]):
    status, lines, said = check(capsys, "--add-ignores", "--reason", "known since May")
    assert (status, lines) == (0, [])
    assert said.startswith("Suppressed 13 findings in 3 files.\n")
    text = MOTOR.read_text("utf-8")
    assert "'motor-state', 10)  # archlint: ignore[NME002] known since May\n" in text
    assert check(capsys, "--extend-select", "LNT005")[:2] == (0, [])


def test_only_what_is_selected_and_new(capsys: pytest.CaptureFixture[str]):
    check(capsys, "--baseline", "known.txt", "--write-baseline", "--select", "NME001")
    status, lines, said = check(capsys, "--baseline", "known.txt", "--add-ignores", "--select", "NME001,NME002")
    assert (status, lines) == (0, [])
    assert said.startswith("Suppressed 1 finding in 1 file.\n")
    assert MOTOR.read_text("utf-8").count("archlint: ignore") == 1


def test_what_no_comment_can_suppress_is_told(capsys: pytest.CaptureFixture[str]):
    MOTOR.write_text("import rclpy\ndef f(:\n", "utf-8")
    status, lines, said = check(capsys, "--add-ignores")
    assert status == 1
    assert [line.split()[2] for line in lines] == ["LNT002"]
    assert "No comment can suppress the 1 that is left.\n" in said


def test_a_rule_that_reports_the_first_place_is_suppressed_at_each(capsys: pytest.CaptureFixture[str]):
    imports = "".join(f"from sensor_msgs.msg import {name}\n" for name in ("Imu", "Image", "Range", "Joy", "NavSatFix"))
    text = MOTOR.read_text("utf-8")
    MOTOR.write_text(imports + text, "utf-8")
    status, lines, _ = check(capsys, "--add-ignores", "--select", "PKG001")
    assert (status, lines) == (0, [])
    assert MOTOR.read_text("utf-8") == imports.replace("\n", "  # archlint: ignore[PKG001]\n") + text


def test_a_read_only_file_ends_it_before_anything_is_written(capsys: pytest.CaptureFixture[str]):
    MOTOR.chmod(0o444)
    status, _, said = check(capsys, "--add-ignores")
    assert (status, said) == (2, f"archlint: error: cannot write {MOTOR}: the file is read-only\n")
    changed = [path for path in Path("src").rglob("*.py") if "archlint:" in path.read_text("utf-8")]
    assert changed == []


@pytest.mark.parametrize(
    "words", [["--add-ignores", "--diff"], ["--reason", "x"], ["--add-ignores", "--reason", "one\ntwo"]]
)
def test_what_does_not_go_together(capsys: pytest.CaptureFixture[str], words: list[str]):
    assert check(capsys, *words)[0] == 2


def test_a_suppression_that_hides_nothing_any_more_goes_with_fix(capsys: pytest.CaptureFixture[str]):
    before = MOTOR.read_text("utf-8")
    check(capsys, "--add-ignores", "--select", "NME002")
    text = MOTOR.read_text("utf-8")
    MOTOR.write_text(text.replace("'motor-state'", "'motor_state'"), "utf-8")
    assert [line.split()[2] for line in check(capsys, "--select", "NME002,LNT001")[1]] == ["LNT001"]
    check(capsys, "--select", "NME002,LNT001", "--fix")
    assert MOTOR.read_text("utf-8") == before.replace("'motor-state'", "'motor_state'")
