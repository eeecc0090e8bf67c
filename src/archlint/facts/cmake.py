"""CMakeLists.txt as a list of commands: what a package installs stands there.

Nothing is configured: variables are replaced where ``set`` and ``project`` make them plain texts, and
conditions are not evaluated.
"""

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
_VARIABLE = re.compile(r"\$\{([\w.+/-]+)\}")
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
    """The commands of a CMake file, with the variables replaced that the file itself sets to plain texts."""
    variables: dict[str, list[str]] = {}
    found = []
    for command in _commands(text[:LIMIT]):
        expanded = Command(command.name, tuple(_expand(command, variables)), command.line, command.column)
        _remember(expanded, variables)
        found.append(expanded)
    return found


def _commands(text: str) -> list[Command]:
    found: list[Command] = []
    name: str | None = None
    start = (1, 1)
    arguments: list[Argument] = []
    depth = 0
    line, line_start, at = 1, 0, 0
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
                found.append(Command(name, tuple(arguments), *start))
                name, arguments = None, []
        elif match["comment"] or match["bracket_comment"]:
            continue
        elif depth == 0:
            name, start, arguments = value.lower(), (line, column), []
        elif kind is not None:
            quoted = match["quoted"] is not None
            arguments.append(Argument(value[1:-1] if quoted else value, line, column, quoted))
    return found


def _expand(command: Command, variables: dict[str, list[str]]) -> list[Argument]:
    found: list[Argument] = []
    for argument in command.arguments:
        whole = _VARIABLE.fullmatch(argument.text)
        if whole is not None and not argument.quoted and whole[1] in variables:
            values = variables[whole[1]]
            found.extend(Argument(value, argument.line, argument.column) for value in values)
            continue
        text = _VARIABLE.sub(lambda m: ";".join(variables.get(m[1], [m[0]])), argument.text)
        parts = [text] if argument.quoted else [part for part in text.split(";") if part]
        found.extend(Argument(part, argument.line, argument.column, argument.quoted) for part in parts)
    return found[:10_000]


def _remember(command: Command, variables: dict[str, list[str]]) -> None:
    texts = command.texts
    if command.name == "project" and texts:
        variables["PROJECT_NAME"] = [texts[0]]
        variables["CMAKE_PROJECT_NAME"] = [texts[0]]
    elif command.name == "set" and texts:
        values = texts[1:]
        for keyword in ("CACHE", "PARENT_SCOPE"):
            if keyword in values:
                values = values[: values.index(keyword)]
        if any("${" in value for value in values) or sum(map(len, values)) > 20_000:
            variables.pop(texts[0], None)
        else:
            variables[texts[0]] = values
    elif command.name == "list" and len(texts) > 2 and texts[0].upper() == "APPEND":
        known = variables.get(texts[1], [])
        if len(known) + len(texts) < 2_000:
            variables[texts[1]] = [*known, *texts[2:]]
    elif command.name == "file" and len(texts) > 2 and texts[0].upper() in ("GLOB", "GLOB_RECURSE"):
        options = {"CONFIGURE_DEPENDS", "RELATIVE", "LIST_DIRECTORIES", "true", "false"}
        variables[texts[1]] = [text for text in texts[2:] if text not in options]
