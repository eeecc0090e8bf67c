from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.ros import names
from archlint.ros.remapping import RemapRule, first_match, resolve, rules_of_arguments


def rules(*texts: str) -> list[RemapRule]:
    return [RemapRule.parse(text) for text in texts]


@pytest.mark.parametrize(
    ("text", "node", "kinds", "match", "replacement"),
    [
        ("foo:=bar", None, {"topic", "service", "action"}, "foo", "bar"),
        ("/a/b:=~/c", None, {"topic", "service", "action"}, "/a/b", "~/c"),
        ("~/a:=/b", None, {"topic", "service", "action"}, "~/a", "/b"),
        ("rostopic://foo:=bar", None, {"topic", "action"}, "foo", "bar"),
        ("rosservice:///foo:=/bar", None, {"service"}, "/foo", "/bar"),
        ("talker:foo:=bar", "talker", {"topic", "service", "action"}, "foo", "bar"),
        ("talker:rosservice://~/foo:=bar", "talker", {"service"}, "~/foo", "bar"),
        ("rostopic:foo:=bar", "rostopic", {"topic", "service", "action"}, "foo", "bar"),
        ("__node:=other", None, {"node_name"}, "", "other"),
        ("__name:=other", None, {"node_name"}, "", "other"),
        ("talker:__node:=other", "talker", {"node_name"}, "", "other"),
        ("__ns:=/a/b", None, {"namespace"}, "", "/a/b"),
        ("__ns:=/", None, {"namespace"}, "", "/"),
        ("talker:__ns:=/a/", "talker", {"namespace"}, "", "/a/"),
    ],
)
def test_rules(text: str, node: str | None, kinds: set[str], match: str, replacement: str) -> None:
    rule = RemapRule.parse(text)
    assert (rule.node, set(rule.kinds), rule.match, rule.replacement) == (node, kinds, match, replacement)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("foo", "has no ':='"),
        ("foo=bar", "has no ':='"),
        (":=bar", "is not a remap rule"),
        ("foo:=", "is not a remap rule"),
        ("foo/:=bar", "is not a remap rule"),
        ("foo:=bar/", "is not a remap rule"),
        ("foo//a:=bar", "is not a remap rule"),
        ("1foo:=bar", "is not a remap rule"),
        ("foo:=bar:=baz", "is not a remap rule"),
        ("a b:=c", "is not a remap rule"),
        ("{node}:=c", "is not a remap rule"),
        ("a__b:=c", "must not have '__'"),
        ("a:=c__d", "must not have '__'"),
        ("*:=bar", "wildcards are not implemented"),
        ("/foo/*:=bar", "wildcards are not implemented"),
        (r"foo:=bar/\1", "backreferences are not implemented"),
        ("__node:=a/b", "is not a remap rule"),
        ("__ns:=relative", "is not a remap rule"),
        ("__node:rostopic://a:=b", "is not a remap rule"),
        ("__name:=a b", "is not a remap rule$"),
        ("__ns:=", "is not a remap rule$"),
        ("__node:=", "is not a remap rule$"),
    ],
)
def test_rules_that_rcl_refuses(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        RemapRule.parse(text)


@pytest.mark.parametrize(
    ("name", "namespace", "texts", "expected"),
    [
        ("chatter", "/", [], "/chatter"),
        ("chatter", "/a/b", [], "/a/b/chatter"),
        ("/chatter", "/a", [], "/chatter"),
        ("~", "/a", [], "/a/talker"),
        ("~/s", "/a", [], "/a/talker/s"),
        ("{node}/x", "/a", [], "/a/talker/x"),
        ("{ns}/x", "/a", [], "/a/x"),
        ("foo__bar", "/", [], "/foo__bar"),
        ("chatter", "/a", ["chatter:=other"], "/a/other"),
        ("chatter", "/a", ["/chatter:=/other"], "/a/chatter"),
        ("chatter", "/a", ["chatter:=/x", "/x:=/y"], "/x"),
        ("chatter", "/a", ["~/chatter:=z"], "/a/chatter"),
        ("~/c", "/a", ["~/c:=z"], "/a/z"),
        ("chatter", "/a", ["other:chatter:=/x"], "/a/chatter"),
        ("chatter", "/a", ["talker:chatter:=/x"], "/x"),
        ("chatter", "/a", ["chatter:=first", "chatter:=second"], "/a/first"),
        ("chatter", "/a", ["rosservice://chatter:=/x"], "/a/chatter"),
        ("chatter", "/a", ["chatter:=~/x"], "/a/talker/x"),
    ],
)
def test_resolution(name: str, namespace: str, texts: list[str], expected: str) -> None:
    resolved = resolve(name, "topic", ("talker", namespace), rules(*texts))
    assert (resolved.name, resolved.error) == (expected, None)


@pytest.mark.parametrize(
    ("name", "namespace", "code"),
    [
        ("{ns}/x", "/", "REPEATED_SLASH"),
        ("/foo/{ns}", "/a", "REPEATED_SLASH"),
        ("a//b", "/", "REPEATED_SLASH"),
        ("foo-bar", "/", "UNALLOWED_CHARACTERS"),
        ("x/1y", "/", "TOKEN_STARTS_WITH_NUMBER"),
        ("foo/", "/", "ENDS_WITH_SLASH"),
    ],
)
def test_resolution_that_fails(name: str, namespace: str, code: str) -> None:
    resolved = resolve(name, "topic", ("talker", namespace))
    assert resolved.name is None
    assert resolved.error is not None
    assert resolved.error.code == code


def test_local_rules_come_before_global_ones() -> None:
    resolved = resolve("x", "topic", ("n", "/"), rules("x:=local"), rules("x:=global"))
    assert (resolved.name, resolved.rule) == ("/local", rules("x:=local")[0])


def test_rules_of_a_command_line() -> None:
    line = ["-r", "no:=no", "--ros-args", "-r", "a:=b", "--remap", "c:=d", "-p", "x:=1"]
    line += ["-r", "bad/:=e", "--", "-r", "f:=g", "--ros-args", "-r", "h:=i"]
    assert [rule.text for rule in rules_of_arguments(line)] == ["a:=b", "c:=d", "h:=i"]


@pytest.mark.parametrize("text", ["__node:=a", "__ns:=/a", "n:__name:=b", "x:=y"])
def test_a_rule_keeps_its_text(text: str) -> None:
    assert RemapRule.parse(text).text == text


def test_only_the_word_behind_the_option_is_a_rule() -> None:
    assert rules_of_arguments(["a:=b", "--remap", "c:=d"]) == []
    assert rules_of_arguments(["--ros-args", "a:=b"]) == []
    assert [rule.text for rule in rules_of_arguments(["--ros-args", "-r", "a:=b", "c:=d"])] == ["a:=b"]


def test_humble_takes_no_rule_for_an_action() -> None:
    [rule] = rules("dock:=park")
    assert rule.in_distro("humble").kinds == {"topic", "service"}
    assert rule.in_distro("humble").text == rule.text
    assert rule.in_distro("jazzy") == rule.in_distro(None) == rule


tokens = st.sampled_from(["a", "b", "c"])
topic_names = st.lists(tokens, min_size=1, max_size=2).map("/".join)
prefixed = st.tuples(st.sampled_from(["", "/", "~/"]), topic_names).map("".join)
rule_lists = st.lists(st.tuples(prefixed, prefixed).map(":=".join).map(RemapRule.parse), max_size=4)


@given(prefixed, rule_lists)
def test_a_remap_is_one_step(name: str, chosen: list[RemapRule]) -> None:
    node = ("n", "/ns")
    plain = names.expand(name, *node)
    assert isinstance(plain, str)
    outcomes = {plain} | {str(names.expand(rule.replacement, *node)) for rule in chosen}
    resolved = resolve(name, "topic", node, chosen)
    assert resolved.name in outcomes
    rule = first_match(plain, "topic", *node, chosen)
    expected = plain if rule is None else names.expand(rule.replacement, *node)
    assert resolved.name == expected


@given(prefixed, rule_lists, rule_lists)
def test_rules_after_the_first_match_do_not_matter(name: str, chosen: list[RemapRule], more: list[RemapRule]) -> None:
    resolved = resolve(name, "topic", ("n", "/ns"), chosen)
    if resolved.rule is not None:
        assert resolve(name, "topic", ("n", "/ns"), chosen, more) == resolved


@given(st.text("abn_:/=~rostopic", max_size=20))
def test_a_rule_that_parses_says_what_it_was_made_of(text: str) -> None:
    try:
        rule = RemapRule.parse(text)
    except ValueError:
        return
    assert rule.text == text
    assert text.endswith(":=" + rule.replacement)
