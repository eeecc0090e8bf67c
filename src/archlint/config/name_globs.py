"""Patterns of names and of nodes as the configuration has them, one or several, checked."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from archlint.architecture import PACKAGE, Globs

if TYPE_CHECKING:
    from archlint.config.schema import OneOrMore
    from archlint.config.source import Key


def several(given: Any) -> tuple[Any, ...]:
    """What may be one or more, as more."""
    match given:
        case tuple():
            return given
    return (given,)


def node_globs(given: OneOrMore, key: Key) -> Globs:
    return _checked(given, key, of_nodes=True)


def name_globs(given: OneOrMore, key: Key) -> Globs:
    return _checked(given, key, of_nodes=False)


def _checked(given: OneOrMore, key: Key, *, of_nodes: bool) -> Globs:
    patterns = several(given)
    for pattern in patterns:
        check_pattern(key, pattern, of_nodes=of_nodes)
    return patterns


def check_pattern(key: Key, pattern: str, *, of_nodes: bool) -> None:
    """Names have no colon: what looks like a prefix is ``package:``, which goes for nodes only."""
    prefix, colon, rest = pattern.partition(":")
    if not pattern:
        raise key.error(f"`{key}` has an empty pattern, which matches nothing")
    if colon and not (of_nodes and prefix + colon == PACKAGE and rest):
        allowed = f"a node's name, or `{PACKAGE}NAME` for the nodes of a package" if of_nodes else "a name"
        raise key.error(f"`{key}` has {pattern!r}; a pattern is {allowed}")
