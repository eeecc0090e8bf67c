"""Expressions, held against Python itself."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import Holed, Known, OneOf, Unknown
from interpreting import OUTSIDE, assert_like_python, evaluate, interpret


@pytest.mark.parametrize(
    "expression",
    [
        "(lambda a, b=3: a * b)(2)",
        "[i * j for i in range(4) for j in range(i) if j % 2 == 0]",
        "{key: value for key, value in zip('ab', [1, 2])}",
        "{i % 2 for i in range(5)}",
        "[[row for row in range(2)] for _ in range(2)]",
        "[x for x in (y for y in [1, 2, 3]) if x > 1]",
        "'a' and '' or 'c'",
        "0 or [] or 'last'",
        "1 and 2 and 0 and 3",
        "(number := 5) + number",
        "[*range(2), *'ab']",
        "(*[1], 2, *(3,))",
        "{**{'a': 1, 'b': 2}, 'b': 3}",
        "'abc'[::-1] + 'abc'[-1] + 'abcdef'[1:3]",
        "[1, 2, 3, 4][1:-1]",
        "(1, 2, 3)[::2]",
        "[1, 2][5:]",
        "'x' if not [] else 'y'",
        "'x' if {'a': 1} else 'y'",
        "not 0",
        "1 < 2 < 3",
        "1 < 2 > 5",
        "None is None",
        "[(1, 2), (3, 4)][1][0]",
        "{'a': {'b': [1, 2]}}['a']['b'][1]",
        "{1: 'int', 'one': 'text'}[1]",
        "[1, 2, 3][-1]",
        "len({1, 1, True, 1.0, 2})",
    ],
)
def test_is_what_python_says(expression: str):
    assert_like_python(f"it = {expression}")


@pytest.mark.parametrize(
    ("expression", "options"),
    [
        ("unknown or 'b'", {..., "b"}),
        ("'a' if unknown else 'b'", {"a", "b"}),
        ("('a' if unknown else '') or 'c'", {"a", "c"}),
        ("['a', 'b'][unknown]", {"a", "b"}),
        ("{'x': 'a', 'y': 'b'}[unknown]", {"a", "b"}),
        ("{'x': 'a'}.get(unknown, 'b')", {"a", "b"}),
        ("'abc'[unknown]", {...}),
        ("[unknown, 'b'][1]", {"b"}),
        ("[*unknown, 'b'][1]", {...}),
        ("[*unknown, 'b'][0:1]", {...}),
        ("{**unknown, 'a': 1}['b']", {...}),
        ("{unknown: 1}['b']", {...}),
        ("[x for x in unknown]", {...}),
        ("[x for x in [1, 2] if unknown]", {...}),
        ("[x for x in [1, 2]][unknown.step:]", {...}),
        ("not unknown", {...}),
        ("1 < unknown < 3", {...}),
        ("1 > 2 > unknown", {False}),
        ("await unknown", {...}),
        ("unknown.attribute[0].other()", {...}),
    ],
)
def test_what_is_not_known_stays_so(expression: str, options: set):
    body = f"async def main():\n    unknown = outside.value()\n    return {expression}\nit = main()"
    assert interpret(f"{OUTSIDE}{body}").options("it") == options


def test_the_first_operand_that_decides_ends_the_rest():
    assert_like_python(
        """
        seen = []

        def note(value):
            seen.append(value)
            return value

        note(0) and note(1)
        note(2) or note(3)
        note(4) and note(5)
        """
    )


def test_what_an_open_operand_leaves_may_have_happened():
    found = interpret(f"{OUTSIDE}it = 'before'\nouts = outside.value() and (it := 'after')")
    assert found.options("it") == {"before", "after"}


def test_what_stands_in_for_a_parameter_comes_from_it():
    name = Known("", frozenset({"name"}))
    assert evaluate("x or 'robot'", x=name) == OneOf(
        (Known("", frozenset({"name"})), Known("robot", frozenset({"name"})))
    )
    assert evaluate("x or y", x=Known("a"), y=name) == Known("a")


def test_a_parameter_decides_no_branch():
    flag = Known(True, frozenset({"flag"}))
    assert evaluate("'a' if x else 'b'", x=flag) == OneOf((Known("a"), Known("b")))
    assert evaluate("not x", x=flag) == Unknown("the value is not a constant")


def test_a_slice_of_what_is_one_of_several():
    assert evaluate("x[1:]", x=OneOf((Known("abc"), Known("xy")))) == OneOf((Known("bc"), Known("y")))
    assert isinstance(evaluate("x[1:]", x=Holed(("a", None), "data")), Unknown)


def test_too_many_combinations_are_cut():
    several = OneOf(tuple(map(Known, range(12))))
    assert isinstance(evaluate("x + y * 100", x=several, y=several), Unknown)


def test_what_is_not_defined_is_unknown():
    found = interpret("it = undefined\nused = undefined + 'x'")
    assert "is not defined" in found.reason("it")
    assert found.value("used") != Known("x")


@pytest.mark.parametrize(
    ("iterable", "reason"),
    [
        ("5", "the collection that the loop iterates over is not known"),
        ("outside.items()", "outside.items() is outside of this workspace"),
        ("f()", "'f' raises"),
    ],
)
def test_why_an_item_is_not_known(iterable: str, reason: str):
    interpreted = interpret(
        f"{OUTSIDE}def f():\n    raise ValueError\nfor item in {iterable}:\n    pass\nseen = []\n"
        f"[seen.append(each) for each in {iterable}]\nother = next(iter(seen))"
    )
    assert interpreted.reason("item") == interpreted.reason("other") == reason


def test_a_comprehension_leaves_no_variable_behind():
    assert_like_python("each = 'outer'\nnumbers = [each for each in range(3)]")


def test_long_collections_are_followed_up_to_a_bound():
    found = interpret("it = [number for number in range(4000)]\nlong = [0] * 4000 + [0] * 4000\nfirst = it[0]")
    assert not found.is_known("it")
    assert not found.is_known("long")


def test_how_much_a_generator_yields_is_not_known():
    found = interpret("def names():\n    yield 'a'\n    yield 'b'\nlisted = list(names())\nfirst = next(names())")
    assert not found.is_known("listed")
    assert found.options("first") == {"a", "b"}


@pytest.mark.parametrize("name", ["locals()", "globals()", "b'bytes'", "1j", "..."])
def test_what_is_not_followed_is_unknown(name: str):
    assert not interpret(f"it = {name}").is_known("it")


def test_names_of_another_module():
    found = interpret(
        "import names\nfrom names import PREFIX as prefix, missing\nfrom names import *\n"
        "it = prefix + names.SCAN + SCAN\nhidden = _HIDDEN\nno = names.nothing",
        names="PREFIX = '/robot/'\nSCAN = 'scan'\n_HIDDEN = 1",
    )
    assert found.constant("it") == "/robot/scanscan"
    assert found.reason("missing") == "names has no 'missing'"
    assert not found.is_known("hidden")
    assert found.reason("no") == "names has no 'nothing'"


def test_a_circle_of_imports_ends():
    found = interpret(
        "from other import VALUE\nNAME = 'it'\nit = VALUE", other="from it import NAME\nVALUE = 1\nlate = NAME"
    )
    assert found.constant("it") == 1
