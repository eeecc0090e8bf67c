"""``archlint explain CODE``: what a rule reports, why, and what to write instead."""

from __future__ import annotations

import argparse
import sys

from archlint.cli import console
from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.options import add_plugins, add_talking, plugins_here
from archlint.cli.parser import Parser
from archlint.cli.rule_page import full_page, shown
from archlint.rulebook import Rule, codes_of, find_rule, suggestion
from archlint.suggestions import listed, meant

LEVELS = {"on": "on by default", "off": "opt-in", "closed-world": "on in a closed world"}


def parser() -> Parser:
    parser = Parser("explain", "Print a rule's page: what it finds, why it matters, what to write instead.")
    parser.add_argument("rule", metavar="CODE", nargs="?", help="the code or the name of a rule")
    parser.add_argument("--all", action="store_true", help="show all examples, not only the first of each kind")
    add_plugins(parser)
    add_talking(parser)
    return parser


def run(arguments: argparse.Namespace) -> int:
    if arguments.rule is None:
        raise UsageError("which rule? `archlint rules` lists them, and `archlint explain SRV003` explains one")
    rule = find_rule(arguments.rule)
    if rule is None:
        left_out = plugins_here(arguments)
        rule = find_rule(arguments.rule)
        if rule is None:
            near = f"\n{left_out}" if left_out else _suggested(arguments.rule)
            raise UsageError(f"unknown rule `{arguments.rule}`{near}")
    page = full_page(rule, _facts(rule)) if arguments.all else _short(rule)
    if console.wants_color(arguments.color, sys.stdout):
        _print_rendered(page)
    else:
        console.say(page)
    return CLEAN


def _suggested(word: str) -> str:
    codes = codes_of(word)
    return meant(f"one of {listed(codes)}") if codes else suggestion(word)


def _short(rule: Rule) -> str:
    part = shown(rule, _facts(rule))
    return f"{part.text}\n*More examples: `archlint explain {rule.code} --all`*\n" if part.has_more else part.text


def _facts(rule: Rule) -> str:
    fix = f"{rule.fix} fix" if rule.fix else "no automatic fix"
    home = f", of {rule.plugin}" if rule.plugin else ""
    return f"*{rule.severity.label}, {LEVELS[rule.default]}, {fix}, since {rule.since}{home}*"


def _print_rendered(page: str) -> None:
    from io import StringIO

    from rich.console import Console
    from rich.markdown import Markdown

    rendered = StringIO()
    terminal = Console(file=rendered, force_terminal=True, force_interactive=False, highlight=False)
    terminal.print(Markdown(page, code_theme="ansi_dark"), width=min(terminal.width, 100))
    console.say(rendered.getvalue())
