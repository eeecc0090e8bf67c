"""``archlint server``: the language server."""

from __future__ import annotations

import argparse
import importlib.util

from archlint.cli.exits import CLEAN, UsageError
from archlint.cli.parser import Parser

_EPILOG = """\
Editors start it themselves and talk with it over its standard input and output.
It needs archlint[lsp].
"""


def parser() -> Parser:
    parser = Parser("server", "Serve an editor: findings while you type, and their fixes.")
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = _EPILOG
    parser.add_argument("--stdio", action="store_true", help="talk over standard input and output, as it always does")
    return parser


def run(arguments: argparse.Namespace) -> int:
    if importlib.util.find_spec("pygls") is None or importlib.util.find_spec("lsprotocol") is None:
        raise UsageError('the server needs what is not installed: pip install "archlint[lsp]"')
    from archlint.server.language_server import DamagedFrame, serve  # with all that analyses

    try:
        serve()
    except DamagedFrame as error:
        raise UsageError(f"standard input is no language client: {error}") from None
    return CLEAN
