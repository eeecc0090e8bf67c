"""Launch files that are there to be copied."""

from __future__ import annotations

import posixpath
import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.systems.model import System

_SHOWN = frozenset(
    {"example", "examples", "sample", "template"}
    | {"beispiel", "ejemplo", "ejemplos", "esempio", "exemple", "exemplo", "plantilla"}
)


def is_shown_only(system: System) -> bool:
    """Whether the launch file of a system is an example or a template by its name, and no other one includes it."""
    if system.launched is None or system.is_included:
        return False
    words = re.split(r"[\W_]+", posixpath.basename(system.launched.file).lower())
    return not _SHOWN.isdisjoint(words)


__all__ = ["is_shown_only"]
