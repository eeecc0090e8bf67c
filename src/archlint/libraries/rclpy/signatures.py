"""What methods of rclpy's ``Node`` take, as far as all supported distributions agree."""

from __future__ import annotations

from collections.abc import Collection

from archlint.libraries import tables

_TAKE_NOTHING = ("get_logger", "get_clock")
"""Methods without a row that take no argument in any distribution."""


def refuses(method: str, given: int, keywords: Collection[str]) -> bool:
    """Whether Python refuses a call of a node's method with so many positional arguments and these keywords.

    Which keyword-only parameters there are differs from one distribution to the next: none is refused.
    """
    row = tables.NODE_ROWS.get(method)
    if row is None or not row.strict:
        return method in _TAKE_NOTHING and bool(given or keywords)
    taken, left = row.positional[:given], row.positional[given:]
    if given > len(row.positional) or any(name in keywords for name in taken):
        return True
    if not row.positional and keywords:
        return True
    return any(name not in row.optional and name not in keywords for name in left)
