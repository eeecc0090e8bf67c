"""What is wanted where somebody types in Python: in a create call, a parameter's name, a launch file's Node(…)."""

from __future__ import annotations

import re
from collections.abc import Mapping

from archlint.libraries import tables
from archlint.libraries.tables import Api
from archlint.lookup.open_calls import Open, Typing, typing_at
from archlint.lookup.texts import Texts
from archlint.lookup.wanted import Wanted, WantedKind
from archlint.place import Place

_CREATING = {row.path.rpartition(".")[2]: row for row in tables.ROWS if row.effect == "endpoint" and row.name}
_READING = frozenset({"get_parameter", "get_parameter_or", "has_parameter", "undeclare_parameter", "get_parameters"})
_NODES = frozenset({"Node", "LifecycleNode", "ComposableNode", "ComposableLifecycleNode", "ComposableNodeContainer"})
_PACKAGES = frozenset({"get_package_share_directory", "get_package_prefix", "FindPackageShare", "FindPackagePrefix"})
_IMPORT = re.compile(r"^\s*from\s+([\w.]+)\.(msg|srv|action)\s+import\s+(?:\(([^)]*)\)?|([^\n#]*))", re.MULTILINE)
_IMPORTING = re.compile(r"^\s*from\s+(\w+)\.(msg|srv|action)\s+import\s+\(?(?:[\w\s]+,)*\s*(\w*)\Z")


def wanted_in_python(texts: Texts, file: str, line: int, column: int) -> Wanted | None:
    """What is wanted at a position of a Python file; None where that is nothing of ROS."""
    lines = texts.lines(file)
    row = texts.line(file, line)[: column - 1]
    replaces = Place(file, line, column, line, column)
    importing = _IMPORTING.match(row)
    if importing is not None:
        typed = importing[3]
        return Wanted("import", _back(replaces, typed), typed, module=f"{importing[1]}/{importing[2]}")
    before = "\n".join([*lines[: line - 1], row])
    typing = typing_at(before)
    if typing is None or not typing.opened or "\n" in typing.typed or not typing.is_plain:
        return None
    place = _back(replaces, typing.typed)
    behind = "\n".join([texts.line(file, line)[column - 1 :], *lines[line : line + 15]])
    return _of_call(typing, place, before, behind)


def _back(place: Place, typed: str) -> Place:
    return Place(place.file, place.line, place.column - len(typed), place.end_line, place.end_column)


def _of_call(typing: Typing, place: Place, before: str, behind: str) -> Wanted | None:
    top, typed = typing.opened[-1], typing.typed
    row = _CREATING.get(top.name)
    if row is not None and top.bracket == "(":
        return _of_creation(row, top, typing, place, before)
    if not typing.in_text:
        return None
    call = next((each for each in reversed(typing.opened) if each.name), None)
    if call is None:
        return None
    if call.name in _READING and typing.opened[-1 if call is top else -2] is call and call.number == 0:
        return Wanted("parameter", place, typed)
    if call.name in _PACKAGES and call is top:
        return Wanted("package", place, typed)
    if call.name in _NODES:
        return _of_node(typing, call, place, before[call.start :], behind)
    return None


def _of_creation(row: Api, top: Open, typing: Typing, place: Place, before: str) -> Wanted | None:
    given = {
        _parameter(row, keyword, number): before[start:end].strip()
        for number, (keyword, start, end) in enumerate(top.starts)
    }
    wanted = _parameter(row, top.keyword, top.number)
    if wanted == row.name and typing.in_text:
        named = given.get(row.type or "", "")
        return Wanted("name", place, typing.typed, row.kind, imported(before).get(named, named.rpartition(".")[2]))
    if wanted == row.type and typing.in_text == row.type_as_text:
        return Wanted("type", place, typing.typed, row.kind)
    return None


def _parameter(row: Api, keyword: str, number: int) -> str:
    if keyword:
        return keyword
    return row.positional[number] if number < len(row.positional) else ""


def imported(text: str) -> Mapping[str, str]:
    """The interfaces that a text imports, ``package/msg/Name`` by the name that they have there."""
    names: dict[str, str] = {}
    for match in _IMPORT.finditer(text):
        for item in (match[3] or match[4] or "").split(","):
            name, _, bound = (part.strip() for part in item.strip().partition(" as "))
            if name.isidentifier():
                names[bound or name] = f"{match[1]}/{match[2]}/{name}"
    return names


def _of_node(typing: Typing, call: Open, place: Place, before: str, behind: str) -> Wanted | None:
    """In ``Node(…)`` of a launch file."""
    inside = typing.opened[typing.opened.index(call) + 1 :]
    around = before + re.split(r"Node\w*\(", behind)[0]
    package, executable = _keyword(around, "package"), _keyword(around, "executable")
    brackets = "".join(each.bracket for each in inside)
    match call.keyword, brackets:
        case "package", "":
            return Wanted("package", place, typing.typed)
        case "executable", "":
            return Wanted("executable", place, typing.typed, package=package)
        case "remappings", "[(":
            what: WantedKind = "remap source" if inside[-1].number == 0 else "remap target"
            return Wanted(what, place, typing.typed, package=package, executable=executable)
        case "parameters", "[{" if not inside[-1].behind_colon:
            return Wanted("parameter", place, typing.typed, package=package, executable=executable)
    return None


def _keyword(text: str, name: str) -> str:
    """A keyword's plain text in a call."""
    match = re.search(rf"""\b{name}\s*=\s*["']([\w.-]*)["']""", text)
    return "" if match is None else match[1]


__all__ = ["imported", "wanted_in_python"]
