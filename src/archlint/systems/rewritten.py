"""What a node reads of a parameter file that the launch has written or rewritten: nav2's ``RewrittenYaml`` and
``ReplaceString``.

Source: ``nav2_common/launch`` of ros-navigation/navigation2, which loads the file, changes it and dumps it with PyYAML.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from archlint.launch.named_files import Replacing, Rewriting, Written
from archlint.launch.parameters import from_yaml
from archlint.syntax.parameter_files import (
    NotKnown,
    ParameterEntry,
    ParameterSection,
    first_not_known,
    node_key,
    read_parameters,
)
from archlint.syntax.parameter_structure import ROOT
from archlint.syntax.safe_yaml import plain_scalar, written_and_read

Path = tuple[str, ...]


def rewritten(
    sections: Sequence[ParameterSection], changes: Iterable[Rewriting | Replacing | Written]
) -> Sequence[ParameterSection]:
    """The sections after the changes, one after the other."""
    for change in changes:
        match change:
            case Replacing(words=words):
                sections = [_replaced(section, words) for section in sections]
            case Rewriting():
                sections = _rewritten(sections, change)
            case Written(text=text):
                sections = [_as_written(section) for section in read_parameters(text).sections]
    return sections


def _as_written(section: ParameterSection) -> ParameterSection:
    """What the launch writes stands in no file of the workspace."""
    return replace(section, entries=tuple(replace(entry, changed=True, added=True) for entry in section.entries))


# ------------------------------------------------------------------------------------------------- RewrittenYaml


def _rewritten(sections: Sequence[ParameterSection], change: Rewriting) -> list[ParameterSection]:
    loaded = {section.path: section for section in sections}  # of two alike, PyYAML keeps the second
    read = [_read_back(section) for section in loaded.values()]
    new = {key: _value(text, change.convert_types) for key, text in change.parameters}
    read = [_by_keys(section, new) for section in read if not {*section.path, ROOT} & new.keys()]
    for path, value in new.items():
        keys = tuple(path.split("."))
        if ROOT in keys[:-1]:
            cut = keys.index(ROOT)
            read = _set(read, keys[:cut], keys[cut + 1 :], value)
    names = dict(change.keys)
    values = {text: _value(now, change.convert_types) for text, now in change.values}
    root = (change.root_key,) if change.root_key else ()
    read = [_renamed(_revalued(section, values) if values else section, names, root) for section in read]
    return sorted(read, key=lambda section: (*section.path, ROOT))  # PyYAML sorts the keys


def _value(text: str | NotKnown, convert: bool) -> object:
    """A text as ``RewrittenYaml.convert`` has it, dumped and read by rcl."""
    match text:
        case str():
            return _read(text, convert)
    return text


def _read(text: str, convert: bool) -> object:
    if convert:
        try:
            return float(text) if "." in text else int(text)
        except ValueError:
            pass
    lower = text.lower()
    return lower == "true" if lower in ("true", "false") else written_and_read(text)


def _read_back(section: ParameterSection) -> ParameterSection:
    """All is dumped anew, with quotes only where PyYAML needs them."""
    entries = (replace(entry, value=_again(entry.value, entry.in_python), quoted=False) for entry in section.entries)
    return replace(section, entries=tuple(entries))


def _again(value: Any, in_python: Any) -> Any:
    """A value of the file as it is read once it is dumped: PyYAML writes ``null`` for None, which is a text to rcl."""
    match value, in_python:
        case list(), _:
            there = in_python if isinstance(in_python, list) else value
            return [_again(item, loaded) for item, loaded in zip(value, there, strict=True)]
        case ((None | "~" | "null" | "Null" | "NULL"), None):
            return "null"
        case str(), _:
            return written_and_read(value)
    return value


def _by_keys(section: ParameterSection, new: Mapping[str, object]) -> ParameterSection:
    """A key that is rewritten gets the value, wherever it stands; what was below it is gone."""
    entries: dict[Path, ParameterEntry] = {}
    for entry in section.entries:
        depth = next((number for number, key in enumerate(entry.path, start=1) if key in new), None)
        if depth is not None:
            path = entry.path[:depth]
            entry = replace(entry, name=".".join(path), path=path, value=new[path[-1]], changed=True)
        entries[entry.path] = entry
    return replace(section, entries=tuple(entries.values()))


def _set(sections: list[ParameterSection], node: Path, path: Path, value: object) -> list[ParameterSection]:
    """What is at a whole path gets the value; it is added where it was not there."""
    for number, section in enumerate(sections):
        if section.path == node:
            changed = replace(section, entries=_set_entry(section, path, value))
            return [*sections[:number], changed, *sections[number + 1 :]]
    added = ParameterEntry(".".join(path), value, (1, 1, 1, 1), path=path, changed=True, added=True)
    return [*sections, ParameterSection(node_key(node), "/".join(node), added.span, (added,), node)]


def _set_entry(section: ParameterSection, path: Path, value: object) -> tuple[ParameterEntry, ...]:
    entries = list(section.entries)
    name, above = ".".join(path), ".".join(path[:-1])
    for number, entry in enumerate(entries):
        if entry.name == name:
            entries[number] = replace(entry, value=value, changed=True)
            return tuple(entries)
        if entry.name == above and isinstance(entry.value, list) and path[-1].isdecimal():
            index = int(path[-1])
            if index < len(entry.value):
                items = [*entry.value[:index], value, *entry.value[index + 1 :]]
                entries[number] = replace(entry, value=_if_known(items), changed=True)
            return tuple(entries)
    kept = [entry for entry in entries if entry.path[: len(path)] != path]
    return (*kept, ParameterEntry(name, value, section.span, path=path, changed=True, added=True))


def _revalued(section: ParameterSection, values: Mapping[str, object]) -> ParameterSection:
    entries = (replace(entry, value=_revalue(entry.value, values)) for entry in section.entries)
    return replace(section, entries=tuple(entries))


def _revalue(value: Any, values: Mapping[str, object]) -> Any:
    match value:
        case list():
            return _if_known([_revalue(item, values) for item in value])
    return values.get(str(value), value)


def _if_known(items: list[Any]) -> object:
    """A list, or the first of its values that is not known."""
    return first_not_known(items) or items


def _renamed(section: ParameterSection, names: Mapping[str, str], root: Path) -> ParameterSection:
    return _with_keys(section, lambda key: names.get(key, key), root) if names or root else section


def _with_keys(section: ParameterSection, changed: Callable[[str], str], root: Path = ()) -> ParameterSection:
    path = (*root, *map(changed, section.path))
    rows = ((entry, tuple(map(changed, entry.path))) for entry in section.entries)
    entries = tuple(replace(entry, name=".".join(now), path=now) for entry, now in rows)
    return replace(section, key=node_key(path), written="/".join(path), entries=entries, path=path)


# ------------------------------------------------------------------------------------------------- ReplaceString


def _replaced(section: ParameterSection, words: Sequence[tuple[str, str]]) -> ParameterSection:
    entries = tuple(replace(entry, value=_in_value(entry.value, entry.quoted, words)) for entry in section.entries)
    return _with_keys(replace(section, entries=entries), lambda key: _in_text(key, words))


def _in_text(text: str, words: Sequence[tuple[str, str]]) -> str:
    for old, new in words:
        text = text.replace(old, new)
    return text


def _in_value(value: Any, quoted: bool, words: Sequence[tuple[str, str]]) -> Any:
    """The words are replaced in the text of the file, which is read afterwards."""
    match value:
        case list():
            return _if_known([_in_value(item, quoted, words) for item in value])
        case NotKnown():
            return value
        case _ if not any(old in str(value) for old, _ in words):
            return value
        case str():
            text = _in_text(value, words)
            return text if quoted else _plain(text)
    return NotKnown("a value that ReplaceString changes")


def _plain(text: str) -> object:
    if _PLAIN.fullmatch(text):
        return plain_scalar(text)
    match from_yaml(text) if text.startswith("[") and text.endswith("]") else None:
        case list() as items:
            return items
    return NotKnown("a string that YAML may read in several ways")


_PLAIN = re.compile(r"[\w/.<>+$-]+")
