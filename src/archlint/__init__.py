"""archlint: the architecture linter and graph analyzer for ROS 2.

For Python programs, the most used names of :mod:`archlint.api` are here, too.  They are imported where they are asked
for, since the command starts with this module; type checkers read ``__init__.pyi``.
"""

__version__ = "0.1.0"

_OF_API = frozenset({"ArchlintError", "CheckResult", "Finding", "Graph", "Severity", "Workspace", "load"})


def __getattr__(name: str) -> object:
    if name not in _OF_API:  # that of a module, most of the time
        raise AttributeError(f"module 'archlint' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module("archlint.api"), name)
