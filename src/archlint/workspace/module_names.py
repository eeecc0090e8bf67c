"""The dotted name under which Python imports a file."""

from __future__ import annotations

import os
from functools import lru_cache

from archlint.workspace.model import Package


def module_name(path: str, package: Package | None) -> str:
    """``pkg/pkg/sub/node.py`` → ``pkg.sub.node``.

    The name starts below the first folder without an ``__init__.py``; in an ament_python package a folder of
    the package's own name counts as a package even without one, as colcon installs it.
    """
    folder, file = os.path.split(path)
    stem = file.removesuffix(".py")
    parts = [] if stem == "__init__" else [stem]
    while _is_python_package(folder) or _is_named_package(folder, package):
        folder, name = os.path.split(folder)
        parts.insert(0, name)
    return ".".join(parts) or stem


def _is_named_package(folder: str, package: Package | None) -> bool:
    if package is None or not folder.startswith(package.root + os.sep):
        return False
    inside = os.path.relpath(folder, package.root).split(os.sep)
    return package.name in inside and package.build_type == "ament_python" and inside[0] == package.name


@lru_cache(maxsize=100_000)
def _is_python_package(folder: str) -> bool:
    return os.path.isfile(os.path.join(folder, "__init__.py"))
