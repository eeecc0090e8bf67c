"""The cache of whole runs: when it answers, when it does not, and that nothing in it can do harm."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from archlint import run_cache
from archlint.finding import Finding, Place, Related, Severity
from archlint.report.model import summarise
from archlint.run_cache import RunCache

FINDING = Finding(
    code="OWN001",
    name="multiple-publishers",
    severity=Severity.WARNING,
    message="two nodes publish /cmd_vel",
    place=Place("src/a.py", 1, 2, 3, 4),
    help="name one owner",
    node="/a",
    system="robot.launch.py",
    related=(Related(Place("src/b.py", 5, 6, 7, 8), "the other publisher"),),
    identity=("/cmd_vel",),
)
SUMMARY = summarise([FINDING], files=2, nodes=2, suppressed=0, unresolved=1, elapsed_s=0.5)


@pytest.fixture
def source(tmp_path: Path) -> Path:
    path = tmp_path / "a.py"
    path.write_text("first")
    return path


def cache(source: Path, *request: object) -> RunCache:
    return RunCache(source.parent / "cache", ["options", *request], [str(source)])


def save(source: Path) -> None:
    cache(source).save([FINDING], SUMMARY, ["a notice"])


def age(path: Path, seconds: int = 100) -> None:
    """Make a file look as if it had been changed long ago."""
    status = path.stat()
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns - seconds * 10**9))


def test_an_unchanged_run_gives_back_what_was_found(source: Path):
    assert cache(source).load() is None
    save(source)
    findings, summary, notices = cache(source).load() or ([], None, [])
    assert findings == [FINDING]
    assert findings[0].identity == ("/cmd_vel",)
    assert (summary, notices) == (SUMMARY, ["a notice"])


def test_nothing_is_read_where_no_status_changed(source: Path, monkeypatch: pytest.MonkeyPatch):
    age(source)
    save(source)
    monkeypatch.setattr(run_cache, "_digest", lambda path: pytest.fail(f"read {path}"))
    assert cache(source).load()


def test_a_changed_file_is_a_miss(source: Path):
    save(source)
    source.write_text("second, and longer")
    assert cache(source).load() is None


def test_a_change_that_its_status_does_not_show_is_a_miss_all_the_same(source: Path):
    save(source)
    status = source.stat()
    source.write_text("secnd")
    os.utime(source, ns=(status.st_atime_ns, status.st_mtime_ns))
    assert cache(source).load() is None


def test_a_touched_file_is_not_a_changed_one(source: Path):
    save(source)
    age(source)
    assert cache(source).load()


def test_other_options_other_files_and_other_code_are_misses(source: Path, monkeypatch: pytest.MonkeyPatch):
    save(source)
    assert cache(source, "--select=SRV").load() is None
    assert RunCache(source.parent / "cache", ["options"], [str(source), "b.py"]).load() is None
    monkeypatch.setattr(run_cache, "own_code", lambda: [("rule.py", 1, 1)])
    assert cache(source).load() is None


def test_a_file_that_goes_away_is_a_miss(source: Path):
    save(source)
    source.unlink()
    assert cache(source).load() is None


def test_a_file_that_changed_during_the_run_is_not_kept(source: Path):
    running = cache(source)
    source.write_text("second, and longer")
    running.save([], SUMMARY, [])
    assert cache(source).load() is None


def test_without_a_folder_nothing_is_kept(source: Path):
    for _ in range(2):
        off = RunCache(None, ["options"], [str(source)])
        assert off.load() is None
        off.save([], SUMMARY, [])


@pytest.mark.parametrize(
    "damage",
    [
        lambda record: b"",
        lambda record: b"\xff\xfe",
        lambda record: b"[" * 100_000,
        lambda record: b"[]",
        lambda record: json.dumps({**record, "result": {}}).encode(),
        lambda record: json.dumps({**record, "written": "soon"}).encode(),
        lambda record: json.dumps(
            {**record, "result": {**record["result"], "findings": [{"severity": "fatal"}]}}
        ).encode(),
    ],
)
def test_a_damaged_record_is_a_miss(source: Path, damage):
    save(source)
    [path] = (source.parent / "cache" / "runs").iterdir()
    path.write_bytes(damage(json.loads(path.read_bytes())))
    assert cache(source).load() is None


def test_a_folder_that_cannot_be_written_is_no_error(source: Path):
    (source.parent / "cache").write_text("a file, not a folder")
    save(source)
    assert cache(source).load() is None
