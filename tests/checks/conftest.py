from __future__ import annotations

from pathlib import Path

import pytest

from checks.judging import Judge


@pytest.fixture
def judge(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Judge:
    monkeypatch.chdir(tmp_path)
    return Judge(tmp_path)
