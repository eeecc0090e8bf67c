"""Which names a function binds, held against Python's own symbol tables."""

from __future__ import annotations

import symtable
import textwrap

import pytest

from archlint.interpreter.bindings import bound_in, bound_names
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from interpreting import assert_like_python

BODIES = [
    "a = 1",
    "a, (b, *c) = 1, (2, 3)",
    "a: int = 1",
    "a: int",
    "a += 1",
    "a.b = c[0] = 1",
    "for a, b in c:\n    d = 1\nelse:\n    e = 1",
    "while a:\n    b = 1\nelse:\n    c = 1",
    "if a:\n    b = 1\nelif c:\n    d = 1\nelse:\n    e = 1",
    "with a as b, c as (d, e):\n    f = 1",
    "try:\n    a = 1\nexcept E as b:\n    c = 1\nelse:\n    d = 1\nfinally:\n    e = 1",
    "match a:\n    case [b, *c]:\n        d = 1\n    case {'k': e, **f}:\n        pass\n    case g | g:\n        pass\n"
    "    case P(h, x=i) as j:\n        pass",
    "import a, b.c, d as e",
    "from a import b, c as d",
    "def a(b=c):\n    d = 1",
    "class a(b):\n    c = 1",
    "global a\na = 1\nb = 2",
    "async with a as b:\n    async for c in d:\n        pass",
    "if (a := 1) and (b := 2):\n    pass",
    "while (a := next()) is not None:\n    pass",
    "print(a := 1, *(b := []), c=(d := 2))",
    "x = not (a := 1)",
    "return (a := 1)",
    "assert (a := 1)",
    "[a for a in b]",
    "lambda a: a",
    "del a",
]


def of_python(text: str) -> tuple[set[str], set[str]]:
    """The names that a function binds, and those that it declares global."""
    [function] = symtable.symtable(text, "it.py", "exec").get_children()
    symbols = function.get_symbols()
    outer = {symbol.get_name() for symbol in symbols if symbol.is_declared_global()}
    return {symbol.get_name() for symbol in symbols if symbol.is_local()}, outer


def function_of(text: str) -> facts.Function:
    function = lower(text).body[0]
    assert isinstance(function, facts.Function)
    return function


@pytest.mark.parametrize("body", BODIES)
def test_the_names_of_a_function_are_pythons(body: str):
    text = f"async def f(p, /, q, *r, s=1, **t):\n{textwrap.indent(body, '    ')}\n"
    local, outer = of_python(text)
    found, declared = bound_names(function_of(text))
    # What a function deletes it has assigned, too, or its caller gets an error.
    assert set(found) == local - ({"a"} if body == "del a" else set())
    assert set(declared) == outer


def test_names_of_an_outer_function():
    text = "def f():\n    a = 1\n    def g():\n        nonlocal a\n        a, b = 2, 3\n"
    inner = function_of(text).body[1]
    assert isinstance(inner, facts.Function)
    assert bound_names(inner) == ({"b"}, {"a"})


def test_names_of_a_lambda():
    [statement] = lower("lambda a, *b, c=1: (d := a)").body
    assert isinstance(statement, facts.Expression) and isinstance(statement.value, facts.Lambda)
    assert bound_names(statement.value) == ({"a", "b", "c", "d"}, set())


def test_names_of_a_block():
    assert bound_in(lower("a = 1\nif a:\n    b = 2\ndef c():\n    d = 1\n").body) == {"a", "b", "c"}


def test_which_variable_a_name_means():
    assert_like_python(
        """
        name = 'module'

        def reads():
            return name

        def own():
            name = 'own'
            return name

        def around():
            name = 'around'

            def inner():
                return name

            class Inside:
                name = 'class'

                def method(self):
                    return name

            return inner(), Inside().method(), Inside.name

        def declares():
            global name
            name = 'declared'
            return name

        def walrus():
            return [(last := each) for each in range(3)]

        results = reads(), own(), around(), walrus(), declares(), reads()
        """
    )
