"""Patterns of several names, one below the other."""

from __future__ import annotations

import pytest

from archlint.name_paths import matches_names


def a(name: str) -> bool:
    return name == "a"


@pytest.mark.parametrize(
    ("pattern", "names", "matches"),
    [
        ([a], "a", True),
        ([a], "b", False),
        ([a], "a/a", False),
        ([None], "b/c", True),
        ([None, a], "a", True),
        ([None, a], "b/c/a", True),
        ([None, a], "b/c/a/b", False),
        ([a, None, a], "a/a", True),
        ([a, None, a], "a/b/a", True),
        ([a, None, a], "a", False),
        ([None, a] * 40, "/".join("a" * 60), True),
        ([*[None, a] * 40, bool], "/".join("a" * 39 + "b"), False),
    ],
)
def test_names_below_each_other(pattern, names: str, matches: bool):
    assert matches_names(pattern, names.split("/")) is matches
