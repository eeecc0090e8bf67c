"""The text format: code frames, plain and in colour."""

from __future__ import annotations

import re

import pytest
from reports import NESTED, UNREADABLE, report

from archlint.finding import Finding, Place, Related, Severity
from archlint.report import render


def shown(finding: Finding, source: str | None = None) -> str:
    return render("text", report(finding, sources=None if source is None else {finding.place.file: source}))


def at(line: int, column: int, end_line: int, end_column: int, message: str = "it is wrong") -> Finding:
    place = Place("a.py", line, column, end_line, end_column)
    return Finding("TOP001", "topic-type-mismatch", Severity.ERROR, message, place)


def test_a_finding_shows_what_where_and_what_to_do():
    assert (
        shown(NESTED)
        == """\
error[SRV003] nested-service-call: the handler of /plan waits for /map
 --> pkg/node.py:8:18
  |
4 |         self.map = self.create_client(GetMap, 'map')
  |                    --------------------------------- the client is created here
...
7 |     def on_plan(self, request, response):
8 |         answer = self.map.call(GetMap.Request())
  |                  ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
9 |         response.map = answer.map
  |
 ::: pkg/main.py:1:1
  |
1 | rclpy.spin(node)
  | ---------------- one thread spins the node
  |
  = help: use call_async
"""
    )


def test_findings_are_parted_by_an_empty_line():
    assert render("text", report(NESTED, UNREADABLE)).count("\n\n") == 1


def test_a_file_that_cannot_be_shown_has_no_frame():
    assert shown(UNREADABLE) == (
        "warning[LNT002] unreadable-file: syntax error: expected ':'\n --> pkg/broken.py:3:1\n"
    )


def test_a_related_place_that_cannot_be_shown_still_speaks():
    related = Related(Place("gone.py", 3, 1, 3, 9), "the other publisher")
    finding = Finding("OWN001", "multiple-publishers", Severity.WARNING, "two", NESTED.place, related=(related,))
    assert " ::: gone.py:3:1\n  = line 3: the other publisher\n" in shown(finding)


def test_nothing_found_says_nothing():
    assert render("text", report()) == ""


@pytest.mark.parametrize(
    ("source", "finding", "underlined"),
    [
        ("x = f(1)", at(1, 5, 1, 9), "1 | x = f(1)\n  |     ^^^^\n"),
        ("\tf(1)", at(1, 2, 1, 6), "1 |     f(1)\n  |     ^^^^\n"),
        ("y = '日本' + f(1)", at(1, 12, 1, 16), "1 | y = '日本' + f(1)\n  |              ^^^^\n"),
        ("y = '日本'", at(1, 5, 1, 9), "1 | y = '日本'\n  |     ^^^^^^\n"),
        ("f(\n  1)", at(1, 1, 2, 5), "1 | f(\n  | ^^\n2 |   1)\n"),
        ("f", at(1, 1, 1, 1), "1 | f\n  | ^\n"),
        ("f", at(1, 9, 1, 12), "1 | f\n  |  ^\n"),
    ],
    ids=["plain", "tab", "wide before", "wide inside", "several lines", "empty span", "past the end"],
)
def test_the_underline_stands_under_the_place(source: str, finding: Finding, underlined: str):
    assert underlined in shown(finding, source)


def test_a_very_long_line_is_cut_around_the_place():
    text = shown(at(1, 5001, 1, 5005), "a" * 5000 + "BBBB" + "c" * 5000)
    code, marks = re.findall(r"\|(.*)\n", text)[1:3]
    assert len(code) < 200
    assert code.index("BBBB") == marks.index("^^^^")
    assert code.startswith(" …a") and code.endswith("c…")


def test_what_the_user_wrote_cannot_steer_the_terminal():
    finding = Finding(
        "NME001",
        "hardcoded-name",
        Severity.WARNING,
        "name '\x1b]0;owned\x07' [red]x[/red]",
        Place("evil\x1b[2J.py", 1, 1, 1, 2),
        help="\x9b31m \u202e",
        related=(Related(Place("evil\x1b[2J.py", 1, 1, 1, 2), "here\r"),),
    )
    text = render("text", report(finding, sources={finding.place.file: "\x1b[31mx\x00"}))
    assert not re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e]", text)
    assert "[red]x[/red]" in text


def test_colours_add_nothing_but_colours():
    coloured = render("text", report(NESTED, UNREADABLE), color=True)
    assert "\x1b[1;31merror[SRV003]" in coloured
    assert re.sub(r"\x1b\[[0-9;]*m", "", coloured) == render("text", report(NESTED, UNREADABLE))


def test_the_system_of_a_finding_is_named():
    finding = Finding("OWN001", "multiple-publishers", Severity.WARNING, "two", NESTED.place, system="a.launch.py")
    assert "  = system: a.launch.py\n" in shown(finding)
