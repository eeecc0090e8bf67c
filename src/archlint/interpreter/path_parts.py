"""Attributes of a pathlib.Path: the parts of a path whose text is known."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.interpreter.containers import new_list
from archlint.interpreter.values import Known, Value

if TYPE_CHECKING:
    from archlint.interpreter.machine import Machine

ATTRIBUTES = frozenset({"name", "stem", "suffix", "parents"})


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
    return _parents(machine, path)


def _parents(machine: Machine, path: Known) -> Value:
    """The folders around a path; of ``$(workspace)/…`` and the like nobody knows where they begin."""
    folders: list[str] = []
    text = str(path.value)
    while "/" in text.removeprefix("/") or (text.startswith("/") and text != "/"):
        text = text.rpartition("/")[0] or "/"
        folders.append(text)
    values = [Known(folder, path.via, kind="path") for folder in folders]
    return new_list(machine, values, "tuple", open_=not text.startswith("/"))


__all__ = ["ATTRIBUTES", "attribute"]
