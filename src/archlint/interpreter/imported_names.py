"""The modules that the imports of a module may mean."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.syntax.facts import Class, Facts, Function, Import, ImportFrom, Stmt
from archlint.syntax.parts import once_for
from archlint.syntax.walk import statements_of


@once_for
def imported_names(module: Facts) -> list[tuple[str, int]]:
    """The names that the imports of a module may mean, each with the dots before it."""
    rows: list[tuple[str, int]] = []
    for part in _imports(module.body):
        if isinstance(part, Import):
            names = [".".join(part.module.split(".")[:end]) for end in range(1, part.module.count(".") + 2)]
            level = 0
        else:
            names = [part.module, *(f"{part.module}.{name}".lstrip(".") for name, _ in part.names)]
            level = part.level
        rows += [(name, level) for name in names if name or level]
    return rows


def _imports(body: Sequence[Stmt]) -> Iterator[Import | ImportFrom]:
    """The imports of a module, those inside functions and classes included."""
    for statement in statements_of(body):
        if isinstance(statement, (Import, ImportFrom)):
            yield statement
        elif isinstance(statement, (Function, Class)):
            yield from _imports(statement.body)


__all__ = ["imported_names"]
