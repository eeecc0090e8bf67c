"""Folders that are not looked into: other tools' folders, marked ones, and what builds leave behind."""

from __future__ import annotations

from collections.abc import Set

MARKERS = ("COLCON_IGNORE", "AMENT_IGNORE")
_NEVER = frozenset({"__pycache__", "node_modules", "venv", "site-packages"})

COLCON_FOLDERS = frozenset({"build", "install", "log"})
_COLCON_TRACES = frozenset(
    {
        ".built_by",
        ".colcon_install_layout",
        "latest",
        "latest_build",
        "local_setup.bash",
        "local_setup.sh",
        "setup.bash",
        "_local_setup_util_sh.py",
    }
)
_SOURCE_TRACES = frozenset({"__init__.py", "package.xml", "setup.py"})


def is_pruned_by_name(name: str) -> bool:
    """Whether a folder is left out whatever is in it."""
    return name.startswith(".") or name in _NEVER or name.endswith(".egg-info")


def is_pruned_by_content(name: str, names: Set[str], siblings: Set[str]) -> bool:
    """Whether the folder ``name``, which has entries called ``names``, is left out.

    ``siblings`` are the entries of the folder around it.
    """
    if not names.isdisjoint(MARKERS) or "pyvenv.cfg" in names:
        return True
    if name == "devel":  # catkin's, which links to the folders that its user has
        return not names.isdisjoint(_COLCON_TRACES | {".catkin"}) and names.isdisjoint(_SOURCE_TRACES)
    return name in COLCON_FOLDERS and _is_build_output(name, names, siblings)


def _is_build_output(name: str, names: Set[str], siblings: Set[str]) -> bool:
    """Whether ``build``, ``install`` or ``log`` is what a build left, and not a folder of that name.

    Without a trace of colcon it is recognised by its place: beside ``src`` of a workspace, or, with the copies that
    setuptools makes, beside a ``setup.py``.
    """
    if not names.isdisjoint(_SOURCE_TRACES):
        return False
    if not names.isdisjoint(_COLCON_TRACES):
        return True
    if "setup.py" in siblings and name == "build":
        return "lib" in names or any(entry.startswith("bdist.") for entry in names)
    return "src" in siblings and "package.xml" not in siblings
