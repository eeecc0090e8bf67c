"""``archlint completion``: the script with which a shell completes commands, options, rules and launch files."""

from __future__ import annotations

import argparse

from archlint.cli import console
from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.parser import Parser

SHELLS = ("bash", "zsh", "fish")
_EPILOG = """\
Once for each user:
  bash  archlint completion bash \\
          > ~/.local/share/bash-completion/completions/archlint
  zsh   archlint completion zsh > ~/.zfunc/_archlint
        and in ~/.zshrc: fpath+=~/.zfunc; autoload -U compinit; compinit
  fish  archlint completion fish > ~/.config/fish/completions/archlint.fish
Again after an update: the script knows the rules of the archlint that wrote it.
"""


def parser() -> Parser:
    parser = Parser("completion", "Print the script that makes a shell complete commands, options and rules.")
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    parser.add_argument("shell", metavar="SHELL", nargs="?", choices=SHELLS, help=", ".join(SHELLS))
    return parser


def run(arguments: argparse.Namespace) -> int:
    if arguments.shell is None:
        raise UsageError("for which shell: bash, zsh or fish? --help says where to put the script")
    from archlint.cli.completers import script  # with shtab, and the options of all commands

    console.say(script(arguments.shell))
    return CLEAN
