"""The file of a baseline: what a person and git see of it, and what is wrong with one."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from archlint.engine import baseline_file
from archlint.engine.baseline_file import BaselineError
from archlint.report.occurrence import Key


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def key(folder: Path, code: str = "SRV003", file: str = "src/node.py", what: str = "on_request, plan") -> Key:
    return Key(code, str(folder / file), what)


def lines(path: str) -> list[str]:
    return [line for line in Path(path).read_text("utf-8").splitlines() if not line.startswith("#")]


def test_one_sorted_line_an_entry_that_a_person_can_read(folder: Path):
    keys = [key(folder), key(folder, "NME001", "src/a.py", "Talker, /chatter"), key(folder, file="src/b.py")]
    baseline_file.write(Path("known.txt"), keys)
    assert lines("known.txt") == [
        "NME001 src/a.py: Talker, /chatter",
        "SRV003 src/b.py: on_request, plan",
        "SRV003 src/node.py: on_request, plan",
    ]


def test_what_is_written_is_what_is_read(folder: Path):
    odd = [
        key(folder, what=""),
        key(folder, what="a: b, : c"),
        key(folder, file="with space.py"),
        key(folder, file="a: b.py"),
        key(folder, file='"quoted".py'),
        key(folder, file="../beside/node.py"),
    ]
    keys = [*odd, key(folder), key(folder)]
    baseline_file.write(Path("known.txt"), keys)
    normal = [Key(one.code, os.path.normpath(one.file), one.what) for one in keys]
    assert sorted(entry.key for entry in baseline_file.read(Path("known.txt")).entries) == sorted(normal)


def test_files_are_named_from_the_folder_of_the_baseline(folder: Path, monkeypatch: pytest.MonkeyPatch):
    (folder / "ci").mkdir()
    baseline_file.write(Path("ci/known.txt"), [key(folder)])
    assert lines("ci/known.txt") == ["SRV003 ../src/node.py: on_request, plan"]
    monkeypatch.chdir("ci")
    [entry] = baseline_file.read(Path("known.txt")).entries
    assert entry.key == key(folder)


def test_the_order_of_lines_comments_and_other_ends_of_line_do_not_matter(folder: Path):
    Path("known.txt").write_bytes(b"\n# ours since May\r\nSRV003 src/node.py: on_request, plan\r\n\r\nNME001 a.py: x")
    entries = baseline_file.read(Path("known.txt")).entries
    assert [(entry.line, entry.key) for entry in entries] == [
        (3, key(folder)),
        (5, key(folder, "NME001", "a.py", "x")),
    ]


def test_the_comment_at_the_top_stays(folder: Path):
    baseline_file.write(Path("known.txt"), [key(folder)])
    text = Path("known.txt").read_text("utf-8").replace("SRV003", "# ask Kim before you add a line\nSRV003")
    Path("known.txt").write_text(text, "utf-8")
    baseline_file.write(Path("known.txt"), [])
    assert Path("known.txt").read_text("utf-8").endswith("# ask Kim before you add a line\n")


CONFLICT = """\
NME001 a.py: x
<<<<<<< HEAD
NME001 b.py: x
=======
NME001 c.py: x
>>>>>>> feature
"""


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (CONFLICT, "known.txt:2: a merge conflict"),
        ("NME001 a.py: x\nnode.py is fine\n", "known.txt:2: not an entry"),
        ("NME001\n", "known.txt:1: not an entry"),
        ('NME001 "a\\q.py": x\n', "known.txt:1: not an entry"),
        ('{"NME001": 3}\n', "known.txt:1: not an entry"),
        (b"NME001 a.py: x\n\nNME001 \xff.py: x\n", "known.txt:3: is not UTF-8"),
    ],
)
def test_a_line_that_is_none_is_named_and_not_repeated(text: str | bytes, said: str):
    Path("known.txt").write_bytes(text.encode() if isinstance(text, str) else text)
    with pytest.raises(BaselineError) as raised:
        baseline_file.read(Path("known.txt"))
    assert str(raised.value).startswith(said)
    assert "fine" not in str(raised.value)


def test_a_conflict_is_solved_by_writing_again(folder: Path):
    Path("known.txt").write_text(f"{baseline_file.MARK}: ours\n{CONFLICT}", "utf-8")
    entries = baseline_file.read_to_rewrite(Path("known.txt")).entries
    assert [Path(entry.key.file).name for entry in entries] == ["a.py", "b.py", "c.py"]


def test_no_other_file_is_overwritten():
    Path("node.py").write_text("import rclpy\n", "utf-8")
    with pytest.raises(BaselineError, match=r"node.py is not a baseline, so it is not overwritten"):
        baseline_file.read_to_rewrite(Path("node.py"))


def test_a_read_only_file_stays_as_it_is(folder: Path):
    baseline_file.write(Path("known.txt"), [])
    Path("known.txt").chmod(0o444)
    with pytest.raises(BaselineError, match=r"cannot write known.txt: the file is read-only"):
        baseline_file.write(Path("known.txt"), [key(folder)])
    assert lines("known.txt") == []


def test_a_folder_that_is_not_there():
    with pytest.raises(BaselineError, match=r"cannot write ci/known.txt: No such file or directory"):
        baseline_file.write(Path("ci/known.txt"), [])
