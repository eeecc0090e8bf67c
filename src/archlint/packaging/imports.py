"""What the files of a workspace import as they start."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import once
from archlint.finding import Place
from archlint.records import dataclass
from archlint.syntax import facts

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex
    from archlint.workspace.model import SourceFile


@dataclass(frozen=True)
class ModuleImport:
    """``import module``, or ``from module import names``; ``unused`` where no line has a word for what that binds."""

    file: SourceFile
    module: str
    names: tuple[str, ...]
    place: Place
    unused: bool = False


@once
def imports_at_start(workspace: WorkspaceIndex) -> Sequence[ModuleImport]:
    """The imports of each file that always run, relative ones left out: not inside functions, nor where a failure is
    caught."""
    return list(_imports_at_start(workspace))


def _imports_at_start(workspace: WorkspaceIndex) -> Iterator[ModuleImport]:
    for file, file_facts in workspace.code.asked_for():
        used = {*file_facts.names, "*"}
        passes_on = file.relative.endswith("__init__.py")  # what it imports, others take from there
        for statement in file_facts.body:
            match statement:
                case facts.Import(module=module, alias=alias, span=span):
                    unused = not passes_on and (alias or module.partition(".")[0]) not in used
                    yield ModuleImport(file, module, (), Place(file.relative, *span), unused)
                case facts.ImportFrom(module=module, level=0, names=names, span=span):
                    bound = {name for _, name in names}
                    unused = not passes_on and bound.isdisjoint(used)
                    named = tuple(name for name, _ in names)
                    yield ModuleImport(file, module, named, Place(file.relative, *span), unused)


def imports(workspace: WorkspaceIndex, path: str, module: str) -> bool:
    """Whether a file imports a module, or names of it, as it starts."""
    file_facts = workspace.facts_at(path)
    statements = () if file_facts is None else file_facts.body
    return any(isinstance(each, (facts.Import, facts.ImportFrom)) and each.module == module for each in statements)
