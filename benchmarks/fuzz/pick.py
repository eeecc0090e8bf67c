"""What the grammars choose with, and the odd texts that they have in common."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, TypeVar

from hypothesis import strategies as st

T = TypeVar("T")

ODD_NAMES = (
    *(
        "",
        "/",
        "~",
        "//",
        "/a//b",
        "a/",
        "~/x",
        "~x",
        "/~",
        "{node}/x",
        "{ns}",
        "{",
        "{x}{y}",
        "1st",
        "a-b",
        "a b",
        "class",
    ),
    *(
        "ünï",
        "名前",
        "x\u202ey",
        "\u200b",
        "a\tb",
        "a\\nb",
        "'",
        '"',
        "\\",
        "`",
        "<a>",
        "&amp;",
        "]]>",
        "-->",
        "--",
        "#",
        "%s",
    ),
    *(
        "$(var a)",
        "$(find-pkg-share x)",
        "$(",
        "$(var",
        "${{",
        "{{",
        "}}",
        "/**",
        "**",
        "*",
        "/*/x",
        "../..",
        "/dev/zero",
    ),
    *(
        "__x__",
        "a" * 300,
        "/a" * 130,
        "rosout",
        "/clock",
        "parameter_events",
        "0",
        "-1",
        "true",
        "null",
        "NaN",
        "1e999",
    ),
)
"""Names as people write them by mistake, and texts that mean something to one reader or another."""
NAMES = ("scan", "/cmd_vel", "cmd_vel", "~/state", "odom", "/robot1/scan", "battery", "set_mode", "dock", "scann")
NUMBERS = (
    *(
        "0",
        "1",
        "-1",
        "2",
        "10",
        "0.5",
        "1e-9",
        "1e309",
        "-0.0",
        "2**63",
        "10**30",
        "0x10",
        "1_000",
        "True",
        "None",
        "9" * 400,
    ),
    *("float('nan')", "float('inf')", "1j", "7 // 2", "1 << 70", "b'x'", "..."),
)
"""Numbers in Python, and what stands where one should."""


class Pick:
    """Choices of one example."""

    def __init__(self, draw: Callable[[st.SearchStrategy[Any]], Any]) -> None:
        self._draw = draw

    def one(self, *options: T) -> T:
        """One of some options, the first in the simplest example."""
        return self.among(options)

    def among(self, options: Sequence[T]) -> T:
        return options[self.number(0, len(options) - 1)]

    def number(self, low: int, high: int) -> int:
        return int(self._draw(_numbers(low, high))) if low < high else low

    def rarely(self, one_in: int = 8) -> bool:
        """True in about one of so many cases, and in none of the simplest example."""
        return self.number(0, one_in - 1) == one_in - 1

    def some(self, make: Callable[[], T], most: int, least: int = 0) -> list[T]:
        return [make() for _ in range(self.number(least, most))]

    def name(self) -> str:
        """A name of a topic, node, package …, now and then an odd one."""
        return self.among(ODD_NAMES) if self.rarely() else self.among(NAMES)

    def word(self) -> str:
        """An identifier."""
        return self.one(
            "robot", "arm", "driver", "state", "value", "goal", "x", "ünï", "_hidden", "__mangled", "self", "len"
        )


@cache
def _numbers(low: int, high: int) -> st.SearchStrategy[int]:
    return st.integers(low, high)


def strategy(make: Callable[[Pick], T]) -> st.SearchStrategy[T]:
    """The strategy of what a function makes of choices."""

    @st.composite
    def made(draw: st.DrawFn) -> T:
        return make(Pick(draw))

    return made()
