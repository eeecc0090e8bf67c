"""A configuration for files that are shown from another folder than the working directory."""

from __future__ import annotations

import os
from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from archlint.architecture import Contract
    from archlint.config.settings import Settings
    from archlint.globs import Glob


def seen_from(folder: str, settings: Settings) -> Settings:
    """The settings with patterns for paths from ``folder``, an absolute path, and with places that are such paths."""

    def glob(pattern: Glob) -> Glob:
        return replace(pattern, seen_from=folder)

    def contract(declared: Contract) -> Contract:
        file = os.path.relpath(declared.place.file, folder).replace(os.sep, "/")
        return replace(declared, place=replace(declared.place, file=file))

    return replace(
        settings,
        exclude=tuple(map(glob, settings.exclude)),
        launch=tuple(map(glob, settings.launch)),
        per_file_ignores={glob(pattern): codes for pattern, codes in settings.per_file_ignores.items()},
        contracts=tuple(map(contract, settings.contracts)),
    )
