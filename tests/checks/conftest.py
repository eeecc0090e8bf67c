from __future__ import annotations

from pathlib import Path

import pytest

from checks.callbacks import Run, findings
from checks.judging import Judge


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    monkeypatch.chdir(tmp_path)
    return Judge(tmp_path)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """Runs the rules that are on by default over one file."""
    monkeypatch.chdir(tmp_path)
    return lambda text, distro=None: findings(tmp_path, text, distro)
