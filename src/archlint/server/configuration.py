"""The configuration of a workspace, as it is on the disk or in the editor, and what is wrong with it."""

from __future__ import annotations

import os
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from archlint.config.files import FILE_NAMES, MAX_BYTES
from archlint.config.settings import ConfigurationError, Settings, load
from archlint.disk import read_regular
from archlint.engine import baseline_file
from archlint.plugins.permission import VARIABLE
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.engine.known import Baseline, Entry
    from archlint.live.buffers import Buffers


@dataclass(frozen=True)
class Mistake:
    """What is wrong with a file that configures, by its absolute path; ``line`` counts from 1."""

    path: str
    line: int
    message: str


@dataclass(frozen=True)
class Configuration:
    """What holds now.  Where a file cannot be used, the settings are those that could be read before."""

    settings: Settings = field(default_factory=Settings)
    baseline: Baseline | None = None
    mistakes: tuple[Mistake, ...] = ()

    def again(self, root: str, buffers: Buffers) -> Configuration:
        """As it is now, for the workspace at ``root``."""

        def read(path: Path) -> bytes:
            buffer = buffers.get(os.path.normpath(path))
            return read_regular(path, MAX_BYTES) if buffer is None else buffer.data

        try:
            settings = load(Path(root), read=read, plugins=os.environ.get(VARIABLE) == "1")
        except ConfigurationError as error:
            mistake = Mistake(os.path.abspath(error.file or root), error.line or 1, error.message)
            return replace(self, mistakes=(mistake,))
        try:
            baseline = None if settings.baseline is None else _baseline(Path(settings.baseline), root)
        except baseline_file.BaselineError as error:
            mistake = Mistake(os.path.normpath(settings.file or root), 1, f"`baseline`: {error}")
            return Configuration(settings, self.baseline, (mistake,))
        return Configuration(settings, baseline)

    def is_read_from(self, path: str) -> bool:
        """Whether a file, by its absolute path, may decide what holds."""
        baseline = self.settings.baseline
        plugins = (file for plugin in self.settings.running_plugins for file in plugin.files)
        named = (*self.settings.read, *plugins, *([] if baseline is None else [baseline]))
        return os.path.basename(path) in FILE_NAMES or any(os.path.normpath(file) == path for file in named)


def _baseline(path: Path, root: str) -> Baseline:
    """What a baseline holds of a run whose findings name their files from ``root``: a run takes these names for paths
    from the working directory."""
    baseline = baseline_file.read(path)

    def shown(entry: Entry) -> Entry:
        file = os.path.abspath(os.path.relpath(entry.key.file, root))
        return replace(entry, key=replace(entry.key, file=file))

    return replace(baseline, entries=tuple(map(shown, baseline.entries)))


__all__ = ["Configuration", "Mistake"]
