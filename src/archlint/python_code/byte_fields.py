"""Fields of type ``byte`` that code compares with numbers.

Source: rosidl_generator_py makes ``bytes`` of length one of a ``byte``, and of the constants of that type; Python finds
no ``bytes`` equal to an ``int``, and refuses to order the two.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.source_code import source_code
from archlint.place import Place
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.model import FieldUse
    from archlint.systems.model import System

_Spot = tuple[str, int, int, int, int]
"""A file, and the span in it."""
_EQUAL = frozenset({"==", "!=", "in", "not in"})
_ORDER = frozenset({"<", "<=", ">", ">="})


@dataclass(frozen=True)
class ByteCompared:
    """``status.level == 0``; one that ``fails`` raises a TypeError, the others have one result, whatever comes."""

    place: Place
    use: FieldUse
    operator: str
    number: int

    @property
    def fails(self) -> bool:
        return self.operator in _ORDER


def bytes_compared(system: System) -> Iterator[ByteCompared]:
    """Each such comparison at a place that only messages with a byte there come to."""
    uses = _byte_fields(system)
    for file in sorted({file for file, *_ in uses}):
        code = source_code(system).facts_at(file)
        for part in everything_in(code.body, facts.Compare) if code is not None else ():
            match part:
                case facts.Compare(left, [operator], [right]) if operator in _EQUAL | _ORDER:
                    for field, other in ((left, right), (right, left)):
                        use = uses.get((file, *field.span)) if isinstance(field, facts.Attribute) else None
                        number = _number(other)
                        if use is not None and number is not None:
                            yield ByteCompared(Place(file, *part.span), use, operator, number)


def _byte_fields(system: System) -> dict[_Spot, FieldUse]:
    """What reads a field of that type, by its place."""
    table = None if system.workspace is None else system.workspace.interfaces
    uses: dict[_Spot, FieldUse | None] = {}
    for use in (use for program in system.programs for use in program.field_uses):
        kind = None if table is None else table.field_type(use.type, use.section_name, use.name)
        place = use.place
        key = (place.file, place.line, place.column, place.end_line, place.end_column)
        is_byte = kind is not None and kind.name == "byte" and not kind.array and use.access == "read"
        uses[key] = use if is_byte and uses.get(key, use) is not None else None
    return {key: use for key, use in uses.items() if use is not None and not system.roles.is_test(use.place.file)}


def _number(part: facts.Base) -> int | None:
    """The number that an expression is, or the first of a list of numbers."""
    match part:
        case facts.Literal(value=int(number)) if not isinstance(number, bool):
            return number
        case facts.Sequence(elements=[first, *_]):
            return _number(first)
    return None


__all__ = ["ByteCompared", "bytes_compared"]
