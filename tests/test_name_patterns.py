from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.name_patterns import LONGEST_TEXT, InvalidPattern, compile_pattern, matches

CHARACTERS = st.sampled_from(["a", "b", ".", "_", "[ab]", "[^a]", "[]a]", r"\w", r"\d", r"\."])
SUFFIXES = st.sampled_from(["*", "+", "?", "{2}", "{1,2}", "{,2}", "{1,}", "*?"])
GROUPS = st.sampled_from(["(%s)", "(?:%s)", "(?=%s)", "(?!%s)", "(?P<x>%s)"])
PATTERNS = st.recursive(
    CHARACTERS,
    lambda inner: st.one_of(
        st.tuples(inner, inner).map("".join),
        st.tuples(inner, inner).map(lambda two: f"(?:{two[0]}|{two[1]})"),
        st.tuples(GROUPS, inner).map(lambda two: two[0] % two[1]),
        st.tuples(inner, SUFFIXES).map(lambda two: f"(?:{two[0]}){two[1]}"),
    ),
    max_leaves=6,
)


@given(PATTERNS, st.text("ab_.1", max_size=8))
def test_it_says_what_python_says(pattern: str, text: str):
    try:
        expected = re.fullmatch(pattern, text) is not None
    except re.error:  # one name for two groups
        return
    assert matches(pattern, text) is expected


@pytest.mark.parametrize("pattern", ["(a+)+b", "(a|a)*b", "(((a*)*)*)*b", "(.*a){20}b"])
def test_it_comes_to_an_end_where_python_does_not(pattern: str):
    assert matches(pattern, "a" * LONGEST_TEXT) is not True


def test_what_takes_too_much_work_is_not_judged():
    assert matches("(?:(?:(?:a?){250}){250}){250}b", "a" * LONGEST_TEXT) is None
    assert matches("a*", "a" * (LONGEST_TEXT + 1)) is None


@pytest.mark.parametrize("pattern", [r"(a)\1", "(?i)a", "(?<=a)b", "[", "a" * 501, "(" * 30 + "a" + ")" * 30])
def test_what_cannot_be_matched_so_is_refused(pattern: str):
    with pytest.raises(InvalidPattern):
        compile_pattern(pattern)
