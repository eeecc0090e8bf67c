"""Where ``--add-ignores`` writes a suppression, and what it leaves as it is."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.fixes.ignores import with_ignores


def written(tmp_path: Path, name: str, text: str, wanted: dict[int, set[str]], reason: str = "") -> str | None:
    file = tmp_path / name
    file.write_bytes(text.encode())
    return with_ignores({str(file): wanted}, reason).texts.get(str(file))


@pytest.mark.parametrize(
    ("before", "line", "after"),
    [
        ("call()\n", 1, "call()  # archlint: ignore[SRV003]\n"),
        ("call()", 1, "call()  # archlint: ignore[SRV003]"),
        ("call()\r\nmore()\r\n", 1, "call()  # archlint: ignore[SRV003]\r\nmore()\r\n"),
        ("call()  # noqa: E501\n", 1, "call()  # noqa: E501  # archlint: ignore[SRV003]\n"),
        ("call()  # archlint: ignore[TMO001] why\n", 1, "call()  # archlint: ignore[TMO001, SRV003] why\n"),
        ("call()  # archlint: ignore[SRV003]\n", 1, None),
        ("call(\n    1,\n    2,\n)\n", 2, "call(\n    1,  # archlint: ignore[SRV003]\n    2,\n)\n"),
        ('call("""a\nb""", 1)\n', 1, 'call("""a\nb""", 1)  # archlint: ignore[SRV003]\n'),
        ("a = call() + \\\n    1\n", 1, "a = call() + \\\n    1  # archlint: ignore[SRV003]\n"),
        ("@wrap\ndef call():\n    pass\n", 2, "@wrap\ndef call():  # archlint: ignore[SRV003]\n    pass\n"),
        ("call(\n", 1, None),
        ("call('# archlint: ignore[TMO001]')\n", 1, None),
        ("call()\n", 2, None),
    ],
)
def test_python(tmp_path: Path, before: str, line: int, after: str | None):
    assert written(tmp_path, "node.py", before, {line: {"SRV003"}}) == after


def test_several_codes_of_one_statement_and_a_reason(tmp_path: Path):
    text = 'call("""a\nb""")\n'
    after = 'call("""a\nb""")  # archlint: ignore[SRV003, TMO001] known since May\n'
    assert written(tmp_path, "node.py", text, {1: {"TMO001"}, 2: {"SRV003"}}, "known since May") == after


IGNORE = "<!-- archlint: ignore[LCH002] -->"


@pytest.mark.parametrize(
    ("before", "line", "after"),
    [
        ("<a>\n  <b/>\n</a>\n", 2, f"<a>\n  {IGNORE}\n  <b/>\n</a>\n"),
        ('<a>\n  <b\n    c="1"/>\n</a>\n', 3, f'<a>\n  {IGNORE}\n  <b\n    c="1"/>\n</a>\n'),
        ("<a><b/></a>\n", 1, f"<a>{IGNORE}<b/></a>\n"),
        ('<?xml version="1.0"?>\n<a/>\n', 2, f'<?xml version="1.0"?>\n{IGNORE}\n<a/>\n'),
        (
            "<a>\n  <!-- archlint: ignore[LCH003] -->\n  <b/>\n</a>\n",
            3,
            "<a>\n  <!-- archlint: ignore[LCH003, LCH002] -->\n  <b/>\n</a>\n",
        ),
        ("<a>\n", 1, None),
    ],
)
def test_xml(tmp_path: Path, before: str, line: int, after: str | None):
    assert written(tmp_path, "it.launch.xml", before, {line: {"LCH002"}}) == after


def test_a_reason_does_not_end_a_comment_of_xml(tmp_path: Path):
    after = written(tmp_path, "it.launch.xml", "<a/>\n", {1: {"LCH002"}}, "so -- said")
    assert after == "<!-- archlint: ignore[LCH002] so - - said -->\n<a/>\n"


@pytest.mark.parametrize(
    ("before", "line", "after"),
    [
        ("a:\n  b: 1\n", 2, "a:\n  b: 1  # archlint: ignore[PRM004]\n"),
        ("a: |\n  b: 1\n", 2, None),
        ("a: [\n", 1, None),
    ],
)
def test_yaml(tmp_path: Path, before: str, line: int, after: str | None):
    assert written(tmp_path, "config.yaml", before, {line: {"PRM004"}}) == after


def test_a_file_that_is_not_there_is_left_out(tmp_path: Path):
    assert with_ignores({str(tmp_path / "gone.py"): {1: {"SRV003"}}}, "").texts == {}
