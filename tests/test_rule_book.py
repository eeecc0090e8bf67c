"""Every page of the rule book keeps its word: its Bad blocks give the marked findings and its Good ones none."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.testing.pages import Example, load_examples
from archlint.testing.running import findings_of

EXAMPLES = load_examples(Path(__file__).parents[1] / "rules")


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.id)
def test_an_example_gives_exactly_the_findings_it_is_marked_with(
    example: Example, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    assert findings_of(example, tmp_path) == sorted(example.expected)
