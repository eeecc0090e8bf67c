"""Plugins that are installed: entry points of the group ``archlint.rules``, each with the name of a module."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.metadata import EntryPoint, entry_points
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

from archlint.disk import walk
from archlint.plugins.loading import plugin_of
from archlint.plugins.model import Plugin, PluginError
from archlint.suggestions import did_you_mean

GROUP = "archlint.rules"


def entry_point(name: str) -> EntryPoint:
    """The entry point with a name.  Raises :class:`PluginError` where none has it, or several."""
    known = {point.name: point for point in entry_points(group=GROUP)}
    if name not in known:
        near = did_you_mean(name, known, quote="`")
        raise PluginError(f"no plugin of that name is installed: no package has it as an entry point of {GROUP}{near}")
    return known[name]


def places_of(point: EntryPoint) -> list[str]:
    """Where the code of an entry point lies, found without running any of it."""
    spec = find_spec(point.module.partition(".")[0])
    if spec is None:
        return []
    return [*([spec.origin] if spec.origin else []), *(spec.submodule_search_locations or ())]


def load_installed(point: EntryPoint) -> Plugin:
    """The plugin of an entry point, whose module is imported.  Raises :class:`PluginError`."""
    try:
        module = point.load()
    except (Exception, SystemExit) as error:
        raise PluginError(f"{point.name}: {point.value}: {type(error).__name__}: {error}") from None
    if not isinstance(module, ModuleType) or module.__file__ is None:
        raise PluginError(f"{point.name}: {point.value} must name a module with rules")
    file = Path(module.__file__)
    parts = {path.relative_to(file.parent).as_posix(): path.read_bytes() for path in _files(file)}
    return plugin_of(module, point.name, file.parent, parts)


def _files(file: Path) -> Iterator[Path]:
    """What a change of counts as a change of the plugin: the module, or all modules of its package."""
    yield file
    if (file.parent / "__init__.py").is_file():
        for folder, _, names in walk(file.parent):
            yield from (Path(folder, name) for name in sorted(names) if name.endswith(".py"))
