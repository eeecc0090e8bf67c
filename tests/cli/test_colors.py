"""When colours are written, and how wide lines may be."""

from __future__ import annotations

import io

import pytest

from archlint.cli.console import columns, wants_color


class Stream(io.StringIO):
    def __init__(self, terminal: bool) -> None:
        super().__init__()
        self.terminal = terminal

    def isatty(self) -> bool:
        return self.terminal


@pytest.mark.parametrize(
    ("when", "terminal", "environment", "colours"),
    [
        ("auto", True, {}, True),
        ("auto", False, {}, False),
        ("always", False, {"NO_COLOR": "1"}, True),
        ("never", True, {"FORCE_COLOR": "1"}, False),
        ("auto", True, {"NO_COLOR": "1"}, False),
        ("auto", True, {"NO_COLOR": ""}, True),
        ("auto", False, {"FORCE_COLOR": "1"}, True),
        ("auto", False, {"FORCE_COLOR": "0"}, False),
        ("auto", False, {"CLICOLOR_FORCE": "1"}, True),
        ("auto", False, {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        ("auto", True, {"CLICOLOR": "0"}, False),
        ("auto", True, {"TERM": "dumb"}, False),
    ],
)
def test_colours(monkeypatch, when: str, terminal: bool, environment: dict[str, str], colours: bool):
    for name in ("NO_COLOR", "FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-256color")
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert wants_color(when, Stream(terminal)) is colours


@pytest.mark.parametrize(
    ("terminal", "given", "width"),
    [(True, "100", 100), (True, "0", 80), (True, "wide", 80), (False, "100", None)],
    ids=["given", "zero", "no number", "a pipe"],
)
def test_only_a_terminal_has_a_width(monkeypatch, terminal: bool, given: str, width: int | None):
    monkeypatch.setenv("COLUMNS", given)
    assert columns(Stream(terminal)) == width
