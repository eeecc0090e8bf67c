"""What a configuration file says: converted, checked, and what it builds on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from archlint.config import architecture_tables, contract_tables, external_tables, rule_options
from archlint.config import values as read
from archlint.config.conversion import converted
from archlint.config.files import is_within, own_table, read_source, repository_of
from archlint.config.schema import ConfigurationFile
from archlint.config.source import Key, Source

Reading = Callable[[Any, Key], object]

_READERS: Mapping[str, Reading] = {
    "baseline": read.file_in_repository,
    "cache-dir": read.folder_in_repository,
    "contracts": contract_tables.contracts,
    "exclude": read.globs,
    "extend-select": read.selectors,
    "external-nodes": external_tables.external_nodes,
    "ignore": read.selectors,
    "launch": read.globs,
    "layers": architecture_tables.layers,
    "owners": architecture_tables.owners,
    "per-file-ignores": read.ignores_by_glob,
    "per-package-ignores": read.ignores_by_name,
    "rules": rule_options.rule_options,
    "select": read.selectors,
    "severity": read.severities,
}
"""The keys whose values are more than they look.  A new key is a field of :class:`ConfigurationFile` and one of
``Settings``, and a row here if its value has to be checked or changed."""

_READERS_OF_USERS: Mapping[str, Reading] = {**_READERS, "cache-dir": read.folder}
"""The same for a file that the user has named: it is no repository's."""

Contents = list[tuple[dict[str, Any], Source]]


def read_tables(source: Source, trail: tuple[Path, ...], named: bool) -> Contents:
    """What a file and those that it builds on say by key, as it is written, the farthest first; ``trail`` are those
    that build on it.  Where the user has ``named`` the first of them, it is not the choice of a repository.

    Raises :class:`ConfigurationError`.
    """
    given = converted(own_table(source) or {}, ConfigurationFile, Key((), source)).given()
    below: Contents = []
    if "extend" in given:
        below = _extended(source, str(given.pop("extend")), (*trail, source.path.resolve()), named)
    return [*below, (given, source)]


def read_values(tables: Contents, named: bool) -> Contents:
    """The same with what the values mean; ``named`` as above.  Raises :class:`ConfigurationError`."""
    readers = _READERS_OF_USERS if named else _READERS

    def value_of(key: str, value: Any, source: Source) -> Any:
        return readers[key](value, Key((key,), source)) if key in readers else value

    return [({key: value_of(key, value, source) for key, value in given.items()}, source) for given, source in tables]


def _extended(source: Source, extend: str, trail: tuple[Path, ...], named: bool) -> Contents:
    """The file that another builds on.  One outside of the repository counts only where the user
    ``named`` the configuration: a repository must not choose what else of the machine is read and shown."""
    path = source.path.parent / read.home_of(extend, Key(("extend",), source))
    if path.resolve() in trail:
        shown = " -> ".join(Source(step, "", ()).shown for step in (*trail, path.resolve()))
        raise source.error(f"`extend` forms a circle: {shown}", ("extend",))
    if not path.is_file():
        raise source.error(f"`extend` names a file that does not exist: {extend}", ("extend",), extend)
    foreign = not is_within(path, repository_of(trail[0].parent))
    if foreign and not named:
        message = f"`extend` leads out of the repository: {extend}; to allow that, name this file with --config"
        raise source.error(message, ("extend",), extend)
    parent = read_source(path, named=True, foreign=foreign, read=source.read)
    assert parent is not None
    return read_tables(parent, trail, named)
