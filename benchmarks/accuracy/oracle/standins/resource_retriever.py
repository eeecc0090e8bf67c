"""Stand-in for resource_retriever: a package's files lie in its folder in the repository."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from ament_index_python.packages import get_package_share_directory


def get_filename(url: Any, use_protocol: bool = True) -> str:
    """The file that a package:// URL names."""
    package, _, rest = str(url).removeprefix("package://").partition("/")
    path = str(Path(get_package_share_directory(package)) / rest)
    return f"file://{path}" if use_protocol else path


def get(url: Any) -> bytes:
    """The content of what a package:// URL names."""
    return Path(get_filename(url, use_protocol=False)).read_bytes()
