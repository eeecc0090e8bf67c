"""Commands that code runs: whether they are over at once, or switch the machine off."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from archlint.analysis.reach import argument
from archlint.model.given import Constant
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.analysis.source_code import SourceCode
    from archlint.model import ApiCall


_SWITCHES_OFF = frozenset({"shutdown", "poweroff", "reboot", "halt"})
_IN_FRONT = frozenset({"sudo", "systemctl"})


def ends_the_machine(code: SourceCode, call: ApiCall) -> bool:
    """Whether a command switches the machine off, or starts it anew: nothing that would have to wait goes on."""
    words = _words(code, call)
    commands = [word.rpartition("/")[2] for word in words if not word.startswith("-")]
    command = next((word for word in commands if word not in _IN_FRONT), "")
    return command in _SWITCHES_OFF and "-c" not in words  # `shutdown -c` calls it off


def is_soon_over(code: SourceCode, call: ApiCall) -> bool:
    """Whether a command only sets something, or asks the state of something, on this machine: milliseconds."""
    return all(map(_asks_for_a_moment, _commands(code, call)))


def goes_on_behind(code: SourceCode, call: ApiCall) -> bool:
    """Whether the shell starts a command and does not wait for it: ``os.system('ros2 launch … &')``."""
    written, given = next((each.value for each in code.arguments(call)[:1]), None), argument(call, "command")
    known = [] if given is None else [option.value for option in given.alternatives if isinstance(option, Constant)]
    ends = [_end_of(written)] if given is None or len(known) < len(given.alternatives) else list(map(str, known))
    return call.api == "os.system" and all(_BEHIND.search(end) is not None for end in ends)


_BEHIND = re.compile(r"(?<!&)&\s*(?:\)\s*)?(?:(?:&&|;)?\s*sleep\s+0?\.\d+\s*)?$")
"""``… &`` at the end, be it in brackets, and with less than a second in which the process comes up."""


def _end_of(command: facts.Base | None) -> str:
    """The text that a command ends in, as far as it is written out; empty where it is not."""
    match command:
        case facts.Literal(value=str(text)):
            return text
        case facts.FormatString(parts=[*_, str(text)]):
            return text
        case facts.Binary(op="+", right=right):
            return _end_of(right)
        case facts.Call(func=facts.Attribute(value=text, attr="format")):
            return _end_of(text)
    return ""


def makes_a_file(code: SourceCode, call: ApiCall) -> bool:
    """Whether a command makes a file of another one, of which what comes next depends: a second or less."""
    return all(words and words[0].rpartition("/")[2] in _MAKES for words in _commands(code, call))


_MAKES = frozenset({"xacro"})


def _asks_for_a_moment(command_line: Sequence[str]) -> bool:
    words = [word.rpartition("/")[2] for word in command_line if not word.startswith("-")]
    match words:
        case ["systemctl", "is-active" | "is-enabled" | "is-failed", *_]:
            return True
        case ["ip", *rest]:
            return _LASTING.isdisjoint(rest)
        case ["nmcli", *rest]:
            return bool({"show", "status"} & set(rest)) and _LASTING.isdisjoint(rest)
        case ["echo" | "printf" | "touch", *rest]:
            return not any(sign in word for word in rest for sign in _GOES_ON)
        case [command, *_]:
            return command in _SHORT
    return False


_SHORT = frozenset(
    {
        "amixer",
        "i2cdetect",
        "i2cget",
        "i2cset",
        "lsblk",
        "lspci",
        "lsusb",
        "pactl",
        "wpctl",
        "hostname",
        "ifconfig",
        "iw",
        "iwconfig",
        "iwgetid",
        "uname",
        "vcgencmd",
    }
    | {"kill", "killall", "pgrep", "pidof", "pkill"}
)
"""Commands that ask the kernel or a service of this machine for something, or set it, and end."""
_UNKNOWN = "?"
_GOES_ON = (";", "|", "&", "`", "$(")
"""Signs by which a shell runs another command, too, or first."""
_LASTING = frozenset({"event", "exec", "monitor", "rescan", "scan"})
"""Words that make such a command last."""


def _words(code: SourceCode, call: ApiCall) -> list[str]:
    """The words of a command that are written out."""
    return _words_in([argument.value for argument in code.arguments(call)[:1]])


def _commands(code: SourceCode, call: ApiCall) -> list[list[str]]:
    """The words of each command that a call may start: of several that a ``for`` goes through, all of them."""
    variable = next((argument.value.variable for argument in code.arguments(call)[:1]), "")
    for loop in code.loops(call):
        if variable and isinstance(loop, facts.For) and loop.target.variable == variable:
            rows = loop.iterable.elements if isinstance(loop.iterable, facts.Sequence) else []
            return [_words_in([row]) for row in rows] or [[]]
    return [_words(code, call)]


def _words_in(values: Sequence[facts.Base]) -> list[str]:
    """A field of an f-string is a word, or a part of one, that nobody knows."""
    words: list[str] = []
    for part in everything_in(values, facts.Base):
        if isinstance(part, facts.Literal) and isinstance(part.value, str):
            words += part.value.split()
        elif isinstance(part, facts.FormatString):
            words += "".join(text if isinstance(text, str) else _UNKNOWN for text in part.parts).split()
    return words


__all__ = ["ends_the_machine", "goes_on_behind", "is_soon_over", "makes_a_file"]
