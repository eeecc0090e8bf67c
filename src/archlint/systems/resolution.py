"""The final name of an endpoint, from names that may be known only in part."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from archlint.model import (
    NAMED,
    EntityKind,
    Resolution,
    Text,
)
from archlint.records import dataclass
from archlint.ros import names, remapping
from archlint.ros.names import InvalidName
from archlint.ros.remapping import RemapRule

_RANK = {"exact": 0, "parameter": 1, "partial": 2, "unknown": 3}
_ANY_NODE = "_"
"""Stands for a node name that a name does not use, where rcl wants one."""


@dataclass(frozen=True)
class NodeName:
    """A node's own name and its absolute namespace, as far as they are known."""

    name: Text
    namespace: Text

    @property
    def full(self) -> str | None:
        if self.name.text is None or self.namespace.text is None:
            return None
        return names.join(self.namespace.text, self.name.text)

    @property
    def resolution(self) -> Resolution:
        return _weakest([self.name, self.namespace]).resolution

    @property
    def error(self) -> str | None:
        """Why rmw rejects the name or the namespace, where they are known."""
        checks = ((self.name, names.validate_node_name), (self.namespace, names.validate_namespace))
        for text, validate in checks:
            if text.text is not None and text.resolution in ("exact", "parameter"):
                wrong = validate(text.text)
                if wrong is not None:
                    return wrong.message
        return None


@dataclass(frozen=True)
class FinalName:
    """The outcome for one endpoint.

    ``name`` is the fully qualified name (a pattern with ``*`` for partial ones), or None where the name, the
    node's name or its namespace is unknown.  ``error`` is set where rcl rejects the name, in rcl's words.
    """

    name: str | None
    error: str | None = None
    resolution: Resolution = "exact"
    parameter: str | None = None
    reason: str | None = None

    @property
    def resolved(self) -> bool:
        """True for one known name, be it a parameter's default."""
        return self.name is not None and self.resolution in ("exact", "parameter")

    def forgotten(self, reason: str) -> FinalName:
        """The same without its name, which is not known for this reason."""
        return replace(self, name=None, resolution="unknown", reason=reason)


def node_init(
    name: Text,
    namespace: Text,
    local_rules: Sequence[RemapRule] = (),
    global_rules: Sequence[RemapRule] = (),
    *,
    given_name: Text | None = None,
    given_namespace: Text | None = None,
) -> NodeName:
    """A node's own name and namespace: those in the code, unless ``__node`` or ``__ns`` rules say otherwise.

    The first rule that applies counts; ``given_name`` and ``given_namespace`` stand for rules without prefix
    behind ``global_rules``, since launch_ros writes ``arguments`` and ``ros_arguments`` before them.  The prefix
    of a ``__node`` rule is compared with the name in the code, that of a ``__ns`` rule with the new name.
    """
    new_name = (
        _replacement(remapping.NODE_NAME, name, local_rules)
        or _replacement(remapping.NODE_NAME, name, global_rules)
        or given_name
        or name
    )
    new_namespace = (
        _replacement(remapping.NAMESPACE, new_name, local_rules)
        or _replacement(remapping.NAMESPACE, new_name, global_rules)
        or given_namespace
        or namespace
    )
    return NodeName(new_name, _absolute(new_namespace))


def _replacement(kind: remapping.RuleKind, name: Text, rules: Sequence[RemapRule]) -> Text | None:
    return next((Text(rule.replacement, "exact") for rule in rules if rule.applies(kind, name.text)), None)


def _absolute(namespace: Text) -> Text:
    if namespace.text is None or namespace.text.startswith("/"):
        return namespace
    return replace(namespace, text=names.absolute_namespace(namespace.text))


def endpoint_name(text: Text, kind: EntityKind, own: NodeName, rules: Sequence[RemapRule]) -> FinalName:
    """Expand and remap ``text``; ``kind`` is the endpoint's kind."""
    weakest = _weakest(_parts(text, own))
    if text.text is not None and own.error is None and all(map(_known, (text, own.name, own.namespace))):
        return _exact(text.text, weakest, kind, own, rules)
    return _cautious(text, weakest, kind, own, rules)


def _exact(name: str, weakest: Text, kind: EntityKind, own: NodeName, rules: Sequence[RemapRule]) -> FinalName:
    assert own.name.text is not None and own.namespace.text is not None
    node = (own.name.text, own.namespace.text)
    final = remapping.resolve(name, NAMED[kind], node, rules)
    error = final.error.message if final.error else None
    if not name and weakest.parameter is not None and final.rule is None:
        why = f"the parameter '{weakest.parameter}' has to be set: it is empty"
        return FinalName(None, error, "unknown", weakest.parameter, why)
    shown = final.name or names.substitute(final.rule.replacement if final.rule else name, *node)
    return FinalName(shown, error, weakest.resolution, weakest.parameter)


def _cautious(text: Text, weakest: Text, kind: EntityKind, own: NodeName, rules: Sequence[RemapRule]) -> FinalName:
    """As ``_exact``, where a part is not known or wrong: what cannot be decided is unknown."""
    if text.text is None or weakest.resolution == "unknown":
        return FinalName(None, None, "unknown", weakest.parameter, _reason(weakest, text, own))
    if weakest.resolution == "partial":
        final = names.expand_pattern(text.text, own.name.text or "", own.namespace.text or "/")
    else:
        final = _expand(text.text, own)
    if isinstance(final, InvalidName):
        shown = names.substitute(text.text, own.name.text or "", own.namespace.text or "/")
        return FinalName(shown, final.message, weakest.resolution, weakest.parameter, weakest.reason)
    plain = FinalName(final, None, weakest.resolution, weakest.parameter, weakest.reason)
    return _remapped(plain, kind, own, rules) if rules else plain


def _weakest(parts: Sequence[Text]) -> Text:
    """The part that is known least; the first of equals."""
    return max(parts, key=lambda part: _RANK[part.resolution])


def _parts(text: Text, own: NodeName) -> list[Text]:
    parts = [text]
    if text.text is not None and names.uses_namespace(text.text):
        parts.append(own.namespace)
    if text.text is not None and names.uses_node_name(text.text):
        parts.append(own.name)
    return parts


def _reason(weakest: Text, text: Text, own: NodeName) -> str:
    why = weakest.reason or "it is known only at run time"
    if weakest is text:
        return why
    return f"the node's {'name' if weakest is own.name else 'namespace'} is not known: {why}"


def _expand(name: str, own: NodeName) -> str | InvalidName:
    """Expanded and validated.  A node name that rmw rejects, or that is known in part, is not held against
    the endpoint."""
    node_name = own.name.text if own.name.text is not None and _known(own.name) else _ANY_NODE
    namespace = own.namespace.text if own.namespace.text is not None and _known(own.namespace) else "/"
    if own.error:
        return names.validate_topic_name(name) or names.substitute(name, node_name, namespace)
    expanded = names.expand(name, node_name, namespace)
    if isinstance(expanded, InvalidName):
        return expanded
    return names.validate_full_name(expanded) or expanded


def _remapped(final: FinalName, kind: EntityKind, own: NodeName, rules: Sequence[RemapRule]) -> FinalName:
    """``final`` after the first rule that matches; unknown where a rule might match."""
    assert final.name is not None
    for rule in rules:
        if NAMED[kind] not in rule.kinds:
            continue
        matches = _matches(rule, final.name, own)
        if matches is None:
            reason = f"the remap rule {rule.text!r} may apply to it"
            return FinalName(None, None, "unknown", final.parameter, reason)
        if matches:
            replacement = Text(rule.replacement, final.resolution, final.parameter)
            return endpoint_name(replacement, kind, own, ())
    return final


def _matches(rule: RemapRule, name: str, own: NodeName) -> bool | None:
    """Whether ``rule`` matches the expanded ``name``; None where that depends on what is not known."""
    if rule.node is not None and rule.node != own.name.text:
        if _known(own.name) or not names.pattern_matches(own.name.text or names.HOLE, rule.node):
            return False
        return None if rule.match.rsplit("/", 1)[-1] == name.rsplit("/", 1)[-1] else False
    if not all(map(_known, _parts(Text(rule.match, "exact"), own))):
        return None if rule.match.rsplit("/", 1)[-1] == name.rsplit("/", 1)[-1] else False
    match = _expand(rule.match, own)
    if match == name:
        return True
    if names.HOLE in name and isinstance(match, str) and names.pattern_matches(name, match):
        return None
    return False


def _known(text: Text) -> bool:
    return text.resolution in ("exact", "parameter")
