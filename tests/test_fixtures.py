"""Every workspace of ``fixtures/`` gives the findings that its ``expected.toml`` lists, no more and no fewer."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.rulebook import rules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FIXTURES = Path(__file__).parents[1] / "fixtures"
WORKSPACES = sorted(path.parent.name for path in FIXTURES.glob("*/expected.toml"))


@pytest.mark.parametrize("closed_world", [False, True], ids=["open", "closed"])
@pytest.mark.parametrize("name", WORKSPACES)
def test_a_workspace_gives_the_findings_that_are_expected_of_it(
    name: str, closed_world: bool, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(FIXTURES / name)
    settings = replace(load(FIXTURES / name), closed_world=closed_world)

    report = check(Request((".",), settings, cached=False, jobs=1))

    expected = expected_of(name, closed_world)
    found = [(finding.code, finding.place.file, finding.place.line) for finding in report.findings]
    found = [anywhere(one) if anywhere(one) in expected else one for one in found]
    assert sorted(found, key=str) == sorted(expected, key=str)


Expected = tuple[str, str, "int | None"]
"""Code, file and line of a finding; None where the line does not matter."""


def anywhere(found: Expected) -> Expected:
    code, file, _ = found
    return (code, file, None)


def expected_of(name: str, closed_world: bool) -> list[Expected]:
    """What a workspace's rules must find, of the rules that have a page by now."""
    listed = tomllib.loads((FIXTURES / name / "expected.toml").read_text("utf-8"))["finding"]
    return [
        (one["code"], one["file"], one.get("line"))
        for one in listed
        if one["code"] in rules() and (closed_world or not one.get("closed_world", False))
    ]
