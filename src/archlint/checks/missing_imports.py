"""API006: imports of the workspace's own Python code that find nothing."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_others
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding
from archlint.packaging.missing_imports import MissingImport, missing_imports
from archlint.suggestions import meant

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("API006", scope=Scope.CODE)
def missing_import(system: System, options: Options) -> Iterator[Finding]:
    """Imports of modules, and of names of modules, that the workspace would have and does not."""
    if system.workspace is not None:
        for missing in missing_imports(system.workspace):
            yield _finding(missing, system.workspace.package_of(missing.place.file) or "")


def _finding(missing: MissingImport, package: str) -> Finding:
    module, name = missing.module, missing.name
    if missing.beside:
        message = f"'{module}' is not found once a console script imports this file: its folder is not on Python's path"
        help = f"write `from {missing.beside} import …`"
        help += f", and give {missing.without_init} an __init__.py" if missing.without_init else ""
    elif missing.by_launch:
        message = f"'{module}' is not found: launch loads this file by its path, and its folder is not on Python's path"
        help = "move the module into the Python package of the workspace, and import it from there"
    elif missing.outside:
        message = f"'{module}' is not found: its file lies outside of every ROS package, so that no build installs it"
        help = "move the module into a Python package that a setup.py installs, and import it from there"
    elif missing.present:
        top = module.partition(".")[0]
        own = "." not in module or top == missing.present.partition(".")[0]
        absent = f"module {module}" if own else f"package {top}"
        message = f"there is no {absent}: the import fails; the module is {missing.present}"
        help = f"write `from {missing.present} import …`"
    elif missing.interfaces:
        message = f"package {module} has '{name}' in {missing.interfaces}: the import fails with an ImportError"
        help = f"write `from {missing.interfaces} import {name}`"
    elif name:
        message = f"{module} has no '{name}': the import fails with an ImportError"
        help = f"define {name} there, or import what there is"
    else:
        message = f"there is no module {module}: the import fails{meant(missing.near)}"
        help = f"import {missing.near}" if missing.near else "correct the name, or add the file"
        help = f"write `from {missing.near} import {', '.join(missing.names)}`" if missing.names else help
    kind = "beside" if missing.beside else "present" if missing.present else "outside" if missing.outside else ""
    kind = f"interfaces of {module}" if missing.interfaces else kind
    top = module.partition(".")[0]
    if missing.near.partition(".")[0] not in ("", top):
        kind = f"slip of {top}"  # whoever writes it right in one line, does so in all
    return finding(
        "API006",
        missing.place,
        message,
        help=help,
        identity=(module, name),
        group=(package, kind) if kind else (package, module, name),
        meant=missing.near,
    )


@folds("API006")
def missing_in_one_package(findings: Sequence[Finding]) -> Finding:
    """The first import of something in a package, for all of them: who wrote one so has written all so."""
    inside = "file" if len({finding.place.file for finding in findings}) == 1 else "package"
    return with_others(findings, f"another import of the {inside} does", f"more imports of the {inside} do", "the same")


__all__ = ["missing_import", "missing_in_one_package"]
