"""Methods that are compared with True or False in place of what they return: ``if self.is_ready == False:``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import classes_of, methods_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_EQUAL = frozenset({"==", "!=", "is", "is not"})


@dataclass(frozen=True)
class ComparedMethod:
    """Such a comparison."""

    name: str
    place: Place
    is_called_before: bool
    """Whether the method around calls it further up, perhaps for what it does."""
    takes_arguments: bool
    """Whether it takes anything but ``self``, by default or not."""


def compared_methods(workspace: WorkspaceIndex) -> Iterator[ComparedMethod]:
    """Such comparisons in the files that were asked for, and in what these import of the workspace, but for test
    code."""
    asked = list(workspace.python_files())
    imported = (path for path in workspace.code.reached_from(asked) if not workspace.roles.is_test(path))
    for path in sorted({*asked, *imported}):
        for name, span, is_called_before, takes_arguments in _compared(workspace, path) or ():
            yield ComparedMethod(name, Place(path, *span), is_called_before, takes_arguments)


@kept_for_each_file
def _compared(code: facts.Facts) -> list[tuple[str, facts.Span, bool, bool]]:
    if "setattr" in code.names or "__dict__" in code.names:
        return []
    targets = (target for part in everything_in(code.body) for target in part.assigned)
    assigned = {name.attr for target in targets for name in everything_in([target], facts.Attribute)}
    rows: list[tuple[str, facts.Span, bool, bool]] = []
    for cls in classes_of(code):
        count = Counter(method.name for method in methods_of(cls))
        plain = {m.name: m for m in methods_of(cls) if count[m.name] == 1 and not m.decorators}
        for method in methods_of(cls):
            for test in everything_in(method.body, facts.Compare):
                name = _method(test)
                if name in plain and name not in assigned:
                    rows.append((name, test.span, _is_called(method, name, test), len(plain[name].params) > 1))
    return rows


def _is_called(method: facts.Function, name: str, test: facts.Compare) -> bool:
    """Whether a method calls another one in front of a comparison."""
    called = (call for call in everything_in(method.body, facts.Call) if call.span[:2] < test.span[:2])
    return any(call.func.dotted == f"self.{name}" for call in called)


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


__all__ = ["ComparedMethod", "compared_methods"]
