"""The argument parser of a command, which says what was probably meant."""

from __future__ import annotations

import argparse
from collections.abc import Iterable
from typing import NoReturn

from archlint.cli.exits import UsageError
from archlint.cli.habits import advice_on_option
from archlint.suggestions import did_you_mean, meant


class Parser(argparse.ArgumentParser):
    """Raises :class:`UsageError` for a wrong option or value, with the one that is near."""

    def __init__(self, command: str, description: str) -> None:
        super().__init__(f"archlint {command}", description=description, allow_abbrev=False)

    def error(self, message: str) -> NoReturn:
        words = message.partition("unrecognized arguments: ")[2].split()
        known = [text for action in self._actions for text in action.option_strings]
        for word in words[:1]:
            advice = advice_on_option(word)
            message += f"; {advice}" if advice else _near(word.partition("=")[0], known)
        raise UsageError(f"{message}\nTry `{self.prog} --help`.")

    def _check_value(self, action: argparse.Action, value: object) -> None:
        """As argparse's own, which lists what there is and does not say which was meant."""
        if action.choices is None or value in action.choices:
            return
        choices = [str(choice) for choice in action.choices]
        near = _near(str(value), choices) or f" (choose from {', '.join(choices)})"
        raise argparse.ArgumentError(action, f"invalid choice: '{value}'{near}")


def _near(word: str, known: Iterable[str]) -> str:
    """``; did you mean …?`` for a word that is near a known one, or the beginning of one."""
    begun = [name for name in known if len(word) > len("--") and name.startswith(word)]
    return meant(begun[0]) if len(begun) == 1 else did_you_mean(word, known, quote="")


__all__ = ["Parser"]
