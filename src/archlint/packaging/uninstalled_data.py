"""Files of a package that nodes open by its share folder and that the build of the package leaves out."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_aside
from archlint.analysis.kept import once_for_each_file
from archlint.packaging.uninstalled_files import mended_at, understood
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
    """A file, by its path below the folder of a package, and where code names it.  ``place`` is where the build should
    install it."""

    package: str
    file: str
    named_at: Place
    place: Place


def data_left_out(workspace: WorkspaceIndex) -> Iterator[DataLeftOut]:
    """Each such file that is in the source, of a package whose build is understood, with each place that names it."""
    for path in files_with(workspace, _SHARE):
        if is_aside(workspace, path) or workspace.launch_files.can_be_launched(path):
            continue  # what a launch file names is followed as launch does
        for package, file, span in _named(workspace, path) or ():
            installs = understood(workspace).get(package)
            place = None if installs is None else mended_at(workspace, installs)
            if installs is not None and place is not None and _is_left_out(workspace, installs, file):
                yield DataLeftOut(package, file, Place(path, *span), place)


def _is_left_out(workspace: WorkspaceIndex, installs: Installs, file: str) -> bool:
    sources = installs.source_of(f"share/{installs.package}/{file}")
    there = workspace.tree.is_file(posixpath.normpath(posixpath.join(installs.folder, file)))
    return there and not any(map(workspace.tree.is_file, sources)) and not installs.may_install(file)


@once_for_each_file
def _named(file_facts: facts.Facts) -> list[tuple[str, str, facts.Span]]:
    """The files that a module names by literal parts behind the share folder of a package: that package, the path, the
    place; nothing where it asks whether some file is there."""
    calls = [*everything_in(file_facts.body, facts.Call)]
    if not _ASKS.isdisjoint(map(called_name, calls)):
        return []
    shares = _shares(file_facts)
    rows = []
    for call in calls:
        parts = [argument.value for argument in call.args if not argument.star and argument.keyword is None]
        if called_name(call) != "join" or len(parts) != len(call.args) or len(parts) < 2:
            continue
        package = shares.get(parts[0].variable) or _share(parts[0])
        texts = [part.text for part in parts[1:]]
        if package is not None and None not in texts:
            rows.append((package, posixpath.normpath("/".join(filter(None, texts))), call.span))
    return rows


def _share(value: facts.Base | None) -> str | None:
    """The package whose share folder an expression is."""
    match value:
        case facts.Call(func=function, args=[facts.Argument(value=facts.Literal(value=str(package)))]):
            return package if function.last_name == _SHARE else None
    return None


def _shares(file_facts: facts.Facts) -> dict[str, str]:
    """The variables that are only ever the share folder of one package."""
    values: dict[str, set[str | None]] = {}
    for part in everything_in(file_facts.body):
        match part:
            case facts.Assign(targets=targets, value=value):
                for target in targets:
                    values.setdefault(target.variable, set()).add(_share(value))
            case facts.Param(name=name):
                values.setdefault(name, set()).add(None)
    return {name: package for name, (package, *others) in values.items() if name and package and not others}


__all__ = ["DataLeftOut", "data_left_out"]
