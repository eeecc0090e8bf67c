"""Methods of texts, held against Python itself; of paths and of texts with holes, what is known of them."""

from __future__ import annotations

import pytest

from archlint.interpreter.values import EachValue, Holed, Known, OneOf, Unknown, Value
from interpreting import OUTSIDE, assert_like_python, evaluate, interpret


def test_format_takes_arguments_by_place_by_name_and_by_what_they_hold():
    assert_like_python(
        """
        class Robot:
            name = 'r2'

        automatic = '{} {}'.format(1, 'a')
        numbered = '{0}{1}{0}'.format('a', 'b')
        named = '/{space}/{name}'.format(name='scan', space='robot')
        of_items = '{0[0]}{0[1]}{1[k]}'.format(['a', 2], {'k': 'v'})
        of_attribute = '/{robot.name}/scan'.format(robot=Robot())
        with_widths = '{:>5}|{:05.1f}|{:<3}|'.format('a', 2.25, 'b')
        as_code = '{!r} {!s}'.format('a', 'b')
        braces = '{{}} {{{}}}'.format(3)
        """
    )


@pytest.mark.parametrize(
    ("expression", "reason"),
    [
        ("'{'.format(1)", "a format that fails"),
        ("'{}'.format()", "format() has too few arguments"),
        ("'{name}'.format(other=1)", "format() has no such argument"),
        ("'a'.split('')", "an operation that fails"),
        ("'a'.index('b')", "an operation that fails"),
        ("'a'.center('x')", "an operation that fails"),
        ("'a'.strip(chars='a')", "str.strip() of arguments by name is not followed"),
        ("'ab'.startswith(('a', 'b'))", "a string method of unknown values"),
        ("'a'.ljust(10**9)", "a string too long to follow"),
        ("'a'.replace('', 'b' * 90000)", "a string too long to follow"),
        ("('\\t' * 5000).expandtabs(5000)", "a string too long to follow"),
        ("'a'.translate({})", "str.translate() is not followed"),
        ("'a'.join()", "str.join() is not followed"),
    ],
)
def test_why_nothing_is_known_of_a_text(expression: str, reason: str):
    value = evaluate(expression)
    assert isinstance(value, (Unknown, Holed))
    assert value.reason == reason


@pytest.mark.parametrize(
    "expression", ["'a'.join(outside.names())", "'a b'.split(outside.by())", "'a'.join([outside.x()])"]
)
def test_a_text_of_what_is_not_known(expression: str):
    assert not interpret(f"{OUTSIDE}x = {expression}").is_known("x")


def test_join_takes_each_kind_of_collection():
    assert_like_python(
        """
        of_list = '/'.join(['', 'robot', 'scan'])
        of_tuple = ', '.join(('a', 'b'))
        of_text = '-'.join('abc')
        of_dict = '-'.join({'a': 1, 'b': 2})
        of_nothing = '-'.join([])
        of_loop = ''.join(each.upper() for each in ['a', 'b'])
        """
    )


def test_a_text_in_pieces():
    assert_like_python(
        """
        words = ' a b  c '.split()
        rows = 'a\\nb\\n'.splitlines(), 'a\\nb'.splitlines(keepends=True)
        at_most = 'a,b,c'.split(',', 1), 'a,b,c'.rsplit(',', maxsplit=1)
        around = 'a=b=c'.partition('='), 'a/b/c'.rpartition('/'), 'a'.partition('=')
        name, _, kind = 'scan:laser'.partition(':')
        last = '/robot/scan'.split('/')[-1]
        """
    )


def test_which_of_several_arguments_it_is_gives_several_texts():
    options = OneOf((Known("a"), Known("b")))
    assert evaluate("'abc'.replace(x, '-')", x=options) == OneOf((Known("-bc"), Known("a-c")))
    assert evaluate("'abc'.startswith(x)", x=options) == OneOf((Known(True), Known(False)))


def test_what_a_parameter_chose_of_a_text_comes_from_it():
    chosen = Known("A/b", frozenset({"name"}))
    assert evaluate("x.lower()", x=chosen) == Known("a/b", frozenset({"name"}))
    assert evaluate("'/A/b/c'.replace(x, '')", x=chosen) == Known("//c", frozenset({"name"}))
    assert evaluate("x.split('/')[1]", x=chosen) == Known("b", frozenset({"name"}))


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("startswith('/')", True),
        ("startswith('x')", False),
        ("endswith('scan')", True),
        ("endswith('map')", False),
    ],
)
def test_what_the_known_ends_of_a_text_tell(call: str, expected: object):
    """``f'/Robot/{unknown}/scan'``."""
    text = Holed(("/Robot/", None, "/scan"), "not here")
    assert evaluate(f"x.{call}", x=text) == Known(expected)


@pytest.mark.parametrize(
    ("call", "of_class"),
    [
        ("startswith('/Robot/and/more')", "bool"),
        ("endswith('a/very/long/scan')", "bool"),
        ("startswith('/', 1)", "bool"),
        ("title()", "str"),
        ("encode()", "bytes"),
        ("index('/')", "int"),
        ("maketrans('a', 'b')", None),
    ],
)
def test_what_methods_of_a_text_give_that_is_not_known(call: str, of_class: str | None):
    holed = Holed(("/Robot/", None, "/scan"), "not here")
    assert evaluate(f"x.{call}", x=holed) == Unknown("not here", of_class=of_class)
    if of_class is not None:
        assert evaluate(f"x.{call}", x=Unknown("not here", of_class="str")) == Unknown("not here", of_class=of_class)


def test_the_parts_of_a_text_that_is_not_known_are_texts():
    holed = Holed(("/Robot/", None, "/scan"), "not here")
    assert evaluate("x.split('/')", x=holed) == EachValue(Unknown("not here", of_class="str"))


def test_letters_change_around_a_hole():
    text = Holed(("/Robot/", None, "/Scan"), "not here")
    assert evaluate("x.lower()", x=text) == Holed(("/robot/", None, "/scan"), "not here")
    assert evaluate("x.upper()", x=text) == Holed(("/ROBOT/", None, "/SCAN"), "not here")


@pytest.mark.parametrize(
    ("call", "path", "kind"),
    [
        ("joinpath('b', 'c.yaml')", "/a/b/c.yaml", "path"),
        ("resolve()", "/a", "path"),
        ("absolute()", "/a", "path"),
        ("expanduser()", "/a", "path"),
        ("as_posix()", "/a", "other"),
    ],
)
def test_a_path_stays_a_path(call: str, path: str, kind: str):
    value = evaluate(f"p.{call}", p=Known("/a", kind="path"))
    assert isinstance(value, Known)
    assert (value.value, value.kind) == (path, kind)


@pytest.mark.parametrize("call", ["exists()", "is_file()"])
def test_whether_a_file_is_there_is_asked_of_paths_alone(call: str):
    of_path = evaluate(f"p.{call}", p=Known("/a", kind="path"))
    assert of_path == Unknown("whether a file exists")
    of_text = evaluate(f"p.{call}", p=Known("/a"))
    assert of_text == Unknown(f"str.{call[:-2]}() is not followed")


def test_a_path_below_a_folder_that_is_not_known():
    value: Value = evaluate("p.joinpath(x)", p=Known("/a", kind="path"), x=Unknown("not here"))
    assert value == Unknown("not here")
