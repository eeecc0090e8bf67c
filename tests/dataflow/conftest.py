"""Small systems, traced."""

from __future__ import annotations

from pathlib import Path

import pytest

from dataflow.tracing import Traced


@pytest.fixture
def traced(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Traced:
    monkeypatch.chdir(tmp_path)
    return Traced(tmp_path)
