"""``# archlint: ignore[…]``: what it hides and what it does not."""

from __future__ import annotations

import pytest

from archlint.engine.suppressions import apply, refusal, stale
from archlint.finding import Finding, Place, Severity
from archlint.syntax.facts import Suppression


def finding(line: int, code: str = "SRV003", name: str = "nested-service-call") -> Finding:
    return Finding(code, name, Severity.ERROR, "it waits", Place("node.py", line, 5, line, 20))


def ignore(codes: list[str], applies_to: tuple[int, int] = (12, 12), scope: str = "line") -> Suppression:
    return Suppression(applies_to[0], 30, 60, applies_to, codes, scope)


@pytest.mark.parametrize("code", ["SRV003", "srv003", "nested-service-call"])
def test_a_comment_hides_the_findings_of_its_line(code: str):
    outcome = apply([finding(11), finding(12)], {"node.py": [ignore([code])]})
    assert [one.place.line for one in outcome.kept] == [11]
    assert [one.place.line for one in outcome.suppressed] == [12]
    assert outcome.unused == []


def test_all_lines_of_the_statement_are_covered():
    outcome = apply([finding(12), finding(14), finding(15)], {"node.py": [ignore(["SRV003"], (12, 14))]})
    assert [one.place.line for one in outcome.kept] == [15]


def test_a_file_is_covered_whole():
    outcome = apply([finding(1), finding(900)], {"node.py": [ignore(["SRV003"], (1, 1), "file")]})
    assert outcome.kept == []


@pytest.mark.parametrize("code", ["SRV002", "SRV", "ALL", "*"])
def test_other_codes_prefixes_and_wildcards_hide_nothing(code: str):
    suppression = ignore([code])
    outcome = apply([finding(12)], {"node.py": [suppression]})
    assert len(outcome.kept) == 1
    [unused] = outcome.unused
    assert (unused.file, unused.suppression, unused.code) == ("node.py", suppression, code)


def test_another_file_is_not_covered():
    assert len(apply([finding(12)], {"other.py": [ignore(["SRV003"])]}).kept) == 1


def test_of_several_codes_the_unused_ones_are_told_apart():
    outcome = apply([finding(12)], {"node.py": [ignore(["SRV003", "TMO001"])]})
    assert [one.code for one in outcome.unused] == ["TMO001"]


def test_a_bare_ignore_is_refused():
    bare = ignore([])
    outcome = apply([finding(12)], {"node.py": [bare]})
    assert len(outcome.kept) == 1
    assert outcome.refused == [("node.py", bare)]
    assert refusal("node.py", bare) == (
        "node.py:12:30: a bare `archlint: ignore` has no effect; name the rule, as in `# archlint: ignore[SRV003]`"
    )


def test_a_failure_of_archlint_itself_cannot_be_hidden():
    failed = finding(1, "LNT003", "internal-error")
    assert apply([failed], {"node.py": [ignore(["LNT003"], (1, 1), "file")]}).kept == [failed]


def test_one_finding_for_each_comment_with_all_that_it_need_not_name():
    unused = apply([finding(12)], {"node.py": [ignore(["SRV003", "TMO001", "TMO002"])]}).unused
    [found] = stale(unused, frozenset({"SRV003", "TMO001", "TMO002"}))
    assert (found.code, found.place.line, found.message) == (
        "LNT001",
        12,
        "this suppression of TMO001, TMO002 is unused",
    )


def test_rules_that_did_not_run_are_left_alone():
    unused = apply([], {"node.py": [ignore(["SRV003", "TMO001"])]}).unused
    assert stale(unused, frozenset({"OWN001"})) == []


def test_a_code_of_no_rule():
    unused = apply([], {"node.py": [ignore(["SRV033"])]}).unused
    [found] = stale(unused, frozenset())
    assert found.message == "there is no rule SRV033; did you mean SRV003?"
