"""Expansion and validation of ROS names, as rcl does it (rcl: validate_topic_name.c,
expand_topic_name.c).

Kept apart from archlint's own implementation, so that one mistake cannot hide in both.
"""

from __future__ import annotations

import re

from .unknown import is_tainted, mask

_LONGEST_TOPIC = 247
_LONGEST_NAMESPACE = 245
_LONGEST_NODE_NAME = 255


class NameError_(Exception):
    """A name that rcl refuses; `reason` is what rcl says about it."""

    def __init__(self, name: str, reason: str) -> None:
        super().__init__(f"{name!r}: {reason}")
        self.name = name
        self.reason = reason


def join(prefix: str, name: str) -> str:
    """Join a namespace (or a full node name) and a relative name."""
    return prefix + name if prefix == "/" else f"{prefix}/{name}"


def expand(name: str, node: str, namespace: str) -> str:
    """The fully qualified form of a topic, service or action name; raises NameError_ as rcl would."""
    if not isinstance(name, str):
        raise TypeError(f"a name must be a string, not {type(name).__name__}")
    _validate_written(mask(name))
    if name.startswith("/") and "{" not in name:
        _validate_full(name)
        return name
    expanded = join(namespace, node) + name[1:] if name.startswith("~") else name
    while found := re.search(r"\{([^}]*)\}", expanded):
        value = {"node": node, "ns": namespace, "namespace": namespace}.get(found[1])
        if value is None:
            raise UnknownSubstitution(name, f"unknown substitution {found[0]}")
        expanded = expanded.replace(found[0], value)
    if not expanded.startswith("/"):
        expanded = join(namespace, expanded)
    _validate_full(expanded)
    return expanded


def node_identity(name: str, namespace: str | None) -> tuple[str, str]:
    """The (name, namespace) that a node gets from its constructor's arguments."""
    if not isinstance(name, str):
        raise TypeError(f"a node name must be a string, not {type(name).__name__}")
    namespace = namespace or "/"
    if not namespace.startswith("/"):
        namespace = "/" + namespace
    plain = mask(name)
    if not plain:
        raise NameError_(name, "node name must not be empty")
    if not re.fullmatch(r"[A-Za-z0-9_]+", plain):
        raise NameError_(name, "node name must not contain characters other than alphanumerics or '_'")
    if plain[0].isdigit():
        raise NameError_(name, "node name must not start with a number")
    if len(plain) > _LONGEST_NODE_NAME:
        raise NameError_(name, "node name is too long")
    if namespace != "/":
        _validate_full(namespace, _LONGEST_NAMESPACE)
    return name, namespace


class UnknownSubstitution(NameError_):
    """A substitution that there is none of, which rclpy tells by a plain ValueError."""


class Remapping:
    """The remap rules and parameters of a node's own `cli_args`; the first rule that matches is taken."""

    def __init__(self, arguments: object) -> None:
        self._rules: list[tuple[str, str | None, str, str]] = []
        self.parameters: list[tuple[str, str]] = []
        words = [str(word) for word in arguments] if isinstance(arguments, (list, tuple)) else []
        inside = False
        for index, word in enumerate(words):
            inside = (inside or word == "--ros-args") and word != "--"
            following = words[index + 1] if index + 1 < len(words) else ""
            if inside and word in ("-r", "--remap", "-p", "--param"):
                left, assigns, right = following.partition(":=")
                if not (left and assigns):
                    raise NameError_(following, "not a rule")
                if word in ("-p", "--param"):
                    self.parameters.append((left, right))
                else:
                    self._add(left, right)

    def _add(self, left: str, right: str) -> None:
        kind, _, rest = left.rpartition("://")
        node, _, match = rest.rpartition(":")
        if match == "__ns":
            _validate_full(right, _LONGEST_NAMESPACE)
        elif not match.startswith("__"):
            _validate_written(right)
            if "//" in right:
                raise NameError_(right, "must not contain repeated '/'")
        self._rules.append((kind, node or None, match, right))

    def special(self, word: str, node: str) -> str | None:
        """What a rule for `__node` or `__ns` says."""
        wanted = {"__node": ("__node", "__name")}.get(word, (word,))
        rules = [right for _, only, match, right in self._rules if match in wanted and only in (None, node)]
        return rules[0] if rules else None

    def apply(self, kind: str, full: str, node: str, namespace: str) -> str:
        """The name under which the fully qualified name of an endpoint of a kind goes."""
        of_kind = ("", "rosservice") if kind in ("service", "client") else ("", "rostopic")
        for scheme, only, match, right in self._rules:
            applies = scheme in of_kind and only in (None, node) and not match.startswith("__")
            if applies and expand(match, node, namespace) == full:
                return expand(right, node, namespace)
        return full


def _validate_written(name: str) -> None:
    if not name:
        raise NameError_(name, "topic name must not be empty string")
    if name[0].isdigit() or re.search(r"/[0-9]", name):
        raise NameError_(name, "topic name token must not start with a number")
    if name.endswith("/"):
        raise NameError_(name, "topic name must not end with a forward slash")
    if re.search(r"[^A-Za-z0-9_/~{}]", name):
        raise NameError_(name, "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'")
    if "~" in name[1:]:
        raise NameError_(name, "topic name must not have tilde '~' unless it is the first character")
    if name[0] == "~" and len(name) > 1 and name[1] != "/":
        raise NameError_(name, "topic name must not have a tilde '~' that is not followed by a forward slash '/'")
    rest = re.sub(r"\{([A-Za-z0-9_]*)\}", "", name)
    if "{" in rest or "}" in rest:
        raise NameError_(name, "topic name must have balanced curly braces around plain words")
    if re.search(r"\{[0-9]", name):
        raise NameError_(name, "substitution must not start with a number")


def _validate_full(name: str, longest: int = _LONGEST_TOPIC) -> None:
    plain = mask(name)
    if not plain.startswith("/"):
        raise NameError_(name, "full name must be absolute")
    if plain.endswith("/"):
        raise NameError_(name, "full name must not end with a forward slash")
    if re.search(r"[^A-Za-z0-9_/]", plain):
        raise NameError_(name, "full name must not contain characters other than alphanumerics, '_' or '/'")
    # What stands for an unknown value may itself begin or end with a slash: no verdict on those.
    if "//" in plain and not is_tainted(name):
        raise NameError_(name, "full name must not contain repeated '/'")
    if re.search(r"/[0-9]", plain):
        raise NameError_(name, "full name must not have a token that starts with a number")
    if len(plain) > longest:
        raise NameError_(name, "full name is too long")
