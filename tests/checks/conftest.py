"""What tests of rules share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from checks.judging import EVERYWHERE
from robot_package import write_robot


@pytest.fixture
def findings(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., list[Finding]]:
    """What one rule finds in the package ``robot`` with a launch file in XML, and other files."""
    monkeypatch.chdir(tmp_path)

    def run(code: str, launch: str = "", **files: str) -> list[Finding]:
        write_robot(tmp_path, launch, **{"archlint.toml": f'select = ["{code}"]\n' + EVERYWHERE.get(code, "")} | files)
        return check(Request((".",), load(tmp_path), cached=False, jobs=1)).findings

    return run
