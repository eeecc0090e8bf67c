"""The key ``plugins``: which of the plugins run, and who may decide that."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from archlint.config.files import repository_of
from archlint.config.source import Key, Source
from archlint.config.values import file_in_repository
from archlint.plugins.installed import entry_point, load_installed, places_of
from archlint.plugins.loading import load_file
from archlint.plugins.model import Plugin, PluginError, activate
from archlint.plugins.permission import belongs_to, refusal


def activated(tables: Sequence[tuple[dict[str, Any], Source]], allowed: bool | None) -> tuple[Plugin, ...]:
    """The plugins that run, loaded, with their rules in this context; none where they are not ``allowed``.  The nearest
    of the files that name some counts.

    Raises :class:`ConfigurationError`, also where nobody said whether code of the repository may run.
    """
    given, source = [table for table in tables if "plugins" in table[0]][-1]
    key = Key(("plugins",), source)
    plugins: list[Plugin] = []
    for name in given["plugins"] if allowed is not False else ():
        try:
            plugins.append(_plugin(name, key, allowed))
            activate(plugins)
        except PluginError as error:
            raise key.error(str(error), name) from None
    activate(plugins, left_out=len(plugins) < len(given["plugins"]))
    return tuple(plugins)


def _plugin(name: str, key: Key, allowed: bool | None) -> Plugin:
    """A file of the repository, or what is installed under a name."""
    if name.endswith(".py"):
        path = Path(file_in_repository(name, key))
        if not allowed:
            raise PluginError(refusal(name))
        return load_file(path, name)
    point = entry_point(name)
    if not allowed and belongs_to(places_of(point), repository_of(Path(key.base))):
        raise PluginError(refusal(name))
    return load_installed(point)
