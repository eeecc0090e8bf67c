"""CMakeLists.txt as a list of commands, as they are written: no variable is replaced."""

from __future__ import annotations

import re
from dataclasses import dataclass

_TOKEN = re.compile(
    r"""
    (?P<bracket_comment>\#\[(?P<eq1>=*)\[.*?\](?P=eq1)\])
  | (?P<comment>\#[^\n]*)
  | (?P<bracket>\[(?P<eq2>=*)\[.*?\](?P=eq2)\])
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
    for match in _TOKEN.finditer(text):
        line += text.count("\n", at, match.start())
        newline = text.rfind("\n", at, match.start())
        line_start = newline + 1 if newline >= 0 else line_start
        at = match.start()
        column = match.start() - line_start + 1
        kind, value = match.lastgroup, match.group()
        if match["open"]:
            depth += 1
        elif match["close"]:
            depth = max(0, depth - 1)
            if depth == 0 and name is not None:
                commands.append(Command(name, tuple(arguments), *start))
                name, arguments = None, []
        elif match["comment"] or match["bracket_comment"]:
            continue
        elif depth == 0:
            name, start, arguments = value.lower(), (line, column), []
        elif kind is not None:
            quoted = match["quoted"] is not None
            arguments.append(Argument(value[1:-1] if quoted else value, line, column, quoted))
    return commands
