"""Remap rules: their grammar, and what they make of a name (rcl ``arguments.c``, ``remap.c``, ``node.c``).

rcl takes the first rule that matches and stops: rules never chain.  Rules of the node itself come before
those of the process.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Final, Literal

from archlint.architecture import ACTION, SERVICE, TOPIC, ConnectionKind
from archlint.records import dataclass
from archlint.ros import names
from archlint.ros.names import InvalidName

NODE_NAME: Final = "node_name"
NAMESPACE: Final = "namespace"

RuleKind = Literal["topic", "service", "action", "node_name", "namespace"]
"""What a rule applies to."""

_TOKEN = r"(?!__)[A-Za-z_](?:[A-Za-z0-9]|_(?!_))*"
_NAME = rf"(?:~/|/)?{_TOKEN}(?:/{_TOKEN})*"
_PREFIX = rf"(?:(?P<node>{_TOKEN}):(?!=))?"
_NODE_RULE = re.compile(rf"{_PREFIX}(?:__node|__name):=(?P<replacement>{_TOKEN})")
_NAMESPACE_RULE = re.compile(rf"{_PREFIX}__ns:=(?P<replacement>/(?:{_TOKEN}(?:/{_TOKEN})*/?)?)")
_NAME_RULE = re.compile(rf"{_PREFIX}(?P<scheme>rostopic://|rosservice://)?(?P<match>{_NAME}):=(?P<replacement>{_NAME})")
_KINDS: Final[dict[str | None, frozenset[RuleKind]]] = {
    None: frozenset((TOPIC, SERVICE, ACTION)),
    "rostopic://": frozenset((TOPIC, ACTION)),
    "rosservice://": frozenset((SERVICE,)),
}


@dataclass(frozen=True)
class RemapRule:
    """One rule, as after ``-r``, and what it applies to; ``__node`` and ``__ns`` rules have no ``match``."""

    text: str
    kinds: frozenset[RuleKind]
    match: str
    replacement: str
    node: str | None = None
    """Only nodes of this name, without namespace; None: every node of the process."""

    @classmethod
    def parse(cls, text: str) -> RemapRule:
        """Raises ``ValueError`` where rcl refuses the rule."""
        if match := _NODE_RULE.fullmatch(text):
            return cls(text, frozenset((NODE_NAME,)), "", match["replacement"], match["node"])
        if match := _NAMESPACE_RULE.fullmatch(text):
            return cls(text, frozenset((NAMESPACE,)), "", match["replacement"], match["node"])
        if match := _NAME_RULE.fullmatch(text):
            return cls(text, _KINDS[match["scheme"]], match["match"], match["replacement"], match["node"])
        raise ValueError(_refusal(text))

    def applies(self, kind: RuleKind, node_name: str | None) -> bool:
        return kind in self.kinds and self.node in (None, node_name)

    def in_distro(self, distro: str | None) -> RemapRule:
        """The rule as rcl of a distribution takes it; None stands for all that are supported.

        rcl_action resolves an action's name, as a topic's, in Kilted and later, and in Jazzy since 9.2.8 (October
        2025); in Humble a rule for it does nothing (`make test-ros` tries a version before and one after).
        """
        return replace(self, kinds=self.kinds - {ACTION}) if distro == "humble" else self


def _refusal(text: str) -> str:
    if ":=" not in text:
        return f"{text!r} is not a remap rule: it has no ':='"
    if "*" in text:
        return f"{text!r}: wildcards are not implemented in remap rules"
    if "\\" in text:
        return f"{text!r}: backreferences are not implemented in remap rules"
    if re.search(r"__(?!node|name|ns)", text):
        return f"{text!r} is not a remap rule: names in it must not have '__'"
    return f"{text!r} is not a remap rule"


@dataclass(frozen=True)
class Resolved:
    """A final name, or why there is none, and the rule that gave it."""

    name: str | None
    error: InvalidName | None = None
    rule: RemapRule | None = None


def first_match(
    name: str, kind: ConnectionKind, node_name: str, namespace: str, rules: Iterable[RemapRule]
) -> RemapRule | None:
    """The first rule that matches the fully qualified ``name``."""
    for rule in rules:
        if rule.applies(kind, node_name) and names.expand(rule.match, node_name, namespace) == name:
            return rule
    return None


def resolve(
    name: str,
    kind: ConnectionKind,
    node: tuple[str, str],
    local_rules: Sequence[RemapRule] = (),
    global_rules: Sequence[RemapRule] = (),
) -> Resolved:
    """The final name of a topic, service or action: expanded, remapped at most once, validated.

    ``kind`` is ``topic``, ``service`` or ``action``; ``node`` is the node's final name and its
    absolute namespace.
    """
    expanded = names.expand(name, *node)
    if isinstance(expanded, InvalidName):
        return Resolved(None, expanded)
    rule = first_match(expanded, kind, *node, [*local_rules, *global_rules])
    if rule is not None:
        replaced = names.expand(rule.replacement, *node)
        if isinstance(replaced, InvalidName):
            return Resolved(None, replaced, rule)
        expanded = replaced
    error = names.validate_full_name(expanded)
    return Resolved(None if error else expanded, error, rule)


def rules_of_arguments(arguments: Iterable[str]) -> list[RemapRule]:
    """The remap rules between ``--ros-args`` and ``--`` of a command line; malformed ones are left out."""
    rules: list[RemapRule] = []
    in_ros_arguments = remap_next = False
    for argument in arguments:
        if argument in ("--ros-args", "--"):
            in_ros_arguments, remap_next = argument == "--ros-args", False
        elif in_ros_arguments and remap_next:
            remap_next = False
            try:
                rules.append(RemapRule.parse(argument))
            except ValueError:
                continue
        else:
            remap_next = argument in ("-r", "--remap")
    return rules
