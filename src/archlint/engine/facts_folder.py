"""A folder of shards with its index, as ``archlint facts`` writes it and ``--facts`` reads it."""

from __future__ import annotations

import contextlib
import hashlib
import os
import platform
import re
from collections.abc import Mapping
from pathlib import Path

import msgspec

from archlint import __version__
from archlint.disk import read_regular, replace_file
from archlint.engine.facts_file import FORMAT_VERSION, OddShard, Shard, packed, unpacked
from archlint.syntax.facts import FACTS_VERSION

INDEX = "archlint-facts.json"
SUFFIX = ".shard"

_INDEX_BYTES = 50_000_000
_SHARD_BYTES = 500_000_000
_NAME = re.compile(rf"\w[\w.-]*{re.escape(SUFFIX)}", re.ASCII)
_UNSAFE = re.compile(r"[^\w.-]+", re.ASCII)


class FactsError(Exception):
    """Facts that cannot be written or used; ``str()`` says which, why, and what to do."""


class _Version(msgspec.Struct):
    """Of an index of any version."""

    version: int
    archlint: str = "?"
    facts: int = 0


class _Row(msgspec.Struct, forbid_unknown_fields=True):
    file: str
    folder: str
    sha256: str


class _Index(msgspec.Struct, forbid_unknown_fields=True):
    version: int
    archlint: str
    facts: int
    python: str
    shards: list[_Row]


def write(folder: Path, shards: Mapping[str, Shard]) -> None:
    """Write shards, each by the folder that it is about, and take away those that were here before.

    Who reads meanwhile reads all that was here before, or all that is here now.  Raises :class:`FactsError`.
    """
    before = _before(folder)
    rows = []
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for about, shard in sorted(shards.items()):
            data = packed(shard)
            digest = hashlib.sha256(data).hexdigest()
            name = f"{_UNSAFE.sub('-', about).strip('-.') or 'workspace'}-{digest[:16]}{SUFFIX}"
            replace_file(folder / name, data)
            rows.append(_Row(name, about, digest))
        index = _Index(FORMAT_VERSION, __version__, FACTS_VERSION, platform.python_version(), rows)
        replace_file(folder / INDEX, msgspec.json.format(msgspec.json.encode(index)) + b"\n")
    except OddShard as error:
        raise FactsError(f"cannot write facts: {error}") from None
    except OSError as error:
        raise FactsError(f"cannot write {folder}: {error.strerror}") from None
    for name in before - {row.file for row in rows}:
        with contextlib.suppress(OSError):
            os.unlink(folder / name)


def _before(folder: Path) -> set[str]:
    """The shards that an earlier run has written.  Raises :class:`FactsError` for a folder of somebody else's."""
    try:
        names = set(os.listdir(folder))
    except FileNotFoundError:
        return set()
    except OSError as error:
        raise FactsError(f"cannot write {folder}: {error.strerror}") from None
    if names and INDEX not in names:
        raise FactsError(f"{folder} holds other files than facts: name a folder that is new or empty")
    return {name for name in names if _NAME.fullmatch(name)}


def read(folder: Path) -> dict[str, Shard]:
    """The shards of a folder, by the names of their files.  Raises :class:`FactsError`."""
    index = _read_index(folder)
    shards = {}
    for row in index.shards:
        path = folder / row.file
        if not _NAME.fullmatch(row.file):
            raise FactsError(f"{folder / INDEX}: {row.file!r} is not the name of a shard")
        try:
            data = read_regular(path, _SHARD_BYTES)
        except OSError as error:
            raise FactsError(f"cannot read {path}: {error.strerror}") from None
        if hashlib.sha256(data).hexdigest() != row.sha256:
            raise FactsError(f"{path} is not the shard that its index names; {_AGAIN}")
        try:
            shards[str(path)] = unpacked(data)
        except OddShard as error:
            raise FactsError(f"cannot read {path}: {error}; {_AGAIN}") from None
    return shards


def _read_index(folder: Path) -> _Index:
    path = folder / INDEX
    try:
        data = read_regular(path, _INDEX_BYTES)
    except FileNotFoundError:
        raise FactsError(f"there are no facts in {folder}: `archlint facts -o {folder}` writes them") from None
    except OSError as error:
        raise FactsError(f"cannot read {path}: {error.strerror}") from None
    try:
        version = msgspec.json.decode(data, type=_Version)
        if (version.version, version.archlint, version.facts) != (FORMAT_VERSION, __version__, FACTS_VERSION):
            written = f"archlint {version.archlint} (format {version.version}.{version.facts})"
            this = f"archlint {__version__} (format {FORMAT_VERSION}.{FACTS_VERSION})"
            raise FactsError(f"the facts in {folder} were written by {written}, and this is {this}; {_AGAIN}")
        return msgspec.json.decode(data, type=_Index)
    except (msgspec.MsgspecError, ValueError, RecursionError) as error:
        raise FactsError(f"{path} is damaged ({error}); {_AGAIN}") from None


_AGAIN = "write it again with `archlint facts`"

__all__ = ["INDEX", "SUFFIX", "FactsError", "read", "write"]
