"""Files and folders that code looks for in the share folder of a package, and that the build of it leaves out."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once_for_each_file
from archlint.packaging.uninstalled_files import files_told_already, mended_at, understood
from archlint.place import Place
from archlint.python_code.class_chains import files_with
from archlint.syntax import facts
from archlint.syntax.parts import everything_in
from archlint.syntax.walk import called_name

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.installed import Installs

_SHARE = "get_package_share_directory"
_ASKS = frozenset({"exists", "isfile", "is_file", "lexists"})
"""What code asks that can do without a file."""


@dataclass(frozen=True)
class DataLeftOut:
    """A file or folder, by its path below the folder of a package, and where code names it.  ``place`` is where the
    build should install it."""

    package: str
    file: str
    named_at: Place
    place: Place
    folder: bool = False


def data_left_out(workspace: WorkspaceIndex) -> Iterator[DataLeftOut]:
    """Each such file that is in the source, of a package whose build is understood, with each place that names it."""
    for path in _asking(workspace):
        for package, file, span in _named(workspace, path) or ():
            installs = understood(workspace).get(package)
            place = None if installs is None else mended_at(workspace, installs)
            if installs is None or place is None or installs.may_install(file):
                continue
            if _is_left_out(workspace, installs, file):
                yield DataLeftOut(package, file, Place(path, *span), place)
            elif _is_folder_left_out(workspace, installs, file):
                yield DataLeftOut(package, file, Place(path, *span), place, folder=True)


def _asking(workspace: WorkspaceIndex) -> Iterator[str]:
    """The Python files in use that ask for a share folder, launch files among them."""
    launch_files = [
        path for path in workspace.launch_files.all() if path.endswith(".py") and workspace.code.mentions(path, _SHARE)
    ]
    for path in dict.fromkeys((*files_with(workspace, _SHARE), *launch_files)):
        if not is_aside(workspace, path):
            yield path


def _is_left_out(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    sources = installs.source_of(f"share/{installs.package}/{file}")
    path = posixpath.normpath(posixpath.join(installs.folder, file))
    there = workspace.tree.is_file(path) and path not in files_told_already(workspace)
    return there and not any(map(workspace.tree.is_file, sources))


def _is_folder_left_out(workspace: WorkspaceIndex, installs: Installs, folder: str) -> bool:
    """Whether nothing of a folder of the source is installed, and nothing that is comes to where it is looked for."""
    path = posixpath.normpath(posixpath.join(installs.folder, folder))
    files = [*workspace.tree.files_below(path)] if path != posixpath.normpath(installs.folder) else []
    if all(posixpath.basename(file) in _MEANS_NOTHING for file in files):
        return False
    told, target = files_told_already(workspace), f"share/{installs.package}/{posixpath.normpath(folder)}"
    rows = (posixpath.normpath(row.destination) for row in installs.files)
    if any(where == target or where.startswith(f"{target}/") for where in rows):
        return False
    if any(workspace.tree.is_folder(source) for source in installs.source_of(target)):
        return False
    return not any(file in told or any(installs.places_of(file)) for file in files)


_MEANS_NOTHING = frozenset({".gitkeep", ".gitignore", "README.md", "CMakeLists.txt", "package.xml"})
"""What keeps a folder in a repository, or is of another package."""


@once_for_each_file
def _named(file_facts: facts.Facts) -> list[tuple[str, str, facts.Span]]:
    """The files that a module names by literal parts behind the share folder of a package: that package, the path, the
    place; nothing where it asks whether some file is there."""
    calls = [*everything_in(file_facts.body, facts.Call)]
    if not _ASKS.isdisjoint(map(called_name, calls)):
        return []
    texts_of = _only_values(file_facts, lambda value: value.text)
    shares = _only_values(file_facts, lambda value: _share(value, texts_of))
    rows = []
    for call in calls:
        parts = [argument.value for argument in call.args if not argument.star and argument.keyword is None]
        if called_name(call) != "join" or len(parts) != len(call.args) or len(parts) < 2:
            continue
        package = shares.get(parts[0].variable) or _share(parts[0], texts_of)
        texts = [part.text for part in parts[1:]]
        if package is not None and None not in texts:
            rows.append((package, posixpath.normpath("/".join(filter(None, texts))), call.span))
    return rows


def _share(value: facts.Base | None, texts_of: Mapping[str, str]) -> str | None:
    """The package whose share folder an expression is, alone or as the only part of a path."""
    match value:
        case facts.Call(args=[facts.Argument(value=inner)]) if called_name(value) == "join":
            return _share(inner, texts_of)
        case facts.Call(func=function, args=[facts.Argument(value=package)]) if function.last_name == _SHARE:
            return package.text or texts_of.get(package.variable)
    return None


def _only_values(file_facts: facts.Facts, meant: Callable[[facts.Expr], str | None]) -> dict[str, str]:
    """The variables that only ever have one value of a kind."""
    values: dict[str, set[str | None]] = {}
    for part in everything_in(file_facts.body):
        match part:
            case facts.Assign(targets=targets, value=value):
                for target in targets:
                    values.setdefault(target.variable, set()).add(meant(value))
            case facts.Param(name=name):
                values.setdefault(name, set()).add(None)
    return {name: text for name, (text, *others) in values.items() if name and text and not others}


__all__ = ["DataLeftOut", "data_left_out"]
