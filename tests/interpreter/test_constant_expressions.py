"""``eval`` of a text: constants and a few operations on them, held against Python; nothing runs."""

from __future__ import annotations

import pytest

from archlint.interpreter.constant_expressions import NotFollowed, evaluate


@pytest.mark.parametrize(
    "text",
    [
        "1",
        "'a'",
        "None",
        "-1",
        "+2",
        "not 0",
        "1 and 0 and 2",
        "0 or '' or 'x'",
        "1 and 2",
        "0 or None",
        "1 < 2 < 3",
        "1 < 2 > 5",
        "'a' in ['a', 'b']",
        "3 not in [1]",
        "None is None",
        "None is not None",
        "1 + 2 * 3 - 4 / 2",
        "7 // 2 + 7 % 2",
        "'a' + 'b'",
        "[1] + [2]",
        "'x' if 1 > 0 else 'y'",
        "'x' if 1 < 0 else 'y'",
        "str(1)",
        "int('7')",
        "float('1.5')",
        "bool('')",
        "len('abc')",
        "' A '.strip().lower()",
        "'a'.upper()",
        "'abc'.startswith('a')",
        "'abc'.endswith('b')",
        "'a-b'.replace('-', '_')",
        "'a,b'.split(',')",
    ],
)
def test_is_what_python_says(text: str):
    assert evaluate(text) == eval(text)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "(",
        "name",
        "1 +",
        "~1",
        "2 ** 9",
        "'a' * 9",
        "'%s' % 1",
        "1 / 0",
        "1 + 'a'",
        "1 < 'a'",
        "-'a'",
        "int('a')",
        "b'a'",
        "1j",
        "{}",
        "[1][0]",
        "lambda: 1",
        "print(1)",
        "open('a')",
        "str(1, 2)",
        "int(x=1)",
        "len(None)",
        "'a'.join(['b'])",
        "'a'.strip(1)",
        "(1).lower()",
        "__import__('os').system('true')",
        "(" * 500 + ")" * 500,
        "'" + "a" * 100_000 + "'",
        "'" + "a" * 900 + "'.replace('a', '" + "b" * 900 + "')",
    ],
    ids=range(30),
)
def test_anything_else_is_not_followed(text: str):
    with pytest.raises(NotFollowed):
        evaluate(text)
