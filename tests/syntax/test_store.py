"""The cache: what it keeps, what it forgets, and whom it trusts."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.syntax import cache as store_module
from archlint.syntax.cache import NullStore, Stamp, Store, digest_of
from archlint.syntax.signed import signed

DAY = 24 * 3600
OLD: Stamp = (time.time_ns() - 200 * DAY * 10**9, 0, 12, 7)
"""The stamp of a file that was changed well before any run of these tests."""
DIGEST = digest_of(b"import rclpy")
OTHER = digest_of(b"import rospy")
RUN = "0" * 64
KEY = b"k" * 32


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return tmp_path / "cache"


def opened(root: Path) -> Store:
    return Store(str(root), "1.0", KEY)


def filled(root: Path) -> None:
    store = opened(root)
    store.put(DIGEST, b"facts")
    store.put_run(RUN, b"findings")
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()


def files_in(root: Path) -> list[Path]:
    return sorted(path for path in root.rglob("*") if path.is_file())


# --- keeping


def test_what_was_put_is_there_in_the_next_run(root):
    filled(root)
    store = opened(root)
    assert store.get(DIGEST) == b"facts"
    assert store.get_run(RUN) == b"findings"
    assert store.lookup("/ws/node.py", OLD) == DIGEST


def test_what_was_not_put_is_a_miss(root):
    filled(root)
    store = opened(root)
    assert store.get(OTHER) is None
    assert store.get_run("1" * 64) is None
    assert store.lookup("/ws/other.py", OLD) is None


@pytest.mark.parametrize("payload", [b"", b"-", b"\n\n", b"\0\xff" * 1_000], ids=["empty", "dash", "lines", "binary"])
def test_any_payload_comes_back_as_it_was(root, payload):
    opened(root).put(DIGEST, payload)
    assert opened(root).get(DIGEST) == payload


@pytest.mark.parametrize("place", range(4), ids=["modified", "status changed", "size", "inode"])
def test_a_file_whose_status_differs_in_anything_must_be_hashed(root, place):
    filled(root)
    stamp = list(OLD)
    stamp[place] += 1
    changed = (stamp[0], stamp[1], stamp[2], stamp[3])
    assert opened(root).lookup("/ws/node.py", changed) is None


def test_paths_that_are_not_utf8_are_kept(root):
    store = opened(root)
    store.remember("/ws/caf\udce9.py", OLD, DIGEST)
    store.close()
    assert opened(root).lookup("/ws/caf\udce9.py", OLD) == DIGEST


def test_the_digest_depends_on_content_and_purpose():
    assert len({DIGEST, OTHER, digest_of(b"import rclpy", "python 2"), digest_of(b"", "a"), digest_of(b"a")}) == 5


def test_versions_do_not_share_entries(root):
    filled(root)
    assert Store(str(root), "1.1", KEY).get(DIGEST) is None
    assert Store(str(root), "1.1", KEY).lookup("/ws/node.py", OLD) is None


def test_no_cache_keeps_nothing():
    store = NullStore()
    store.put(DIGEST, b"facts")
    store.put_run(RUN, b"findings")
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()
    assert (store.get(DIGEST), store.get_run(RUN), store.lookup("/ws/node.py", OLD)) == (None, None, None)


# --- times that prove nothing


def test_a_file_changed_just_before_the_run_is_not_trusted(root):
    store = opened(root)
    now = time.time_ns()
    young: Stamp = (now, now, 12, 7)
    store.remember("/ws/node.py", young, DIGEST)
    store.close()
    assert opened(root).lookup("/ws/node.py", young) is None


def test_a_file_from_the_future_is_not_trusted(root):
    store = opened(root)
    late: Stamp = (time.time_ns() + 10**15, 0, 12, 7)
    store.remember("/ws/node.py", late, DIGEST)
    store.close()
    assert opened(root).lookup("/ws/node.py", late) is None


def test_what_was_not_trusted_is_not_trusted_later_without_a_new_look(root, monkeypatch):
    now = time.time_ns()
    young: Stamp = (now, now, 12, 7)
    store = opened(root)
    store.remember("/ws/young.py", young, DIGEST)
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()
    monkeypatch.setattr(store_module.time, "time_ns", lambda: now + 100 * 10**9)
    later = opened(root)
    later.remember("/ws/other.py", OLD, OTHER)
    later.close()
    assert opened(root).lookup("/ws/young.py", young) is None
    again = opened(root)
    again.remember("/ws/young.py", young, DIGEST)
    again.close()
    assert opened(root).lookup("/ws/young.py", young) == DIGEST


def test_a_file_that_changed_again_is_forgotten(root):
    filled(root)
    store = opened(root)
    now = time.time_ns()
    store.remember("/ws/node.py", (now, now, 12, 7), OTHER)
    store.close()
    assert opened(root).lookup("/ws/node.py", OLD) is None


# --- the folder


def test_a_new_folder_is_marked_for_git_and_for_backups(root):
    filled(root)
    assert (root / ".gitignore").read_text() == "*\n"
    assert (root / "CACHEDIR.TAG").read_text().startswith("Signature: 8a477f597d28d172789f06886806bc55\n")


def test_a_folder_with_other_things_in_it_is_not_marked(root):
    root.mkdir()
    (root / "notes.txt").touch()
    filled(root)
    assert opened(root).get(DIGEST) == b"facts"
    assert not (root / ".gitignore").exists()


def test_nothing_is_made_where_nothing_is_kept(root):
    store = opened(root)
    assert store.get(DIGEST) is None
    store.close()
    assert not root.exists()


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path):
    (tmp_path / "file").touch()
    filled(tmp_path / "file" / "cache")
    filled(tmp_path / "file")
    assert files_in(tmp_path) == [tmp_path / "file"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_is_read(root):
    filled(root)
    folders = [root, *(path for path in root.rglob("*") if path.is_dir())]
    for folder in folders:
        folder.chmod(0o555)
    try:
        store = opened(root)
        store.put(OTHER, b"more")
        store.remember("/ws/other.py", OLD, OTHER)
        store.close()
        assert opened(root).get(OTHER) is None
        assert opened(root).get(DIGEST) == b"facts"
    finally:
        for folder in folders:
            folder.chmod(0o755)


def test_a_full_disk_is_no_error(root, monkeypatch):
    filled(root)
    before = files_in(root)

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(store_module.os, "replace", full)
    store = opened(root)
    store.put(OTHER, b"more")
    store.close()
    assert files_in(root) == before
    assert opened(root).get(DIGEST) == b"facts"


def test_a_folder_that_vanishes_during_a_run_is_no_error(root):
    store = opened(root)
    store.put(DIGEST, b"facts")
    for path in sorted(root.rglob("*"), reverse=True):
        path.unlink() if path.is_file() else path.rmdir()
    store.put(DIGEST, b"facts")
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()


# --- damage and malice


def test_damage_is_a_miss_never_a_wrong_answer(root):
    filled(root)
    generator = random.Random(2)
    originals = {path: path.read_bytes() for path in files_in(root)}
    for path, data in originals.items():
        for _ in range(60):
            damaged = bytearray(data)
            at = generator.randrange(len(data))
            damaged[at : at + generator.randrange(4)] = generator.randbytes(generator.randrange(1, 4))
            path.write_bytes(damaged[: generator.choice([at, len(damaged), len(damaged)])])
            store = opened(root)
            assert store.get(DIGEST) in (b"facts", None)
            assert store.get_run(RUN) in (b"findings", None)
            assert store.lookup("/ws/node.py", OLD) in (DIGEST, None)
            store.close()
        path.write_bytes(data)


def test_what_is_signed_with_another_key_is_a_miss(root):
    """A repository may ship a cache of its own files, and a machine may have many users."""
    filled(root)
    store = Store(str(root), "1.0", b"o" * 32)
    assert (store.get(DIGEST), store.get_run(RUN), store.lookup("/ws/node.py", OLD)) == (None, None, None)


def test_an_entry_under_another_name_is_a_miss(root):
    filled(root)
    opened(root).put(OTHER, b"more")
    [entry, other] = [next(root.rglob(digest)) for digest in (DIGEST, OTHER)]
    other.write_bytes(entry.read_bytes())
    assert (opened(root).get(DIGEST), opened(root).get(OTHER)) == (b"facts", None)


def write_index(root: Path, content: object) -> None:
    """An index as somebody else would write it, if he knew the key."""
    filled(root)
    index = Path(opened(root).folder) / "index.json"
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    index.write_bytes(signed(opened(root).folder, "index.json", data, KEY))


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[" * 100_000,
        b"1" * 10_000,
        [],
        {},
        {"swept": 0, "files": []},
        {"swept": 0, "files": {"/ws/node.py": "row"}},
        {"swept": 0, "files": {"/ws/node.py": [*OLD, DIGEST]}},
        {"swept": 0, "files": {"/ws/node.py": [*OLD, None, 1]}},
        {"swept": 0, "files": {"/ws/node.py": [*OLD[:3], "7", DIGEST, 1]}},
        {"swept": None, "files": {"/ws/node.py": [*OLD, DIGEST, 1]}},
        {"swept": 0, "files": {"/ws/node.py": [*OLD, "../../../" + DIGEST, 1]}},
    ],
    ids=range(12),
)
def test_an_index_of_the_wrong_shape_is_none(root, content):
    write_index(root, content)
    store = opened(root)
    assert store.lookup("/ws/node.py", OLD) is None
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()
    assert opened(root).lookup("/ws/node.py", OLD) == DIGEST


@pytest.mark.parametrize("key", ["../../../victim", "/etc/passwd", "", ".", "a/b", "0" * 20 + "/" + "0" * 20, "x\0"])
def test_no_key_leads_out_of_the_folder(root, key):
    store = opened(root)
    store.put(key, b"payload")
    store.put_run(key, b"payload")
    assert (store.get(key), store.get_run(key)) == (None, None)
    assert not root.exists()


@pytest.mark.parametrize("linked", ["", "facts", "runs", "facts/" + DIGEST[:2]])
def test_a_linked_folder_is_not_written_to(root, tmp_path, linked):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    link = Path(opened(root).folder) / linked
    link.parent.mkdir(parents=True)
    link.symlink_to(elsewhere, target_is_directory=True)
    filled(root)
    assert list(elsewhere.iterdir()) == []


def test_a_pipe_in_the_place_of_an_entry_is_not_waited_for(root):
    filled(root)
    for path in files_in(root):
        path.unlink()
        os.mkfifo(path)
    store = opened(root)
    assert (store.get(DIGEST), store.get_run(RUN), store.lookup("/ws/node.py", OLD)) == (None, None, None)


# --- forgetting


def days_ago(monkeypatch: pytest.MonkeyPatch, root: Path, days: int, run: Callable[[], None]) -> None:
    """Let a run have taken place some days ago."""
    before = {path: path.stat().st_mtime_ns for path in files_in(root)}
    then = time.time_ns() - days * DAY * 10**9
    with monkeypatch.context() as patch:
        patch.setattr(store_module.time, "time", lambda: then / 10**9)
        patch.setattr(store_module.time, "time_ns", lambda: then)
        run()
    for path in files_in(root):
        if path.stat().st_mtime_ns != before.get(path):
            os.utime(path, ns=(then, then))


def run_on_something_else(root: Path) -> None:
    store = opened(root)
    store.put(OTHER, b"more")
    store.remember("/ws/other.py", OLD, OTHER)
    store.close()


def test_what_no_run_asks_for_is_thrown_away(root, monkeypatch):
    days_ago(monkeypatch, root, 31, lambda: filled(root))
    run_on_something_else(root)
    store = opened(root)
    assert (store.get(DIGEST), store.get_run(RUN), store.lookup("/ws/node.py", OLD)) == (None, None, None)
    assert (store.get(OTHER), store.lookup("/ws/other.py", OLD)) == (b"more", OTHER)


def test_what_was_asked_for_lately_stays(root, monkeypatch):
    days_ago(monkeypatch, root, 29, lambda: filled(root))
    run_on_something_else(root)
    store = opened(root)
    assert (store.get(DIGEST), store.get_run(RUN)) == (b"facts", b"findings")
    assert store.lookup("/ws/node.py", OLD) == DIGEST


def test_facts_of_files_that_are_asked_about_stay(root, monkeypatch):
    def run_on_the_file() -> None:
        store = opened(root)
        assert store.lookup("/ws/node.py", OLD) == DIGEST
        store.close()

    days_ago(monkeypatch, root, 60, lambda: filled(root))
    days_ago(monkeypatch, root, 60, lambda: opened(root).put("all-" + DIGEST, b"more facts"))
    for days in (40, 20):
        days_ago(monkeypatch, root, days, run_on_the_file)
    run_on_something_else(root)
    assert opened(root).get(DIGEST) == b"facts"
    assert opened(root).get("all-" + DIGEST) == b"more facts"


def test_only_the_newest_results_of_runs_are_kept(root):
    store = opened(root)
    written = store_module.KEPT_RUNS + 10
    for number in range(written):
        store.put_run(f"{number:064}", b"findings")
        path = Path(store.folder) / "runs" / f"{number:064}"
        os.utime(path, (time.time() - 1000 + number,) * 2)
    store.remember("/ws/node.py", OLD, DIGEST)
    store.close()
    kept = [number for number in range(written) if opened(root).get_run(f"{number:064}") is not None]
    assert kept == list(range(10, written))


def test_entries_of_old_versions_go_too_and_nothing_that_is_not_ours(root, monkeypatch):
    folder = Path(opened(root).folder)
    foreign = [root / "notes.txt", folder / "thesis.txt", folder / "facts/x.txt"]

    def plant() -> None:
        filled(root)
        for path in foreign:
            path.touch()

    days_ago(monkeypatch, root, 31, plant)
    newer = Store(str(root), "2.0", KEY)
    newer.remember("/ws/node.py", OLD, DIGEST)
    newer.close()
    assert sorted(path for path in files_in(root) if folder in path.parents) == sorted(foreign[1:])
    assert foreign[0].exists()


@pytest.mark.parametrize("linked", ["0.9-3.11", "0.9-3.11/facts", "0.9-3.11/facts/00", "0.9-3.11/runs"])
def test_nothing_is_thrown_away_through_a_link(root, tmp_path, linked):
    elsewhere = tmp_path / "elsewhere"
    long_ago = time.time() - 1000 * DAY
    for folder in ("", "facts/00", "runs", "00"):
        (elsewhere / folder).mkdir(parents=True, exist_ok=True)
        (elsewhere / folder / DIGEST).write_text("somebody's blob")
        os.utime(elsewhere / folder / DIGEST, (long_ago, long_ago))
    link = root / linked
    link.parent.mkdir(parents=True)
    link.symlink_to(elsewhere, target_is_directory=True)
    before = files_in(elsewhere)
    filled(root)
    assert len(before) == 4
    assert files_in(elsewhere) == before


# --- several runs at a time

RUNS_OF_ONE_PROCESS = """
import sys
from archlint.syntax.cache import Store, digest_of

root, me = sys.argv[1:]
for round in range(30):
    store = Store(root, "1.0", b"k" * 32)
    for number in range(20):
        shared = digest_of(b"shared %d" % number)
        payload = b"payload of %d " % number * 2_000
        assert store.get(shared) in (None, payload)
        store.put(shared, payload)
        store.put_run(shared + "0" * 24, payload)
        store.remember(f"/ws/{me}/{number}.py", (1, 2, 3, 4), shared)
    for path in ("/ws/a/3.py", "/ws/b/3.py"):
        assert store.lookup(path, (1, 2, 3, 4)) in (None, digest_of(b"shared 3"))
    store.close()
"""


def test_runs_at_the_same_time_do_not_disturb_each_other(root):
    source = str(Path(store_module.__file__).parents[2])
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", RUNS_OF_ONE_PROCESS, str(root), me],
            env={**os.environ, "PYTHONPATH": source},
            stderr=subprocess.PIPE,
            text=True,
        )
        for me in ("a", "b")
    ]
    assert [(process.communicate()[1], process.returncode) for process in processes] == [("", 0)] * 2
    store = opened(root)
    for number in range(20):
        assert store.get(digest_of(b"shared %d" % number)) == b"payload of %d " % number * 2_000
    known = {me for me in ("a", "b") if store.lookup(f"/ws/{me}/7.py", (1, 2, 3, 4)) is not None}
    assert known
    assert [path.name for path in files_in(root) if path.suffix == ".tmp"] == []
