"""Findings under headings, the most important of them, and where to start when there are many."""

from __future__ import annotations

from dataclasses import replace

import pytest
from reports import NESTED, SAFE, UNREADABLE, UNSAFE, report

from archlint.finding import Finding, Place
from archlint.report import render
from archlint.report.groups import most_important
from archlint.report.model import GroupName, Report
from archlint.report.starting_points import MANY, starting_points


def headings(by: GroupName, *findings: Finding) -> list[str]:
    packages = {"pkg/node.py": "planner"}
    text = render("concise", replace(report(*findings), grouping=by, packages=packages))
    return [block.splitlines()[0] for block in text.split("\n\n")]


@pytest.mark.parametrize(
    ("by", "expected"),
    [
        (
            "rule",
            [
                "LNT001 unused-suppression: 2 findings",
                "LNT002 unreadable-file: 1 finding",
                "SRV003 nested-service-call: 1 finding",
            ],
        ),
        ("package", ["no package: 1 finding", "planner: 3 findings"]),
        ("node", ["/planner: 1 finding", "no node: 3 findings"]),
        ("file", ["pkg/broken.py: 1 finding", "pkg/node.py: 3 findings"]),
    ],
)
def test_findings_stand_under_headings(by: GroupName, expected: list[str]):
    assert headings(by, SAFE, NESTED, SAFE, UNREADABLE) == expected


def test_a_heading_in_text_stands_alone():
    text = render("text", replace(report(UNREADABLE), grouping="file"))
    assert text.splitlines()[:3] == [
        "pkg/broken.py: 1 finding",
        "",
        "warning[LNT002] unreadable-file: syntax error: expected ':'",
    ]


def test_what_was_named_by_the_user_cannot_steer_the_terminal():
    finding = replace(UNREADABLE, place=Place("a\x1b[2J.py", 1, 1, 1, 1))
    assert "\x1b" not in render("concise", replace(report(finding), grouping="file"))


def at(file: str, finding: Finding) -> Finding:
    return replace(finding, place=replace(finding.place, file=file))


def test_errors_are_more_important_and_launched_code_before_other_code():
    resting, started, of_system = (
        at("a.py", NESTED),
        at("b.py", NESTED),
        replace(at("c.py", NESTED), system="x.launch.py"),
    )
    every = replace(report(UNREADABLE, resting, started, of_system), launched=["b.py"])
    assert most_important(every, 9) == [started, of_system, resting, UNREADABLE]
    assert most_important(every, 2) == [started, of_system]


def test_few_findings_need_no_start():
    assert starting_points(report(*[NESTED] * MANY)) == ""


def many(*findings: Finding, launched: list[str]) -> Report:
    return replace(report(*findings), launched=launched, packages={"pkg/node.py": "planner"})


def test_many_begin_with_the_errors_that_are_launched():
    findings = [at("idle.py", NESTED), NESTED, *[UNREADABLE] * 4, *[UNSAFE] * 7]
    assert (
        starting_points(many(*findings, launched=["pkg/node.py"]))
        == """\
Where to start:
  1 error in code that a launch file starts:
    pkg/node.py:8:18 SRV003 nested-service-call
  TMO001 wait-without-timeout has 7 of the 13 findings: `archlint explain TMO001`
  the package planner has 8 of the 13 findings"""
    )


def test_where_no_error_is_launched_all_count():
    text = starting_points(many(*[NESTED] * 8, *[UNREADABLE] * 9, launched=[]))
    assert text.splitlines()[1] == "  8 errors:"
    assert text.count("nested-service-call\n") == 5
    assert "\n    and 3 more\n" in text


def test_one_rule_that_finds_everything_is_no_news():
    assert starting_points(report(*[UNREADABLE] * 20)) == ""


def test_what_has_as_many_as_another_is_no_start():
    findings = [*[UNREADABLE] * 6, *[UNSAFE] * 6]
    assert starting_points(report(*findings)) == ""
