"""The concise format, and the sentence and the table that may stand beside findings."""

from __future__ import annotations

import pytest
from reports import NESTED, UNREADABLE, report

from archlint.report import render
from archlint.report.model import statistics, summarise, summary_line


def test_one_line_a_finding():
    assert render("concise", report(NESTED, UNREADABLE)) == (
        "pkg/node.py:8:18: error: SRV003 the handler of /plan waits for /map\n"
        "pkg/broken.py:3:1: warning: LNT002 syntax error: expected ':'\n"
    )


@pytest.mark.parametrize(
    ("findings", "suppressed", "unresolved", "sentence"),
    [
        ([], 0, 0, "No findings in 42 files with 1 node."),
        ([], 0, 1, "No findings in 42 files with 1 node; 1 unresolved."),
        ([NESTED], 0, 0, "Found 1 error in 42 files with 1 node."),
        (
            [NESTED, UNREADABLE, UNREADABLE],
            3,
            2,
            "Found 1 error, 2 warnings in 42 files with 1 node; 3 suppressed; 2 unresolved.",
        ),
    ],
)
def test_the_run_in_a_sentence(findings: list, suppressed: int, unresolved: int, sentence: str):
    summary = summarise(findings, files=42, nodes=1, suppressed=suppressed, unresolved=unresolved, elapsed_s=0.1)
    assert summary_line(summary) == sentence


def test_statistics_begin_with_the_most_frequent():
    findings = [NESTED, *[UNREADABLE] * 10]
    assert statistics(findings) == "10  LNT002  unreadable-file\n 1  SRV003  nested-service-call\n"
    assert statistics([]) == ""
