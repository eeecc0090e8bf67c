"""What functions, classes and methods of rclpy, message_filters and tf2_ros take in each distribution.

The table, ``tables/signatures.json``, is written by ``scripts/generate_signatures`` from their sources.
"""

from __future__ import annotations

import enum
from collections.abc import Collection, Mapping
from functools import cache, lru_cache
from pathlib import Path

import msgspec

from archlint.model import Misuse
from archlint.records import dataclass

_FILE = Path(__file__).with_name("tables") / "signatures.json"
_AS_IN = {"rclpy.qos.QoSProfile": "kilted"}
"""Classes that check their keywords themselves, and take the same in all distributions: an AssertionError tells of any
other."""


_OF_EVERY_OBJECT = frozenset(dir(object))
_OF_ENUMS = frozenset(dir(enum.IntFlag)).union(dir(enum.Enum), dir(str), {"_name_", "_value_", "name", "value"})
"""What the members of an enum have, whatever it is made of.  Source: docs.python.org/3/library/enum.html."""
_OF_PYTHON_S_OWN = {
    "enum.": _OF_ENUMS,
    "object": _OF_EVERY_OBJECT,
    "typing.NamedTuple": frozenset(dir(tuple)) | {"_asdict", "_field_defaults", "_fields", "_make", "_replace"},
    "typing.TypedDict": frozenset(dir(dict)),
    "typing.": _OF_EVERY_OBJECT,
}
"""What bases bring that Python itself has, by how their names begin; the first that fits counts."""


class _Class(msgspec.Struct):
    bases: list[str]
    methods: dict[str, dict[str, str]]
    attributes: list[str]


class _Table(msgspec.Struct):
    distros: list[str]
    functions: dict[str, dict[str, str]]
    classes: dict[str, _Class]


@dataclass(frozen=True)
class Mismatch:
    """Why a call does not fit: the parameters that this is about, and how many arguments it takes by position."""

    misuse: Misuse
    parameters: tuple[str, ...] = ()
    takes: int = 0


@dataclass(frozen=True)
class Signature:
    """The parameters of one callable, without ``self``."""

    positional: tuple[str, ...]
    by_name: tuple[str, ...]
    """Those that go by keyword alone."""
    optional: frozenset[str]
    any_positional: bool
    any_keyword: bool

    def mismatch(self, given: int, keywords: Collection[str], is_all: bool) -> Mismatch | None:
        """Why a call with so many arguments by position and these by keyword is refused; None where it is not.

        Where that ``is_all`` is not known, more may be given.
        """
        if given > len(self.positional) and not self.any_positional:
            return Mismatch(Misuse.TOO_MANY, self.by_name, len(self.positional))
        twice = [name for name in self.positional[:given] if name in keywords]
        if twice:
            return Mismatch(Misuse.TWICE, tuple(twice))
        unknown = sorted({*keywords}.difference(self.positional, self.by_name))
        if unknown and not self.any_keyword:
            return Mismatch(Misuse.UNKNOWN_KEYWORD, tuple(unknown))
        wanted = (*self.positional[given:], *self.by_name)
        missing = [name for name in wanted if name not in self.optional and name not in keywords]
        return Mismatch(Misuse.MISSING, tuple(missing)) if missing and is_all else None


def signatures_of(path: str) -> Mapping[str, Signature]:
    """The signature of a function, class or method by its canonical name, for each distribution that has it; empty
    where the table does not have it."""
    owner, _, name = path.rpartition(".")
    table = _table()
    if path in table.functions:
        return _of_function(path)
    if path in table.classes:
        return _of_method(path, "__init__")
    return _of_method(owner, name) if owner in table.classes else {}


@cache
def attributes_of(cls: str) -> frozenset[str] | None:
    """The names of the attributes and methods that a class has in any distribution; None where that is not known."""
    row = _table().classes.get(cls)
    if row is None:
        return next((names for start, names in _OF_PYTHON_S_OWN.items() if cls.startswith(start)), None)
    inherited = [attributes_of(base) for base in row.bases]
    if any(names is None for names in inherited) or "__getattr__" in row.attributes:
        return None
    return frozenset(row.methods).union(row.attributes, _OF_EVERY_OBJECT, *filter(None, inherited))


def own_names_of(cls: str) -> frozenset[str]:
    """The names that the body of a class of the table has in any distribution."""
    row = _table().classes[cls]
    return frozenset(row.methods).union(row.attributes)


def distros() -> tuple[str, ...]:
    """The distributions that the table knows, oldest first."""
    return tuple(_table().distros)


@lru_cache(maxsize=4096)
def refusing_distros(
    path: str, given: int, keywords: tuple[str, ...], is_all: bool, newer: tuple[str, ...] = ()
) -> tuple[tuple[str, Mismatch], ...]:
    """The distributions that refuse a call of a callable with so many arguments by position and these by keyword.

    ``newer`` are parameters that a distribution may have which the table does not know.
    """
    known = {name for _, row in _by_age(path) for name in (*row.positional, *row.by_name)}
    ours = [name for name in keywords if name in known or name not in newer]
    rows = ((distro, row.mismatch(given, ours, is_all)) for distro, row in _by_age(path))
    return tuple((distro, mismatch) for distro, mismatch in rows if mismatch is not None)


def _by_age(path: str) -> list[tuple[str, Signature]]:
    by_distro = signatures_of(path)
    return [(distro, by_distro[distro]) for distro in distros() if distro in by_distro]


@cache
def needed(path: str) -> tuple[str, ...]:
    """The parameters of a callable that may not be left out, in the newest distribution."""
    rows = _by_age(path)
    if not rows:
        return ()
    newest = rows[-1][1]
    return tuple(name for name in (*newest.positional, *newest.by_name) if name not in newest.optional)


@cache
def _of_method(cls: str, name: str) -> Mapping[str, Signature]:
    row = _table().classes.get(cls)
    if row is None:
        return {}
    if name in row.methods:
        by_distro = _parsed(row.methods[name])
        return dict.fromkeys(by_distro, by_distro[_AS_IN[cls]]) if cls in _AS_IN else by_distro
    inherited = (_of_method(base, name) for base in row.bases)
    return next(filter(None, inherited), {})


@cache
def _of_function(path: str) -> Mapping[str, Signature]:
    return _parsed(_table().functions[path])


def _parsed(rows: Mapping[str, str]) -> Mapping[str, Signature]:
    """The signatures by distribution; the rows have the names of several as one key."""
    return {distro: _parse(text) for names, text in rows.items() for distro in names.split()}


def _parse(text: str) -> Signature:
    words = [word for word in text.split() if word != "/"]
    at = next((number for number, word in enumerate(words) if word.startswith("*")), len(words))
    names = [word for word in words if not word.startswith("*")]
    return Signature(
        positional=tuple(word.rstrip("=") for word in words[:at]),
        by_name=tuple(word.rstrip("=") for word in names[at:]),
        optional=frozenset(word.rstrip("=") for word in names if word.endswith("=")),
        any_positional=any(word[0] == "*" and word[1:2].isalpha() for word in words),
        any_keyword=any(word.startswith("**") for word in words),
    )


@cache
def _table() -> _Table:
    return msgspec.json.decode(_FILE.read_bytes(), type=_Table)


__all__ = [
    "Mismatch",
    "Signature",
    "attributes_of",
    "distros",
    "needed",
    "own_names_of",
    "refusing_distros",
    "signatures_of",
]
