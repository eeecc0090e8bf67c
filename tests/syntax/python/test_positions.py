"""Spans: the same places as libcst's own provider gives, which is right but slow."""

from __future__ import annotations

import libcst
import pytest
from libcst.metadata import MetadataWrapper, PositionProvider

from archlint.syntax.python.lowering import lower
from archlint.syntax.python.positions import CommentPositions, LineTable, Positions, SpanFinder

SOURCES = {
    "a call over several lines": (
        "self.pub = self.create_publisher(\n    String,  # type\n    'chatter',\n    10,\n)\nx = 1\n"
    ),
    "decorators": "@a\n@b(\n  1\n)\n\n# why\ndef f(x: int = 1, *args, **kw) -> str:\n    return x\n",
    "a decorated class with a footer": "@a\nclass A(B, metaclass=C):\n    x = 1\n\n    # end\n\ny = 2\n",
    "tabs": "if a:\n\tb = f(\t1)\n\tif c:\n\t\td\n",
    "non-ASCII characters": "naïve = 'Grüße 🤖'; é = f('é', ñ)\n",
    "Windows newlines": "def f():\r\n    '''a\r\n    b'''\r\n    return g(\r\n        1)\r\nf()\r\n",
    "old Mac newlines": "a = f(1)\rb = g(2)\r",
    "form feeds": "a = 1\n\x0c\nclass A:\n    b = f(2)\n\x0c\n    c = 3\n",
    "line continuations": "a = 1 + \\\n    f(2)\nassert a, \\\n    'b'\n",
    "no newline at the end": "a = f(1)\nif a: g(2)",
    "strings over several lines": "a = '''b\nc''' 'd' f'''{e(\n1)}\n{f!r:>{g}}'''; h('i')\n",
    "parentheses": "a = (  (b) + (c(d))  )\n(e).f\n((g))(h)\n",
    "semicolons and suites on the line": "a(); b() ; c()\nfor i in j: k(); l()\n",
    "every compound statement": (
        "async def f():\n  async with a as b, c: pass\n  async for i in j:\n    await k\n  else:\n    pass\n"
        "while a:\n  break\nelse:\n  b\n"
        "try:\n  a\nexcept B as e:\n  c\nexcept (D, E):\n  f\nelse:\n  g\nfinally:\n  h\n"
        "with (a as b,\n      c):\n  d\n"
        "match a:\n  case [1, *b] if c: d\n  case {'k': e, **f}:\n    g\n"
    ),
    "imports": "import a.b as c, d\nfrom . import (\n  e,\n  f as g,\n)\nfrom h import *\n",
    "lambdas, slices and comprehensions": (
        "a = lambda x, *y, z=1, **k: x[1:2, ::3]\nb = {c: d for c, d in e if f}\ng(h for h in i)\n"
        "j = [*k, (yield), not l, -m, n if o else p, (q := r)]\n"
    ),
    "an indented comment at the end": "if a:\n    b\n    # c\n  # d\n",
    "an empty file": "",
}


@pytest.mark.parametrize("source", SOURCES.values(), ids=SOURCES)
@pytest.mark.parametrize("kind", [Positions, CommentPositions])
def test_every_statement_and_expression_is_where_libcst_says(source, kind):
    module = libcst.parse_module(source)
    expected = MetadataWrapper(module, unsafe_skip_copy=True).resolve(PositionProvider)
    spans = SpanFinder(source, kind(module))
    compared = 0
    for node, place in expected.items():
        if isinstance(node, (libcst.BaseExpression, libcst.BaseSmallStatement, libcst.BaseCompoundStatement)):
            start, end = place.start, place.end
            assert spans.of(node) == (start.line, start.column + 1, end.line, end.column + 1), node
            compared += 1
    assert compared or not source


def test_columns_count_characters_and_the_end_is_exclusive():
    (statement,) = lower("x = 'é🤖', y\n").body
    text, name = statement.value.elements
    assert text.span == (1, 5, 1, 9)
    assert name.span == (1, 11, 1, 12)


def test_parentheses_and_white_space_are_outside():
    (statement,) = lower("x = ( a )\n").body
    assert statement.value.span == (1, 7, 1, 8)


def test_a_definition_begins_at_its_first_decorator_and_is_named_at_its_name():
    _, function = lower("x = 1\n@timed\n@cached\nasync def run(self):\n    return 1\n\n\n").body
    assert function.span == (2, 1, 5, 13)
    assert function.name_span == (4, 11, 4, 14)


def test_a_subscript_of_several_indices_spans_them():
    (statement,) = lower("a[1, b:c]\n").body
    assert statement.value.index.span == (1, 3, 1, 9)


def test_an_import_in_parentheses_ends_behind_them():
    (statement,) = lower("from a import (\n  b,\n)  # c\n").body
    assert statement.span == (1, 1, 3, 2)


@pytest.mark.parametrize(
    ("text", "offset", "place"),
    [
        ("", 0, (1, 1)),
        ("ab", 2, (1, 3)),
        ("a\nb", 2, (2, 1)),
        ("a\r\nb", 3, (2, 1)),
        ("a\n", 2, (2, 1)),
        ("a\x0cb\u2028c", 4, (1, 5)),
    ],
)
def test_line_table(text, offset, place):
    assert LineTable(text).place(offset) == place


def test_line_table_answers_in_any_order():
    lines = LineTable("ab\ncd\n\nef")
    assert [lines.place(offset) for offset in (7, 0, 4, 6, 1)] == [(4, 1), (1, 1), (2, 2), (3, 1), (1, 2)]
