"""The substitutions of nav2_common, which make parameter files of others.

Source: ``nav2_common/launch`` of ros-navigation/navigation2 (branches jazzy and main).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.interpreter import containers
from archlint.interpreter.values import (
    DictValue,
    External,
    Instance,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)
from archlint.launch.model import FileKind, MadeFile, Replacing, Rewriting
from archlint.launch.objects import LaunchObject, argument
from archlint.syntax.parameter_files import NotKnown
from archlint.syntax.safe_yaml import YamlError, YamlReader

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

Pairs = tuple[tuple[str, str | NotKnown], ...]
Whole = tuple[tuple[str, str], ...]


def rewritten_yaml(run: LaunchRun, value: Instance) -> Value:
    change = _rewriting(run, value)
    if isinstance(change, Unknown):
        return change
    return _made_of(run, run.perform(argument(value, "source_file")), change)


def _rewriting(run: LaunchRun, value: Instance) -> Rewriting | Unknown:
    parameters, keys, values = (_pairs(run, argument(value, f"{name}_rewrites")) for name in ("param", "key", "value"))
    root = run.perform(argument(value, "root_key"))
    convert = argument(value, "convert_types") or Known(False)
    whole_keys = None if keys is None else _whole(keys)
    if parameters is None or values is None or whole_keys is None:
        return Unknown("what a parameter file is rewritten with")
    if not isinstance(root, Known) or not isinstance(convert, Known):
        return Unknown(reason(root, convert))
    return Rewriting(parameters, whole_keys, values, str(root.value), bool(convert.value))


def replaced_string(run: LaunchRun, value: Instance) -> Value:
    source = run.perform(argument(value, "source_file"))
    condition = argument(value, "condition")
    verdict = None if condition is None else run.judge(condition)
    if verdict is not None and verdict.holds is not True:
        return source if verdict.holds is False else Unknown("a file that is changed under a condition")
    pairs = _pairs(run, argument(value, "replacements"))
    words = None if pairs is None else _whole(pairs)
    if words is None or not all(_WORD.fullmatch(old) and _WORDS.fullmatch(new) for old, new in words):
        return Unknown("what a parameter file is changed to")
    return _made_of(run, source, Replacing(words))


_WORD = re.compile(r"[\w<>$@%/-]+")
_WORDS = re.compile(r"[^\n'\"\\#:{}&*!|>%@`]*")
"""What neither ends a line, a text or a key nor begins one."""


def _pairs(run: LaunchRun, value: Value | None) -> Pairs | None:
    """A dict of texts; None for a dict that is not known."""
    if value is None:
        return ()
    if not isinstance(value, DictValue):
        return None
    entries = containers.entries_of(run, value)
    rows = [(key, run.perform(text)) for key, text in entries.entries.values()]
    if entries.open or not all(isinstance(key, Known) for key, _ in rows):
        return None
    return tuple(
        (str(key.value), str(text.value) if isinstance(text, Known) else NotKnown(reason(text)))
        for key, text in rows
        if isinstance(key, Known)
    )


def _whole(pairs: Pairs) -> Whole | None:
    """The pairs, where all of them are known."""
    known = tuple((key, text) for key, text in pairs if isinstance(text, str))
    return known if len(known) == len(pairs) else None


def _made_of(run: LaunchRun, source: Value, change: Rewriting | Replacing) -> Value:
    """The path of the file that is made of each file that the source may be."""
    return one_of(
        _path_of(run, option, change) if isinstance(option, Known) else Unknown(reason(option))
        for option in alternatives(source)
    )


def _path_of(run: LaunchRun, source: Known, change: Rewriting | Replacing) -> Known:
    before = run.made_files.get(str(source.value))
    made = (
        MadeFile(str(source.value), (change,)) if before is None else MadeFile(before.source, (*before.changes, change))
    )
    same = [path for path, one in run.made_files.items() if one == made]
    path = same[0] if same else f"$(file-made-by-launch {len(run.made_files) + 1} {made.source})"
    run.made_files[path] = made
    return Known(path, source.via, source.origin)


def has_node(run: LaunchRun, value: Instance) -> Value:
    """Whether a node has a key of its own at the top of a parameter file."""
    path = run.perform(argument(value, "source_file"))
    node = run.perform(argument(value, "node_name"))
    if not isinstance(path, Known) or not isinstance(node, Known) or str(path.value) in run.made_files:
        return Unknown(reason(path, node))
    reference = run.reference(FileKind.PARAMETERS, path, value.place or run.place_now)
    text = run.paths.text(reference)
    if text is None:
        return Unknown("the content of a file that is not here")
    try:
        reader = YamlReader(text)
        keys = {key for key, _, _ in reader.pairs(reader.root, 0)} if reader.root is not None else set()
    except (YamlError, RecursionError):
        return Unknown("the content of a YAML file that is broken")
    return Known(str(str(node.value) in keys))


def as_bool(run: LaunchRun, value: Instance) -> Value:
    read = LaunchObject(
        External("launch.LaunchConfiguration"),
        value.key,
        value.place,
        {"variable_name": value.arguments.get("name") or Unknown("no name is given")},
        branch_arms=value.branch_arms if isinstance(value, LaunchObject) else frozenset(),
    )
    rows = alternatives(run.perform(read))
    return one_of(_bool(row) if isinstance(row, Known) else Unknown(reason(row)) for row in rows)


def _bool(value: Known) -> Known:
    return Known(str(str(value.value).strip().lower() in ("true", "1", "yes", "on")))
