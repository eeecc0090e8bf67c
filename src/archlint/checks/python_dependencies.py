"""PKG009: modules of Python that package.xml does not ask for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.dependency_uses import brought_by, uses_by_package
from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related
from archlint.packaging.python_dependencies import ModuleUse, modules_to_declare
from archlint.suggestions import listed

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.workspace.model import Package

_SHOWN = 5
"""How many imports are related."""


@rule("PKG009", scope=Scope.WORKSPACE, taste=True)
def undeclared_python_module(system: System, options: Options) -> Iterator[Finding]:
    """Imports of modules that rosdep knows, in packages that ask for none of them."""
    workspace = workspace_of(system)
    if workspace is None:
        return
    asked_for = {folder: {use.needed for use in uses} for folder, uses in uses_by_package(workspace, options).items()}
    rows = modules_to_declare(workspace, lambda name: brought_by(name, workspace), asked_for)  # PKG001 tells of these
    for folder in sorted(rows):
        package, uses = rows[folder]
        kept = [use for use in sorted(uses) if not {use.module, use.key} & {*options.external}]
        if kept:
            yield _undeclared(package, kept)


def _undeclared(package: Package, uses: list[ModuleUse]) -> Finding:
    first = {use.module: use for use in reversed(uses)}
    modules = sorted(first)
    what = f"'{modules[0]}'" if len(modules) == 1 else f"{len(modules)} modules: {listed(modules)}"
    manifest = Place(package.manifest.relative, 1, 1, 1, 1)
    return finding(
        "PKG009",
        uses[0].place if all(use.unused for use in uses) else manifest,  # where it is mended
        f"package '{package.name}' imports {what}, which its package.xml does not declare: rosdep does not install "
        f"{'it' if len(modules) == 1 else 'them'}",
        help=_help(uses),
        related=[Related(first[module].place, f"'{module}' is imported here") for module in modules[:_SHOWN]],
        identity=(package.name, *modules),
    )


def _help(uses: Sequence[ModuleUse]) -> str:
    """What to declare, and what not to import at all."""
    used = {use.module for use in uses if not use.unused}
    keys = sorted({use.key for use in uses if use.module in used})
    idle = sorted({f"'{use.module}'" for use in uses} - {f"'{module}'" for module in used})
    cures = [f"add {''.join(f'<exec_depend>{key}</exec_depend>' for key in keys)}"] if keys else []
    cures += [f"remove the import of {listed(idle)}, which nothing uses"] if idle else []
    return ", and ".join(cures)


__all__ = ["undeclared_python_module"]
