"""How much memory there is for worker processes, and how many of them that is enough for.

Linux tells it, in ``/proc`` and in the folders of control groups (version 2 and 1), which is how containers and CI jobs
are limited.  Elsewhere nothing is known, and the processors alone decide.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

TYPICAL_BYTES = 500_000_000
"""What a worker has at its peak for the files of a usual workspace, with room to spare; the largest files take more."""
MOST_BYTES = 3_000_000_000
"""What a worker may take beside what it begins with; the largest file that is read needs 2.7 GB at the most."""

_ROOT = Path("/")
_UNLIMITED = 1 << 60
"""From here on the limit of a group of version 1 means that there is none."""


def default_processes() -> int:
    """How many processes work at the same time where nobody says: as many as there are processors and memory for."""
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    free = free_bytes()
    return processors if free is None else max(1, min(processors, free // TYPICAL_BYTES))


def free_bytes(root: Path = _ROOT) -> int | None:
    """The bytes that this process and its children may still take; None where that is not known."""
    return min((*_of_machine(root), *_of_groups(root)), default=None)


def own_bytes(root: Path = _ROOT) -> int | None:
    """The address space of this process in bytes; None where that is not known."""
    text = _text(root / "proc" / "self" / "statm").split()
    return int(text[0]) * os.sysconf("SC_PAGE_SIZE") if text else None


def _of_machine(root: Path) -> Iterator[int]:
    for line in _text(root / "proc" / "meminfo").splitlines():
        name, _, value = line.partition(":")
        if name == "MemAvailable":
            yield int(value.split()[0]) * 1024


def _of_groups(root: Path) -> Iterator[int]:
    """What each control group of this process, and each above it, leaves."""
    for line in _text(root / "proc" / "self" / "cgroup").splitlines():
        _, kinds, path = line.split(":", 2)
        if kinds == "":
            folder, names = root / "sys/fs/cgroup", ("memory.max", "memory.current")
        elif "memory" in kinds.split(","):
            folder, names = root / "sys/fs/cgroup/memory", ("memory.limit_in_bytes", "memory.usage_in_bytes")
        else:
            continue
        own = Path(path.strip("/"))  # inside a container the folder of the group may be the top one
        for group in (own, *own.parents):
            limit, used = (_text(folder / group / name).strip() for name in names)
            if limit.isdigit() and used.isdigit() and int(limit) < _UNLIMITED:
                yield max(0, int(limit) - int(used))


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, ValueError):
        return ""
