"""The names that rosdep knows for packages of the system, and the one that a name nearly is."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path

import msgspec

from archlint.suggestions import distance, nearest

FILE = Path(__file__).with_name("rosdep_keys.json")
ON_UBUNTU = FILE.with_name("rosdep_on_ubuntu.json")
_SHORTEST = 6
"""How long a name is at least of which one with another letter can be what was meant."""


@cache
def keys() -> frozenset[str]:
    """The keys that ``scripts/generate_rosdep_keys`` writes, of rosdistro's ``rosdep/*.yaml``; read once."""
    return msgspec.json.decode(FILE.read_bytes(), type=frozenset[str])


class _OnUbuntu(msgspec.Struct):
    """What the same script writes of the packages of Ubuntu."""

    without: dict[str, frozenset[str]]
    """The keys for Python without a package, by the release."""
    named: dict[str, str]
    """The key of a package that is called otherwise."""


@cache
def _on_ubuntu() -> _OnUbuntu:
    return msgspec.json.decode(ON_UBUNTU.read_bytes(), type=_OnUbuntu)


def is_on(key: str, release: str) -> bool:
    """Whether a key for Python has a package on a release of Ubuntu: rosdep stops at one that has none."""
    return key not in _on_ubuntu().without.get(release, ())


def key_of_debian(name: str) -> str | None:
    """The key that stands for a package of Ubuntu, by its name there; None where it has that name, too, or is none."""
    return _on_ubuntu().named.get(name)


_AS_DEBIAN = re.compile(r"^python3?-")
"""What Debian puts in front of the names of its packages of Python."""


def meant_by(name: str, packages: Collection[str], *, is_python: bool) -> str | None:
    """The key, or the one of ``packages``, that was meant by a name that is neither; None where nothing is near.

    ``is_python`` says whether a module of Python may be meant: otherwise ``serial`` may well be somebody's package."""
    spellings = [*_names_of_system(name), *(_names_of_python(name) if is_python else ())]
    written = next((other for other in spellings if other in keys()), None)
    if written is None:
        others = (name.replace("_lint_", "_", 1), name.replace("-", "_"), _AS_DEBIAN.sub("", name).replace("-", "_"))
        written = next((other for other in others if other in packages), None)
    if written is not None or len(name) < _SHORTEST:
        return written
    near = nearest(name, packages, most=1)
    return near if near is not None and distance(name, near, 1) <= 1 else None


def _names_of_system(name: str) -> Iterator[str]:
    """How rosdep may call what a name of CMake or of Debian means, best first."""
    plain = name.lower().replace("_", "-")
    yield plain
    if name != name.lower():  # as a module of CMake; what is lower case may be the name of somebody's package
        yield from (re.sub(r"\d+$", "", plain), f"lib{plain}-dev", f"{plain}-dev")


def _names_of_python(name: str) -> Iterator[str]:
    """How rosdep may call what a name of pip means, best first."""
    plain = name.lower().replace("_", "-")
    bare = re.sub(r"^python3?-", "", plain)
    for other in dict.fromkeys((bare, bare.removeprefix("py"))):
        yield from (f"python3-{other}", f"python3-{other}-pip", f"{other}-pip")


__all__ = ["is_on", "key_of_debian", "keys", "meant_by"]
