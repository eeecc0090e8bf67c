"""Suppression comments and the lines they cover."""

from __future__ import annotations

import pytest

from archlint.syntax.facts import Suppression
from archlint.syntax.python.lowering import lower


def only(text: str) -> Suppression:
    (suppression,) = lower(text).suppressions
    return suppression


def covered(text: str) -> tuple[int, int]:
    return only(text).applies_to


class TestSpelling:
    @pytest.mark.parametrize(
        ("comment", "codes"),
        [
            ("# archlint: ignore[SRV003]", ["SRV003"]),
            ("#archlint:ignore[SRV003]", ["SRV003"]),
            ("#  archlint:  ignore [ SRV003 , hardcoded-name ]", ["SRV003", "hardcoded-name"]),
            ("# archlint: ignore[SRV003] the peer is local", ["SRV003"]),
            ("# noqa: E501  # archlint: ignore[SRV003]", ["SRV003"]),
            ("# archlint: ignore", []),
            ("# archlint: ignore[]", []),
            ("# archlint: ignore[,]", []),
        ],
    )
    def test_codes_are_kept_as_written(self, comment, codes):
        suppression = only(f"a()  {comment}\n")
        assert suppression.codes == codes
        assert suppression.scope == "line"

    @pytest.mark.parametrize(
        "source",
        [
            "a('# archlint: ignore[SRV003]')\n",
            "'''\n# archlint: ignore[SRV003]\n'''\na()\n",
            "a()  # see archlint: ignore[SRV003]\n",
            "a()  # archlint: ignored[SRV003]\n",
            "a()  # archlint: ignore-line[SRV003]\n",
            "a()  # noqa: SRV003\n",
        ],
    )
    def test_what_only_looks_like_one(self, source):
        assert not any(one.codes for one in lower(source).suppressions)

    def test_place_of_the_comment(self):
        suppression = only("x = 'é'  # noqa  # archlint: ignore[A]  why\n")
        assert (suppression.line, suppression.column, suppression.end_column) == (1, 18, 39)

    def test_two_in_one_comment(self):
        found = lower("a()  # archlint: ignore[A]  # archlint: ignore[B]\n").suppressions
        assert [suppression.codes for suppression in found] == [["A"], ["B"]]

    def test_a_whole_file(self):
        suppression = only("import a\n\n# archlint: ignore-file[NME001]\nb()\n")
        assert (suppression.scope, suppression.codes, suppression.line) == ("file", ["NME001"], 3)
        assert suppression.applies_to[0] == 1
        assert suppression.applies_to[1] >= 4


class TestEndOfLine:
    def test_covers_its_line(self):
        assert covered("a()\nb()  # archlint: ignore[A]\nc()\n") == (2, 2)

    def test_covers_all_lines_of_a_call(self):
        assert covered("a()\nb(\n    1,\n    2,\n)  # archlint: ignore[A]\nc()\n") == (2, 5)

    def test_inside_a_call_covers_the_whole_call(self):
        assert covered("a()\nb(\n    1,  # archlint: ignore[A]\n    2,\n)\nc()\n") == (2, 5)

    def test_on_its_own_line_inside_a_call(self):
        assert covered("b(\n    # archlint: ignore[A]\n    1,\n)\nc()\n") == (1, 4)

    def test_covers_all_lines_of_a_string(self):
        assert covered("a = '''\nb\n'''  # archlint: ignore[A]\n") == (1, 3)

    def test_on_a_header_covers_the_header_alone(self):
        source = "class A:\n    def f(\n        self,\n    ):  # archlint: ignore[A]\n        b()\n"
        assert covered(source) == (2, 4)

    def test_on_the_line_of_a_suite_covers_both(self):
        assert covered("if a: b()  # archlint: ignore[A]\nc()\n") == (1, 1)

    @pytest.mark.parametrize(
        "source",
        [
            "try:\n    a()\nexcept (  # archlint: ignore[A]\n    E\n):\n    b()\n",
            "if a:\n    b()\nelif (c  # archlint: ignore[A]\n    or d\n):\n    e()\n",
            "match a:\n  # b\n  case (1  # archlint: ignore[A]\n    | 2\n  ):\n    c()\n",
        ],
    )
    def test_on_a_clause(self, source):
        assert covered(source) == (3, 5)

    def test_on_a_match(self):
        assert covered("match f(\n  a\n):  # archlint: ignore[A]\n  case 1: pass\n") == (1, 3)

    def test_on_a_decorator_covers_what_is_decorated(self):
        assert covered("x = 1\n@a  # archlint: ignore[A]\n@b\n\ndef f():\n    c()\n") == (2, 5)

    def test_on_a_decorated_header(self):
        assert covered("@a\ndef f():  # archlint: ignore[A]\n    c()\n") == (1, 2)

    def test_without_a_newline_at_the_end(self):
        assert covered("a()\nb()  # archlint: ignore[A]") == (2, 2)

    def test_with_windows_newlines(self):
        assert covered("a()\r\nb(\r\n1)  # archlint: ignore[A]\r\nc()\r\n") == (2, 3)


class TestOwnLine:
    def test_covers_the_next_statement(self):
        assert covered("a()\n# archlint: ignore[A]\nb(\n    1,\n)\nc()\n") == (3, 5)

    def test_over_blank_lines_and_other_comments(self):
        assert covered("a()\n# archlint: ignore[A]\n\n# because\n  # of this\nb()\n") == (6, 6)

    def test_covers_the_header_of_a_compound_statement(self):
        assert covered("# archlint: ignore[A]\nwith a(\n  1\n):\n    b()\n") == (2, 4)

    def test_covers_decorators_and_header(self):
        assert covered("# archlint: ignore[A]\n@a(\n)\ndef f():\n    b()\n") == (2, 4)

    def test_between_decorators_and_definition(self):
        assert covered("@a\n# archlint: ignore[A]\ndef f():\n    b()\n") == (1, 3)

    def test_at_the_start_of_a_body(self):
        assert covered("def f():\n    # archlint: ignore[A]\n    b()\n    c()\n") == (3, 3)

    def test_at_the_end_of_a_file_covers_nothing_else(self):
        assert covered("a()\n# archlint: ignore[A]\n") == (2, 2)

    def test_behind_a_form_feed(self):
        assert covered("a()\n\x0c# archlint: ignore[A]\n\x0cb()\n") == (3, 3)
