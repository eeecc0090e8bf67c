"""Launch arguments that a file reads by almost the name under which it declares them.

Told by the text of the file alone: it declares an argument that nothing in it reads, and reads one of nearly the same
name that no launch file of the workspace says anything else of.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file, once
from archlint.place import Place
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PARTS = re.compile(r"[_\-.]")
_SHARED = 2
"""So many words two names share that are one name and a longer one."""
_WRITTEN_OUT = 4
"""So many letters an abbreviated word has."""


@dataclass(frozen=True)
class MisreadArgument:
    """``LaunchConfiguration('use_tim_time')`` in a file that declares ``use_sim_time`` and never reads it."""

    name: str
    declared: str
    place: Place
    declared_at: Place


def misread_arguments(workspace: WorkspaceIndex, file: str) -> Iterator[MisreadArgument]:
    """Those of one Python launch file, where it reads each of them once or more."""
    names = _names(workspace, file)
    if names is None:
        return
    read, declared, said = names
    unread = {name: span for name, span in declared.items() if name not in read and said.get(name, 0) == 1}
    for name, spans in sorted(read.items()):
        if name in declared or said.get(name, 0) != len(spans) or _is_said_elsewhere(workspace, file, name):
            continue
        meant = _meant(name, list(unread))
        if meant is not None:
            yield MisreadArgument(name, meant, Place(file, *spans[0]), Place(file, *unread[meant]))


def _meant(name: str, unread: list[str]) -> str | None:
    near = nearest(name, unread)
    if near is not None:
        return near
    words = set(_PARTS.split(name))
    longer = [other for other in unread if _is_longer(words, set(_PARTS.split(other))) or _is_shorter(name, other)]
    return longer[0] if len(longer) == 1 else None


def _is_longer(words: set[str], others: set[str]) -> bool:
    """Whether one name has all words of another, and a few of its own: ``slam_mode`` and ``slam_toolbox_mode``."""
    return len(words & others) >= _SHARED and (words < others or others < words)


def _is_shorter(first: str, second: str) -> bool:
    """Whether two names differ by how far a word is written out: ``config_dir`` and ``configuration_dir``."""
    pairs = [*zip(_PARTS.split(first), _PARTS.split(second), strict=False)]
    alike = all(a.startswith(b) or b.startswith(a) for a, b in pairs)
    same = len(_PARTS.split(first)) == len(_PARTS.split(second)) >= _SHARED
    return same and alike and min(len(part) for pair in pairs for part in pair) >= _WRITTEN_OUT


_Names = tuple[dict[str, list[facts.Span]], dict[str, facts.Span], dict[str, int]]


@kept_for_each_file
def _names(code: facts.Facts) -> _Names:
    """The arguments that a file reads, those that it declares, and how often it says each text."""
    read: dict[str, list[facts.Span]] = {}
    declared: dict[str, facts.Span] = {}
    for call in everything_in(code.body, facts.Call):
        match call.args:
            case [facts.Argument(value=facts.Literal(value=str(name)), keyword=None | "name" | "variable_name"), *_]:
                if called_name(call) == "LaunchConfiguration":
                    read.setdefault(name, []).append(call.span)
                elif called_name(call) == "DeclareLaunchArgument":
                    declared.setdefault(name, call.span)
    texts = (part.value for part in everything_in(code.body, facts.Literal) if isinstance(part.value, str))
    return read, declared, dict(Counter(texts))


def _is_said_elsewhere(workspace: WorkspaceIndex, file: str, name: str) -> bool:
    """Whether another launch file of the workspace has a word for an argument: it may pass it."""
    word = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    return any(word.search(text) for other, text in _texts_of_launch_files(workspace).items() if other != file)


@once
def _texts_of_launch_files(workspace: WorkspaceIndex) -> dict[str, str]:
    paths = {launched.file for launched in (*workspace.launched, *workspace.launched_alone.values())}
    paths |= {source for launched in workspace.launched for source in launched.sources}
    return {path: workspace.tree.text(path) or "" for path in sorted(paths)}


__all__ = ["MisreadArgument", "misread_arguments"]
