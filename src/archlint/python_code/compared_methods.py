"""Methods that are compared with True or False in place of what they return: ``if self.is_ready == False:``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_EQUAL = frozenset({"==", "!=", "is", "is not"})


def compared_methods(workspace: WorkspaceIndex) -> Iterator[tuple[str, Place]]:
    """The methods of such comparisons, with the place of each, in the files that were asked for, and in what these
    import of the workspace, but for test code."""
    asked = list(workspace.python_files())
    imported = (path for path in workspace.code.reached_from(asked) if not workspace.roles.is_test(path))
    for path in sorted({*asked, *imported}):
        for name, span in _compared(workspace, path) or ():
            yield name, Place(path, *span)


@kept_for_each_file
def _compared(code: facts.Facts) -> list[tuple[str, facts.Span]]:
    if "setattr" in code.names or "__dict__" in code.names:
        return []
    targets = (target for part in everything_in(code.body) for target in part.assigned)
    assigned = {name.attr for target in targets for name in everything_in([target], facts.Attribute)}
    rows: list[tuple[str, facts.Span]] = []
    for cls in classes_of(code):
        count = Counter(method.name for method in methods_of(cls))
        plain = {m.name for m in methods_of(cls) if count[m.name] == 1 and not m.decorators} - assigned
        for method in methods_of(cls):
            for test in everything_in(method.body, facts.Compare):
                name = _method(test)
                if name in plain:
                    rows.append((name, test.span))
    return rows


def _method(test: facts.Compare) -> str:
    """The attribute of ``self`` that is compared with True or False alone; empty for any other comparison."""
    match test:
        case facts.Compare(
            left=facts.Attribute(value=facts.Name(id="self"), attr=name),
            ops=[operator],
            comparators=[facts.Literal(value=bool())],
        ) if operator in _EQUAL:
            return name
    return ""


__all__ = ["compared_methods"]
