"""Texts that code adds to what is certainly no text: ``'speed: ' + self.speed``, where that is a number."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, chain_of, classes_of, methods_of
from archlint.python_code.declared_kinds import kind_with_parameters
from archlint.python_code.early_attribute_reads import is_of_class
from archlint.python_code.field_operations import is_text
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.parameters_as_values import gives_parameters
from archlint.python_code.plain_kinds import Kind, Values, kind_of, kind_of_all, values_in, values_of_self
from archlint.python_code.tried_code import tried_for
from archlint.python_code.unassigned_attributes import may_get, members_of
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, parts_of

if TYPE_CHECKING:
    from archlint.systems.model import System, WorkspaceIndex


@dataclass(frozen=True)
class TextSum:
    """Such a sum: what is added, as it is written, and what that is."""

    place: Place
    added: str
    kind: str


@dataclass(frozen=True)
class _Row:
    """The same by the text of the file; ``cls`` is the position of the class whose attribute ``name`` is added."""

    span: facts.Span
    added: str
    kind: str
    cls: int | None = None
    name: str = ""
    by_parameter: bool = False
    """Whether it is that for the type of a parameter, of a class of nodes."""


def text_sums(system: System) -> Iterator[TextSum]:
    """Every such sum in the files that were asked for, but for test code."""
    workspace = system.workspace
    if workspace is None:
        return
    for path in workspace.python_files():
        code = workspace.facts_at(path)
        for row in (_rows(workspace, path) or ()) if code is not None else ():
            cls = None if row.cls is None or code is None else ClassInFile(path, classes_of(code)[row.cls])
            if row.name and (row.cls is None or not is_its_own(workspace, path, row.cls, row.name)):
                continue
            if not row.by_parameter or (cls is not None and gives_parameters(system, cls)):
                yield TextSum(Place(path, *row.span), row.added, row.kind)


def is_its_own(workspace: WorkspaceIndex, path: str, number: int, name: str) -> bool:
    """Whether an attribute gets its values in the methods of one class alone."""
    code = workspace.facts_at(path)
    if code is None:
        return False
    cls = ClassInFile(path, classes_of(code)[number])
    chain = chain_of(workspace, cls)
    if len(chain.own) > 1 or members_of(workspace, chain) is None or is_of_class(workspace, chain, name):
        return False
    return not may_get(workspace, cls, name)


# ------------------------------------------------------------------------------------------------- by the text alone


@kept_for_each_file
def _rows(code: facts.Facts) -> list[_Row]:
    expecting = tried_for(code.body, {"TypeError"})
    rows: list[_Row] = []
    for number, cls in enumerate(classes_of(code)):
        attributes = values_of_self(cls)
        for function in methods_of(cls):
            rows += _in(code, function, expecting, number, attributes)
    in_methods = {Itself(function) for cls in classes_of(code) for function in methods_of(cls)}
    for function in everything_in(code.body, facts.Function):
        if Itself(function) not in in_methods:
            rows += _in(code, function, expecting, None, {})
    return rows


def _in(
    code: facts.Facts,
    function: facts.Function,
    expecting: set[Itself[facts.Base]],
    number: int | None,
    attributes: Values,
) -> Iterator[_Row]:
    sums = [part for part in parts_of(function.body, facts.Binary) if part.op == "+"]
    variables = values_in(function) if sums else {}
    cls = None if number is None else classes_of(code)[number]
    for part in sums:
        for text, other in ((part.left, part.right), (part.right, part.left)):
            if not is_text(text) or Itself[facts.Base](part) in expecting:
                continue
            name = of_self(other)
            held = attributes.get(name, ()) if name is not None else variables.get(other.variable, ()) or [other]
            of_parameter = kind_with_parameters(code, cls, held)
            if of_parameter is not None:
                added = f"self.{name}" if name is not None else other.dotted
                yield _Row(part.span, added, _words(of_parameter), number, name or "", by_parameter=True)
            elif name is not None:
                kind = kind_of_all(attributes.get(name, ()), {}) if number is not None else None
                if kind is not None:
                    yield _Row(part.span, f"self.{name}", _words(kind), number, name)
            elif (kind := kind_of(other, variables)) is not None:
                yield _Row(part.span, other.dotted, _words(kind))


def _words(kind: Kind) -> str:
    return str(Kind.NUMBER if kind is Kind.NUMERIC else kind)


__all__ = ["TextSum", "is_its_own", "text_sums"]
