"""What CMake refuses to parse in a file.

Source: the grammar in cmake-language(7): a file is commands, each a name with arguments in parentheses; ``if()`` and
its like are closed in the order in which they are opened.
"""

from __future__ import annotations

import re

from archlint.records import dataclass
from archlint.workspace.cmake import LIMIT, Command, parse_cmake, tokens_of

_CLOSES = {f"end{name}": name for name in ("if", "foreach", "while", "function", "macro", "block")}
_OPENS = frozenset(_CLOSES.values())
_WITHIN_IF = frozenset({"else", "elseif"})

_QUOTE = "a quotation mark has no partner"


@dataclass(frozen=True)
class CMakeProblem:
    line: int
    message: str


def malformed_cmake(text: str) -> CMakeProblem | None:
    """The first thing that CMake stops at, if there is any."""
    if len(text) > LIMIT:
        return None
    return _of_tokens(text) or _of_blocks(parse_cmake(text))


def _of_tokens(text: str) -> CMakeProblem | None:
    depth, name, end = 0, "", 0
    opened = named = 0
    for kind, start, value in tokens_of(text):
        between = _without_comments(text[end:start])
        if '"' in between:
            return _problem(text, end + between.index('"'), _QUOTE)
        end = start + len(value)
        if depth == 0 and kind != "open" and name:
            return _problem(text, named, f"'{name}' is no command: it has no parentheses behind it")
        if kind == "open":
            if depth == 0 and not name:
                return _problem(text, start, "a '(' without a command in front of it")
            opened, name = (start if depth == 0 else opened), ""
            depth += 1
        elif kind == "close":
            depth -= 1
            if depth < 0:
                return _problem(text, start, "a ')' has no partner")
        elif depth == 0 and kind == "word":
            name, named = value, start
        elif depth == 0:
            return _problem(text, start, "a text stands outside of every command")
    rest = _without_comments(text[end:])
    if '"' in rest:
        return _problem(text, end + rest.index('"'), _QUOTE)
    if depth:
        return _problem(text, opened, "a '(' has no partner")
    return _problem(text, named, f"'{name}' is no command: it has no parentheses behind it") if name else None


def _without_comments(text: str) -> str:
    """The text with blanks for comments."""
    return re.sub(r"#[^\n]*", lambda comment: " " * len(comment[0]), text)


def _problem(text: str, at: int, message: str) -> CMakeProblem:
    return CMakeProblem(text.count("\n", 0, at) + 1, message)


def _of_blocks(commands: list[Command]) -> CMakeProblem | None:
    """The first block that is closed and not open, or never closed."""
    open_: list[Command] = []
    for command in commands:
        if command.name in _OPENS:
            open_.append(command)
        wanted = "if" if command.name in _WITHIN_IF else _CLOSES.get(command.name)
        if wanted is None:
            continue
        if not open_ or open_[-1].name != wanted:
            inside = f" inside of {open_[-1].name}()" if open_ else ""
            return CMakeProblem(command.line, f"{command.name}() without its {wanted}(){inside}")
        if command.name in _CLOSES:
            open_.pop()
    return CMakeProblem(open_[-1].line, f"{open_[-1].name}() has no end{open_[-1].name}()") if open_ else None


__all__ = ["CMakeProblem", "malformed_cmake"]
