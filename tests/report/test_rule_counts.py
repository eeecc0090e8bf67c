"""``--statistics``: how often each rule found something, as lines and as JSON."""

from __future__ import annotations

import json
from dataclasses import replace

from reports import NESTED, SAFE, UNREADABLE, UNSAFE

from archlint.report.statistics import as_json, as_text


def test_the_most_frequent_rule_is_first():
    assert as_text([NESTED, *[UNREADABLE] * 10]) == "10\tLNT002\tunreadable-file\n 1\tSRV003\tnested-service-call\n"
    assert as_text([]) == ""


def test_a_mark_says_whether_all_or_some_of_it_is_fixable():
    by_hand = replace(SAFE, fix=None)
    assert as_text([SAFE, SAFE, by_hand, UNSAFE]).splitlines() == [
        "3\tLNT001\t[-] unused-suppression",
        "1\tTMO001\t[ ] wait-without-timeout",
    ]
    assert as_text([SAFE]) == "1\tLNT001\t[*] unused-suppression\n"


def test_json_has_the_keys_of_ruff():
    assert json.loads(as_json([SAFE, NESTED, SAFE])) == [
        {"code": "LNT001", "name": "unused-suppression", "count": 2, "fixable": True, "fixable_count": 2},
        {"code": "SRV003", "name": "nested-service-call", "count": 1, "fixable": False, "fixable_count": 0},
    ]
    assert json.loads(as_json([])) == []
