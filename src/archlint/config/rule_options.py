"""The options of rules, as a configuration writes them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from archlint.checks.registry import OptionValue, registered
from archlint.config.conversion import converted
from archlint.config.schema import options_of
from archlint.config.values import unknown_rule
from archlint.rulebook import codes_of, find_rule, may_be_rule

if TYPE_CHECKING:
    from archlint.config.source import Key


def rule_options(table: Mapping[str, Mapping[str, Any]], key: Key) -> dict[str, dict[str, OptionValue]]:
    """The options that a configuration sets for rules, by code."""
    checks = registered()
    options = {}
    for name, given in table.items():
        rule = find_rule(name)
        if rule is None and may_be_rule(name) and not codes_of(name):
            continue  # one that is left out
        if rule is None:
            raise key.at(name).error(unknown_rule(name))
        defaults = checks[rule.code].defaults if rule.code in checks else {}
        options[rule.code] = converted(given, options_of(rule.title, defaults), key.at(name)).given()
    return options
