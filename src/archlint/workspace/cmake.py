"""CMakeLists.txt as a list of commands, as they are written: no variable is replaced."""

from __future__ import annotations

import re
from collections.abc import Iterator

from archlint.records import dataclass

_TOKEN = re.compile(
    r"""
    (?P<bracket>\#?\[(?P<equals>=*)\[)
  | (?P<comment>\#[^\n]*)
  | (?P<quoted>"(?:[^"\\]|\\.)*")
  | (?P<open>\()
  | (?P<close>\))
  | (?P<word>(?:[^\s()"\#\\]|\\.)+)
    """,
    re.VERBOSE | re.DOTALL,
)
LIMIT = 2_000_000


@dataclass(frozen=True)
class Argument:
    text: str
    line: int
    column: int
    quoted: bool = False

    @property
    def open(self) -> bool:
        """True where a variable or generator expression is left in it."""
        return "${" in self.text or "$<" in self.text or "$ENV{" in self.text


@dataclass(frozen=True)
class Command:
    """``name(arguments…)``; ``name`` is lower case, lines and columns start at 1."""

    name: str
    arguments: tuple[Argument, ...]
    line: int
    column: int

    @property
    def texts(self) -> list[str]:
        return [argument.text for argument in self.arguments]


def parse_cmake(text: str) -> list[Command]:
    """The commands of a CMake file, one after the other, blocks and what is in them included."""
    commands: list[Command] = []
    name: str | None = None
    start = (1, 1)
    arguments: list[Argument] = []
    depth = 0
    line, line_start, at = 1, 0, 0
    text = text[:LIMIT]
    for kind, position, value in tokens_of(text):
        line += text.count("\n", at, position)
        newline = text.rfind("\n", at, position)
        line_start = newline + 1 if newline >= 0 else line_start
        at = position
        column = position - line_start + 1
        if kind == "open":
            depth += 1
        elif kind == "close":
            depth = max(0, depth - 1)
            if depth == 0 and name is not None:
                commands.append(Command(name, tuple(arguments), *start))
                name, arguments = None, []
        elif depth == 0:
            name, start, arguments = value.lower(), (line, column), []
        else:
            quoted = kind == "quoted"
            arguments.append(Argument(value[1:-1] if quoted else value, line, column, quoted))
    return commands


def tokens_of(text: str) -> Iterator[tuple[str, int, str]]:
    """Kind, position and text of each token; comments are left out."""
    at = 0
    closed = True  # a bracket that nothing closes is looked for once, not again at each that follows
    while match := _TOKEN.search(text, at):
        kind, start, at = match.lastgroup or "", match.start(), match.end()
        if kind == "bracket":
            end = f"]{match['equals']}]"
            close = text.find(end, at) if closed else -1
            closed = close >= 0
            if closed:
                at = close + len(end)
            elif text[start] == "#":
                at = _line_end(text, start)
        if text[start] != "#":
            yield kind, start, text[start:at]


def _line_end(text: str, start: int) -> int:
    end = text.find("\n", start)
    return len(text) if end < 0 else end
