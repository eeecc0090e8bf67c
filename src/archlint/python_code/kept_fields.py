"""Fields of messages that code keeps in an attribute, and takes for something else there: ``self.count = msg.data`` of
an Int32, and ``'count: ' + self.count``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.class_chains import ClassInFile, classes_of, kept_for_each_class, methods_of
from archlint.python_code.field_operations import (
    FieldOperation,
    deeds_in,
    fields_read,
    goes_wrong,
    held_in,
)
from archlint.python_code.kept_messages import is_given, is_plain
from archlint.python_code.methods_at_work import of_self
from archlint.python_code.plain_kinds import values_of_self
from archlint.python_code.text_sums import is_its_own
from archlint.syntax import facts
from archlint.syntax.walk import is_none

if TYPE_CHECKING:
    from archlint.model import FieldUse
    from archlint.syntax.interfaces import FieldType
    from archlint.systems.model import System

_Field = tuple["FieldUse", "FieldType", bool]
"""A field, and whether the attribute is None until a message comes."""


def kept_field_operations(system: System) -> Iterator[FieldOperation]:
    """Each such piece of code of the same class, where nothing but fields of one type, and what stands for nothing
    until they come, is assigned to the attribute."""
    workspace = system.workspace
    if workspace is None:
        return
    for file in sorted({file for file, *_ in fields_read(system)}):
        code = workspace.facts_at(file) if workspace.code.kind_of(file) == "python" else None
        for number, cls in enumerate(classes_of(code)) if code is not None else ():
            kept = _kept(system, file, cls)
            for operation in _of_class(file, cls, kept):
                name = operation.attribute.rpartition(".")[2]
                if is_its_own(workspace, file, number, name) and not is_given(workspace, name):
                    yield operation


def _of_class(file: str, cls: facts.Class, attributes: dict[str, _Field]) -> Iterator[FieldOperation]:
    for method in methods_of(cls) if attributes else ():
        for deed, other, by, value, span in deeds_in(method):
            row = attributes.get(of_self(value) or "")
            held = None if row is None else held_in(row[1])
            if row is None or held is None or not goes_wrong(held, deed, other, by):
                continue
            use, kind, alone = row
            if deed != "compares" or alone:  # else it asks whether a message has come
                place = Place(file, *span)
                yield FieldOperation(place, use, held, kind.name, deed, other, by, attribute=value.dotted)


def _kept(system: System, file: str, cls: facts.Class) -> dict[str, _Field]:
    """The attributes that hold a field of a message, or a plain value before."""
    uses, workspace = fields_read(system), system.workspace
    spans = () if workspace is None else _attributes_kept(workspace, ClassInFile(file, cls))
    if not any((file, *span) in uses for span in spans):
        return {}
    attributes: dict[str, _Field] = {}
    for name, values in values_of_self(cls).items():
        known = [value for value in values if value is not None]
        rows = [uses.get((file, *value.span)) if isinstance(value, facts.Attribute) else None for value in known]
        fields = [row for row in rows if row is not None]
        others = [value for value, row in zip(known, rows, strict=True) if row is None]
        one_type = len({held_in(kind) for _, kind in fields}) == 1
        if one_type and len(known) == len(values) and all(map(is_plain, others)):
            attributes[name] = (*fields[0], all(is_none(value) for value in others))
    return attributes


@kept_for_each_class
def _attributes_kept(cls: facts.Class) -> list[facts.Span]:
    """Where what stands that a class keeps in attributes, if it is an attribute of something itself."""
    every = (value for values in values_of_self(cls).values() for value in values)
    return [value.span for value in every if isinstance(value, facts.Attribute)]


__all__ = ["kept_field_operations"]
