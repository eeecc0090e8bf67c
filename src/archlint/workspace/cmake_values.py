"""What CMake's commands make of lists, paths and ranges; None for what is not known."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence
from typing import Final, Literal

_DIGITS = 18
"""Of a number that is read; Python refuses to read those of thousands."""

ListMode = Literal["append", "prepend", "remove items", "keep all"]
_LIST_MODES: Final[dict[str, ListMode]] = {
    "APPEND": "append",
    "PREPEND": "prepend",
    "REMOVE_ITEM": "remove items",
    **dict.fromkeys(("REMOVE_DUPLICATES", "SORT", "REVERSE", "FILTER"), "keep all"),
}


def list_mode(word: str) -> ListMode | None:
    """What ``list(word …)`` does to the list; None where it changes none."""
    return _LIST_MODES.get(word.upper())


def changed_list(mode: ListMode, old: list[str] | None, texts: Sequence[str]) -> list[str] | None:
    """The new value of a list; one that is filtered keeps all."""
    new = list(texts)
    if old is None or any("$" in text for text in new):
        return None
    match mode:
        case "append":
            return [*old, *new]
        case "prepend":
            return [*new, *old]
        case "remove items":
            return [text for text in old if text not in new]
    return old


def path_component(path: str, word: str) -> list[str] | None:
    """``get_filename_component(… path word)``: the part of a path that a word asks for."""
    if "$" in path:
        return None
    folder, name = posixpath.split(path)
    stem, dot, _ = name.partition(".")
    last, _, suffix = name.rpartition(".")
    match word:
        case "NAME":
            return [name]
        case "NAME_WE":
            return [stem or name]
        case "NAME_WLE":
            return [last or name]
        case "EXT":
            return [dot + name[len(stem) + 1 :] if dot else ""]
        case "LAST_EXT":
            return [f".{suffix}" if last else ""]
        case "DIRECTORY" | "PATH":
            return [folder]
    return None


def parsed_arguments(texts: Sequence[str], argv: Sequence[str] | None) -> dict[str, list[str]] | None:
    """``cmake_parse_arguments(prefix options one multi args…)``: the variables that it sets.  Its other form,
    ``PARSE_ARGV first prefix …``, reads the arguments of the function around it."""
    form, words = list(texts), None
    if form[:1] == ["PARSE_ARGV"]:
        if argv is None or len(form) != 6 or not form[1].isdecimal() or len(form[1]) > _DIGITS:
            return None
        words, form = list(argv[int(form[1]) :]), form[2:]
    if len(form) < 4 or any("$" in text for text in form[:4]):
        return None
    prefix, *keywords = form[:4]
    options, single, several = (text.split(";") if text else [] for text in keywords)
    values: dict[str, list[str]] = {word: ["FALSE"] for word in options} | {word: [] for word in (*single, *several)}
    rest, to = list[str](), None
    for word in form[4:] if words is None else words:
        if word in values:
            values[word] = ["TRUE"] if word in options else []
            to = None if word in options else word
        elif to is None:
            rest.append(word)
        else:
            values[to].append(word)
            to = to if to in several else None
    return {f"{prefix}_{word}": value for word, value in values.items()} | {f"{prefix}_UNPARSED_ARGUMENTS": rest}


def numbers(texts: Sequence[str], most: int) -> list[str] | None:
    """``foreach(… RANGE texts)``: the numbers from start to stop, ``most`` of them at the most."""
    if not 1 <= len(texts) <= 3 or not all(text.isdecimal() and len(text) <= _DIGITS for text in texts):
        return None
    bounds = [int(text) for text in texts]
    start, stop, step = (0, *bounds, 1)[-3:] if len(bounds) == 1 else (*bounds, 1)[:3]
    return [str(number) for number in range(start, stop + 1, max(step, 1))[:most]]
