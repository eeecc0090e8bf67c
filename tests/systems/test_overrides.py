"""For which nodes a key of a parameter file is, and what a command line sets: as rcl reads both."""

from __future__ import annotations

import pytest

from archlint.systems.overrides import command_line_parameters, key_matches


@pytest.mark.parametrize(
    ("key", "node"),
    [
        ("talker", "/talker"),
        ("/talker", "/talker"),
        ("/X", "/X"),
        ("arm/talker", "/arm/talker"),
        ("/*", "/talker"),
        ("/arm/*", "/arm/talker"),
        ("/*/talker", "/arm/talker"),
        ("/**", "/talker"),
        ("/**", "/left/arm/talker"),
        ("/**/talker", "/talker"),
        ("/**/talker", "/left/arm/talker"),
        ("/left/**", "/left/arm/talker"),
        ("**", None),
        ("/**", None),
    ],
)
def test_a_key_is_for_a_node(key: str, node: str | None) -> None:
    assert key_matches(key, node)


@pytest.mark.parametrize(
    ("key", "node"),
    [
        ("talker", "/arm/talker"),
        ("/arm/talker", "/talker"),
        ("/*", "/arm/talker"),
        ("/arm/*", "/arm"),
        ("/talk*", "/talker"),
        ("talker", "talker"),
        ("/talker", None),
        ("/*", None),
        ("/X/**", None),
    ],
)
def test_a_key_is_for_others(key: str, node: str | None) -> None:
    assert not key_matches(key, node)


@pytest.mark.parametrize(
    ("words", "set_there"),
    [
        (["--ros-args", "-p", "rate:=5"], [("rate", 5)]),
        (["--ros-args", "--param", "mode:=fast"], [("mode", "fast")]),
        (["--ros-args", "-p", "range:=[0.0, 15.0]"], [("range", [0.0, 15.0])]),
        (["--ros-args", "-p", "code:='5'"], [("code", "5")]),
        (["--ros-args", "-p", "a:=1", "-p", "a:=2"], [("a", 1), ("a", 2)]),
        (["--ros-args", "-p", "a:=1", "--", "-p", "b:=2"], [("a", 1)]),
        (["--ros-args", "-p", "a:=1", "--", "x", "--ros-args", "-p", "b:=2"], [("a", 1), ("b", 2)]),
        (["--ros-args", "-p", "a:=b:=c"], [("a", "b:=c")]),
        (["--ros-args", "-p", "talker:rate:=5", "-p", "a:=1"], [("a", 1)]),  # it is for one node
        (["--ros-args", "-p", None, "a:=1"], []),
        (["--ros-args", "-p", "rate", "a:=1"], []),
        (["--ros-args", "-p", "--ros-args", "a:=1"], []),
        (["--ros-args", "-p", "a:=1", "b:=2"], [("a", 1)]),
        (["--ros-args", "-r", "a:=1"], []),
        (["--ros-args", "a:=1"], []),
        (["-p", "a:=1"], []),
        (["a:=1"], []),
        ([], []),
    ],
)
def test_what_a_command_line_sets(words: list[str | None], set_there: list[tuple[str, object]]) -> None:
    assert list(command_line_parameters(words)) == set_there
