"""``isinstance`` of values that are known: right for Python's own types, open where the class is not known."""

from __future__ import annotations

import pytest

from launching import names

IMPORTS = """\
import collections.abc, numbers, os, pathlib, types, typing
from abc import ABC
import numpy
from launch import Substitution, SomeSubstitutionsType
from typing import Iterable, List, Mapping, Sequence, Text
class Plain: pass
class Duck(ABC): pass
class Settings(dict): pass
"""


def verdict(launches, test: str) -> str:
    """``yes``, ``no``, or ``?`` where both are possible."""
    actions = f"[Node(package='robot', executable='talker', name='yes' if {test} else 'no')]"
    (name,) = names(launches.python(actions, before=IMPORTS))
    return name


@pytest.mark.parametrize(
    ("value", "cls", "expected"),
    [
        ("'a'", "Text", "yes"),
        ("'a'", "typing.Text", "yes"),
        ("'a'", "Iterable", "yes"),
        ("'a'", "collections.abc.Sequence", "yes"),
        ("'a'", "Mapping", "no"),
        ("'a'", "os.PathLike", "no"),
        ("'a'", "bytes", "no"),
        ("'a'", "object", "yes"),
        ("3", "numbers.Number", "yes"),
        ("3", "numbers.Integral", "yes"),
        ("3.5", "numbers.Integral", "no"),
        ("True", "int", "yes"),
        ("3", "Text", "no"),
        ("None", "types.NoneType", "yes"),
        ("[1]", "Sequence", "yes"),
        ("[1]", "List", "yes"),
        ("[1]", "Mapping", "no"),
        ("(1,)", "(Mapping, (str, collections.abc.Sequence))", "yes"),
        ("{1}", "Sequence", "no"),
        ("{1}", "collections.abc.Set", "yes"),
        ("{1}", "frozenset", "?"),
        ("{'a': 1}", "Mapping", "yes"),
        ("{'a': 1}", "collections.abc.MutableMapping", "yes"),
        ("{'a': 1}", "Sequence", "no"),
        ("pathlib.Path('a')", "os.PathLike", "yes"),
        ("pathlib.Path('a') / 'b'", "pathlib.Path", "yes"),
        ("pathlib.Path('a')", "str", "no"),
        ("str(pathlib.Path('a'))", "str", "yes"),
        ("Settings()", "dict", "yes"),
        ("Plain()", "dict", "no"),
        ("'a'", "Plain", "no"),
    ],
)
def test_pythons_own_types(launches, value, cls, expected):
    assert verdict(launches, f"isinstance({value}, {cls})") == expected


def test_a_class_that_is_not_known_leaves_it_open(launches):
    assert verdict(launches, "isinstance(3, numpy.integer)") == "?"
    assert verdict(launches, "isinstance('a', Duck)") == "?"  # which may register texts
    assert verdict(launches, "isinstance('a', SomeSubstitutionsType)") == "?"
    assert verdict(launches, "isinstance('a', (int, numpy.str_))") == "?"
    assert verdict(launches, "isinstance('a', (str, numpy.str_))") == "yes"


def test_a_text_is_no_substitution(launches):
    assert verdict(launches, "isinstance('a', Substitution)") == "no"
    assert verdict(launches, "isinstance(LaunchConfiguration('a'), Substitution)") == "yes"
    assert verdict(launches, "isinstance(LaunchConfiguration('a'), LaunchConfiguration)") == "yes"


def test_a_value_of_two_types_is_open(launches):
    assert verdict(launches, "isinstance('a' if os.path.exists('/x') else 3, (str, int))") == "yes"
    assert verdict(launches, "isinstance('a' if os.path.exists('/x') else 3, str)") == "?"
