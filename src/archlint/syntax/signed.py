"""Files that carry the user's signature: what is read of the cache is what this user has put there.

It is imported on every start, before anything else is known to be needed, so it imports next to nothing itself:
:mod:`hmac` and :mod:`hashlib` would load OpenSSL for what two modules of the interpreter do.
"""

from __future__ import annotations

import os
import stat
import sys
from _blake2 import blake2b
from _operator import _compare_digest as is_same

CACHE_FOLDER = ".archlint_cache"
"""The name of the folder of the cache, unless the configuration gives it another one."""
MAX_BYTES = 256_000_000


def version_folder(version: str) -> str:
    """The folder of what one version keeps.  It depends on the Python, too: newer ones accept more source."""
    return f"{version}-{sys.version_info[0]}.{sys.version_info[1]}"


def signed(folder: str, name: str, payload: bytes, key: bytes) -> bytes:
    """A payload with what only this user can make: for these bytes, under this name, of this version."""
    return _signature(folder, name, payload, key) + b"\n" + payload


def read_signed(folder: str, name: str, key: bytes) -> bytes | None:
    """The payload of a file below ``folder``, that of one version; None where it is not this user's."""
    data = _read_file(os.path.join(folder, name))
    if data is None:
        return None
    signature, _, payload = data.partition(b"\n")
    return payload if is_same(signature, _signature(folder, name, payload, key)) else None


def _signature(folder: str, name: str, payload: bytes, key: bytes) -> bytes:
    place = f"{os.path.basename(folder)}/{name.replace(os.sep, '/')}".encode()
    return blake2b(place + b"\0" + payload, key=key, digest_size=16).hexdigest().encode()


def _read_file(path: str) -> bytes | None:
    """The bytes of a regular file; nothing else is opened, for a pipe would be waited on."""
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    except (OSError, ValueError):
        return None
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode) or status.st_size > MAX_BYTES:
            return None
        with os.fdopen(descriptor, "rb", closefd=False) as stream:
            return stream.read()
    except OSError:
        return None
    finally:
        os.close(descriptor)
