"""Patterns with many stars: they mean what the library says, in time that does not explode."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.workspace.ignore import Rule, _of_library
from archlint.workspace.starred import StarredPattern, has_many_stars

NAMES = st.lists(st.sampled_from(["a", "b", "ab", "aab", "abab", "ba.py"]), min_size=1, max_size=4)
PARTS = st.lists(
    st.one_of(st.just("**"), st.text(alphabet="ab*?", min_size=1, max_size=5).filter(lambda part: "**" not in part)),
    min_size=1,
    max_size=4,
)


@given(PARTS, NAMES, st.booleans(), st.booleans())
def test_a_pattern_means_what_the_library_says(parts, names, is_folder, for_folders):
    line = "/" + "/".join(parts) + ("/" if for_folders else "")
    if parts[-1] == "**":
        line += "*" if for_folders else "/*"  # `a/**` is `a/**/*` here
    # Folders are asked about first: below one that a pattern speaks of, the library need not speak of any.
    paths = ["/".join(names[:end]) + "/" for end in range(1, len(names))]
    paths.append("/".join(names) + ("/" if is_folder else ""))
    ignores, speaks_of = _of_library(line)
    starred = StarredPattern(line)
    assert (starred.ignores, any(map(starred.speaks_of, paths))) == (ignores, any(map(speaks_of, paths)))


@pytest.mark.parametrize(
    ("line", "path", "means"),
    [
        ("*a*b*c", "xaybzc", True),
        ("*a*b*c", "xaybzd", False),
        ("*[!x]*[^y]*.py", "ab.py", True),
        (r"*\**\**\*", "a*b*c*", True),
        (r"*\**\**\*", "abc", False),
        ("!*_*_*_*.py", "a_b_c_d.py", True),
        ("*_*_*_*/", "a_b_c_d/", True),
        ("*_*_*_*/", "a_b_c_d", False),
        ("**/a/**/b/**/c", "x/a/b/y/c", True),
        ("**/a/**/b/**/c", "x/a/c", False),
    ],
)
def test_stars_in_one_name_and_between_folders(line, path, means):
    assert has_many_stars(line)
    rule = Rule(line)
    assert rule.speaks_of(path) is means
    assert rule.ignores is not line.startswith("!")


@pytest.mark.parametrize("line", ["*a" * 40 + "b", "**/a/" * 40 + "b"])
def test_forty_stars_are_no_work(line):
    assert not Rule(line).speaks_of("a" * 200)
    assert not Rule(line).speaks_of("a/" * 100 + "c")
