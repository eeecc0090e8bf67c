"""How a text that the code computes came to be."""

from __future__ import annotations

from typing import Literal

OriginKind = Literal["literal", "format", "argument_default", "fallback", "node_name", "path", "other"]
"""``literal``, ``format`` (an f-string or an operation on literals), ``argument_default``, ``node_name`` (made from the
name or namespace of a node), ``fallback`` (what stands for it where something unknown does not say it), ``path`` (a
``pathlib.Path``) or ``other``."""

__all__ = ["OriginKind"]
