"""What a file is, from its name and the folder it lies in."""

from __future__ import annotations

import os
import re
import stat

from archlint.workspace.model import SourceKind

_BY_NAME: dict[str, SourceKind] = {
    "package.xml": "package_xml",
    "setup.py": "setup_py",
    "setup.cfg": "setup_cfg",
    "CMakeLists.txt": "cmake",
    "pyproject.toml": "pyproject",
}
_INTERFACES = frozenset({"msg", "srv", "action"})

CPP_SOURCES = frozenset({"cpp", "cc", "cxx"})
"""Of files that are compiled on their own."""
CPP_SUFFIXES = CPP_SOURCES | {"hpp", "hh", "hxx", "h"}


def is_cpp(path: str) -> bool:
    """Whether a file is C++, by its name."""
    return path.rpartition(".")[2] in CPP_SUFFIXES


_SCRIPT_FOLDERS = frozenset({"scripts", "script", "bin", "nodes"})
"""Where scripts lie that lost their permission to run, say on a file system that knows none."""

_PYTHON_SHEBANG = re.compile(rb"#!.*\bpython[0-9.]*\b")
_SHEBANG_BYTES = 64


def kind_of(name: str, folder: str, folder_is_module: bool = False) -> SourceKind | None:
    """The kind of a file with a suffix; None for what no floor reads.

    ``folder`` is the name of the folder it lies in; ``folder_is_module`` says whether that is a Python
    package.  Launch files are those that ``ros2 launch`` offers by name, and what lies in a folder ``launch``.
    """
    stem, dot, suffix = name.rpartition(".")
    if not dot or not stem:
        return None
    if name in _BY_NAME:
        return _BY_NAME[name]
    if name.endswith(".nodl.xml"):
        return "declaration"
    in_launch_folder = folder == "launch" and not folder_is_module
    if suffix in CPP_SUFFIXES:
        return "cpp"
    if suffix == "py":
        return "launch_python" if in_launch_folder or name.endswith("launch.py") else "python"
    if suffix == "launch" or (suffix == "xml" and (in_launch_folder or name.endswith("launch.xml"))):
        return "launch_xml"
    if suffix in ("yaml", "yml"):
        return "launch_yaml" if stem.endswith("launch") else "parameters"
    return "interface" if suffix in _INTERFACES and folder == suffix else None


def may_be_script(name: str, folder: str, mode: int) -> bool:
    """Whether a file is worth a look for a shebang: no suffix, and executable or where scripts lie."""
    return "." not in name and (folder in _SCRIPT_FOLDERS or bool(mode & stat.S_IXUSR))


def has_python_shebang(path: str) -> bool:
    """Whether the first line of a regular file hands it to Python; False where it cannot be read."""
    try:
        # Between the look at the mode and this a pipe may have taken the file's place: do not wait for it.
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0))
    except OSError:
        return False
    try:
        return _PYTHON_SHEBANG.match(os.read(descriptor, _SHEBANG_BYTES)) is not None
    except OSError:
        return False
    finally:
        os.close(descriptor)
