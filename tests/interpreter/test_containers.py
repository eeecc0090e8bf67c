"""Lists, tuples, sets and dicts with their methods, and Python's own functions on them."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.interpreter.containers import ITEM_LIMIT
from archlint.interpreter.values import Known, OneOf, Unknown
from interpreting import OUTSIDE, NotConstant, assert_like_python, evaluate, in_python, interpret

OF_LISTS = [
    *("it.append(1)", "it.append(2)", "it.extend([3, 1])", "it.insert(0, 5)", "it.insert(-1, 6)", "it.reverse()"),
    *("it.sort()", "it.sort(reverse=True)", "it.remove(1)", "it.pop()", "it.pop(0)", "it.clear()", "it += [7]"),
    *("it = it.copy()", "it = it + [8]", "it = it[1:]", "it[0] = 9", "it = it * 2", "it = sorted(it)"),
    *("it = list(reversed(it))", "it = [each + 1 for each in it]", "it = list(map(abs, it))"),
]
OF_DICTS = [
    *("it['a'] = 1", "it['b'] = 2", "it.update(a=3)", "it.update({'c': 4})", "it.setdefault('a', 5)", "it.pop('a', 0)"),
    *("it.pop('b')", "it.clear()", "it = dict(it)", "it = it.copy()", "it |= {'d': 6}", "del it['a']"),
    *("it = {**it, 'e': 7}", "it = {key: value for key, value in it.items()}", "it = dict(zip('ab', [8, 9]))"),
]
OF_SETS = [
    *("it.add(1)", "it.add(2)", "it.add(1)", "it.update([1, 3])", "it.discard(1)", "it |= {4}", "it.clear()"),
    *("it = it.union([5, 1])", "it = set(it)", "it = it.copy()", "it = {each for each in it}", "it -= {1}"),
    "it.difference_update({2})",
]


def check(start: str, lines: list[str]) -> None:
    """What Python has after these lines is what the interpreter has, or it does not know."""
    source = "\n".join([start, *lines, "count = len(it)", "true = bool(it)", "listed = list(it)"])
    try:
        expected = in_python(source)
    except (IndexError, ValueError, KeyError):
        return
    found = interpret(source)
    for name in ("it", "count", "true"):
        if found.is_known(name):
            assert found.constant(name) == expected[name], name


@given(st.lists(st.sampled_from(OF_LISTS), max_size=6))
def test_lists(lines: list[str]):
    check("it = [1, 2]", lines)


@given(st.lists(st.sampled_from(OF_DICTS), max_size=6))
def test_dicts(lines: list[str]):
    check("it = {}", lines)


@given(st.lists(st.sampled_from(OF_SETS), max_size=6))
def test_sets(lines: list[str]):
    check("it = {1}", lines)


DEQUE = ["it.append(1)", "it.appendleft(2)", "it.extendleft([3, 4])", "it.pop()", "it.popleft()", "it.rotate(1)"]


@given(st.lists(st.sampled_from(DEQUE), max_size=6))
def test_queues(lines: list[str]):
    source = "\n".join(["from collections import deque", "it = deque()", *lines])
    try:
        expected = list(in_python(source)["it"])
    except IndexError:
        return
    found = interpret(source)
    assert not found.is_known("it") or found.constant("it") == expected


FUNCTIONS = [
    "len({x})",
    "sorted({x})",
    "sorted({x}, reverse=True)",
    "list(reversed({x}))",
    "sum({x})",
    "min({x})",
    "max({x})",
    "any({x})",
    "all({x})",
    "list(enumerate({x}))",
    "list(enumerate({x}, start=3))",
    "list(zip({x}, {x}))",
    "tuple({x})",
    "list(map(str, {x}))",
    "list(filter(None, {x}))",
    "{x}[0]",
    "{x}[-1]",
    "{x}[1:]",
    "{x}[::-1]",
    "3 in {x}",
    "[*{x}, 0]",
    "len(set({x}))",
    "dict(enumerate({x}))",
    "next(iter({x}), 'none')",
    "sum([{x}, {x}], [])",
    "isinstance({x}, list)",
    "list(dict.fromkeys({x}))",
    "str(len({x}))",
    "bool({x})",
    "sorted({x}, key=abs)",
]


@given(st.sampled_from(FUNCTIONS), st.lists(st.integers(-3, 5), max_size=4))
def test_functions_of_pythons_own(expression: str, items: list[int]):
    expression = expression.replace("{x}", repr(items))
    if "key=" in expression:
        return  # how another key orders is not followed
    try:
        expected: Any = in_python(f"it = {expression}")["it"]
    except (ValueError, IndexError):
        expected = None
    found = interpret(f"it = {expression}")
    if found.is_known("it"):
        assert found.constant("it") == expected, expression


@pytest.mark.parametrize(
    "expression",
    [
        "int('12', 16)",
        "int('0x1f', base=16)",
        "int(3.9)",
        "int('7')",
        "float('1.5')",
        "bool('')",
        "bool()",
        "str()",
        "int()",
        "float()",
        "abs(-2)",
        "str(1.5)",
        "str(None)",
        "list('abc')",
        "tuple()",
        "dict(a=1, b=2)",
        "dict([('a', 1), ('b', 2)], c=3)",
        "range(3)[1]",
        "list(range(5, 0, -2))",
        "len('abc')",
        "callable(5)",
        "isinstance('a', (int, str))",
        "isinstance(True, int)",
        "isinstance(1, bool)",
        "isinstance(None, type(None))",
        "max('b', 'a')",
        "min([2, 1])",
        "sum([1, 2])",
        "sum([[1], [2]], [])",
        "list(zip('ab', range(3)))",
        "{'a': 1}.get('a')",
        "{'a': 1}.get('b')",
        "{'a': 1}.get('b', 2)",
        "list({'a': 1}.keys())",
        "list({'a': 1}.values())",
        "list({'a': 1}.items())",
        "(1, 2)[1]",
        "[[1, 2], [3]][0][1]",
        "sorted(['b', 'a'])",
        "sorted([1, 2], reverse=1)",
        "getattr('abc', 'upper')()",
    ],
)
def test_is_what_python_says(expression: str):
    try:
        found = interpret(f"it = {expression}").constant("it")
    except NotConstant:
        assert "type(None)" in expression
        return
    assert found == in_python(f"it = {expression}")["it"]


TEXT_METHODS = [
    "upper()",
    "lower()",
    "title()",
    "strip()",
    "lstrip('a')",
    "rstrip('b ')",
    "replace('a', 'xy')",
    "split()",
    "split('b')",
    "rsplit('b', 1)",
    "partition('b')",
    "rpartition('b')",
    "startswith('a')",
    "endswith('b')",
    "find('b')",
    "rfind('b')",
    "count('a')",
    "zfill(6)",
    "center(7, '*')",
    "ljust(5)",
    "rjust(5, '.')",
    "capitalize()",
    "swapcase()",
    "casefold()",
    "removeprefix('a')",
    "removesuffix('b')",
    "isdigit()",
    "isalpha()",
    "isidentifier()",
    "isnumeric()",
    "expandtabs(4)",
    "expandtabs(tabsize=2)",
    "splitlines()",
    "index('a')",
    "join(['x', 'y'])",
    "split(sep='b', maxsplit=1)",
    "islower()",
    "encode()",
    "isspace()",
    "format()",
    "__str__()",
    "isupper()",
    "isalnum()",
]


@given(st.sampled_from(TEXT_METHODS), st.text("aAb \t1", max_size=5))
def test_methods_of_texts(method: str, text: str):
    expression = f"{text!r}.{method}"
    try:
        expected: Any = in_python(f"it = {expression}")["it"]
    except ValueError as error:
        expected = error
    found = interpret(f"it = {expression}")
    if found.is_known("it"):
        assert found.constant("it") == expected, expression


@pytest.mark.parametrize(
    "source",
    [
        "it = {}\nit.setdefault('a', 1)\nx = it['a']",
        "it = dict.fromkeys('ab')\nx = 1",
        "it = {'a': {'b': 1}}\nit['a']['b'] = 2\nx = it['a']['b']",
        "it = [[0] * 2 for _ in range(2)]\nit[0][1] = 5\nx = it",
        "one = [1]\nother = one\nother.append(2)\nx = one",
        "one = {'k': [1]}\nother = one.copy()\nother['k'].append(2)\nx = one['k']",
    ],
)
def test_collections_in_collections(source: str):
    assert interpret(source).constant("x") == in_python(source)["x"]


@pytest.mark.parametrize(
    "source",
    [
        "it = {'a': 1}\nit[outside.key()] = 2\nx = it.get('b')",
        "it = {'a': 1}\nit.update(outside.more())\nx = it.get('b')",
        "it = outside.table() or {}\nx = it.get('b')",
        "it = {'a': 1}\nit.popitem()\nx = len(it)",
        "it = [1]\nit.extend(outside.more())\nx = len(it)",
        "it = [1, 2]\nit.pop(outside.at())\nx = len(it)",
        "it = [1, 2]\nit.remove(outside.item())\nx = len(it)",
        "it = [1, 2]\nit.insert(outside.at(), 3)\nx = it[0]",
        "it = {outside.one(), outside.one()}\nx = len(it)",
        "it = {1}\nit.add(outside.one())\nx = len(it)",
        "it = dict(outside.pairs())\nx = len(it)",
        "it = dict([(outside.key(), 1)])\nx = len(it)",
        "it = [1, 2][outside.at():]\nx = len(it)",
        "it = sorted(outside.items())\nx = len(it)",
        "it = list(zip(outside.items(), [1]))\nx = len(it)",
        "it = list(enumerate(outside.items()))\nx = len(it)",
        "it = list(range(outside.count()))\nx = len(it)",
        "it = min(outside.items())\nx = it",
        "it = sum([1, outside.one()])\nx = it",
        "it = [e for e in outside.items() if e]\nx = len(it)",
        "it = int(outside.text())\nx = it",
        "it = int('1', outside.base())\nx = it",
        "x = len(outside.items())",
        "x = 'abc'[5]",
        "x = [1][5]",
        "x = {}['a']",
        "x = 'a'.replace(outside.one(), 'b')",
        "x = 'a'.startswith(('a', 'b'))",
        "x = len(5)",
        "x = range('a')",
        "x = range()",
        "x = int('a')",
        "x = max([])",
        "x = max([1, 'a'])",
        "x = [1, 'a'].sort() or [1, 'a'].pop(7)",
        "x = getattr([1], outside.name())",
        "x = hasattr(outside, 'x')",
        "x = isinstance(outside.one(), str)",
        "x = isinstance(1, outside.Kind)",
        "x = callable(outside.one())",
        "x = any([0, outside.one()])",
        "x = all([1, outside.one()])",
        "x = input('?')",
        "x = eval(outside.text())",
        "x = hash('a')",
        "x = id('a')",
    ],
)
def test_what_is_not_known_stays_so(source: str):
    assert not interpret(f"{OUTSIDE}{source}").is_known("x")


def test_what_is_open_may_already_hold_it():
    found = interpret(f"{OUTSIDE}it = {{}}\nit.update(outside.more())\nx = it.setdefault('a', 'b')")
    assert found.options("x") == {"b", ...}


def test_what_is_long_is_cut_and_said():
    found = interpret(f"it = list(range({ITEM_LIMIT}))\nit.append(1)\nx = len(it)\nlong = range({ITEM_LIMIT + 1})")
    assert not found.is_known("x")
    assert found.reason("long") == "a range too long to follow"


def test_what_a_parameter_chose_of_a_table_comes_from_it():
    name = Known("a", frozenset({"which"}))
    assert evaluate("{'a': 'x', 'b': 'y'}[k]", k=name) == Known("x", frozenset({"which"}))
    assert evaluate("['x', 'y'][k]", k=Known(1, frozenset({"which"}))) == Known("y", frozenset({"which"}))
    assert evaluate("{'a': ['x']}[k][0]", k=name) == Known("x", frozenset({"which"}))
    assert evaluate("{'a': {'k': 'x'}}[k]['k']", k=name) == Known("x", frozenset({"which"}))
    assert evaluate("list(range(k))[0]", k=Known(1, frozenset({"n"}))) == Known(0, frozenset({"n"}))
    assert evaluate("{'a': 'x'}.get(k, 'z')", k=OneOf((Known("a"), Known("b")))) == OneOf((Known("x"), Known("z")))
    assert isinstance(evaluate("{'a': 'x'}[k]", k=Unknown("data")), Known)


def test_objects_as_collections():
    assert_like_python(
        """
        class Table:
            def __init__(self):
                self.rows = {}

            def __getitem__(self, key):
                return self.rows[key]

            def __setitem__(self, key, value):
                self.rows[key] = value

        class Plain:
            pass

        table, plain = Table(), Plain()
        table['a'] = 1
        found = table['a']
        plain.__dict__['name'] = 'x'
        named = plain.name, plain.__dict__['name']
        setattr(plain, 'other', 2)
        other = plain.other, getattr(plain, 'other'), getattr(plain, 'none', 3), hasattr(plain, 'other')
        """
    )
