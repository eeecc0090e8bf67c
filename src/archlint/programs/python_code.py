"""Which Python code a ``setup.py`` installs: ``packages=``, ``package_dir=`` and ``py_modules=``."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from archlint.interpreter.values import DictValue
from archlint.workspace.installed import AbsentFolder, PythonCode

if TYPE_CHECKING:
    from archlint.interpreter.values import Value
    from archlint.libraries.setuptools.setup_run import SetupRun
    from archlint.workspace.installed import Installs

_MAY_ADD = frozenset({"cmdclass", "distclass", "ext_modules", "include_package_data", "package_data"})
"""Keywords that may bring further code into the packages."""


def python_code(installs: Installs, run: SetupRun, keywords: Mapping[str, Value]) -> PythonCode | None:
    """None where ``packages=`` is left out or not known: setuptools then searches, or other files say it."""
    names, modules = _texts(run, keywords.get("packages")), _texts(run, keywords.get("py_modules"))
    folders = _folders(run, keywords.get("package_dir"))
    if run.packages_at is None or names is None or folders is None or not _MAY_ADD.isdisjoint(keywords):
        return None
    places = [_folder(name, folders) for name in names]
    files = [f"{_folder(name, folders)}.py" for name in modules or ()]

    def shown(path: str) -> str:
        return posixpath.normpath(posixpath.join(installs.folder, path))

    absent = _absent(run, shown, names, folders)
    in_vain = () if absent is not None else tuple(n for n in names if not _is_there(run, shown(_folder(n, folders))))
    root = shown(folders[""]) if folders.get("") else ""
    return PythonCode(
        frozenset(map(shown, places)),
        frozenset(map(shown, files)),
        run.packages_at,
        run.searches,
        absent,
        in_vain,
        root,
    )


def _is_there(run: SetupRun, folder: str) -> bool:
    return run.tree is None or any(True for _ in run.tree.files_below(folder))


def _absent(
    run: SetupRun, shown: Callable[[str], str], names: Sequence[str], folders: Mapping[str, str]
) -> AbsentFolder | None:
    """The first folder of ``package_dir=`` that packages are to be in and that is not there.

    Source: ``build_py.check_package`` of setuptools raises "package directory … does not exist".
    """
    place = run.package_dir_at
    if run.tree is None or place is None:
        return None

    for key, folder in folders.items():
        inside = [name for name in names if key in ("", name) or name.startswith(f"{key}.")]
        if inside and not _is_there(run, shown(folder)):
            return AbsentFolder(folder, place, all(_is_there(run, shown(name.replace(".", "/"))) for name in inside))
    return None


def _texts(run: SetupRun, value: Value | None) -> Sequence[str] | None:
    """The texts of a list; None where one is not known, or there may be more."""
    items = None if value is None else value.items(run)
    if items is None or items.open:
        return None
    texts = [item.text for item in items.values if item.text is not None]
    return texts if len(texts) == len(items.values) else None


def _folders(run: SetupRun, value: Value | None) -> Mapping[str, str] | None:
    """``package_dir=``: the folders of packages by name; None where it is not known."""
    if value is None:
        return {}
    if not isinstance(value, DictValue) or value.entries(run).open:
        return None
    rows = [(key.text, folder.text) for key, folder in value.entries(run).entries.values()]
    texts = {name: folder for name, folder in rows if name is not None and folder is not None}
    return texts if len(texts) == len(rows) else None


def _folder(name: str, folders: Mapping[str, str]) -> str:
    """The folder of a package: that of the nearest package around it which has one."""
    parts = name.split(".")
    for end in range(len(parts), -1, -1):
        start = folders.get(".".join(parts[:end]))
        if start is not None:
            return posixpath.join(start, *parts[end:])
    return posixpath.join(*parts)


__all__ = ["python_code"]
