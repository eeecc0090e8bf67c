"""Attributes for which a class asks with ``hasattr(self, …)``, and that nothing ever gives its objects."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, classes_of, kept_for_each_class, methods_of
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.unassigned_attributes import has_self, members_of
from archlint.python_code.unshared_objects import given_in, is_unshared
from archlint.records import dataclass
from archlint.suggestions import nearest
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_MAKE_ANY = frozenset({"setattr", "__dict__", "vars", "__setattr__"})


@dataclass(frozen=True)
class AbsentAsked:
    """``hasattr(self, 'serial')``, where ``ser`` may have been meant."""

    place: Place
    cls: str
    name: str
    near: str


def absent_asked(workspace: WorkspaceIndex) -> Iterator[AbsentAsked]:
    """Every such question in a class whose objects only its own methods and the program have."""
    for path in workspace.python_files():
        code = workspace.facts_at(path)
        if code is None or "hasattr" not in code.names or not _MAKE_ANY.isdisjoint(code.names):
            continue
        for each in classes_of(code):
            cls = ClassInFile(path, each)
            asked = _asked(workspace, cls)
            members = members_of(workspace, chain_of(workspace, cls)) if asked else None
            if members is None or not is_unshared(workspace, cls):
                continue
            others = given_in(code, each.name)
            for name, span, known in asked:
                if name not in others and not any(name in names for names in members):
                    yield AbsentAsked(Place(path, *span), each.name, name, _near(name, known))


def _near(name: str, known: list[str]) -> str:
    alike = [other for other in known if other.lower().strip("_") == name.lower().strip("_")]
    return alike[0] if alike else nearest(name, known) or ""


@kept_for_each_class
def _asked(code: facts.Class) -> list[tuple[str, facts.Span, list[str]]]:
    """The names that methods of a class ask their object for, with all that it assigns."""
    rows: list[tuple[str, facts.Span]] = []
    for function in methods_of(code):
        for call in everything_in(function.body, facts.Call) if has_self(function) else ():
            match call:
                case facts.Call(
                    func=facts.Name(id="hasattr"),
                    args=[
                        facts.Argument(value=facts.Name(id="self")),
                        facts.Argument(value=facts.Literal(value=str(name))),
                    ],
                ) if not name.startswith("__"):
                    rows.append((name, call.span))
    if not rows:
        return []
    targets = (target for part in everything_in(code.body) for target in part.assigned)
    assigned = sorted({own for target in targets if (own := of_self(target))})
    return [(name, span, assigned) for name, span in rows]


__all__ = ["AbsentAsked", "absent_asked"]
