"""The argument parser of a command, which says what was probably meant."""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from typing import Any, NoReturn

from archlint.cli.console import flush, say
from archlint.cli.exits import UsageError
from archlint.cli.habits import advice_on_option
from archlint.suggestions import did_you_mean, meant

_PATHS = frozenset({"FILE", "DIR", "PATH"})
"""The metavars of what names a file or a folder."""


class _Value(str):
    """A word after ``--``: never an option."""

    __slots__ = ()


class Parser(argparse.ArgumentParser):
    """Raises :class:`UsageError` for a wrong option or value, with the one that is near."""

    def __init__(self, command: str, description: str) -> None:
        super().__init__(f"archlint {command}", description=description, allow_abbrev=False)

    def parse_words(self, words: Sequence[str]) -> argparse.Namespace:
        """Options and paths in any order, and only paths after ``--``."""
        # `parse_intermixed_args` forgets in its second round that there was a `--`.
        after = words.index("--") + 1 if "--" in words else len(words)
        return self.parse_intermixed_args([*words[:after], *map(_Value, words[after:])])

    def _parse_optional(self, arg_string: str) -> Any:
        """What is known of a word that may be an option; None for a value."""
        return None if isinstance(arg_string, _Value) else super()._parse_optional(arg_string)

    def _print_message(self, message: str, file: object = None) -> None:
        """As argparse's own, which says nothing where it cannot write."""
        say(message)
        flush()

    def error(self, message: str) -> NoReturn:
        words = message.partition("unrecognized arguments: ")[2].split()
        known = [text for action in self._actions for text in action.option_strings]
        for word in words[:1]:
            advice = advice_on_option(word)
            message += f"; {advice}" if advice else _near(word.partition("=")[0], known)
        raise UsageError(f"{message}\nTry `{self.prog} --help`.")

    def _check_value(self, action: argparse.Action, value: object) -> None:
        """As argparse's own, which lists what there is and does not say which was meant."""
        metavar = action.metavar[0] if isinstance(action.metavar, tuple) else action.metavar
        if value == "" and metavar in _PATHS:
            raise argparse.ArgumentError(action, "an empty word is no path: is a variable of the shell unset?")
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
