"""Which files are test code, by the names of their folders and their own."""

from __future__ import annotations

import re

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


_TRIES_OUT = frozenset({"test", "tests", "testing", "mock", "mocks", "mocked", "dummy", "dummies"}) | {
    *("fake", "fakes", "stub", "stubs", "fixture", "fixtures"),
}
_PUT_ASIDE = frozenset({"archive", "archived", "archives", "attic", "backups", "deprecated", "legacy", "obsolete"}) | {
    *("old", "outdated", "unused"),
}
_NAMED_OLD = re.compile(r"(?:old|archived|deprecated)_.+|.+_(?:old|archived?|deprecated|backup|bak)")
_COPY = re.compile(r"\(copy|[ _.-]copy\W|sync-conflict-|\(\d+\)|[ _.-](?:bak|backup|old|orig)\.")


def is_trial_file(path: str) -> bool:
    """Whether a file is test code, or stands in for something or tries it out, by a word in its own name or in that of
    a folder of the workspace: ``mock_robot.py``, ``quick_tests/``."""
    parts = path.removeprefix(_below).removesuffix(".py").lower().split("/")
    return is_test_file(path) or any(not _TRIES_OUT.isdisjoint(re.split(r"[\W_]+", part)) for part in parts)


def is_put_aside(path: str) -> bool:
    """Whether a file is kept, and no longer worked on: by the name of a folder of the workspace, or because it is a
    copy that nothing can import, such as ``driver (copy).py`` or ``driver.sync-conflict-20260323.py``."""
    *folders, name = path.removeprefix(_below).lower().split("/")
    old = any(folder in _PUT_ASIDE or _NAMED_OLD.fullmatch(folder) for folder in folders)
    return old or _COPY.search(name) is not None
