"""The texts of files that code of a launch file opens.  A text is never spread out as a value: the open file stands for
it, until something is read in it, or written of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from archlint.interpreter.values import External, Instance, Known, Unknown, Value, constants_of, reason
from archlint.launch.kinds import FileKind
from archlint.launch.objects import argument, known_text

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.launch.run import LaunchRun

    Method = Callable[[LaunchRun, Value, CallSite], Value]

FILE = "io.TextIOWrapper"
"""The class of an open file that is read."""
LONGEST = 1_000_000
"""How long a text may become."""
_CHANGES = ("replace", "strip", "lstrip", "rstrip", "removeprefix", "removesuffix", "lower", "upper")
"""The methods that make another text of one."""


def opened(run: LaunchRun, path: Known) -> Instance:
    """A file that is open for reading."""
    return Instance(External(FILE), run.store.new_key(), None, {"path": path})


def text_in(run: LaunchRun, value: Value) -> str | Unknown:
    """A text, be it that of a file."""
    path, text = argument(value, "path"), known_text(argument(value, "text") or value)
    if path is not None:
        return text_of(run, path)
    return Unknown(reason(value)) if text is None else text


def text_of(run: LaunchRun, path: Value) -> str | Unknown:
    """The text of the file at a path."""
    text = run.paths.text(run.resolve(FileKind.PARAMETERS, path, run.place_now))
    return Unknown("the content of a file that is not in this workspace") if text is None else text


def _read(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
    """``file.read()``."""
    return Unknown("a part of a file") if site.values else receiver


def _changed(name: str) -> Method:
    """``file.read().replace('<name>', name)``: another text."""

    def change(run: LaunchRun, receiver: Value, site: CallSite) -> Value:
        text, given = text_in(run, receiver), constants_of(site.args)
        if isinstance(text, Unknown):
            return text
        if given is None or site.keywords or site.open:
            return Unknown(reason(*site.args))
        if name == "replace" and _length(text, *map(str, given[:2])) > LONGEST:
            return Unknown("a text too long to follow")
        try:
            changed = getattr(text, name)(*given)
        except (TypeError, ValueError):
            return Unknown("an operation that fails")
        return Instance(External(FILE), run.store.new_key(), None, {"text": Known(changed)})

    return change


def _length(text: str, old: str = "", new: str = "") -> int:
    return len(text) + text.count(old) * len(new)


METHODS: dict[str, Method] = {f"{FILE}.read": _read, **{f"{FILE}.{name}": _changed(name) for name in _CHANGES}}

__all__ = ["FILE", "METHODS", "opened", "text_in", "text_of"]
