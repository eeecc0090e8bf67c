"""What a plugin is once it is loaded, and the rules of a run with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field

from archlint.checks.registry import Check, add_checks
from archlint.records import dataclass
from archlint.rulebook import Rule, add_rules, own_rules


class PluginError(Exception):
    """A plugin that cannot be used; ``str()`` says why."""


@dataclass(frozen=True)
class Plugin:
    """The rules of one plugin, by code.  ``digest`` is of the files that it consists of: two with the same one give the
    same findings."""

    name: str
    digest: str
    checks: Mapping[str, Check] = field(compare=False, repr=False)
    rules: Mapping[str, Rule] = field(compare=False, repr=False)
    files: tuple[str, ...] = field(compare=False, repr=False)
    """The paths of its modules and pages."""


def activate(plugins: Sequence[Plugin], left_out: bool = False) -> None:
    """Have the rules of plugins beside archlint's own, for the rest of this context (:mod:`contextvars`); ``left_out``
    where there are further plugins that do not run.  Raises :class:`PluginError` where two rules collide."""
    rules: dict[str, Rule] = {}
    for plugin in plugins:
        _refuse_collision(plugin, {**own_rules(), **rules})
        rules.update(plugin.rules)
    add_rules(rules, whole=not left_out)
    add_checks({code: check for plugin in plugins for code, check in plugin.checks.items()})


def _refuse_collision(plugin: Plugin, others: Mapping[str, Rule]) -> None:
    prefixes = {code[:3]: rule.plugin or "archlint" for code, rule in others.items()}
    names = {rule.name: rule for rule in others.values()}
    for code, rule in plugin.rules.items():
        if code[:3] in prefixes:
            raise PluginError(f"{plugin.name}: {code[:3]}, with which {code} starts, is taken by {prefixes[code[:3]]}")
        if rule.name in names:
            raise PluginError(f"{plugin.name}: {names[rule.name].code} is called {rule.name}, too: rename {code}")
