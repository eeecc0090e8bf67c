"""Every page of the rule book keeps its word: its Bad blocks give the marked findings and its Good ones none."""

from __future__ import annotations

from pathlib import Path

import pytest

from archlint.config import load
from archlint.session import Request, check
from rule_examples import Example, load_examples

EXAMPLES = load_examples(Path(__file__).parents[1] / "rules")


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.id)
def test_an_example_gives_exactly_the_findings_it_is_marked_with(
    example: Example, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    example.write(tmp_path)
    monkeypatch.chdir(tmp_path)

    report = check(Request((".",), load(tmp_path), cached=False, jobs=1))

    found = [(finding.place.file, finding.place.line, finding.code) for finding in report.findings]
    assert sorted(found) == sorted(example.expected)
