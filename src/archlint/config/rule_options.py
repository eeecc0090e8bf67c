"""The options of rules, as a configuration writes them."""

from __future__ import annotations

from collections.abc import Mapping

from archlint.checks.registry import OptionValue, registered
from archlint.config.values import Value, boolean, number, string, strings, table, unknown_key, unknown_rule
from archlint.rulebook import Rule, find_rule


def rule_options(value: Value) -> dict[str, dict[str, OptionValue]]:
    """The options that a configuration sets for rules, by code."""
    checks = registered()
    found = {}
    for name, given in table(value).items():
        rule = find_rule(name)
        if rule is None:
            raise value.source.error(unknown_rule(name), given.path)
        defaults = checks[rule.code].defaults if rule.code in checks else {}
        found[rule.code] = {key: _option(rule, defaults, key, one) for key, one in table(given).items()}
    return found


def _option(rule: Rule, defaults: Mapping[str, OptionValue], key: str, given: Value) -> OptionValue:
    if key not in defaults:
        raise given.source.error(unknown_key(key, defaults, f"{rule.title} has no option"), given.path)
    return _like(defaults[key], given)


def _like(default: OptionValue, given: Value) -> OptionValue:
    """A rule's option, of the type that its default has."""
    match default:
        case bool():
            return boolean(given)
        case tuple():
            return strings(given)
        case str():
            return string(given)
    return number(given)
