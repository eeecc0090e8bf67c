"""What is advised for connections, for a terminal, as data and for a page."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Final, Literal, get_args

from archlint.render.advice import json, markdown, text

if TYPE_CHECKING:
    from archlint.advice.model import Advice

FormatName = Literal["text", "json", "markdown"]
FORMAT_NAMES: Final[tuple[FormatName, ...]] = get_args(FormatName)
FORMATS: Final[Mapping[FormatName, Callable[[Sequence[Advice], bool], str]]] = {
    "text": lambda rows, color: text.render(rows, color=color),
    "json": lambda rows, color: json.render(rows),
    "markdown": lambda rows, color: markdown.render(rows),
}
"""By their names; the second argument is whether colours are wanted."""

__all__ = ["FORMATS", "FORMAT_NAMES", "FormatName"]
