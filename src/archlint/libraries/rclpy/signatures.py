"""What methods of rclpy's ``Node`` take, as far as all distributions agree."""

from __future__ import annotations

from collections.abc import Collection

from archlint.libraries import tables
from archlint.libraries.api_signatures import refusing_distros, signatures_of
from archlint.libraries.rclpy import names


def refuses(method: str, given: int, keywords: Collection[str]) -> bool:
    """Whether all distributions refuse a method of a node so many arguments by position and these by keyword."""
    path, row = f"{names.NODE}.{method}", tables.NODE_ROWS.get(method)
    refusing = refusing_distros(path, given, tuple(sorted(keywords)), True, () if row is None else row.params)
    return bool(refusing) and len(refusing) == len(signatures_of(path))
