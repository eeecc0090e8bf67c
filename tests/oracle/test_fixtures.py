"""The fixture systems are executed, and each entity of the run is held against the graph."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
FIXTURES = PROJECT / "fixtures"
SYSTEMS = sorted(path.name for path in FIXTURES.iterdir() if (path / "src").is_dir())
BY_DATA = ("unbounded.py", "patterns.py")  # there a run decides by chance what the graph leaves open


def graph_of(workspace: Path) -> dict:
    """What `archlint graph` says."""
    done = subprocess.run(
        [sys.executable, "-m", "archlint", "graph", ".", "--format", "json", "--no-cache"],
        cwd=workspace,
        env={**os.environ, "PYTHONPATH": str(PROJECT / "src")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stdout, done.stderr
    return json.loads(done.stdout)


def compared(workspace: Path):
    """The scores of the graph against a run of the same workspace, and the run."""
    from benchmarks.accuracy.compare import compare
    from benchmarks.accuracy.oracle.run import Oracle

    record = Oracle(workspace).run()
    return compare(record, graph_of(workspace)), record


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_graph_of_a_system_is_what_runs(system, tmp_path):
    shutil.copytree(FIXTURES / system, tmp_path / system)
    comparison, record = compared(tmp_path / system)
    assert record["entities"]
    assert comparison.misses == []
    assert comparison.wrong == []


def test_every_form_is_read_as_it_runs(tmp_path):
    shutil.copytree(FIXTURES / "forms", tmp_path / "forms", ignore=shutil.ignore_patterns(*BY_DATA))
    comparison, record = compared(tmp_path / "forms")
    assert len(record["entities"]) > 300
    assert comparison.wrong == []
    # Which of several star imports a message comes from, the packages alone could say.
    assert [miss for miss in comparison.misses if not miss.startswith("star_imports/") or "name is" in miss] == []
