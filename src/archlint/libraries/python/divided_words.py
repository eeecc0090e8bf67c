"""How argparse divides up words that are known."""

from __future__ import annotations

import argparse
from typing import Any

from archlint.interpreter.values import (
    External,
    Known,
    Value,
)
from archlint.records import dataclass

_MARK = "\0"
"""Starts what stands for a word that is not known: no command line can hold it."""


@dataclass(frozen=True)
class Option:
    """One ``add_argument(…)`` call."""

    flags: tuple[str, ...]
    keywords: dict[str, Value]


class NotDivided(Exception):
    """A command line, or a parser, with more in it than is followed."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> Any:
        raise NotDivided(message)


def divide(options: dict[str, Option], words: list[Value], some: bool) -> tuple[dict[str, Any], list[str]]:
    parser = _Parser(add_help=False, argument_default=argparse.SUPPRESS)
    optional: set[str] = set()
    for name, option in options.items():
        parser.add_argument(*option.flags, **_plain_keywords(option, name))
        if not option.flags[0].startswith("-") and "nargs" in option.keywords:
            optional.add(name)
    texts = [f"{_MARK}{n}" if word.text is None else word.text for n, word in enumerate(words)]
    namespace, left = parser.parse_known_args(texts)
    if left and not some:
        raise NotDivided
    # What is not known may be an option: it must be where only a value can be.
    loose = [*left, *(text for name in optional for text in _texts(vars(namespace).get(name)))]
    if any(text.startswith(_MARK) for text in loose):
        raise NotDivided
    return vars(namespace), left


def _texts(value: object) -> list[str]:
    return [value] if isinstance(value, str) else [str(item) for item in value] if isinstance(value, list) else []


_ACTIONS = frozenset({"store", "store_true", "store_false", "store_const", "append", "count", "extend"})


def _plain_keywords(option: Option, name: str) -> dict[str, Any]:
    """The keywords of ``add_argument`` that divide words up, without anything of the program in them."""
    given: dict[str, Any] = {"dest": name} if option.flags[0].startswith("-") else {}
    action = option.keywords.get("action", Known("store"))
    if action == External("argparse.BooleanOptionalAction"):
        return {**given, "action": argparse.BooleanOptionalAction}
    if not isinstance(action, Known) or action.value not in _ACTIONS:
        raise NotDivided
    given["action"] = action.value
    if "nargs" in option.keywords:
        given["nargs"] = _count(option.keywords["nargs"])
    if action.value == "store_const" or ("const" in option.keywords and given.get("nargs") == "?"):
        given["const"] = CONST
    return given


CONST = "\0const"


def _count(value: Value) -> Any:
    if value == External("argparse.REMAINDER"):
        return argparse.REMAINDER
    if not isinstance(value, Known) or not (value.value in ("?", "*", "+") or isinstance(value.value, int)):
        raise NotDivided
    return value.value


def word_of(text: str, words: list[Value]) -> Value:
    """The word that argparse gave back as a text."""
    return words[int(text[len(_MARK) :])] if text.startswith(_MARK) else Known(text)
