"""Calls: how arguments get to parameters, held against ``inspect.signature``, and what a call gives."""

from __future__ import annotations

import inspect
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.interpreter.refusals import _binds
from archlint.interpreter.values import Known
from archlint.syntax import facts
from archlint.syntax.python.lowering import lower
from interpreting import OUTSIDE, assert_like_python, in_python, interpret

SIGNATURES = [
    "()",
    "(a)",
    "(a, b=2)",
    "(a=1, b=2)",
    "(a, /, b)",
    "(a, b=2, /, c=3)",
    "(*, a)",
    "(*, a, b=2)",
    "(a, *, b=2)",
    "(*rest)",
    "(a, *rest)",
    "(**named)",
    "(a, **named)",
    "(a, /, **named)",
    "(a, *rest, b=2, **named)",
    "(*rest, a, **named)",
]
POSITIONAL = st.lists(st.integers(10, 12), max_size=4)
NAMED = st.dictionaries(st.sampled_from("abcd"), st.integers(20, 22), max_size=3)


def bound_by_python(signature: str, args: list[int], named: dict[str, int]) -> Any:
    """What Python passes as which parameter; None where it refuses the call."""
    function = in_python(f"def f{signature}:\n    pass")["f"]
    try:
        bound = inspect.signature(function).bind(*args, **named)
    except TypeError:
        return None
    bound.apply_defaults()
    return dict(bound.arguments)


@given(st.sampled_from(SIGNATURES), POSITIONAL, NAMED)
def test_arguments_get_where_python_puts_them(signature: str, args: list[int], named: dict[str, int]):
    expected = bound_by_python(signature, args, named)
    if expected is None:
        return
    words = ", ".join([*map(str, args), *(f"{name}={value}" for name, value in named.items())])
    given_all = ", ".join(f"'{name}': {name}" for name in expected)
    found = interpret(f"def f{signature}:\n    return {{{given_all}}}\nit = f({words})")
    assert found.constant("it") == expected


@given(st.sampled_from(SIGNATURES), POSITIONAL, NAMED)
def test_the_calls_that_python_refuses_are_refused(signature: str, args: list[int], named: dict[str, int]):
    [function] = lower(f"def f{signature}:\n    pass").body
    assert isinstance(function, facts.Function)
    binds = _binds(function.params, len(args), {name: Known(value) for name, value in named.items()})
    assert binds == (bound_by_python(signature, args, named) is not None)


def test_stars_are_spread():
    assert_like_python(
        """
        def f(a, b=2, *rest, c=3, **named):
            return [a, b, list(rest), c, named]

        pair, table = (5, 6), {'c': 7, 'd': 8}
        results = f(*pair), f(*pair, 7, 8), f(1, **table), f(*[1], *(2, 3), **{'x': 1}, c=9)
        """
    )


def test_of_stars_that_are_not_known_the_rest_is_unknown():
    found = interpret(
        f"{OUTSIDE}def f(a, b=2, **named):\n    return [a, b, named]\n"
        "first = f(1, *outside.value())[0]\nsecond = f(1, *outside.value())[1]\n"
        "named = f(1, **outside.value())[2]\nby_name = f(1, **outside.value(), b=3)[1]"
    )
    assert found.constant("first") == 1
    assert not found.is_known("second")
    assert not found.is_known("named")
    assert found.constant("by_name") == 3


def test_an_argument_that_nobody_passes_is_unknown_and_named():
    found = interpret("def f(a, *, b):\n    return [a, b]\nit = f()\nfirst, second = it[0], it[1]")
    assert found.reason("first") == "nothing in the workspace passes 'a'"
    assert found.reason("second") == "nothing in the workspace passes 'b'"


def test_what_is_called_may_be_one_of_several():
    found = interpret(
        f"{OUTSIDE}def one():\n    return 1\ndef two():\n    return 2\n"
        "f = one\nif outside.value():\n    f = two\nit = f()\nmaybe = None\nif outside.value():\n    maybe = one\n"
        "sure = maybe()"
    )
    assert found.options("it") == {1, 2}
    assert found.constant("sure") == 1  # a call of None would have failed


def test_what_several_functions_leave_is_joined():
    found = interpret(
        f"{OUTSIDE}seen = {{}}\ndef one():\n    seen['x'] = 1\ndef two():\n    seen['x'] = 2\n"
        "f = one if outside.value() else two\nf()\nit = seen['x']"
    )
    assert found.options("it") == {1, 2}


def test_returns_on_several_paths():
    found = interpret(
        f"{OUTSIDE}def f(x):\n    if outside.value():\n        return 'a'\n"
        "    if x:\n        return 'b'\n    return 'c'\n"
        "def g():\n    for _ in outside.items():\n        return 'a'\n"
        "b, c, maybe = f(True), f(False), g()"
    )
    assert found.options("b") == {"a", "b"}
    assert found.options("c") == {"a", "c"}
    assert found.options("maybe") == {"a", None}


def test_a_function_that_always_raises_gives_nothing():
    found = interpret("def f():\n    raise ValueError('no')\nit = f()")
    assert found.reason("it") == "'f' raises"


def test_attributes_that_only_one_path_sets():
    found = interpret(
        f"{OUTSIDE}class Box:\n    def __init__(self):\n        self.x = 1\n        if outside.value():\n"
        "            self.x = 2\n            return\n        self.y = 3\nbox = Box()\nx, y = box.x, box.y"
    )
    assert found.options("x") == {1, 2}
    assert found.options("y") == {3}


@pytest.mark.parametrize("call", ["'text'()", "5()", "None()", "[1]()", "outside.value()()", "undefined()"])
def test_what_cannot_be_called_gives_nothing(call: str):
    assert not interpret(f"{OUTSIDE}it = {call}").is_known("it")


def test_methods_of_a_base_by_its_name():
    assert_like_python(
        """
        class Base:
            def __init__(self, name):
                self.name = name

            def title(self):
                return 'base ' + self.name

        class Derived(Base):
            def __init__(self):
                Base.__init__(self, 'derived')

            def title(self):
                return Base.title(self) + '!'

        class Third(Derived):
            def title(self):
                return super(Derived, self).title() + super().title()

        titles = Derived().title(), Third().title()
        """
    )


def test_super_in_a_comprehension_of_a_method_and_outside_of_one():
    assert interpret("def f():\n    return super().x\nit = f()").reason("it") == "super() outside of a method"


def test_a_call_is_followed_a_few_times_and_then_known_or_unknown():
    found = interpret("def f(x):\n    return x + 1\nresults = [f(1) for _ in range(20)]\nsame = results[19]")
    assert found.constant("same") == 2
    found = interpret(
        "count = [0]\ndef up():\n    count.append(0)\n    return len(count)\n"
        "results = [up() for _ in range(20)]\nit = results[19]"
    )
    assert not found.is_known("it") or found.constant("it") == 21


def test_a_callback_of_ours_that_another_package_calls_is_not_its_result():
    assert not interpret("import outside\ndef f():\n    return 1\nit = outside.call(f)").is_known("it")


def test_with_other_arguments_each_time_a_function_is_followed_often_and_not_for_ever():
    found = interpret(
        "def f(x):\n    return x\nresults = [f(number) for number in range(400)]\n"
        "first, last = results[0], results[399]"
    )
    assert found.constant("first") == 0
    assert found.reason("last") == "'f' is called too often to follow"


@pytest.mark.parametrize(
    "value",
    [
        "'text'",
        "outside.which() and 'a' or 'b'",
        "partial(g, 1, x=2)",
        "thing.method",
        "(lambda x=1: x)",
        "g",
        "thing",
        "'a'.upper",
        "[1]",
        "outside.value()",
        "len",
        "outside.Thing",
    ],
)
def test_the_same_call_again_gives_the_same(value: str):
    found = interpret(
        f"{OUTSIDE}from functools import partial\ndef g(*a, **k):\n    return 1\n"
        "class Thing:\n    def method(self):\n        return 1\nthing = Thing()\n"
        f"def f():\n    return {value}\nresults = [f() for _ in range(30)]\nfirst, last = results[0], results[5]\n"
        "number = len(results)"
    )
    assert found.constant("number") == 30
    assert type(found.value("last")) is type(found.value("first"))


def test_a_change_in_what_it_reads_makes_it_run_again():
    found = interpret(
        "state = {'n': 0}\ndef read():\n    return state['n']\nresults = []\n"
        "for number in range(8):\n    state['n'] = number\n    results.append(read())"
    )
    assert found.constant("results") == list(range(8))
