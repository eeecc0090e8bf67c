"""A repository with a rule of its own."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "docs" / "plugin"
RULES = "tools/our_rules.py"


@pytest.fixture
def repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The example of the documentation: a timer of 100 Hz, where 50 are allowed."""
    folder = tmp_path / "robot"
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("test_*", "__pycache__"))
    monkeypatch.chdir(folder)
    monkeypatch.delenv("ARCHLINT_PLUGINS", raising=False)
    return folder


@pytest.fixture
def marked(repository: Path) -> Path:
    """The same; whoever runs the plugin leaves a file."""
    rules = repository / RULES
    rules.write_text(f"{rules.read_text()}\nopen({str(repository / 'ran')!r}, 'w').close()\n")
    return repository / "ran"
