"""The user's own key, with which cache entries are signed: what came with a repository carries no valid one."""

from __future__ import annotations

import errno
import os
import stat
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:  # each start reads the key, and needs little else
    from collections.abc import Iterable

KEY_BYTES = 32
_NAME = "cache.key"


def user_key(checked: Iterable[str]) -> bytes | None:
    """The key of this user, made when there is none; None where none can be kept.

    It lies in the user's configuration folder (``$XDG_CONFIG_HOME/archlint`` or ``~/.config/archlint``), never
    below one of the paths that are ``checked``, and counts only where nobody else may read or write it.
    """
    from contextlib import suppress  # which known_key does without

    folder = _folder_beside(checked)
    if folder is None:
        return None
    try:
        os.makedirs(folder, mode=0o700, exist_ok=True)
        if not _is_own(os.lstat(folder), stat.S_ISDIR, 0o022):
            return None
        with suppress(FileExistsError):
            _make(os.path.join(folder, _NAME))
        return _read(os.path.join(folder, _NAME))
    except OSError:
        return None


def known_key(checked: Iterable[str]) -> bytes | None:
    """The key of :func:`user_key`; None where there is none yet."""
    folder = _folder_beside(checked)
    try:
        if folder is None or not _is_own(os.lstat(folder), stat.S_ISDIR, 0o022):
            return None
        return _read(os.path.join(folder, _NAME))
    except OSError:
        return None


def _folder_beside(checked: Iterable[str]) -> str | None:
    folder = _folder()
    return None if folder is None or any(_is_below(folder, path) for path in checked) else folder


def _folder() -> str | None:
    home = os.environ.get("LOCALAPPDATA" if sys.platform == "win32" else "XDG_CONFIG_HOME", "")
    folder = home if os.path.isabs(home) else os.path.join(os.path.expanduser("~"), ".config")
    return os.path.join(folder, "archlint") if os.path.isabs(folder) else None


def _is_below(folder: str, path: str) -> bool:
    if not os.path.isdir(path):
        return False
    real, around = os.path.realpath(folder), os.path.realpath(path)
    return real == around or real.startswith(around.rstrip(os.sep) + os.sep)


def _is_own(status: os.stat_result, kind: object, forbidden: int) -> bool:
    """Whether a file or folder is of the right kind, and is this user's alone."""
    assert callable(kind)
    if not kind(status.st_mode):
        return False
    return not hasattr(os, "getuid") or (status.st_uid == os.getuid() and not status.st_mode & forbidden)


def _make(path: str) -> None:
    """Write a new key, whole or not at all; raises ``FileExistsError`` where there is one."""
    if os.path.lexists(path):
        raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), path)
    temporary = os.path.join(os.path.dirname(path), f".{_NAME}.{os.urandom(8).hex()}.tmp")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    descriptor = os.open(temporary, flags, 0o600)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(os.urandom(KEY_BYTES))
        os.link(temporary, path)  # of runs that start at once, the first one's key stays
    finally:
        os.unlink(temporary)


def _read(path: str) -> bytes | None:
    flags = os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    descriptor = os.open(path, flags)
    with os.fdopen(descriptor, "rb") as stream:
        if not _is_own(os.fstat(descriptor), stat.S_ISREG, 0o077):
            return None
        key = stream.read(KEY_BYTES + 1)
    return key if len(key) == KEY_BYTES else None
