"""How long archlint looks at source that is made to stall whoever reads it."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping

from archlint.syntax.python.gate import inspect

TEXTS: Mapping[str, Callable[[int], str]] = {
    "brackets": lambda many: "x = " + "(" * many,
    "a sum": lambda many: "x = " + "1+" * many + "1",
    "a sum over lines": lambda many: "x = (\n" + "1 +\n" * many + "1)",
    "a sum below an error": lambda many: "def f(:\n    pass\nx = " + "1+" * many + "1",
    "attributes": lambda many: "x" + ".b" * many,
    "calls": lambda many: "x" + "()" * many,
    "`not`": lambda many: "x = " + "not " * many + "x",
    "signs": lambda many: "x = " + "-" * many + "1",
    "powers": lambda many: "x = " + "2**" * many + "2",
    "`lambda`": lambda many: "x = " + "lambda: " * many + "1",
    "conditions": lambda many: "x = " + "1 if 1 else " * many + "1",
    "`elif`": lambda many: "if x: pass\n" + "elif x: pass\n" * many,
    "texts side by side": lambda many: "x = (" + "'a'\n" * many + ")",
    "quotes": lambda many: "'" * many,
    "long quotes": lambda many: "'''" * many,
    "quotes and backslashes": lambda many: "'\\\n" * many,
    "escaped quotes": lambda many: "x = '" + "\\'" * many,
    "numbers": lambda many: "x = [" + "1.0, " * many + "]",
}


def stalling(many: int) -> Iterator[tuple[str, float, float]]:
    """Of each text with so many parts: what it is, seconds of CPU until it is accepted or refused, and how much of that
    one with half of the parts takes."""
    for name, text in TEXTS.items():
        half, whole = _seconds(text(many // 2)), _seconds(text(many))
        yield name, whole, half / whole


def _seconds(text: str) -> float:
    started = time.process_time()
    inspect(text)
    return time.process_time() - started
