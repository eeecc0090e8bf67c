"""Commands that CMake runs to ask the computer something, and that write no files."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Iterator

from archlint.workspace.cmake_run import Step

_ASK = frozenset({"arch", "cut", "date", "dpkg-architecture", "echo", "grep", "head", "hostname", "lsb_release"}) | {
    *("nproc", "pkg-config", "tail", "tr", "uname", "wc", "which", "whoami"),
}
_ASK_GIT = frozenset({"describe", "log", "rev-list", "rev-parse"})
_WRITE = frozenset({"OUTPUT_FILE", "ERROR_FILE"})


def only_asks(steps: Iterable[Step], words: Collection[str]) -> bool:
    """Whether all that some CMake files run with ``execute_process`` only asks: for the processor, say, or the commit.
    What stands in a macro or a function is no step."""
    commands = [step.command for step in steps if step.command.name == "execute_process"]
    if not commands or "macro" in words or "function" in words:
        return False
    return all(_asks(command.texts) for command in commands)


def _asks(texts: list[str]) -> bool:
    programs = [*_programs(texts)]
    return bool(programs) and _WRITE.isdisjoint(texts) and all(programs)


def _programs(texts: list[str]) -> Iterator[bool]:
    """Of each program that a command starts, whether it is known to write nothing."""
    for at, text in enumerate(texts[:-1]):
        if text == "COMMAND":
            program, first = posixpath.basename(texts[at + 1]), texts[at + 2 : at + 3]
            yield program in _ASK or (program == "git" and not _ASK_GIT.isdisjoint(first))


__all__ = ["only_asks"]
