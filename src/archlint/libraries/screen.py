"""The words of which a Python file has at least one, or is not looked at unless another file leads to it.

A file without any of them can neither create nor wait for anything.  ``rclpy`` alone would lose mixins and helpers that
never import it.  ``create_node`` is missing: where that is rclpy's, the file names rclpy, or imports a file of the
workspace that does, and is read for that.
"""

from __future__ import annotations

from archlint.libraries import tables

_FURTHER = (
    "rclpy",
    "ActionServer",
    "ActionClient",
    "declare_parameter",
    "get_parameter",
    "message_filters",
    "tf2_ros",
    "wait_for_service",
    "call_async",
    "archlint:",
)

WORDS = tuple(word.encode() for word in (*_FURTHER, *(name for name, row in tables.NODE_ROWS.items() if row.creates)))
"""As they are written in the bytes of a file: what creates on a node comes from the API tables."""
