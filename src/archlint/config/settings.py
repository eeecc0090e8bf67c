"""The configuration: found, read, checked and merged, with where each value came from.

``[tool.archlint]`` in ``pyproject.toml``, or the same keys in ``archlint.toml`` or ``.archlint.toml``.  The
nearest file upwards wins; a ``pyproject.toml`` without the table is passed over.  A mistake is an error that
shows the line and, where something is near, what was probably meant.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextvars import copy_context
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from archlint.config.files import find, read_source
from archlint.config.presets import PRESETS
from archlint.config.selection import Layer, Selection, resolve
from archlint.config.source import ConfigurationError
from archlint.globs import Glob
from archlint.records import dataclass
from archlint.ros.distros import DISTROS
from archlint.syntax.signed import CACHE_FOLDER

if TYPE_CHECKING:
    from archlint.architecture import Contract, Layers
    from archlint.checks.registry import OptionValue
    from archlint.config.preset_names import PresetName
    from archlint.config.source import Reader, Source
    from archlint.finding import Severity
    from archlint.plugins.model import Plugin
    from archlint.ros.external_nodes import ExternalNode

__all__ = ["ConfigurationError", "Settings", "load"]


@dataclass(frozen=True)
class Settings:
    """The effective configuration.  ``origins`` says where a key that is not at its default was set."""

    layers: tuple[Layer, ...] = ()
    preset: PresetName | None = None
    severity: Mapping[str, Severity] = field(default_factory=dict)
    exclude: tuple[Glob, ...] = ()
    per_file_ignores: Mapping[Glob, tuple[str, ...]] = field(default_factory=dict)
    per_package_ignores: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    distro: str | None = None
    closed_world: bool = False
    launch: tuple[Glob, ...] = ()
    """The launch files that are systems; all of them where none is named."""
    external: tuple[str, ...] = ()
    external_nodes: tuple[ExternalNode, ...] = ()
    """What nodes offer whose source is elsewhere."""
    shared_topics: tuple[str, ...] = ()
    cache_dir: str | None = None
    baseline: str | None = None
    """The file with the findings that are held back."""
    owners: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    contracts: tuple[Contract, ...] = ()
    node_layers: Layers | None = None
    rules: Mapping[str, Mapping[str, OptionValue]] = field(default_factory=dict)
    unused_files: bool = False
    """Whether findings in files and functions that nothing runs are shown, too."""
    plugins: tuple[str, ...] = ()
    """The plugins that are named, whether they run or not."""
    running_plugins: tuple[Plugin, ...] = ()
    origins: Mapping[str, str] = field(default_factory=dict)
    file: str | None = None
    """The nearest configuration file; None without one."""
    read: tuple[str, ...] = ()
    """All configuration files: the nearest one, and those that it builds on."""

    @property
    def leaves_out_plugins(self) -> bool:
        return len(self.running_plugins) < len(self.plugins)

    def activate_plugins(self) -> None:
        """Have the rules of the plugins, for the rest of this context (:mod:`contextvars`)."""
        if self.plugins:
            from archlint.plugins.model import activate  # hardly any configuration has plugins

            activate(self.running_plugins, self.leaves_out_plugins)

    @property
    def selection(self) -> Selection:
        return resolve((PRESETS[self.preset].layer, *self.layers))

    @property
    def cache_folder(self) -> str:
        """Where the cache is: as configured, else beside the configuration, else in the working directory."""
        beside = Path() if self.file is None else Path(self.file).parent
        return self.cache_dir or (beside / CACHE_FOLDER).as_posix()

    @property
    def distros(self) -> tuple[str, ...]:
        """The distributions to judge for: the one configured, else all."""
        return DISTROS if self.distro is None else (self.distro,)


_OF_A_LAYER = ("select", "extend-select", "ignore")
_FIELDS = {"layers": "node_layers"}
"""Keys that are called otherwise in :class:`Settings`, whose ``layers`` are those of configuration."""


def load(start: Path, file: Path | None = None, read: Reader | None = None, *, plugins: bool | None = None) -> Settings:
    """The settings for what is checked at ``start``: of ``file`` if given, else of the nearest one upwards.  ``read``
    gives the bytes of files, if not the disk.

    ``plugins`` says whether those that are named run or are left out; with None one that would run code of the
    repository is an error.  Raises :class:`ConfigurationError` for anything that cannot be read or understood.
    """
    source = _source(start, file, read)
    if source is None:
        return Settings()
    # In a context of its own: it has the rules of the plugins only while it reads.
    return copy_context().run(_settings_of, source, file is not None, plugins)


def _settings_of(source: Source, named: bool, plugins: bool | None) -> Settings:
    from archlint.config.reading import read_tables, read_values  # most workspaces have none, and need no schema

    tables = read_tables(source, (), named)
    running: tuple[Plugin, ...] = ()
    if any("plugins" in given for given, _ in tables):
        from archlint.config.plugins import activated  # hardly any configuration has plugins

        running = activated(tables, plugins)
    settings = Settings()
    for values, origin in read_values(tables, named):
        settings = _merged(settings, values, origin)
    files = tuple(origin.path.as_posix() for _, origin in tables)
    return replace(settings, file=source.path.as_posix(), read=files, running_plugins=running)


def _source(start: Path, file: Path | None, read: Reader | None) -> Source | None:
    return find(start.absolute(), read) if file is None else read_source(file.absolute(), named=True, read=read)


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
            merged = {k: _on_top(below[k], above, depth - 1) if k in below else above for k, above in value.items()}
            return {**below, **merged}
    return value
