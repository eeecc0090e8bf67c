"""``archlint server`` where it cannot serve."""

from __future__ import annotations

import importlib.util

import pytest

from archlint.cli import main


def test_without_the_extra_it_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)

    assert main(["server"]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err == 'archlint: error: the server needs what is not installed: pip install "archlint[lsp]"\n'
