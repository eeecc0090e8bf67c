"""Small workspaces that the oracle executes."""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))


@pytest.fixture(scope="module")
def processes():
    """The servers that all runs live in; each run is a fork of one."""
    from benchmarks.accuracy.oracle.processes import Pool, Python

    pool = Pool(Python())
    yield pool
    pool.close()


@pytest.fixture
def execute(tmp_path, processes):
    """Write files into a workspace, run everything in it, and give the oracle's record."""
    from benchmarks.accuracy.oracle.run import Oracle

    def run(files: dict[str, str] | str) -> dict:
        for name, text in ({"node.py": files} if isinstance(files, str) else files).items():
            path = tmp_path / "workspace" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(textwrap.dedent(text).lstrip("\n"), encoding="utf-8")
        return Oracle(tmp_path / "workspace", processes=processes).run()

    return run


@pytest.fixture
def entities(execute):
    """As `execute`, but only (line, kind, name) of each entity."""

    def run(files: dict[str, str] | str) -> list[tuple[int, str, str | None]]:
        return [(each["line"], each["kind"], each["name"]) for each in execute(files)["entities"]]

    return run
