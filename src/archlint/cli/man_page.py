"""The manual page, made of the same words as the help of each command.

It has no date: the same archlint prints the same page.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterable, Iterator
from textwrap import wrap

from archlint import __version__
from archlint.cli.all_options import commands_of, whole_parser
from archlint.cli.overview import DESCRIPTION, EXIT_STATUSES, OPTIONS
from archlint.project import issue_tracker

_FILES = {
    "archlint.toml, pyproject.toml": "the configuration: the nearest one upwards counts; `archlint config` prints it",
    ".archlint_cache": "results of earlier runs; it may be deleted",
    "~/.config/archlint": "the key that signs the cache, or below $XDG_CONFIG_HOME",
}
_ENVIRONMENT = {
    "ROS_DISTRO": "the distribution to judge for, where the configuration names none",
    "NO_COLOR, FORCE_COLOR, CLICOLOR, CLICOLOR_FORCE": "whether there are colours, where --color does not say",
    "COLUMNS": "the width of the terminal",
    "CI": "where it is set, no progress is shown",
}
_LINE = 78
_BOLD = re.compile(r"`([^`]+)`")


def man_page() -> str:
    """The page in the macros of man(7)."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield f'.TH ARCHLINT 1 "" "archlint {__version__}" "User Commands"'
    yield ".SH NAME"
    yield r"archlint \- architecture linter and graph analyzer for ROS 2"
    yield from (".SH SYNOPSIS", r".B archlint", r"[\fICOMMAND\fR] [\fIOPTIONS\fR] [\fIPATH\fR ...]")
    yield from (".SH DESCRIPTION", _paragraph(DESCRIPTION))
    yield from (".PP", _paragraph("`archlint PATH` and `archlint` alone mean `archlint check`."))
    yield ".SH OPTIONS"
    yield from _definitions(OPTIONS)
    yield ".SH COMMANDS"
    for name, command in commands_of(whole_parser()).items():
        yield from _command(name, command)
    yield ".SH EXIT STATUS"
    yield from _definitions({str(status): words for status, words in EXIT_STATUSES.items()})
    yield ".SH ENVIRONMENT"
    yield from _definitions(_ENVIRONMENT)
    yield ".SH FILES"
    yield from _definitions(_FILES)
    yield from (".SH BUGS", _paragraph(f"False findings, missing ones and crashes: {issue_tracker()}"))


def _command(name: str, command: argparse.ArgumentParser) -> Iterator[str]:
    positional = [action for action in command._actions if not action.option_strings]
    yield f".SS archlint {_text(' '.join([name, *(_value(action) for action in positional)]))}"
    yield _paragraph(command.description or "")
    for group in command._action_groups:
        options = {_option(action): _help(action) for action in group._group_actions if _help(action)}
        if options and group.title not in ("positional arguments", "options"):
            yield from (".PP", f".I {_text(str(group.title).capitalize())}")
            yield from [_paragraph(group.description)] if group.description else []
        yield from _definitions(options)
    if command.epilog:
        yield from (".PP", ".nf", *map(_text, command.epilog.strip().splitlines()), ".fi")


def _definitions(rows: dict[str, str]) -> Iterator[str]:
    for term, words in rows.items():
        yield from (".TP", rf"\fB{_text(term)}\fR", _paragraph(words))


def _option(action: argparse.Action) -> str:
    value = "" if action.nargs == 0 else f" {_value(action)}"
    return ", ".join(f"{name}{value}" for name in action.option_strings) or _value(action)


def _value(action: argparse.Action) -> str:
    """What stands for the values of an option or an argument."""
    metavar: str | tuple[str, ...] = action.metavar or action.dest.upper()
    names: Iterable[str] = [metavar] if isinstance(metavar, str) else metavar
    first, *others = names
    repeated = [f"[{' '.join(others) or first} ...]"] if action.nargs in ("+", "*") else []
    if action.nargs in ("*", "?"):
        return f"[{first}{' ...' if action.nargs == '*' else ''}]"
    return " ".join([first, *repeated])


def _help(action: argparse.Action) -> str:
    return "" if action.help in (None, argparse.SUPPRESS) else str(action.help) % vars(action)


def _paragraph(words: str) -> str:
    """Words in lines of a length that is usual in a page."""
    lines = wrap(_text(words), _LINE, break_long_words=False, break_on_hyphens=False)
    return "\n".join(rf"\&{line}" if line.startswith(".") else line for line in lines)


def _text(words: str) -> str:
    """Words as roff prints them: hyphens that can be copied, quotes that begin no command."""
    safe = words.replace("\\", r"\e").replace("-", r"\-").replace("'", r"\(aq")
    return _BOLD.sub(r"\\fB\1\\fR", safe)


__all__ = ["man_page"]
