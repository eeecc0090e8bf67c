"""Reading and writing that nothing in a foreign folder can turn against the one who runs archlint."""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Collection, Iterator
from pathlib import Path


def read_regular(path: str | Path, limit: int) -> bytes:
    """The bytes of a regular file of at most ``limit`` bytes.

    A pipe or a device is never waited on.  Raises ``OSError``, also for what is no regular file or is too large.
    """
    try:
        descriptor = os.open(path, os.O_RDONLY | _flag("O_NONBLOCK") | _flag("O_CLOEXEC") | _flag("O_BINARY"))
    except ValueError:  # a NUL in the name
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), path) from None
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise OSError(errno.EINVAL, "not a regular file", path)
        with os.fdopen(descriptor, "rb", closefd=False) as stream:
            data = stream.read(limit + 1) or b""  # None of a file of the system that has nothing to say yet
    finally:
        os.close(descriptor)
    if len(data) > limit:
        raise OSError(errno.EFBIG, f"the file is too large: the limit is {limit // 1000} kB", path)
    return data


def walk(top: str | Path) -> Iterator[tuple[str, list[str], list[str]]]:
    """As :func:`os.walk`, which before Python 3.12 calls itself for each folder: it fails in a tree of 1,000 levels."""
    waiting = [os.fspath(top)]
    while waiting:
        folder = waiting.pop()
        try:
            with os.scandir(folder) as entries:
                is_folder = {entry.name: _leads_to_folder(entry) for entry in entries}
        except OSError:
            continue
        folders = [name for name, leads_on in is_folder.items() if leads_on]
        yield folder, folders, [name for name, leads_on in is_folder.items() if not leads_on]
        below = (os.path.join(folder, name) for name in reversed(folders))
        waiting.extend(path for path in below if not os.path.islink(path))


def _leads_to_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a link to itself
        return False


def lies_in(path: str | Path, folders: Collection[str]) -> bool:
    """Whether a path leads, through whatever links, to one of some folders or files, or to what is below; those are
    given by their real paths.  Without any, everything does."""
    real = os.path.realpath(path)
    return not folders or any(f"{real}{os.sep}".startswith(folder.rstrip(os.sep) + os.sep) for folder in folders)


def replace_file(target: Path, data: bytes, like: os.stat_result | None = None) -> None:
    """Put ``data`` in place of ``target`` in one step, with the permissions and the owner that ``like`` has.

    It is written aside first, to a name that nobody can know before, and never through a link.  ``target`` itself
    should be no link.  Raises ``OSError``.
    """
    temporary = target.with_name(f".{target.name[:200]}.{os.urandom(8).hex()}.tmp")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | _flag("O_NOFOLLOW") | _flag("O_CLOEXEC") | _flag("O_BINARY")
    descriptor = os.open(temporary, flags, 0o666)
    try:
        with os.fdopen(descriptor, "wb") as stream:
            stream.write(data)
            if like is not None:
                _make_like(descriptor, like)
        os.replace(temporary, target)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise


def _make_like(descriptor: int, like: os.stat_result) -> None:
    if hasattr(os, "fchown"):
        with contextlib.suppress(OSError):  # only root may give a file away
            os.fchown(descriptor, like.st_uid, like.st_gid)
    if hasattr(os, "fchmod"):
        os.fchmod(descriptor, like.st_mode & 0o7777)


def _flag(name: str) -> int:
    """A flag of ``os.open`` that not every system has."""
    return getattr(os, name, 0)
