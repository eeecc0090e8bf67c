"""The oracle's own expansion of names, held to rcl's examples."""

from __future__ import annotations

import pytest
from benchmarks.accuracy.oracle.names import NameError_, expand


@pytest.mark.parametrize(
    ("name", "namespace", "expected"),
    [
        ("chatter", "/", "/chatter"),
        ("chatter", "/a/b", "/a/b/chatter"),
        ("/chatter", "/a", "/chatter"),
        ("~", "/a", "/a/talker"),
        ("~/s", "/a", "/a/talker/s"),
        ("{node}/x", "/a", "/a/talker/x"),
        ("{ns}/x", "/a", "/a/x"),
        ("foo__bar", "/", "/foo__bar"),
    ],
)
def test_expansion(name, namespace, expected):
    assert expand(name, "talker", namespace) == expected


@pytest.mark.parametrize("name", ["", "a//b", "foo-bar", "x/1y", "foo/", "a~b", "~b", "{ns}/x", "{what}", "a{b", "9"])
def test_refusal(name):
    with pytest.raises(NameError_):
        expand(name, "talker", "/")
