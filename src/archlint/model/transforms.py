"""Transforms, as calls send them and look them up."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.model.given import Given


@dataclass(frozen=True)
class FramePair:
    """Two coordinate frames: ``parent`` and ``child`` of a transform that is sent, target and source of one that is
    looked up.  Not ``certain`` where it is one of several pairs, and the source does not decide which."""

    parent: Given
    child: Given
    certain: bool = True


__all__ = ["FramePair"]
