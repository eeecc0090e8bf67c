"""The fixture systems are executed, and each entity of the run is held against the graph."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine import pipeline
from archlint.render.json import document

PROJECT = Path(__file__).resolve().parents[2]
FIXTURES = PROJECT / "fixtures"
SYSTEMS = sorted(path.name for path in FIXTURES.iterdir() if (path / "src").is_dir())
BY_DATA = ("unbounded.py", "patterns.py")  # there a run decides by chance what the graph leaves open


@pytest.fixture
def compared(tmp_path, monkeypatch, processes):
    """The scores of the graph of a workspace against a run of it, and the run."""
    from benchmarks.accuracy.compare import compare
    from benchmarks.accuracy.oracle.run import Oracle

    def run(name: str, *left_out: str):
        workspace = tmp_path / name
        shutil.copytree(FIXTURES / name, workspace, ignore=shutil.ignore_patterns(*left_out))
        record = Oracle(workspace, processes=processes).run()
        monkeypatch.chdir(workspace)
        graph = document(pipeline.graph(pipeline.Request((".",), load(workspace), cached=False)))
        return compare(record, graph), record

    return run


@pytest.mark.parametrize("system", SYSTEMS)
def test_the_graph_of_a_system_is_what_runs(system, compared):
    comparison, record = compared(system)
    assert record["entities"]
    assert comparison.misses == []
    assert comparison.wrong == []


def test_every_form_is_read_as_it_runs(compared):
    comparison, record = compared("forms", *BY_DATA)
    assert len(record["entities"]) > 300
    assert comparison.wrong == []
    # Which of several star imports a message comes from, the packages alone could say.
    assert [miss for miss in comparison.misses if not miss.startswith("star_imports/") or "name is" in miss] == []
