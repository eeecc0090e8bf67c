"""Numbers with what they count."""

from __future__ import annotations

import pytest

from archlint.counted import counted


@pytest.mark.parametrize(("number", "words"), [(0, "0 launch files"), (1, "1 launch file"), (2, "2 launch files")])
def test_only_one_is_singular(number: int, words: str):
    assert counted(number, "launch file") == words
