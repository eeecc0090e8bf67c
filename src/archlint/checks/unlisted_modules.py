"""PKG005: modules with a node and ``main()`` that no entry point names."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.checks.packages import workspace_of
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.packaging.unlisted_modules import unlisted_modules

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("PKG005", scope=Scope.WORKSPACE, taste=True, says_if_installed=True)
def module_without_entry_point(system: System, options: Options) -> Iterator[Finding]:
    """Modules that could be programs as all others beside them are, if an entry point named them."""
    workspace = workspace_of(system)
    for row in unlisted_modules(workspace) if workspace is not None else ():
        name = row.module.rpartition(".")[2]
        yield finding(
            "PKG005",
            row.place,
            f"no entry point names '{row.module}', though all other modules beside it with a main() are executables",
            help=f"add '{name} = {row.module}:main' to console_scripts",
            related=[Related(row.beside.place, "the entry points are here")],
            identity=(row.package, row.module),
        )


__all__ = ["module_without_entry_point"]
