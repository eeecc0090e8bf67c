"""The dotted names under which Python imports the files of a workspace."""

from __future__ import annotations

import os
from collections.abc import Mapping, Set


class ModuleNames:
    """Names the modules of one ROS package, or of the files in none.

    ``root`` is the folder of the ROS package, above which no dotted name reaches, ``package`` its name; both
    are None for files in no package.  ``inits`` are the folders known to hold an ``__init__.py``;
    ``installed_as`` maps folders and files that are installed under a name of their own to that name, which may have
    dots.
    """

    def __init__(
        self,
        root: str | None,
        package: str | None,
        inits: Set[str],
        installed_as: Mapping[str, str] | None = None,
    ) -> None:
        self.package = package
        self._root = root
        self._inits = inits
        self._installed_as = installed_as or {}
        self._known: dict[str, tuple[str, ...]] = {}

    def module(self, path: str) -> str | None:
        """``pkg/pkg/sub/node.py`` → ``pkg.sub.node``; None where no import statement can reach a file."""
        if path in self._installed_as:
            return self._installed_as[path]
        folder, name = os.path.split(path)
        stem, dot, _ = name.rpartition(".")
        if not dot:  # a script, started by its path
            return name if name.isidentifier() else None
        packages = self._packages(folder)
        if stem == "__init__":
            return ".".join(packages) or None
        return ".".join((*packages, stem)) if stem.isidentifier() else None

    def _packages(self, folder: str) -> tuple[str, ...]:
        """The names of the Python packages that a file in ``folder`` is in, the outermost first."""
        inner: list[str] = []
        while folder not in self._known:
            outermost = self._outermost(folder)
            if outermost is None:
                inner.append(folder)
                folder = os.path.dirname(folder)
            else:
                self._known[folder] = outermost
        around = self._known[folder]
        for folder in reversed(inner):
            # A folder inside a package is one too, with __init__.py or without.
            is_package = around or self._is_package(folder) or self._is_own_folder(folder)
            around = self._known[folder] = (*around, os.path.basename(folder)) if is_package else ()
        return around

    def _outermost(self, folder: str) -> tuple[str, ...] | None:
        """The packages of a folder that is in none of the folders above it; None where those decide."""
        if folder in self._installed_as:
            return (self._installed_as[folder],)
        return () if folder == self._root or not os.path.basename(folder).isidentifier() else None

    def _is_package(self, folder: str) -> bool:
        if folder in self._inits:
            return True
        # Outside of ROS packages nothing says where to stop, and files above what was asked for count too.
        return self._root is None and os.path.isfile(os.path.join(folder, "__init__.py"))

    def _is_own_folder(self, folder: str) -> bool:
        """Whether this is the folder named as the package, which is installed even without ``__init__.py``."""
        parent, name = os.path.split(folder)
        return name == self.package and self._root is not None and parent in (self._root, f"{self._root}/src")
