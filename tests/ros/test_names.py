"""The vectors are those of rcl's own tests (``test_validate_topic_name.cpp``, ``test_expand_topic_name.cpp``)
and of rmw's, completed by corners of the sources."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from archlint.ros import names
from archlint.ros.names import InvalidName

TOPIC_ALPHABET = "ab_1/~{}* -"


def code(result: InvalidName | str | None) -> str | None:
    return result.code if isinstance(result, InvalidName) else None


ACCEPTED = """
    foo abc123 _foo Foo BAR ~ foo/bar ~/foo {foo}_bar foo/{ping}/bar foo/_bar foo_/bar foo_ /foo /bar/baz
    /_private/thing /public_namespace/_private/thing {foo1} {foo_bar} {_bar} foo__bar {} a//b ~x
"""


@pytest.mark.parametrize("name", ACCEPTED.split())
def test_names_that_rcl_accepts_before_expansion(name: str) -> None:
    assert names.validate_topic_name(name) is None


@pytest.mark.parametrize(
    ("name", "expected", "index"),
    [
        ("", "EMPTY", 0),
        ("123abc", "TOKEN_STARTS_WITH_NUMBER", 0),
        ("123", "TOKEN_STARTS_WITH_NUMBER", 0),
        ("0a", "TOKEN_STARTS_WITH_NUMBER", 0),
        ("9a", "TOKEN_STARTS_WITH_NUMBER", 0),
        ("1/", "TOKEN_STARTS_WITH_NUMBER", 0),
        ("foo/123bar", "TOKEN_STARTS_WITH_NUMBER", 4),
        ("x/1y", "TOKEN_STARTS_WITH_NUMBER", 2),
        ("foo/", "ENDS_WITH_SLASH", 3),
        ("/", "ENDS_WITH_SLASH", 0),
        ("fo o/", "ENDS_WITH_SLASH", 4),
        (" ", "UNALLOWED_CHARACTERS", 0),
        ("foo bar", "UNALLOWED_CHARACTERS", 3),
        ("foo-bar", "UNALLOWED_CHARACTERS", 3),
        ("foo.bar", "UNALLOWED_CHARACTERS", 3),
        ("rostopic://foo", "UNALLOWED_CHARACTERS", 8),
        ("größe", "UNALLOWED_CHARACTERS", 2),
        ("a/٣", "UNALLOWED_CHARACTERS", 2),
        ("/~", "MISPLACED_TILDE", 1),
        ("foo~", "MISPLACED_TILDE", 3),
        ("foo~/bar", "MISPLACED_TILDE", 3),
        ("foo/~bar", "MISPLACED_TILDE", 4),
        ("foo/~/bar", "MISPLACED_TILDE", 4),
        ("{~}", "MISPLACED_TILDE", 1),
        ("~foo", "TILDE_NOT_FOLLOWED_BY_SLASH", 1),
        ("~foo/1", "TILDE_NOT_FOLLOWED_BY_SLASH", 1),
        ("foo/bar}/baz", "UNMATCHED_CURLY_BRACE", 7),
        ("foo/{bar", "UNMATCHED_CURLY_BRACE", 4),
        ("{$}", "SUBSTITUTION_UNALLOWED", 1),
        ("{{bar}_baz}", "SUBSTITUTION_UNALLOWED", 1),
        ("foo/{bar/baz}", "SUBSTITUTION_UNALLOWED", 8),
        ("{1foo}", "SUBSTITUTION_STARTS_WITH_NUMBER", 1),
    ],
)
def test_names_that_rcl_rejects_before_expansion(name: str, expected: str, index: int) -> None:
    wrong = names.validate_topic_name(name)
    assert wrong is not None
    assert (wrong.code, wrong.index) == (expected, index)


@pytest.mark.parametrize(
    ("name", "expected", "index"),
    [
        ("/a", None, None),
        ("/a/b_1/_c", None, None),
        ("/" + "a" * 246, None, None),
        ("", "EMPTY", 0),
        ("a", "NOT_ABSOLUTE", 0),
        ("/", "ENDS_WITH_SLASH", 0),
        ("/a/", "ENDS_WITH_SLASH", 2),
        ("/a~", "UNALLOWED_CHARACTERS", 2),
        ("/{a}", "UNALLOWED_CHARACTERS", 1),
        ("/a//b", "REPEATED_SLASH", 3),
        ("/1a", "TOKEN_STARTS_WITH_NUMBER", 1),
        ("/a/2", "TOKEN_STARTS_WITH_NUMBER", 3),
        ("/" + "a" * 247, "TOO_LONG", 246),
    ],
)
def test_full_names(name: str, expected: str | None, index: int | None) -> None:
    wrong = names.validate_full_name(name)
    assert (wrong and wrong.code, wrong and wrong.index) == (expected, index)


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("talker", None),
        ("_hidden", None),
        ("a__b", None),
        ("a" * 255, None),
        ("", "EMPTY"),
        ("my-node", "UNALLOWED_CHARACTERS"),
        ("ns/node", "UNALLOWED_CHARACTERS"),
        ("1-", "UNALLOWED_CHARACTERS"),
        ("1node", "STARTS_WITH_NUMBER"),
        ("a" * 256, "TOO_LONG"),
    ],
)
def test_node_names(name: str, expected: str | None) -> None:
    assert code(names.validate_node_name(name)) == expected


@pytest.mark.parametrize(
    ("namespace", "expected"),
    [
        ("/", None),
        ("/a/b", None),
        ("/" + "a" * 244, None),
        ("", "EMPTY"),
        ("a", "NOT_ABSOLUTE"),
        ("/a/", "ENDS_WITH_SLASH"),
        ("/a//b", "REPEATED_SLASH"),
        ("/a-b", "UNALLOWED_CHARACTERS"),
        ("/2", "TOKEN_STARTS_WITH_NUMBER"),
        ("/" + "a" * 245, "TOO_LONG"),
        ("/" + "a" * 300, "TOO_LONG"),
    ],
)
def test_namespaces(namespace: str, expected: str | None) -> None:
    assert code(names.validate_namespace(namespace)) == expected


def test_messages_speak_of_what_was_validated() -> None:
    wrong = names.validate_namespace("/a/")
    assert wrong is not None
    assert wrong.message == "namespace must not end with a '/', unless only a '/'"


@pytest.mark.parametrize(("given_", "absolute"), [("", "/"), ("a", "/a"), ("/a", "/a"), ("/", "/")])
def test_the_namespace_of_a_constructor(given_: str, absolute: str) -> None:
    assert names.absolute_namespace(given_) == absolute


@pytest.mark.parametrize(
    ("name", "node", "namespace", "expected"),
    [
        ("/chatter", "my_node", "/my_ns", "/chatter"),
        ("chatter", "my_node", "/my_ns", "/my_ns/chatter"),
        ("{node}/chatter", "my_node", "/my_ns", "/my_ns/my_node/chatter"),
        ("/{node}", "my_node", "/my_ns", "/my_node"),
        ("{node}", "my_node", "/my_ns", "/my_ns/my_node"),
        ("{ns}", "my_node", "/my_ns", "/my_ns"),
        ("{namespace}", "my_node", "/my_ns", "/my_ns"),
        ("{namespace}/{node}/chatter", "my_node", "/my_ns", "/my_ns/my_node/chatter"),
        ("/foo/{namespace}", "my_node", "/my_ns", "/foo//my_ns"),
        ("ping", "my_node", "/", "/ping"),
        ("ping", "my_node", "/my_ns", "/my_ns/ping"),
        ("/ping", "my_node", "/", "/ping"),
        ("/ping", "my_node", "/my_ns", "/ping"),
        ("~", "my_node", "/", "/my_node"),
        ("~", "my_node", "/my_ns", "/my_ns/my_node"),
        ("~/ping", "my_node", "/", "/my_node/ping"),
        ("~/ping", "my_node", "/my_ns", "/my_ns/my_node/ping"),
        ("chatter", "talker", "/a/b", "/a/b/chatter"),
        ("~/{node}/{node}", "n", "/", "/n/n/n"),
        ("{ns}/x", "talker", "/", "//x"),
        ("foo__bar", "talker", "/", "/foo__bar"),
        ("~x", "talker", "/", "/talkerx"),
    ],
)
def test_expansion(name: str, node: str, namespace: str, expected: str) -> None:
    assert names.expand(name, node, namespace) == expected


@pytest.mark.parametrize(
    ("name", "node", "namespace", "expected"),
    [
        ("{doesnotexist}", "my_node", "/my_ns", "UNKNOWN_SUBSTITUTION"),
        ("{}", "my_node", "/my_ns", "UNKNOWN_SUBSTITUTION"),
        ("white space", "my_node", "/my_ns", "UNALLOWED_CHARACTERS"),
        ("chatter", "invalid node", "/my_ns", "UNALLOWED_CHARACTERS"),
        ("chatter", "my_node", "my_ns", "NOT_ABSOLUTE"),
    ],
)
def test_expansion_that_fails(name: str, node: str, namespace: str, expected: str) -> None:
    assert code(names.expand(name, node, namespace)) == expected


def test_an_unknown_substitution_is_named_where_it_stands_first() -> None:
    wrong = names.expand("x{odd}/{odd}", "node", "/")
    assert wrong == InvalidName("UNKNOWN_SUBSTITUTION", "unknown substitution: {odd}", 1)


@pytest.mark.parametrize(
    ("pattern", "namespace", "expected"),
    [
        ("a/*", "/ns", "/ns/a/*"),
        ("/a/*", "/ns", "/a/*"),
        ("~/*", "/ns", "/ns/node/*"),
        ("*/a", "/", "/*/a"),
        ("*/a", "/ns", "/*/a"),
        ("*", "/ns", "/*"),
        ("a*b", "/", "/a*b"),
        ("{ns}/*", "/ns", "/ns/*"),
        ("~*", "/", "/node*"),
        ("{*}", "/", "/{*}"),
        ("*/{node}", "/ns", "/*/node"),
        ("a" * 246 + "*", "/", "/" + "a" * 246 + "*"),  # 247 characters are allowed, and the hole may be none
    ],
)
def test_patterns_keep_their_holes(pattern: str, namespace: str, expected: str) -> None:
    assert names.expand_pattern(pattern, "node", namespace) == expected


@pytest.mark.parametrize(
    ("pattern", "expected"),
    [
        ("* x", "UNALLOWED_CHARACTERS"),
        ("1*", "TOKEN_STARTS_WITH_NUMBER"),
        ("*/2", "TOKEN_STARTS_WITH_NUMBER"),
        ("*/", "ENDS_WITH_SLASH"),
        ("a~*", "MISPLACED_TILDE"),
        ("a//*", "REPEATED_SLASH"),
        ("{ns}/*", "REPEATED_SLASH"),
        ("~foo*", "TILDE_NOT_FOLLOWED_BY_SLASH"),
        ("a" * 250 + "*", "TOO_LONG"),
        # A hole may mend these.
        ("*1", None),
        ("*~", None),
        ("a*1", None),
        ("{*", None),
        ("*//a", None),
    ],
)
def test_patterns_that_no_filling_can_save(pattern: str, expected: str | None) -> None:
    assert code(names.expand_pattern(pattern, "node", "/")) == expected


@pytest.mark.parametrize(
    ("name", "at", "message"),
    [
        ("", 0, "topic name must not be empty string"),
        ("1a", 0, "topic name token must not start with a number"),
        ("a/", 1, "topic name must not end with a forward slash"),
        ("{1}", 1, "substitution name must not start with a number"),
        ("a~", 1, "topic name must not have tilde '~' unless it is the first character"),
        ("a}", 1, "topic name must not have unmatched (unbalanced) curly braces '{}'"),
        ("a{b", 1, "topic name must not have unmatched (unbalanced) curly braces '{}'"),
        ("{a/}", 2, "substitution name must not contain characters other than alphanumerics or '_'"),
        ("a b", 1, "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"),
        ("~ab", 1, "topic name must not have a tilde '~' that is not followed by a forward slash '/'"),
        ("a/1", 2, "topic name token must not start with a number"),
    ],
)
def test_what_rcl_says_of_a_name_and_where(name: str, at: int, message: str) -> None:
    wrong = names.validate_topic_name(name)
    assert wrong is not None
    assert (wrong.index, wrong.message) == (at, message)


@pytest.mark.parametrize(
    ("name", "at", "message"),
    [
        ("", 0, "topic name must not be empty"),
        ("a", 0, "topic name must be absolute, it must lead with a '/'"),
        ("/a/", 2, "topic name must not end with a '/'"),
        ("/a~", 2, "topic name must not contain characters other than alphanumerics, '_', or '/'"),
        ("/a//b", 3, "topic name must not contain repeated '/'"),
        ("/a/1", 3, "topic name must not have a token that starts with a number"),
        ("/" + "a" * 247, 246, "topic length should not exceed '247'"),
    ],
)
def test_what_rmw_says_of_a_full_name_and_where(name: str, at: int, message: str) -> None:
    wrong = names.validate_full_name(name)
    assert wrong is not None
    assert (wrong.index, wrong.message) == (at, message)


@pytest.mark.parametrize(
    ("name", "at", "message"),
    [
        ("", 0, "node name must not be empty"),
        ("a/b", 1, "node name must not contain characters other than alphanumerics or '_'"),
        ("1a", 0, "node name must not start with a number"),
        ("a" * 256, 254, "node name length should not exceed '255'"),
    ],
)
def test_what_rmw_says_of_a_node_name_and_where(name: str, at: int, message: str) -> None:
    wrong = names.validate_node_name(name)
    assert wrong is not None
    assert (wrong.index, wrong.message) == (at, message)


@pytest.mark.parametrize(
    ("name", "at", "message"),
    [
        ("a", 0, "namespace must be absolute, it must lead with a '/'"),
        ("/a/", 2, "namespace must not end with a '/', unless only a '/'"),
        ("/" + "a" * 245, 244, "namespace should not exceed '245'"),
    ],
)
def test_what_rmw_says_of_a_namespace_and_where(name: str, at: int, message: str) -> None:
    wrong = names.validate_namespace(name)
    assert wrong is not None
    assert (wrong.index, wrong.message) == (at, message)


@pytest.mark.parametrize(
    ("pattern", "at", "words"),
    [
        ("1*", 0, "must not start with a number"),
        ("*a/", 2, "must not end with a forward slash"),
        ("a~*", 1, "must not have tilde '~' unless it is the first character"),
        ("*x y", 2, "must not contain characters other than alphanumerics"),
        ("*X", None, ""),
        ("~ab*", 1, "must not have a tilde '~' that is not followed by a forward slash '/'"),
        ("~a/b*", 1, "must not have a tilde '~' that is not followed by a forward slash '/'"),
        ("~a*", None, ""),  # rcl never looks at the last character, and the hole may be none
        ("~/ab*", None, ""),
        ("*/1a", 2, "must not start with a number"),
    ],
)
def test_where_a_pattern_is_wrong_and_why(pattern: str, at: int | None, words: str) -> None:
    wrong = names.validate_pattern(pattern)
    assert (wrong and wrong.index) == at
    assert wrong is None or words in wrong.message


@pytest.mark.parametrize(
    ("name", "node", "namespace"),
    [
        ("a", False, True),
        ("~/a", True, True),
        ("/a", False, False),
        ("*/a", False, False),
        ("/{node}/a", True, False),
        ("/{ns}/a", False, True),
        ("/{namespace}/a", False, True),
        ("/{NODE}/a", False, False),
    ],
)
def test_what_the_meaning_of_a_name_depends_on(name: str, node: bool, namespace: bool) -> None:
    assert (names.uses_node_name(name), names.uses_namespace(name)) == (node, namespace)


@pytest.mark.parametrize(
    ("pattern", "name", "matches"),
    [
        ("/*/scan", "/front/scan", True),
        ("/*/scan", "/a/b/scan", True),
        ("/*/scan", "/scan", True),
        ("/arm/*/scan", "/arm/scan", False),
        ("/a.b*", "/axb", False),
        ("/a", "/a", True),
        ("/a/*b*b/*c", "/a/b/c", False),  # each part has a place of its own
        ("/a/*b*b/*c", "/a/bb/c", True),
        ("/a*bc*c", "/abc", False),
        ("/a*b*c*c", "/abcc", True),
        ("/a*x*b", "/acb", False),
        ("/a*b*b*c", "/abxbc", True),
        ("/*/a*b", "/axb", True),  # the first hole is nothing, and takes the slash with it
    ],
)
def test_what_a_pattern_may_become(pattern: str, name: str, matches: bool) -> None:
    assert names.pattern_matches(pattern, name) is matches


@pytest.mark.parametrize(
    ("name", "hidden"),
    [("/_a", True), ("/a/_action/status", True), ("/a_b", False), ("_a", True), ("/a/b_", False)],
)
def test_hidden_names(name: str, hidden: bool) -> None:
    assert names.is_hidden(name) is hidden


def test_the_hidden_names_of_an_action() -> None:
    assert names.action_entities("/dock") == {
        "send_goal": "/dock/_action/send_goal",
        "cancel_goal": "/dock/_action/cancel_goal",
        "get_result": "/dock/_action/get_result",
        "feedback": "/dock/_action/feedback",
        "status": "/dock/_action/status",
    }


node_names = st.from_regex("[a-zA-Z_][a-zA-Z0-9_]{0,10}", fullmatch=True)
namespaces = st.lists(node_names, max_size=3).map(lambda tokens: "/" + "/".join(tokens))
any_names = st.text(TOPIC_ALPHABET, max_size=12) | st.text(max_size=12)


@given(any_names, node_names, namespaces)
def test_an_expanded_name_is_absolute_and_expands_to_itself(name: str, node: str, namespace: str) -> None:
    expanded = names.expand(name, node, namespace)
    if isinstance(expanded, str):
        assert expanded.startswith("/")
        if names.validate_full_name(expanded) is None:
            assert names.expand(expanded, "other", "/elsewhere") == expanded


@given(any_names, node_names, namespaces)
def test_what_is_valid_after_expansion_was_valid_before(name: str, node: str, namespace: str) -> None:
    full = names.substitute(name, node, namespace) if name else ""
    if not names.validate_full_name(full) and "{" not in name and not name.startswith("~"):
        assert names.validate_topic_name(name) is None


@given(any_names)
def test_an_error_points_into_the_name(name: str) -> None:
    for validate in (names.validate_topic_name, names.validate_full_name, names.validate_node_name):
        wrong = validate(name)
        assert wrong is None or 0 <= wrong.index <= max(len(name) - 1, 0)


@given(
    st.lists(st.text("ab/~_", max_size=4), min_size=2, max_size=3),
    st.text("ab_/1{}~", max_size=4),
    node_names,
)
def test_a_pattern_is_wrong_only_where_each_filling_is(parts: list[str], filling: str, node: str) -> None:
    filled = names.expand(filling.join(parts), node, "/ns")
    if isinstance(filled, str) and names.validate_full_name(filled) is None:
        assert isinstance(names.expand_pattern("*".join(parts), node, "/ns"), str)


@given(st.lists(st.text("ab/_", max_size=4), min_size=2, max_size=3), st.text("ab_/", max_size=4), node_names)
def test_an_expanded_pattern_matches_each_filling(parts: list[str], filling: str, node: str) -> None:
    pattern = names.expand_pattern("*".join(parts), node, "/ns")
    filled = names.expand(filling.join(parts), node, "/ns")
    if isinstance(pattern, str) and isinstance(filled, str) and names.validate_full_name(filled) is None:
        assert names.pattern_matches(pattern, filled)
