"""``archlint man``: the manual page."""

from __future__ import annotations

import argparse

from archlint.cli import console
from archlint.cli.exits import CLEAN
from archlint.cli.parser import Parser

_EPILOG = """\
Read it with `archlint man | man -l -`; for `man archlint`, once for each user:
  mkdir -p ~/.local/share/man/man1
  archlint man > ~/.local/share/man/man1/archlint.1
"""


def parser() -> Parser:
    parser = Parser("man", "Print the manual page, in the form that `man` reads.")
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    return parser


def run(arguments: argparse.Namespace) -> int:
    from archlint.cli.man_page import man_page  # with the options of all commands

    console.say(man_page())
    return CLEAN
