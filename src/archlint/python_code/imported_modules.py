"""Which module of the workspace a name means that a file imports: ``words`` behind ``from robot import words``."""

from __future__ import annotations

import posixpath
from collections import Counter
from typing import TYPE_CHECKING

from archlint.python_code.offered_names import may_make_names, own_names, stars
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import once_for

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


@once_for
def bindings_of(code: facts.Facts) -> Counter[str]:
    """How often a file binds each name, in whichever scope."""
    return Counter(names_bound(code.body))


@once_for
def imported_once(code: facts.Facts) -> frozenset[str]:
    """The names that imports at the top level of a file bind, and nothing else does."""
    names: set[str] = set()
    for statement in code.body if not stars(code) else ():
        match statement:
            case facts.Import(module=module, alias=alias) if alias or "." not in module:
                names.add(alias or module)
            case facts.ImportFrom(names=imported):
                names.update(bound for _, bound in imported)
    return frozenset(name for name in names if bindings_of(code)[name] == 1)


def module_meant_by(workspace: WorkspaceIndex, file: str, name: str) -> str | None:
    """The file of the module of the workspace that a name means in a file."""
    code = workspace.facts_at(file)
    for statement in () if code is None or name not in imported_once(code) else code.body:
        match statement:
            case facts.Import(module=module, alias=alias) if (alias or module) == name:
                return _file_of_module(workspace, file, module, 0)
            case facts.ImportFrom(module=module, level=level, names=names) if any(bound == name for _, bound in names):
                own = next(own for own, bound in names if bound == name)
                package = path_of(workspace, file, module, level)
                if package is not None and _may_bind(workspace, package, own):
                    return None
                return _file_of_module(workspace, file, f"{module}.{own}" if module else own, level)
    return None


def _may_bind(workspace: WorkspaceIndex, package: str, name: str) -> bool:
    """Whether the ``__init__.py`` of a package may have something else by the name of a module."""
    code = workspace.facts_at(package)
    if code is None or stars(code) or may_make_names(code):
        return True
    return not own_names(code).isdisjoint({name, "__getattr__"})


def _file_of_module(workspace: WorkspaceIndex, file: str, module: str, level: int) -> str | None:
    """The file of exactly the module that an import asks for."""
    path = path_of(workspace, file, module, level)
    return path if path is not None and posixpath.basename(path) == f"{module.rpartition('.')[2]}.py" else None


def path_of(workspace: WorkspaceIndex, file: str, module: str, level: int) -> str | None:
    """The file that an import means wherever it is imported, or that lies beside this one."""
    path = workspace.code.path_of_import(file, module, level)
    if path is not None and posixpath.dirname(path) == posixpath.dirname(file):
        return path
    return workspace.code.file_of_import(file, module, level)


__all__ = ["bindings_of", "imported_once", "module_meant_by", "path_of"]
