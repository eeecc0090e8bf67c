"""Stand-in for ament_index_python: the share folder of a package is its folder in the repository."""

from .packages import (
    PackageNotFoundError,
    get_package_prefix,
    get_package_share_directory,
    get_package_share_path,
    get_packages_with_prefixes,
)

__all__ = [
    "PackageNotFoundError", "get_package_prefix", "get_package_share_directory", "get_package_share_path",
    "get_packages_with_prefixes",
]  # fmt: skip
