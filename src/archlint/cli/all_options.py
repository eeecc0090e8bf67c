"""One parser with all commands, for what describes them as a whole: completion, the man page."""

from __future__ import annotations

import argparse
from importlib import import_module

from archlint.cli import COMMANDS
from archlint.cli.overview import DESCRIPTION


def whole_parser() -> argparse.ArgumentParser:
    """``archlint`` with its commands as sub-parsers.  It only describes: :func:`archlint.cli.main` parses."""
    parser = argparse.ArgumentParser("archlint", description=DESCRIPTION)
    parser.add_argument("-V", "--version", action="store_true", help="print the version")
    commands = parser.add_subparsers(metavar="COMMAND", dest="command")
    for name in COMMANDS:
        own = import_module(f"archlint.cli.{name}").parser()
        commands.add_parser(
            name, parents=[own], add_help=False, help=own.description, description=own.description, epilog=own.epilog
        )
    return parser


def commands_of(parser: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    """The commands of :func:`whole_parser` by their names."""
    actions = [action for action in parser._actions if action.dest == "command"]
    choices = actions[0].choices
    assert isinstance(choices, dict)
    return choices


__all__ = ["commands_of", "whole_parser"]
