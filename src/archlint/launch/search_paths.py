"""Search paths that a launch file gives its processes (``GAZEBO_MODEL_PATH``): folders that are joined without what
separates them, a colon from each other and a slash from what is in them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from archlint.interpreter.values import Holed, Known, ListValue, Value, alternatives
from archlint.launch.mistakes import JoinedFolder
from archlint.launch.objects import LaunchObject, known_text
from archlint.launch.tables import LaunchClass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.run import LaunchRun

_FOLDER = r"\$\(find-pkg-(?:share|prefix) ([\w.-]+)\)"
_AFTER = re.compile(rf"{_FOLDER}([A-Za-z][\w-]*)")
"""A word right behind the folder of a package."""
_BEFORE = re.compile(rf"(?:^|:)([A-Za-z_][\w-]*){_FOLDER}")
"""A word right in front of one, which begins what is searched: ``models/opt/ros/…``."""
_ABSOLUTE = re.compile(rf"{_FOLDER}|/")


def note_variable(run: LaunchRun, entity: LaunchObject) -> None:
    """Note what ``SetEnvironmentVariable`` joins."""
    name, value, place = run.text_of(entity.argument("name")), entity.argument("value"), entity.place
    if name is None or value is None or place is None or not name.endswith("PATH"):
        return
    _note_words(run, name, run.perform(value), place)
    if isinstance(value, ListValue) and run.is_closed(value):
        _note_neighbours(run, name, run.items(value), place)


def note_assigned(run: LaunchRun, name: str, value: Value, place: Place) -> None:
    """Note what ``os.environ['GAZEBO_MODEL_PATH'] = …`` joins."""
    if not name.endswith("PATH"):
        return
    _note_words(run, name, value, place)
    for option in alternatives(value):
        match option:
            case Holed(parts=(None, str(text), *_), reason=why) if why == of_environment(name):
                if _ABSOLUTE.match(text):
                    run.note_joined_folder(JoinedFolder(name, name, _shown(text), ":", place))


def of_environment(name: str) -> str:
    """Why nobody knows a variable of the environment."""
    return f"the environment variable {name}"


def _note_words(run: LaunchRun, name: str, value: Value, place: Place) -> None:
    for option in alternatives(value):
        for at, piece in enumerate(option.pieces):
            for before, after in _joined_in(piece or "", at == 0):
                run.note_joined_folder(JoinedFolder(name, before, after, "/", _joined_at(option) or place))


def _joined_at(text: Value) -> Place | None:
    """Where a text was made of others."""
    match text:
        case Known(origin=origin) | Holed(origin=origin):
            return origin
    return None


def _joined_in(text: str, is_first: bool) -> Iterator[tuple[str, str]]:
    for match in _AFTER.finditer(text):
        yield _shown(match[0].removesuffix(match[2])), match[2]
    for match in _BEFORE.finditer(text):
        if is_first or match[0].startswith(":"):
            yield match[1], _shown(match[0][match[0].index("$") :])


def _note_neighbours(run: LaunchRun, name: str, items: Sequence[Value], place: Place) -> None:
    """The variable itself, in a list of substitutions, in front of a folder or behind one."""
    for before, after in pairwise(items):
        if _is_variable(run, before, name):
            text = known_text(run.perform(after)) or ""
            if _ABSOLUTE.match(text):
                run.note_joined_folder(JoinedFolder(name, name, _shown(text), ":", place))
        elif _is_variable(run, after, name):
            text = known_text(run.perform(before)) or ""
            if text and not text.endswith((":", "/")):
                run.note_joined_folder(JoinedFolder(name, _shown(text), name, ":", place))


def _is_variable(run: LaunchRun, value: Value, name: str) -> bool:
    match value:
        case LaunchObject(kind=LaunchClass.ENVIRONMENT_VARIABLE):
            return run.text_of(value.argument("name")) == name
    return False


def _shown(text: str) -> str:
    """A path as a reader knows it."""
    return re.sub(_FOLDER, r"…/\1", text)


__all__ = ["note_assigned", "note_variable", "of_environment"]
