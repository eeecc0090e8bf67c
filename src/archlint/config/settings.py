"""The configuration: found, read, checked and merged, with where each value came from.

``[tool.archlint]`` in ``pyproject.toml``, or the same keys in ``archlint.toml`` or ``.archlint.toml``.  The
nearest file upwards wins; a ``pyproject.toml`` without the table is passed over.  A mistake is an error that
shows the line and, where something is near, what was probably meant.
"""

from __future__ import annotations

import importlib
import os
import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from archlint.config import architecture_tables, rule_options
from archlint.config import values as read
from archlint.config.selection import Layer, Selection, resolve
from archlint.config.values import ConfigurationError, Source, Value
from archlint.disk import read_regular
from archlint.globs import Glob
from archlint.ros.distros import DISTROS

if TYPE_CHECKING:
    from archlint.architecture import Contract, Layers
    from archlint.checks.registry import OptionValue
    from archlint.finding import Severity

__all__ = ["KEYS", "ConfigurationError", "Settings", "load"]

FILE_NAMES = (".archlint.toml", "archlint.toml", "pyproject.toml")
"""In the order in which they are looked for in a folder."""

CACHE_FOLDER = ".archlint_cache"
MAX_BYTES = 1_000_000
"""A larger file is no configuration."""


@dataclass(frozen=True)
class Settings:
    """The effective configuration.  ``origins`` says where a key that is not at its default was set."""

    layers: tuple[Layer, ...] = ()
    severity: Mapping[str, Severity] = field(default_factory=dict)
    exclude: tuple[Glob, ...] = ()
    per_file_ignores: Mapping[Glob, tuple[str, ...]] = field(default_factory=dict)
    per_package_ignores: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    distro: str | None = None
    closed_world: bool = False
    launch: tuple[Glob, ...] = ()
    """The launch files that are systems; all of them where none is named."""
    external: tuple[str, ...] = ()
    shared_topics: tuple[str, ...] = ()
    cache_dir: str | None = None
    owners: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    contracts: tuple[Contract, ...] = ()
    node_layers: Layers | None = None
    rules: Mapping[str, Mapping[str, OptionValue]] = field(default_factory=dict)
    origins: Mapping[str, str] = field(default_factory=dict)
    file: str | None = None
    """The nearest configuration file; None without one."""

    @property
    def selection(self) -> Selection:
        return resolve(self.layers)

    @property
    def cache_folder(self) -> str:
        """Where the cache is: as configured, else beside the configuration, else in the working directory."""
        beside = Path() if self.file is None else Path(self.file).parent
        return self.cache_dir or (beside / CACHE_FOLDER).as_posix()

    @property
    def distros(self) -> tuple[str, ...]:
        """The distributions to judge for: the one configured, else all."""
        return DISTROS if self.distro is None else (self.distro,)


KEYS: dict[str, Callable[[Value], object]] = {
    "cache-dir": read.folder,
    "closed-world": read.boolean,
    "contracts": architecture_tables.contracts,
    "distro": read.one_of(DISTROS),
    "exclude": read.globs,
    "extend": read.string,
    "extend-select": read.selectors,
    "external": read.strings,
    "ignore": read.selectors,
    "launch": read.globs,
    "layers": architecture_tables.layers,
    "owners": architecture_tables.owners,
    "per-file-ignores": read.ignores_by_glob,
    "per-package-ignores": read.ignores_by_name,
    "rules": rule_options.rule_options,
    "select": read.selectors,
    "severity": read.severities,
    "shared-topics": read.strings,
}
"""Every key and how its value is read.  A new key is a row here and a field of :class:`Settings`."""

_OF_A_LAYER = ("select", "extend-select", "ignore")
_FIELDS = {"layers": "node_layers"}
"""Keys that are called otherwise in :class:`Settings`, whose ``layers`` are those of configuration."""


def load(start: Path, file: Path | None = None) -> Settings:
    """The settings for what is checked at ``start``: of ``file`` if given, else of the nearest one upwards.

    Raises :class:`ConfigurationError` for anything that cannot be read or understood.
    """
    source = read_source(file.absolute(), named=True) if file is not None else find(start.absolute())
    if source is None:
        return Settings()
    return replace(_settings(source, (), named=file is not None), file=source.path.as_posix())


def find(start: Path) -> Source | None:
    """The configuration file that counts for ``start``, a folder or a file."""
    for folder in (start, *start.parents):
        for name in FILE_NAMES:
            path = folder / name
            source = read_source(path) if path.is_file() else None
            if source is None:
                continue
            if not _is_within(path, _repository(folder)):
                raise ConfigurationError("leads out of the repository: name it with --config", source.shown)
            return source
    return None


def _repository(folder: Path) -> Path:
    """The repository that a folder is in; the folder itself where it is in none."""
    folders = (folder, *folder.parents)
    return next((one for one in folders if os.path.lexists(one / ".git")), folder).resolve()


def _is_within(path: Path, folder: Path) -> bool:
    return path.resolve().is_relative_to(folder)


def read_source(path: Path, named: bool = False, foreign: bool = False) -> Source | None:
    """A configuration file's text; None for a ``pyproject.toml`` without the table, unless it was named."""
    shown = Source(path, "", ()).shown
    try:
        content = read_regular(path, MAX_BYTES)
    except OSError as error:
        raise ConfigurationError(f"cannot be read: {error.strerror}", shown) from None
    in_pyproject = path.name == "pyproject.toml"
    if in_pyproject and b"archlint" not in content and not named:
        return None
    try:
        source = Source(path, content.decode("utf-8-sig"), ("tool", "archlint") if in_pyproject else (), foreign)
    except UnicodeDecodeError:
        raise ConfigurationError("is not UTF-8", shown) from None
    foreign = foreign or not (named or _is_within(path, _repository(path.parent)))
    source = replace(source, foreign=foreign)
    if in_pyproject and _own_table(source) is None and not named:
        return None
    return source


def _own_table(source: Source) -> dict[str, Any] | None:
    document = _parse(source)
    if not source.table:
        return document
    match document:
        case {"tool": {"archlint": dict() as table}}:
            return table
    return None


def _parse(source: Source) -> dict[str, Any]:
    toml = importlib.import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
    try:
        document: dict[str, Any] = toml.loads(source.text)
    except (ValueError, RecursionError) as error:
        place = re.search(r"\(at line (\d+), column (\d+)\)", str(error))
        why = str(error).partition(" (at ")[0] or "nested too deeply"
        message = "not valid TOML" if source.foreign else f"not valid TOML: {why}"
        lines = source.text.splitlines() or [""]
        line, column = (int(place[1]), int(place[2])) if place else (len(lines), len(lines[-1]))
        raise source.error_at(message, line, column, column + 1) from None
    return document


def _settings(source: Source, trail: tuple[Path, ...], named: bool) -> Settings:
    table = _own_table(source) or {}
    for key in table:
        if key not in KEYS:
            raise source.error(read.unknown_key(key, KEYS), (key,))
    values = {key: KEYS[key](Value(table[key], (key,), source)) for key in KEYS if key in table}
    parent = Settings()
    if "extend" in values:
        parent = _extended(source, str(values.pop("extend")), (*trail, source.path.resolve()), named)
    return _merged(parent, values, source)


def _extended(source: Source, extend: str, trail: tuple[Path, ...], named: bool) -> Settings:
    """The settings of the file that another builds on.  One outside of the repository counts only where the user
    ``named`` the configuration: a repository must not choose what else of the machine is read and shown."""
    path = source.path.parent / read.home_of(source, extend, ("extend",))
    if path.resolve() in trail:
        shown = " -> ".join(Source(step, "", ()).shown for step in (*trail, path.resolve()))
        raise source.error(f"`extend` forms a circle: {shown}", ("extend",))
    if not path.is_file():
        raise source.error(f"`extend` names a file that does not exist: {extend}", ("extend",), extend)
    foreign = not _is_within(path, _repository(trail[0].parent))
    if foreign and not named:
        message = f"`extend` leads out of the repository: {extend}; to allow that, name this file with --config"
        raise source.error(message, ("extend",), extend)
    parent = read_source(path, named=True, foreign=foreign)
    assert parent is not None
    return _settings(parent, trail, named)


def _merged(parent: Settings, values: dict[str, Any], source: Source) -> Settings:
    """The parent's settings with those of a file on top: tables are merged, everything else is replaced."""
    layer = Layer(values.get("select"), values.get("extend-select", ()), values.get("ignore", ()))
    changes: dict[str, Any] = {"layers": (*parent.layers, layer)}
    for key in values.keys() - set(_OF_A_LAYER):
        name = _FIELDS.get(key, key.replace("-", "_"))
        changes[name] = _on_top(getattr(parent, name), values[key], 2 if key == "rules" else 1)
    origins = {**parent.origins, **{key: source.line_of((key,)) for key in values}}
    return replace(parent, **changes, origins=origins)


def _on_top(below: Any, value: Any, depth: int) -> Any:
    """A value in place of the one below it; tables are merged, down to a depth."""
    match value:
        case dict() if depth:
            merged = {key: _on_top(below[key], one, depth - 1) if key in below else one for key, one in value.items()}
            return {**below, **merged}
    return value
