"""Which commands have an answer that is the same each time until something changes, and who keeps it."""

from __future__ import annotations

import argparse

from archlint.cli import console
from archlint.engine.keeper import Keeper


def keeper_of(arguments: argparse.Namespace, drawn: bool) -> Keeper | None:
    """Who keeps what is said, where that is all that the command does, and each time the same: what Graphviz has
    ``drawn`` depends on which one is installed."""
    does_more = ("file", "observed", "facts", "scheduler", "verbose", "no_cache")
    if drawn or any(getattr(arguments, option, None) for option in does_more):
        return None
    return Keeper(arguments.words, console.terminal(), (arguments.launch or ())[:1])


__all__ = ["keeper_of"]
