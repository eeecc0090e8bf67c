"""Attributes of a pathlib.Path: the parts of a path whose text is known."""

from __future__ import annotations

import posixpath
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.interpreter.containers import new_list
from archlint.interpreter.values import Known, Unknown, Value

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

ATTRIBUTES = frozenset({"name", "parent", "stem", "suffix", "parents"})


def attribute(machine: Machine, path: Known, name: str) -> Value:
    """One of :data:`ATTRIBUTES`."""
    text = str(path.value)
    last = posixpath.basename(text)
    match name:
        case "name":
            return Known(last, path.via)
        case "stem":
            return Known(posixpath.splitext(last)[0], path.via)
        case "suffix":
            return Known(posixpath.splitext(last)[1], path.via)
        case "parent":
            return folder_of(machine, path)
    return _parents(machine, path)


def folder_of(machine: Machine, path: Known) -> Value:
    """The folder that a path lies in."""
    text = str(path.value)
    around = machine.library.folder_around(text)
    if isinstance(around, Unknown):
        return around
    if around is None:
        around = text.rpartition("/")[0] or ("/" if text.startswith("/") else ".")
    return Known(around, path.via, kind="path")


def shortest(machine: Machine, path: Known) -> Value:
    """A path without ``..``, as ``os.path.normpath`` gives it."""
    text = str(path.value)
    if not text.startswith("$("):
        return Known(posixpath.normpath(text), path.via, path.origin, path.kind)
    first, *rest = text.split("/")
    shorter: Value = replace(path, value=first)
    for part in rest:
        if not isinstance(shorter, Known):
            return shorter
        if part == "..":
            shorter = folder_of(machine, shorter)
        elif part not in ("", "."):
            shorter = Known(f"{shorter.value!s}/{part}", path.via)
    return replace(shorter, origin=path.origin, kind=path.kind) if isinstance(shorter, Known) else shorter


def _parents(machine: Machine, path: Known) -> Value:
    """The folders around a path, the nearest first.  Where one is not known, nor how many there are, it stands for all
    that follow."""
    folders = [folder_of(machine, path)]
    while isinstance(last := folders[-1], Known) and last.value not in ("/", "."):
        folders.append(folder_of(machine, last))
    return new_list(machine, folders, "tuple", open_=isinstance(last, Unknown), ordered=True)


__all__ = ["ATTRIBUTES", "attribute", "folder_of", "shortest"]
