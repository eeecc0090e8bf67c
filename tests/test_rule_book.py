"""Every page of the rule book keeps its word: its Bad blocks give the marked findings and its Good ones none."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.selection import Layer
from archlint.config.settings import Settings, load
from archlint.engine import baseline_file
from archlint.engine.pipeline import Request, check
from archlint.observed.read import read
from archlint.report import concise
from archlint.rulebook import OFF, rules
from rule_examples import Example, load_examples

EXAMPLES = load_examples(Path(__file__).parents[1] / "rules")


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.id)
def test_an_example_gives_exactly_the_findings_it_is_marked_with(
    example: Example, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    example.write(tmp_path)
    monkeypatch.chdir(tmp_path)

    observed = read("observed.json") if "observed.json" in example.files else None
    settings = _settings(tmp_path, example.page_code)
    baseline = None if settings.baseline is None else baseline_file.read(Path(settings.baseline))
    report = check(Request((".",), settings, cached=False, jobs=1, observed=observed, baseline=baseline))

    found = [(finding.place.file, finding.place.line, finding.code) for finding in report.findings]
    assert sorted(found) == sorted(example.expected), concise.render(report)


def _settings(folder: Path, code: str) -> Settings:
    """The example's own configuration; a rule that is off by default is turned on for its page."""
    settings = load(folder)
    if rules()[code].default != OFF:
        return settings
    return replace(settings, layers=(*settings.layers, Layer(extend_select=(code,))))
