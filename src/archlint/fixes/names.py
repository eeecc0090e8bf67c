"""NME001: take a name from a parameter whose default is the name as it was."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import chain
from typing import TYPE_CHECKING

from archlint.finding import Edit, Fix

if TYPE_CHECKING:
    from archlint.edit_sites import NamedCall
    from archlint.fixes.source import Source
    from archlint.fixes.surroundings import Surroundings


class Names:
    """The create calls of a run whose names could become parameters, and the parameters that fixes declare."""

    def __init__(self, calls: Iterable[NamedCall], around: Surroundings) -> None:
        self._around = around
        self._by_file: dict[str, dict[NamedCall, Source]] = {}
        for call in calls:
            source = around.source(call.name.file)
            if source is not None and source.indent(call.statement) is not None:
                self._by_file.setdefault(call.name.file, {})[call] = source
        self._declared_elsewhere: set[str] = set()
        """Parameters that fixes declare on nodes of other files."""

    def fix(self, calls: Sequence[NamedCall]) -> Fix | None:
        """The fix for the names that one finding is about."""
        edits = [edit for call in calls for edit in self._edits(call)]
        return Fix("unsafe", tuple(dict.fromkeys(edits)), "take the name from a parameter") if edits else None

    def _edits(self, call: NamedCall) -> list[Edit]:
        """Declare a parameter in front of the create call and read the name from it.

        Other calls with the same name in reach of the new variable take it too: their fix is that of the first.
        """
        calls = self._by_file.get(call.name.file, {})
        source = calls.get(call)
        if source is None or call.stays:
            return []  # a name that is absolute for a reason stays
        if any(other.name == call.name and other.written != call.written for other in calls):
            return []  # several names meet at this call
        mine = [other for other in calls if other.function == call.function and other.same_as == call.same_as]
        if any(_reaches(other, call) for other in mine):
            return []  # the first one's fix is also this one's
        name = self._free_name(call, source)
        at = source.starts[call.statement.line - 1]
        served = sorted({call.name, *(other.name for other in mine if _reaches(call, other))})
        return [
            Edit(source.place(at, at), _lines(call, source, name)),
            *(Edit(place, name) for place in served),
        ]

    def _free_name(self, call: NamedCall, source: Source) -> str:
        """A name for the parameter and the variable that is not in use yet: of the last part of the topic, else of the
        last two, and so on."""
        parts = [re.sub(r"\W+", "_", part).strip("_").lower() for part in call.written.split("/")]
        parts = [part for part in parts if part] or [call.interface]
        names = [_base("_".join(parts[-count:]), call.interface) for count in range(1, len(parts) + 1)]
        candidates = chain(names, (f"{names[0]}_{number}" for number in range(2, 1_000)))
        # Whoever else declares parameters on a node that is passed is perhaps in another file.
        elsewhere = self._around.elsewhere(source) if call.shares_node else ()
        texts = (source.text, *elsewhere, *sorted(self._declared_elsewhere))
        name = next(name for name in candidates if name not in source.taken and not _used(name, texts))
        source.taken.add(name)
        if call.shares_node:
            self._declared_elsewhere.add(name)
        return name


def _reaches(call: NamedCall, other: NamedCall) -> bool:
    """Whether the other call always runs after this one's statement has begun."""
    start, end = (call.block.line, call.block.column), (call.block.end_line, call.block.end_column)
    return call.name < other.name and start <= (other.statement.line, other.statement.column) < end


def _lines(call: NamedCall, source: Source, name: str) -> str:
    """The lines that declare and read the parameter; a node that may have it already is asked first."""
    indent = source.indent(call.statement)
    node = source.at(call.node)
    declare = f"{node}.declare_parameter('{name}', {source.at(call.name)})"
    lines = [declare, f"{name} = {node}.get_parameter('{name}').value"]
    if not _runs_once(call, source):
        step = "\t" if indent is not None and indent.startswith("\t") else "    "
        lines[:1] = [f"if not {node}.has_parameter('{name}'):", step + declare]
    return "".join(f"{indent}{line}{source.newline}" for line in lines)


def _runs_once(call: NamedCall, source: Source) -> bool:
    """Whether the call runs once for each node: nothing but the one call of its method has the method's name, not
    even as a text or in a comment."""
    return call.runs_once and (call.method is None or source.text.count(call.method) == 2)


def _base(words: str, interface: str) -> str:
    base = words if words.endswith(interface) else f"{words}_{interface}"
    return base if base[0].isalpha() else f"{interface}_{words}"


def _used(name: str, texts: Iterable[str]) -> bool:
    """Whether a text uses a name as a variable or in a string; attributes are in nobody's way."""
    return any(name in text and re.search(rf"(?<![\w.]){name}\b", text) for text in texts)
