"""Names of nodes, topics, services and actions, by the rules of rcl and rmw.

Source of each rule: rcl ``validate_topic_name.c`` and ``expand_topic_name.c``, rmw
``validate_full_topic_name.c``, ``validate_node_name.c`` and ``validate_namespace.c``, the same from Humble to
Rolling.  Messages are those that a user of ROS 2 gets to read at run time.

A *pattern* is a name in which ``*`` stands for text that only data decides, any text, slashes included.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import Literal

from archlint.records import dataclass

HOLE = "*"
TOPIC_NAME_LIMIT = 247
NAMESPACE_LIMIT = 245
NODE_NAME_LIMIT = 255

_MANY = 10_000
"""How many names are kept with what rules say of them: the same few are asked for again and again."""

_TOKEN_NUMBER = "topic name token must not start with a number"
_UNALLOWED = "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'"
_SUBSTITUTION = "substitution name must not contain characters other than alphanumerics or '_'"
_BRACE = "topic name must not have unmatched (unbalanced) curly braces '{}'"
_MISPLACED_TILDE = "topic name must not have tilde '~' unless it is the first character"
_TILDE = "topic name must not have a tilde '~' that is not followed by a forward slash '/'"
_LAST_SLASH = "topic name must not end with a forward slash"


NameFault = Literal[
    "EMPTY",
    "ENDS_WITH_SLASH",
    "MISPLACED_TILDE",
    "NOT_ABSOLUTE",
    "REPEATED_SLASH",
    "STARTS_WITH_NUMBER",
    "SUBSTITUTION_STARTS_WITH_NUMBER",
    "SUBSTITUTION_UNALLOWED",
    "TILDE_NOT_FOLLOWED_BY_SLASH",
    "TOKEN_STARTS_WITH_NUMBER",
    "TOO_LONG",
    "UNALLOWED_CHARACTERS",
    "UNKNOWN_SUBSTITUTION",
    "UNMATCHED_CURLY_BRACE",
]


@dataclass(frozen=True)
class InvalidName:
    """Why ROS rejects a name: rcl's code, rcl's message, and where in the text (from 0)."""

    code: NameFault
    message: str
    index: int


@lru_cache(maxsize=_MANY)
def validate_topic_name(text: str) -> InvalidName | None:
    """What rcl says of a topic, service or action name as code gives it, before expansion."""
    if not text:
        return InvalidName("EMPTY", "topic name must not be empty string", 0)
    if _is_digit(text[0]):
        return InvalidName("TOKEN_STARTS_WITH_NUMBER", _TOKEN_NUMBER, 0)
    if text.endswith("/"):
        return InvalidName("ENDS_WITH_SLASH", _LAST_SLASH, len(text) - 1)
    return _wrong_character(text) or _wrong_token(text)


def has_placeholder(text: str) -> bool:
    """Whether a name has a part for the reader to fill in: ``[Namespace]/scan``, ``/<robot>/scan``."""
    return _FILLED_IN.search(text) is not None


_FILLED_IN = re.compile(r"\[[A-Za-z][\w -]*\]|<[A-Za-z][\w -]*>")


def _wrong_character(text: str) -> InvalidName | None:
    opened: int | None = None
    for index, char in enumerate(text):
        if _is_word(char):
            if opened == index - 1 and _is_digit(char):
                message = "substitution name must not start with a number"
                return InvalidName("SUBSTITUTION_STARTS_WITH_NUMBER", message, index)
        elif char == "~":
            if index:
                return InvalidName("MISPLACED_TILDE", _MISPLACED_TILDE, index)
        elif char == "}":
            if opened is None:
                return InvalidName("UNMATCHED_CURLY_BRACE", _BRACE, index)
            opened = None
        elif opened is not None:
            return InvalidName("SUBSTITUTION_UNALLOWED", _SUBSTITUTION, index)
        elif char == "{":
            opened = index
        elif char != "/":
            return InvalidName("UNALLOWED_CHARACTERS", _UNALLOWED, index)
    return None if opened is None else InvalidName("UNMATCHED_CURLY_BRACE", _BRACE, opened)


def _wrong_token(text: str) -> InvalidName | None:
    # rcl never looks at the last character here, so that ``~x`` passes and becomes ``/nodex``.
    if text[0] == "~" and len(text) > 2 and text[1] != "/":
        return InvalidName("TILDE_NOT_FOLLOWED_BY_SLASH", _TILDE, 1)
    number = re.search("/[0-9]", text)
    return number and InvalidName("TOKEN_STARTS_WITH_NUMBER", _TOKEN_NUMBER, number.start() + 1)


def validate_full_name(text: str) -> InvalidName | None:
    """What rmw says of a fully qualified topic, service or action name."""
    return _full(text) or _too_long_topic(text)


@lru_cache(maxsize=_MANY)
def _full(text: str) -> InvalidName | None:
    if not text:
        return InvalidName("EMPTY", "topic name must not be empty", 0)
    if text[0] != "/":
        return InvalidName("NOT_ABSOLUTE", "topic name must be absolute, it must lead with a '/'", 0)
    if text.endswith("/"):
        return InvalidName("ENDS_WITH_SLASH", "topic name must not end with a '/'", len(text) - 1)
    for index, char in enumerate(text):
        if char != "/" and not _is_word(char):
            message = "topic name must not contain characters other than alphanumerics, '_', or '/'"
            return InvalidName("UNALLOWED_CHARACTERS", message, index)
    return _wrong_slash(text)


def _wrong_slash(text: str) -> InvalidName | None:
    wrong = re.search("/[/0-9]", text)
    if wrong is None:
        return None
    if wrong.group() == "//":
        return InvalidName("REPEATED_SLASH", "topic name must not contain repeated '/'", wrong.start() + 1)
    message = "topic name must not have a token that starts with a number"
    return InvalidName("TOKEN_STARTS_WITH_NUMBER", message, wrong.start() + 1)


def _too_long(text: str, limit: int, message: str) -> InvalidName | None:
    return InvalidName("TOO_LONG", message, limit - 1) if len(text) > limit else None


def _too_long_topic(text: str) -> InvalidName | None:
    return _too_long(text, TOPIC_NAME_LIMIT, "topic length should not exceed '247'")


@lru_cache(maxsize=_MANY)
def validate_node_name(text: str) -> InvalidName | None:
    """What rmw says of a node's own name, without namespace."""
    if not text:
        return InvalidName("EMPTY", "node name must not be empty", 0)
    for index, char in enumerate(text):
        if not _is_word(char):
            message = "node name must not contain characters other than alphanumerics or '_'"
            return InvalidName("UNALLOWED_CHARACTERS", message, index)
    if _is_digit(text[0]):
        return InvalidName("STARTS_WITH_NUMBER", "node name must not start with a number", 0)
    return _too_long(text, NODE_NAME_LIMIT, "node name length should not exceed '255'")


def validate_namespace(text: str) -> InvalidName | None:
    """What rmw says of an absolute namespace (:func:`absolute_namespace` makes one of an argument)."""
    if text == "/":
        return None
    wrong = _full(text)
    if wrong is not None:
        message = wrong.message.replace("topic name", "namespace", 1)
        if wrong.code == "ENDS_WITH_SLASH":
            message += ", unless only a '/'"
        return InvalidName(wrong.code, message, wrong.index)
    return _too_long(text, NAMESPACE_LIMIT, "namespace should not exceed '245'")


def absolute_namespace(text: str) -> str:
    """The namespace that a constructor's argument gives: ``""`` is the root, ``ns`` is ``/ns``."""
    return text if text.startswith("/") else "/" + text


def join(namespace: str, name: str) -> str:
    """``name`` below an absolute ``namespace``."""
    return namespace + name if namespace == "/" else f"{namespace}/{name}"


def expand(name: str, node_name: str, namespace: str) -> str | InvalidName:
    """Expand a name as ``rcl_expand_topic_name`` does; ``namespace`` is absolute.

    The result still has to pass :func:`validate_full_name`.
    """
    wrong = validate_topic_name(name) or validate_node_name(node_name) or validate_namespace(namespace)
    if wrong is not None:
        return wrong
    expanded = substitute(name, node_name, namespace)
    unknown = re.search(r"\{[^}]*\}", expanded)
    if unknown is not None:
        message = f"unknown substitution: {unknown.group()}"
        return InvalidName("UNKNOWN_SUBSTITUTION", message, name.index(unknown.group()))
    return expanded


def substitute(name: str, node_name: str, namespace: str) -> str:
    """``name`` made absolute, with ``~``, ``{node}``, ``{ns}`` and ``{namespace}`` replaced, unchecked."""
    if name.startswith("~"):
        name = join(namespace, node_name) + name[1:]
    elif name.startswith("/") and "{" not in name:
        return name
    name = name.replace("{node}", node_name).replace("{ns}", namespace).replace("{namespace}", namespace)
    return name if name.startswith("/") else join(namespace, name)


def uses_node_name(name: str) -> bool:
    """Whether the expansion of ``name`` depends on the node's own name."""
    return name.startswith("~") or "{node}" in name


def uses_namespace(name: str) -> bool:
    """Whether the expansion of ``name`` depends on the node's namespace."""
    return not name.startswith(("/", HOLE)) or "{ns}" in name or "{namespace}" in name


def expand_pattern(name: str, node_name: str, namespace: str) -> str | InvalidName:
    """Expand a name with holes.  Only what is wrong whatever fills the holes is an error.

    A name that starts with a hole may turn out relative, private or absolute, so that nothing is put before
    it but a slash.
    """
    wrong = validate_pattern(name)
    if wrong is not None:
        return wrong
    if name.startswith(HOLE):
        return "/" + name.replace("{node}", node_name)
    expanded = substitute(name, node_name, namespace)
    return _wrong_slash(expanded) or _too_long_topic(expanded.replace(HOLE, "")) or expanded


def validate_pattern(name: str) -> InvalidName | None:
    """What rcl is certain to say of a name with holes, whatever fills them."""
    if name and _is_digit(name[0]):
        return InvalidName("TOKEN_STARTS_WITH_NUMBER", _TOKEN_NUMBER, 0)
    if name.endswith("/"):
        return InvalidName("ENDS_WITH_SLASH", _LAST_SLASH, len(name) - 1)
    fixed_before = False
    for index, char in enumerate(name):
        if char == "~" and fixed_before:
            return InvalidName("MISPLACED_TILDE", _MISPLACED_TILDE, index)
        if not _is_word(char) and char not in "/~{}*":
            return InvalidName("UNALLOWED_CHARACTERS", _UNALLOWED, index)
        fixed_before = fixed_before or char != HOLE
    if name[:1] == "~" and len(name.replace(HOLE, "")) > 2 and name[1] not in ("/", HOLE):
        return InvalidName("TILDE_NOT_FOLLOWED_BY_SLASH", _TILDE, 1)
    number = re.search("/[0-9]", name)
    return number and InvalidName("TOKEN_STARTS_WITH_NUMBER", _TOKEN_NUMBER, number.start() + 1)


def pattern_matches(pattern: str, name: str) -> bool:
    """Whether some filling of the holes of an expanded ``pattern`` gives ``name``.

    A hole right after the first slash may stand for nothing or bring a slash of its own.
    """
    if pattern.startswith("/" + HOLE):
        pattern = pattern[1:]
    first, *others = pattern.split(HOLE)
    if not others:
        return name == first
    *between, last = others
    at, end = len(first), len(name) - len(last)
    if at > end or not (name.startswith(first) and name.endswith(last)):
        return False
    for part in between:  # the first place of each leaves the most for the others
        start = name.find(part, at, end)
        if start < 0:
            return False
        at = start + len(part)
    return True


def is_hidden(name: str) -> bool:
    """Whether ROS tools hide a topic, service, action or node of this name: a token starts with ``_``."""
    return any(token.startswith("_") for token in name.split("/"))


ActionPart = Literal["send_goal", "cancel_goal", "get_result", "feedback", "status"]
"""What a hidden service or topic of an action is for."""
_ACTION_PARTS: tuple[ActionPart, ...] = ("send_goal", "cancel_goal", "get_result", "feedback", "status")


def action_entities(action: str) -> dict[ActionPart, str]:
    """The hidden services and topics of an action, by what they are for (rcl_action ``names.c``)."""
    return {part: f"{action}/_action/{part}" for part in _ACTION_PARTS}


def _is_digit(char: str) -> bool:
    return "0" <= char <= "9"


def _is_word(char: str) -> bool:
    """ASCII letters, digits and ``_``: what rcutils takes for alphanumeric does not depend on a locale."""
    return char == "_" or (char.isascii() and char.isalnum())
