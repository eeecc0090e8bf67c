"""Sources that are small enough to read and would take all memory to parse: refused before a parser sees them."""

from __future__ import annotations

import pytest

from archlint.syntax import compile as compiler
from archlint.syntax.facts import decode
from archlint.syntax.python import gate


@pytest.mark.parametrize("token", ["1,", "(1),", "'a',", "x,", "-1,"])
def test_a_table_of_more_tokens_than_libcst_can_bear_is_refused(token: str) -> None:
    text = f"x = [{token * gate.MAX_TOKENS}]\n"
    refusal = gate.inspect(text)
    assert refusal is not None
    assert refusal.message == "the file is too large to analyse: more than 300,000 words, numbers and signs"


@pytest.mark.parametrize("text", ["x = '" + "a b " * 240_000 + "'\n", "# a b c d\n" * 90_000, "x = 1\n" * 60_000])
def test_long_texts_comments_and_code_are_not(text: str) -> None:
    assert len(text) > gate.MAX_TOKENS
    assert not gate.has_too_many_tokens(text)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"A<" * 200_000, "too many '<' to analyse (more than 20,000)"),
        (b"s << 1;" * 30_000, None),
        (b"std::vector<int> v;" * 1000, None),
    ],
)
def test_so_is_cpp_with_a_crowd_of_angle_brackets(data: bytes, message: str | None) -> None:
    facts = decode(compiler.encoded_cpp(b"void f() {" + data + b"}")[1:])
    assert facts is not None
    assert [problem.message for problem in facts.problems] == ([] if message is None else [message])
