"""Brackets inside each other in YAML: PyYAML's scanner goes through all that are open at each token."""

from __future__ import annotations

import pytest

from archlint.syntax.rcl_yaml import DEEPEST, LaunchLoader
from archlint.syntax.safe_yaml import YamlError, YamlReader


@pytest.mark.parametrize("rcl", [False, True])
@pytest.mark.parametrize("brackets", ["[", "{a: ", "[{b: "])
def test_they_are_given_up_soon(brackets: str, rcl: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    fetched = 0
    fetch = LaunchLoader.fetch_more_tokens

    def counted(self: LaunchLoader) -> None:
        nonlocal fetched
        fetched += 1
        fetch(self)

    monkeypatch.setattr(LaunchLoader, "fetch_more_tokens", counted)
    with pytest.raises(YamlError, match="nested too deeply"):
        YamlReader("nodes: " + brackets * 30_000, rcl=rcl)
    assert fetched < 6 * DEEPEST


def test_some_are_read() -> None:
    reader = YamlReader("[" * 50 + "1" + "]" * 50)
    assert str(reader.value(reader.root)) == "[" * 50 + "1" + "]" * 50
