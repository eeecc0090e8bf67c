"""``archlint rules``: the table of rules."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import Any

from archlint import cells
from archlint.cli import console
from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.options import add_plugins, plugins_here
from archlint.cli.parser import Parser
from archlint.rulebook import Rule, codes_of, rules, suggestion


def parser() -> Parser:
    parser = Parser("rules", "List every rule: its severity, whether it is on by default, what it finds.")
    parser.add_argument("rule", metavar="CODES", nargs="*", help="these only: codes, prefixes such as SRV, or names")
    add_plugins(parser)
    parser.add_argument("--format", metavar="F", choices=("text", "json"), default="text", help="text or json")
    return parser


def run(arguments: argparse.Namespace) -> int:
    left_out = plugins_here(arguments)
    if left_out:
        console.note(f"archlint: {left_out}")
    chosen = _chosen(arguments.rule)
    book = [rule for rule in rules().values() if rule.code in chosen]
    console.say(_json(book) if arguments.format == "json" else _text(book))
    return CLEAN


def _chosen(words: Sequence[str]) -> set[str]:
    """The codes that are meant; all without a word.  Raises :class:`UsageError` for a rule that there is not."""
    for word in words:
        if not codes_of(word):
            raise UsageError(f"unknown rule `{word}`{suggestion(word)}")
    return {code for word in words or ["ALL"] for code in codes_of(word)}


def _text(book: list[Rule]) -> str:
    rows = [["code", "name", "severity", "default", "fix", "finds"]]
    rows += [[rule.code, rule.name, rule.severity.label, rule.default, rule.fix or "-", rule.summary] for rule in book]
    return "".join(f"{line}\n" for line in cells.columns(rows))


def _json(book: list[Rule]) -> str:
    import json

    return json.dumps({"version": 1, "rules": [_entry(rule) for rule in book]}, indent=1) + "\n"


def _entry(rule: Rule) -> dict[str, Any]:
    return {
        "code": rule.code,
        "name": rule.name,
        "severity": rule.severity.label,
        "default": rule.default,
        "fix": rule.fix or None,
        "since": rule.since,
        "plugin": rule.plugin or None,
        "summary": rule.summary,
    }
