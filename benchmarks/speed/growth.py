"""How time and memory grow with a workspace, and which file takes longest."""

from __future__ import annotations

import statistics
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.speed.processes import CHECK, Cost, run
from benchmarks.speed.workspaces import make_workspace


@dataclass(frozen=True)
class Size:
    """The medians of cold runs over a workspace of so many packages."""

    packages: int
    cost: Cost


def growth(sizes: Sequence[int], rounds: int) -> Iterator[Size]:
    """Cold runs of one process over made-up workspaces."""
    with tempfile.TemporaryDirectory() as temporary:
        for packages in sizes:
            folder = Path(temporary, str(packages))
            make_workspace(folder, packages)
            costs = [run([*CHECK, "--no-cache", "--jobs", "1"], folder) for _ in range(rounds)]
            yield Size(packages, _median(costs))


def _median(costs: Sequence[Cost]) -> Cost:
    return Cost(
        statistics.median(cost.wall for cost in costs),
        statistics.median(cost.cpu for cost in costs),
        statistics.median(cost.peak for cost in costs),
    )


def slowest_files(checkout: Path, shown: int) -> list[tuple[float, str]]:
    """The files that take longest when each is checked alone, with seconds of CPU; the largest tenth of those that
    use rclpy is tried: to try all of them takes hours, and without rclpy there is nothing to check."""
    using = [file for file in checkout.rglob("*.py") if b"rclpy" in file.read_bytes()]
    files = sorted(using, key=lambda file: (-file.stat().st_size, file))
    largest = files[: max(shown, len(files) // 10)]
    with tempfile.TemporaryDirectory() as temporary:
        costs: list[tuple[float, str]] = []
        for file in largest:
            alone = Path(temporary, "node.py")
            alone.write_bytes(file.read_bytes())
            cost = run([*CHECK, "--no-cache", "--jobs", "1"], alone.parent)
            costs.append((cost.cpu, str(file.relative_to(checkout))))
    return sorted(costs, reverse=True)[:shown]
