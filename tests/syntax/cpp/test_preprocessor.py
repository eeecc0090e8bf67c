"""Branches of the preprocessor that hold no whole statements."""

from __future__ import annotations

from textwrap import dedent

from archlint.syntax.cpp.preprocessor import with_whole_branches


def kept(source: str) -> list[str]:
    """The lines that are left, without those that are blank."""
    text = with_whole_branches(dedent(source).encode()).decode()
    assert text.count("\n") == dedent(source).count("\n")
    return [line.strip() for line in text.splitlines() if line.strip()]


def test_the_first_branch_stays_where_each_opens_a_block() -> None:
    source = """
        #if A && \\
          B
        if (a) {
        #else
        if (b) {
        #endif
        }
    """
    assert kept(source) == ["if (a) {", "}"]


def test_a_block_under_a_condition_of_its_own_stays_whole() -> None:
    source = """
        #ifdef A
        if (a) {
        #endif
        go();
        #ifdef A
        }
        #endif
    """
    assert kept(source) == ["if (a) {", "go();", "}"]


def test_whole_branches_stay_as_they_are() -> None:
    source = '#if A\nf("{"); // (\n#else\ng();\n#endif\n'
    assert with_whole_branches(source.encode()) == source.encode()


def test_what_if_0_leaves_out_is_no_code() -> None:
    source = """
        if (a) { one(); }
        #if 0
        else if (b) { two(); }
        #endif
        else if (c) { three(); }
        #if 0  // the old way
        old();
        #else
        now();
        #endif
    """
    assert kept(source) == ["if (a) { one(); }", "else if (c) { three(); }", "now();"]
