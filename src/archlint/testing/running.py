"""Runs what the pages of rules promise."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextvars import copy_context
from dataclasses import replace
from pathlib import Path

from archlint.config.selection import Layer
from archlint.config.settings import Settings, load
from archlint.engine import baseline_file
from archlint.engine.pipeline import check
from archlint.engine.request import Request
from archlint.observed.read import read
from archlint.plugins.installed import entry_point, load_installed
from archlint.plugins.loading import load_file
from archlint.plugins.model import Plugin, activate
from archlint.records import dataclass
from archlint.rulebook import OFF, rules
from archlint.testing.pages import Example, read_page

Marked = tuple[str, int, str]
"""A file, a line from 1, and the code of a rule."""


@dataclass(frozen=True)
class PageExample:
    """One example on a page of a plugin."""

    plugin: Plugin
    example: Example

    def __str__(self) -> str:
        return self.example.id

    @property
    def expected(self) -> list[Marked]:
        """The lines that are marked with rules of the plugin."""
        return sorted(row for row in self.example.expected if row[2] in self.plugin.rules)

    def found(self, folder: Path) -> list[Marked]:
        """What the rules of the plugin find once the files of the example lie in ``folder``."""
        rows = findings_of(self.example, folder, [self.plugin])
        return [row for row in rows if row[2] in self.plugin.rules]


def examples_of(plugin: str | os.PathLike[str]) -> list[PageExample]:
    """The examples on the pages of a plugin: of a file, or of one that is installed, by its name.

    Raises :class:`archlint.plugins.model.PluginError`.
    """
    name = os.fspath(plugin)
    loaded = load_file(Path(name), name) if name.endswith(".py") else load_installed(entry_point(name))
    return [
        PageExample(loaded, example) for code, rule in loaded.rules.items() for example in read_page(code, rule.body)
    ]


def findings_of(example: Example, folder: Path, plugins: Sequence[Plugin] = ()) -> list[Marked]:
    """What a check of an example finds, laid out in ``folder``.  Its configuration is its own; a rule that is off by
    default is on for its page."""
    return copy_context().run(_findings_of, example, folder, plugins)


def _findings_of(example: Example, folder: Path, plugins: Sequence[Plugin]) -> list[Marked]:
    example.write(folder)
    if plugins:
        activate(plugins)
    settings = _settings(example, folder, plugins)
    baseline = None if settings.baseline is None else baseline_file.read(Path(settings.baseline))
    observed = read(str(folder / "observed.json")) if "observed.json" in example.files else None
    request = Request(
        (str(folder),),
        settings,
        cached=False,
        jobs=1,
        folder=str(folder),
        observed=observed,
        baseline=baseline,
        fixes=False,
    )
    rows = [(finding.place.file, finding.place.line, finding.code) for finding in check(request).findings]
    # A recording and a baseline are named as they were given: by absolute paths.
    return sorted(
        (os.path.relpath(folder / file, folder).replace(os.sep, "/"), line, code) for file, line, code in rows
    )


def _settings(example: Example, folder: Path, plugins: Sequence[Plugin]) -> Settings:
    settings = load(folder, plugins=False)
    settings = replace(settings, plugins=tuple(plugin.name for plugin in plugins), running_plugins=tuple(plugins))
    if rules()[example.page_code].default != OFF:
        return settings
    return replace(settings, layers=(*settings.layers, Layer(extend_select=(example.page_code,))))
