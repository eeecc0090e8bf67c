"""The concise format, and the sentences that may stand beside findings."""

from __future__ import annotations

import pytest
from reports import NESTED, SAFE, UNREADABLE, UNSAFE, report

from archlint.report import render
from archlint.report.fix_marks import fix_line
from archlint.report.model import summarise, summary_line


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


def test_a_safe_fix_is_marked():
    assert render("concise", report(SAFE, UNSAFE)) == (
        "pkg/node.py:2:1: warning: LNT001 [*] it hides nothing\n"
        "pkg/node.py:4:20: warning: TMO001 it waits without a timeout\n"
    )


@pytest.mark.parametrize(
    ("findings", "sentence"),
    [
        ([NESTED], ""),
        ([SAFE, NESTED], "[*] 1 fixable with `--fix`."),
        ([SAFE, SAFE, UNSAFE], "[*] 2 fixable with `--fix` (1 more with `--fix --unsafe-fixes`)."),
        ([UNSAFE], "No safe fixes; 1 fixable with `--fix --unsafe-fixes`."),
    ],
    ids=["none", "safe", "both", "unsafe"],
)
def test_what_has_a_fix_in_a_sentence(findings: list, sentence: str):
    assert fix_line(findings) == sentence
