"""What a run writes down: one JSON line per entity, node or refusal, with the user's line."""

from __future__ import annotations

import ast
import json
import sys
import types
from array import array
from collections import Counter
from functools import cache, partial
from pathlib import Path
from typing import Any, TextIO

from .later import nobody
from .unknown import is_uncertain, pattern

_MOST_AT_ONE_PLACE = 500  # more come from a loop without end
KINDS = ("publisher", "subscriber", "service", "client", "action_server", "action_client", "timer")


class Recorder:
    """Collects what the nodes of one run create. `phase` tells how the code came to run."""

    def __init__(self) -> None:
        self.root = ""
        self.phase = "main"
        self._out: TextIO | None = None
        self._at: Counter[tuple[str, int]] = Counter()
        self.nodes: list[Any] = []
        self.tasks: list[Any] = []  # (callable, arguments) that a running system would execute later

    def open(self, root: str, out: TextIO) -> None:
        """Start: user code is what lies under `root`; lines go to `out`."""
        self.root = root.rstrip("/") + "/"
        self._out = out

    def write(self, what: str, **fields: Any) -> None:
        """Write one line; nothing is kept back, so a run that is cut off keeps what it saw."""
        if self._out is not None:
            self._out.write(json.dumps({"what": what, "phase": self.phase, **fields}) + "\n")
            self._out.flush()

    def entity(
        self,
        kind: str,
        node: Any,
        *,
        written: object = None,
        name: str | None = None,
        type_: str | None = None,
        qos: dict[str, object] | None = None,
        callback: object = None,
        period: float | None = None,
    ) -> None:
        """Note one communication entity at the user's line that is creating it now."""
        site = self.site()
        if site is None:
            return
        self._at[site["file"], site["line"]] += 1
        if self._at[site["file"], site["line"]] > _MOST_AT_ONE_PLACE:
            raise KeyboardInterrupt(f"endpoints without end at {site['file']}:{site['line']}")
        self.write(
            "entity",
            kind=kind,
            **site,
            written=text(written),
            **known(name),
            type=type_,
            qos=qos,
            node=pattern(node.get_fully_qualified_name()),
            **{"class": type(node).__qualname__},
            callback=callable_name(callback),
            period_s=period,
        )

    def parameter(self, node: Any, name: str, type_: str, value: object) -> None:
        """Note one declared parameter with the value that it has from then on: None where none is known."""
        if site := self.site():
            self.write(
                "parameter",
                **site,
                **known(name),
                type=type_.lower(),
                value=plain(value),
                node=pattern(node.get_fully_qualified_name()),
                **{"class": type(node).__qualname__},
            )

    def refusal(self, kind: str, written: object, reason: str) -> None:
        """Note a create call that rcl would have refused."""
        if site := self.site():
            self.write("refused", kind=kind, **site, written=text(written), reason=reason)

    def node(self, node: Any, *, lifecycle: bool) -> None:
        """Note that a node came to be, and the classes it is made of."""
        self.nodes.append(node)
        classes = [_class_place(cls, self.root) for cls in type(node).__mro__]
        site = self.site() or {}
        self.write(
            "node",
            **site,
            node=pattern(node.get_fully_qualified_name()),
            lifecycle=lifecycle,
            **{"class": type(node).__qualname__},
            classes=[place for place in classes if place],
        )

    def site(self) -> dict[str, Any] | None:
        """Where the user's code is: the innermost frame in the repository, and the frames that led to it."""
        frame: types.FrameType | None = sys._getframe(1)
        found: list[tuple[str, int, int, int]] = []
        while frame is not None:
            filename = frame.f_code.co_filename
            if filename.startswith(self.root):
                found.append((filename[len(self.root) :], *_call_span(frame)))
            frame = frame.f_back
        if not found:
            return None
        file, line, column, end_line = found[0]
        return {
            "file": file,
            "line": line,
            "column": column,
            "end_line": end_line,
            "via": [f"{place[0]}:{place[1]}" for place in found[1:6]],
        }


recorder = Recorder()


def known(name: str | None) -> dict[str, str | None]:
    """A name as it is reported: null with a pattern when part of it is not known."""
    if name is None:
        return {"name": None}
    return {"name": None, "pattern": pattern(name)} if is_uncertain(name) else {"name": name}


def text(value: object) -> str | None:
    """What was written as a name, if it is text."""
    return pattern(value) if isinstance(value, str) else None


def plain(value: object) -> object:
    """A parameter's value as JSON has it: None where it is not known, or a part of it is not."""
    if isinstance(value, (list, tuple, array)):
        members = [plain(each) for each in value]
        return None if None in members else members
    if isinstance(value, (bytes, bytearray)):
        return list(value)
    if isinstance(value, str) and is_uncertain(value):
        return None
    return value if isinstance(value, (bool, int, float, str)) else None


def callable_name(value: object) -> str | None:
    """The qualified name of a callback."""
    if value is nobody:
        return None
    if isinstance(value, partial):
        return callable_name(value.func)
    return getattr(value, "__qualname__", None)


def _class_place(cls: type, root: str) -> str | None:
    module = sys.modules.get(cls.__module__)
    file = getattr(module, "__file__", None) or ""
    return f"{file[len(root) :]}:{cls.__qualname__}" if file.startswith(root) else None


def _call_span(frame: types.FrameType) -> tuple[int, int, int]:
    """(first line, first column, last line) of the call expression that a frame is executing; 1-based."""
    calls = _calls_of(frame.f_code.co_filename)
    positions = getattr(frame.f_code, "co_positions", None)
    if positions is not None:
        found = list(positions())[frame.f_lasti // 2]
        call = calls["by_end"].get((found[1], found[3]))
    else:
        call = calls["by_line"].get(frame.f_lineno)
    if call is None:
        return frame.f_lineno, 1, frame.f_lineno
    return call.lineno, call.col_offset + 1, call.end_lineno or call.lineno


@cache
def _calls_of(filename: str) -> dict[str, dict[Any, ast.Call]]:
    """The call expressions of a file by where they end, and by the line a 3.10 frame reports for them."""
    try:
        tree = ast.parse(Path(filename).read_bytes())
    except (OSError, SyntaxError, ValueError):
        return {"by_end": {}, "by_line": {}}
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    by_line: dict[Any, ast.Call] = {}
    for call in calls:  # outer calls come first in ast.walk
        by_line.setdefault(call.func.end_lineno, call)
        by_line.setdefault(call.lineno, call)
    return {"by_end": {(call.end_lineno, call.end_col_offset): call for call in calls}, "by_line": by_line}
