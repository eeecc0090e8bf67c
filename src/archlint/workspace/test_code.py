"""Which files are test code, by the names of their folders and their own."""

from __future__ import annotations

_below = ""
"""Where the workspace lies, as the files' paths begin: a folder called ``tests`` above it makes nothing a test."""


def look_below(root: str) -> None:
    """Judge folders below ``root`` only: the workspace, as its files' paths begin, or empty."""
    global _below
    _below = root.rstrip("/") + "/" if root and root != "." else ""


def is_test_file(path: str) -> bool:
    """Whether a file is test code: in a folder ``test`` or ``tests`` of the workspace, or named like a test."""
    parts = path.removeprefix(_below).split("/")
    stem = parts[-1].removesuffix(".py")
    return (
        any(part in ("test", "tests") for part in parts[:-1])
        or stem.startswith("test_")
        or stem.endswith("_test")
        or stem == "conftest"
    )
