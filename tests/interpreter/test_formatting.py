"""Texts that ``%``, ``format`` and f-strings make, held against Python itself."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.interpreter.values import Holed, Known, OneOf, Unknown
from interpreting import OUTSIDE, NotConstant, assert_like_python, evaluate, in_python, interpret

CONSTANTS = st.one_of(st.integers(-99, 99), st.booleans(), st.none(), st.text("ab{}%", max_size=3), st.floats(0.5, 9))
PERCENT = st.lists(
    st.sampled_from(["a", "%s", "%d", "%r", "%5.1f", "%%", "%x", "%-4s|", "%", "%*d", "%(k)s"]), max_size=4
)
FIELDS = st.lists(
    st.sampled_from(["a", "{}", "{0}", "{!r}", "{!a}", "{!s}", "{:>4}", "{0:03d}", "{1}", "{{", "}}", "{k}", "{:.1f}"]),
    max_size=4,
)


def check(expression: str) -> None:
    """An expression is what Python makes of it, or unknown; where Python raises, it is unknown."""
    try:
        expected = in_python(f"it = {expression}")["it"]
    except Exception as error:
        expected = error
    try:
        found = interpret(f"it = {expression}").constant("it")
    except NotConstant:
        return
    assert found == expected, expression


@pytest.mark.filterwarnings("ignore::SyntaxWarning")
@given(PERCENT, st.lists(CONSTANTS, max_size=3))
def test_percent(pieces: list[str], arguments: list[Any]):
    check(f"{''.join(pieces)!r} % {tuple(arguments)!r}")


@pytest.mark.filterwarnings("ignore::SyntaxWarning")
@given(PERCENT, CONSTANTS)
def test_percent_of_one_value(pieces: list[str], argument: Any):
    check(f"{''.join(pieces)!r} % {argument!r}")


@given(st.lists(st.sampled_from(["a", "%(k)s", "%(k)d", "%(n)r", "%%", "%s", "%"]), max_size=4), CONSTANTS)
def test_percent_of_a_dict(pieces: list[str], value: Any):
    check(f"{''.join(pieces)!r} % {{'k': {value!r}}}")


@given(FIELDS, st.lists(CONSTANTS, max_size=2))
def test_format(pieces: list[str], arguments: list[Any]):
    template = "".join(pieces)
    if ("{}" in template and ("{0" in template or "{1" in template)) or "{!" in template or "{:" in template:
        pieces = [piece for piece in pieces if "0" not in piece and "1" not in piece]
    check(f"{''.join(pieces)!r}.format({', '.join(map(repr, arguments))})")


@given(st.sampled_from(["", "!r", "!s", "!a"]), st.sampled_from(["", ":>6", ":04d", ":.2f", ":x", ":6"]), CONSTANTS)
def test_f_strings(conversion: str, spec: str, value: Any):
    name = "value"
    source = f"{name} = {value!r}\nit = f'<{{{name}{conversion}{spec}}}>'"
    try:
        expected = in_python(source)["it"]
    except (ValueError, TypeError) as error:
        expected = error
    found = interpret(source)
    assert not found.is_known("it") or found.constant("it") == expected


def test_fields_of_objects_and_collections():
    assert_like_python(
        """
        class Robot:
            name = 'r1'

        table, items, robot = {'a': 'x', 1: 'one'}, ['first', 'second'], Robot()
        results = [
            '{0[a]}{1[1]}'.format(table, items),
            '{0.name}'.format(robot),
            '{r.name}/{t[a]}'.format(r=robot, t=table),
            '{:>{}}'.format('a', 3) if False else '',
            f'{robot.name}/{items[0]}',
            '%(a)s' % table,
            '/'.join([robot.name, *items]),
        ]
        """
    )


@pytest.mark.parametrize(
    ("expression", "parts"),
    [
        ("'a/' + unknown", ("a/", None)),
        ("unknown + '/a'", (None, "/a")),
        ("f'a/{unknown}/b'", ("a/", None, "/b")),
        ("f'{unknown}{unknown}/b'", (None, "/b")),
        ("'a/%s/b' % unknown", ("a/", None, "/b")),
        ("'a/%s/%s' % ('x', unknown)", ("a/x/", None)),
        ("'a/{}/b'.format(unknown)", ("a/", None, "/b")),
        ("'a/{x}'.format(x=unknown)", ("a/", None)),
        ("'/'.join(['a', unknown, 'b'])", ("a/", None, "/b")),
        ("f'a/{unknown:>4}'", ("a/", None)),
        ("f'a/{unknown!r}'", ("a/", None)),
        ("('a/' + unknown).upper()", ("A/", None)),
        ("'a/' + ('b/' + unknown)", ("a/b/", None)),
    ],
)
def test_what_is_known_of_a_text_is_kept(expression: str, parts: tuple[str | None, ...]):
    found = evaluate(expression, unknown=Unknown("data"))
    assert isinstance(found, Holed)
    assert found.parts == parts
    assert found.reason == "data"
    assert found.pattern == "".join("*" if part is None else part for part in parts)


@pytest.mark.parametrize(
    "expression",
    [
        "'%d' % unknown",
        "'{}' % unknown",
        "'%s %s' % unknown",
        "'{'.format(1)",
        "'{x}'.format(1)",
        "'{1}'.format(1)",
        "unknown % 1",
        "unknown.format(1)",
        "'/'.join(unknown)",
        "f'{holed!r}'",
        "f'{holed:>20}'",
        "'%99999d' % 1",
        "f'{1:>99999}'",
        "'%(a)s' % unknown",
    ],
)
def test_what_cannot_be_told_is_unknown(expression: str):
    found = evaluate(expression, unknown=Unknown("data"), holed=Holed(("a", None), "data"))
    assert not isinstance(found, Known)
    assert not (isinstance(found, Holed) and "'" in found.pattern)


def test_each_of_several_values_is_put_in():
    several = OneOf((Known("a"), Known("b")))
    for expression in ("f'/{x}'", "'/%s' % x", "'/{}'.format(x)", "'/' + x", "'/'.join(['', x])"):
        found = evaluate(expression, x=several)
        assert isinstance(found, OneOf)
        assert [option.value for option in found.values] == ["/a", "/b"]


def test_none_among_others_is_what_stands_there_for_now():
    found = evaluate("f'/{x}'", x=OneOf((Known(None), Known("b"))))
    assert isinstance(found, OneOf)
    assert {type(option) for option in found.values} == {Holed, Known}


def test_too_many_combinations_are_unknown():
    several = OneOf(tuple(Known(str(number)) for number in range(7)))
    found = evaluate("f'{x}/{x}'", x=several)
    assert not isinstance(found, OneOf) or len(found.values) <= 12


def test_parameters_stay_with_texts():
    name = Known("robot", frozenset({"name"}))
    for expression in (
        "f'{x}/a'",
        "'%s/a' % x",
        "'{}/a'.format(x)",
        "x + '/a'",
        "x.lower() + '/a'",
        "'/'.join([x, 'a'])",
    ):
        found = evaluate(expression, x=name)
        assert found == Known("robot/a", frozenset({"name"})), expression
    assert evaluate("x % 1", x=Known("a%d", frozenset({"name"}))) == Known("a1", frozenset({"name"}))
    assert evaluate("x % {'k': 1}", x=Known("a%(k)d", frozenset({"name"}))) == Known("a1", frozenset({"name"}))


def test_objects_without_a_text_of_their_own():
    found = interpret(f"{OUTSIDE}class Thing:\n    pass\nit = f'/{{Thing()}}'\nother = str(outside.Thing())")
    assert not found.is_known("it")
    assert not found.is_known("other")
