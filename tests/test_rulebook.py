"""The rule book: pages, the rules they declare, and the functions that implement them."""

from __future__ import annotations

import pytest

from archlint import checks, rulebook
from archlint.checks.registry import registered
from archlint.finding import Severity
from archlint.rulebook import RuleBookError, codes_of, parse_page, rules, suggestion

PAGE = """---
code: SRV003
name: nested-service-call
severity: error
default: on
fix: none
since: 0.1.0
summary: A service handler waits for another service: both may hang
---
# SRV003 nested-service-call

```python
client.call(request)  # expect: SRV003
```
"""


def test_a_page_declares_its_rule():
    rule = parse_page(PAGE, "SRV003-nested-service-call.md")
    assert (rule.code, rule.name, rule.severity) == ("SRV003", "nested-service-call", Severity.ERROR)
    assert (rule.default, rule.fix, rule.since) == ("on", "", "0.1.0")
    assert rule.summary == "A service handler waits for another service: both may hang"


def test_readers_do_not_see_the_marks_of_the_test_suite():
    page = parse_page(PAGE, "page").page
    assert "client.call(request)\n" in page
    assert "expect" not in page


@pytest.mark.parametrize(
    ("before", "after", "complaint"),
    [
        ("---\ncode", "code", "front matter"),
        ("severity: error", "severity: grave", "GRAVE"),
        ("severity: error\n", "", "severity"),
        ("default: on", "default: maybe", "default is on, off or closed-world"),
        ("fix: none", "fix: perhaps", "fix is safe, unsafe or none"),
        ("fix: none", "- fix", "not a line of `key: value`"),
    ],
)
def test_a_page_that_cannot_be_used_says_why(before: str, after: str, complaint: str):
    with pytest.raises(RuleBookError, match=complaint):
        parse_page(PAGE.replace(before, after, 1), "page.md")


def test_every_page_belongs_to_a_rule_that_runs_and_the_other_way_round():
    assert set(rules()) == {*registered(), *checks.MADE_BY_SESSION}


def test_names_are_unique():
    names = [rule.name for rule in rules().values()]
    assert len(names) == len(set(names))


def test_selectors(monkeypatch: pytest.MonkeyPatch):
    book = {code: parse_page(PAGE.replace("SRV003", code), code) for code in ("OWN001", "SRV002", "SRV003")}
    monkeypatch.setattr(rulebook, "rules", lambda: book)
    assert codes_of("ALL") == ["OWN001", "SRV002", "SRV003"]
    assert codes_of("SRV") == codes_of("srv00") == ["SRV002", "SRV003"]
    assert codes_of("SRV003") == codes_of("srv003") == ["SRV003"]
    assert codes_of("SRV9") == codes_of("") == codes_of("no such name") == []


def test_a_rule_is_found_by_its_name():
    assert codes_of("unreadable-file") == ["LNT002"]


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("LNT02", "LNT002"),
        ("LTN", "LNT"),
        ("unreadable-fil", "unreadable-file (LNT002)"),
    ],
)
def test_an_unknown_selector_suggests_the_nearest(typed: str, meant: str):
    assert suggestion(typed) == f"; did you mean {meant}?"


def test_for_what_is_near_nothing_the_list_is_named():
    assert suggestion("zzzzzz") == "; `archlint rules` lists them"
