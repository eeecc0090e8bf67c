"""Small trees on disk, written down as they would be listed."""

from __future__ import annotations

import textwrap
from pathlib import Path

from archlint.workspace.discovery import find
from archlint.workspace.model import SourceFile, Workspace


def plant(folder: Path, files: dict[str, str]) -> Path:
    """Write files by their paths; a path that ends in ``/`` is an empty folder."""
    for path, text in files.items():
        target = folder / path
        if path.endswith("/"):
            target.mkdir(parents=True)
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(textwrap.dedent(text))
    return folder


def manifest(name: str, build_type: str = "ament_python", more: str = "") -> str:
    export = f"<export><build_type>{build_type}</build_type></export>"
    return f"<package format='3'><name>{name}</name>{more}{export}</package>\n"


def look(folder: Path, *paths: str, exclude: tuple[str, ...] = ()) -> Workspace:
    """What a user in ``folder`` gets for ``paths`` (without any, for the folder)."""
    return find(paths, exclude=exclude, working_directory=str(folder))


def found(folder: Path, *paths: str, exclude: tuple[str, ...] = ()) -> list[str]:
    """The files that are checked, as shown."""
    return [file.relative for file in look(folder, *paths, exclude=exclude).files if not file.context]


def file_in(workspace: Workspace, relative: str) -> SourceFile:
    [file] = [file for file in workspace.files if file.relative == relative]
    return file
