"""Stand-in for ament_index_python.packages."""

from __future__ import annotations

import tempfile
from pathlib import Path

folders: dict[str, str] = {}
"""The folder of each package of the repository, filled in by the run."""


class PackageNotFoundError(KeyError):
    """No such package."""


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """The folder of the package; one that is not in the repository has an empty folder."""
    return folders.get(package_name) or str(Path(tempfile.gettempdir()) / "share" / str(package_name))


def get_package_share_path(package_name: str, print_warning: bool = True) -> Path:
    """The folder of the package."""
    return Path(get_package_share_directory(package_name))


def get_package_prefix(package_name: str) -> str:
    """The folder of the package."""
    return get_package_share_directory(package_name)


def get_packages_with_prefixes() -> dict[str, str]:
    """The packages of the repository."""
    return dict(folders)
