"""What the machine and its control groups leave, as Linux tells it."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.syntax import memory
from archlint.syntax.memory import TYPICAL_BYTES, default_processes, free_bytes, own_bytes
from archlint.syntax.workers import Crashed, run_in_workers


def lay_out(root: Path, **files: str) -> Path:
    for name, text in files.items():
        path = root / name.replace("__", "/").replace("DOT", ".")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


MEMINFO = "MemTotal:       8000000 kB\nMemFree:         100000 kB\nMemAvailable:    4000000 kB\n"


def test_what_the_machine_has_left(tmp_path: Path):
    assert free_bytes(lay_out(tmp_path, proc__meminfo=MEMINFO)) == 4_000_000 * 1024


def test_elsewhere_nothing_is_known(tmp_path: Path):
    assert free_bytes(tmp_path) is None
    assert own_bytes(tmp_path) is None


def test_the_narrowest_group_decides(tmp_path: Path):
    lay_out(tmp_path, proc__meminfo=MEMINFO, proc__self__cgroup="0::/ci/job\n")
    groups = tmp_path / "sys/fs/cgroup"
    for folder, limit, used in (("ci/job", "max", "700"), ("ci", "2000000000", "500000000")):
        (groups / folder).mkdir(parents=True, exist_ok=True)
        (groups / folder / "memory.max").write_text(f"{limit}\n")
        (groups / folder / "memory.current").write_text(f"{used}\n")
    assert free_bytes(tmp_path) == 1_500_000_000


def test_inside_a_container_the_group_may_be_the_top_one(tmp_path: Path):
    lay_out(tmp_path, proc__meminfo=MEMINFO, proc__self__cgroup="4:cpu,memory:/docker/1\n1:cpuset:/docker/1\n")
    group = tmp_path / "sys/fs/cgroup/memory"
    group.mkdir(parents=True)
    (group / "memory.limit_in_bytes").write_text("1000\n")
    (group / "memory.usage_in_bytes").write_text("1500\n")
    assert free_bytes(tmp_path) == 0


def test_a_group_of_version_1_without_a_limit(tmp_path: Path):
    lay_out(tmp_path, proc__meminfo=MEMINFO, proc__self__cgroup="4:memory:/\n")
    group = tmp_path / "sys/fs/cgroup/memory"
    group.mkdir(parents=True)
    (group / "memory.limit_in_bytes").write_text("9223372036854771712\n")
    (group / "memory.usage_in_bytes").write_text("1500\n")
    assert free_bytes(tmp_path) == 4_000_000 * 1024


@pytest.mark.parametrize(
    ("free", "processes"), [(0, 1), (TYPICAL_BYTES, 1), (3 * TYPICAL_BYTES, 3), (10**15, 8), (None, 8)]
)
def test_processes_by_memory_and_processors(monkeypatch: pytest.MonkeyPatch, free: int | None, processes: int):
    monkeypatch.setattr(memory, "free_bytes", lambda: free)
    monkeypatch.setattr(memory.os, "sched_getaffinity", lambda process: set(range(8)), raising=False)
    assert default_processes() == processes


def _takes(source: bytes) -> bytes:
    return bytes(len(bytearray(int(source))) // 1_000_000)


@pytest.mark.skipif(own_bytes() is None, reason="the limit is one beside what a process has, which only Linux tells")
def test_a_worker_that_takes_more_than_it_may_ends_alone():
    large, small = run_in_workers(_takes, [b"400000000", b"1000000"], 1, 30, most_bytes=200_000_000)
    assert isinstance(large, Crashed)
    assert small == b"\0"
