"""The substitutions of nav2_common, which make parameter files of others.

Source: ``nav2_common/launch`` of ros-navigation/navigation2 (branches jazzy and main).
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from archlint.interpreter.values import (
    DictValue,
    Known,
    Unknown,
    Value,
    alternatives,
    one_of,
    reason,
)
from archlint.launch.kinds import FileKind
from archlint.launch.named_files import MadeFile, Replacing, Rewriting, path_made_by_launch
from archlint.launch.objects import LaunchObject, known_text, launch_object
from archlint.launch.substitutions.texts import each_text
from archlint.launch.tables import LaunchClass
from archlint.syntax.parameter_files import NotKnown
from archlint.syntax.safe_yaml import YamlError, YamlReader

if TYPE_CHECKING:
    from archlint.launch.run import LaunchRun

Pairs = tuple[tuple[str, str | NotKnown], ...]
KnownPairs = tuple[tuple[str, str], ...]


def rewritten_yaml(run: LaunchRun, value: LaunchObject) -> Value:
    change = _rewriting(run, value)
    if isinstance(change, Unknown):
        return change
    return _made_of(run, run.perform(value.argument("source_file")), change)


def _rewriting(run: LaunchRun, value: LaunchObject) -> Rewriting | Unknown:
    parameters, keys, values = (_pairs(run, value.argument(f"{name}_rewrites")) for name in ("param", "key", "value"))
    root, convert = run.perform(value.argument("root_key")), value.given("convert_types")
    root_key, known_keys = known_text(root), None if keys is None else _all_known(keys)
    if parameters is None or values is None or known_keys is None:
        return Unknown("the values that a parameter file is rewritten with")
    match convert:
        case Known(value=converts) if root_key is not None:
            return Rewriting(parameters, known_keys, values, root_key, bool(converts))
    return Unknown(reason(root, convert))


def replaced_string(run: LaunchRun, value: LaunchObject) -> Value:
    source = run.perform(value.argument("source_file"))
    condition = value.argument("condition")
    verdict = None if condition is None else run.judge(condition)
    if verdict is not None and verdict.holds is not True:
        return source if verdict.holds is False else Unknown("a file that is changed under a condition")
    pairs = _pairs(run, value.argument("replacements"))
    words = None if pairs is None else _all_known(pairs)
    if words is None or not all(_WORD.fullmatch(old) and _WORDS.fullmatch(new) for old, new in words):
        return Unknown("the replacements in a parameter file")
    return _made_of(run, source, Replacing(words))


_WORD = re.compile(r"[\w<>$@%/-]+")
_WORDS = re.compile(r"[^\n'\"\\#:{}&*!|>%@`]*")
"""What neither ends a line, a text or a key nor begins one."""


def _pairs(run: LaunchRun, value: Value | None) -> Pairs | None:
    """A dict of texts; None for a dict that is not known."""
    match value:
        case None | Known(value=None | ""):  # an empty text has no keys either
            return ()
        case DictValue():
            entries = value.entries(run)
        case _:
            return None
    rows = [(known_text(key), _text_or_why(run.perform(text))) for key, text in entries.entries.values()]
    known = tuple((key, text) for key, text in rows if key is not None)
    return None if entries.open or len(known) < len(rows) else known


def _text_or_why(value: Value) -> str | NotKnown:
    text = known_text(value)
    return NotKnown(reason(value)) if text is None else text


def _all_known(pairs: Pairs) -> KnownPairs | None:
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
    made_file = (
        MadeFile(str(source.value), (change,)) if before is None else MadeFile(before.source, (*before.changes, change))
    )
    same = [path for path, file in run.made_files.items() if file == made_file]
    path = same[0] if same else path_made_by_launch(len(run.made_files) + 1, made_file.source)
    run.made_files[path] = made_file
    return Known(path, source.via, source.origin)


def has_node(run: LaunchRun, value: LaunchObject) -> Value:
    """Whether a node has a key of its own at the top of a parameter file."""
    path, node = run.perform(value.argument("source_file")), run.perform(value.argument("node_name"))
    written, name = known_text(path), known_text(node)
    if written is None or name is None or written in run.made_files:
        return Unknown(reason(path, node))
    reference = run.reference(FileKind.PARAMETERS, path, value.place or run.place_now)
    text = run.paths.text(reference)
    if text is None:
        return Unknown("the content of a file that is not in this workspace")
    try:
        reader = YamlReader(text)
        keys = {key for key, _, _ in reader.pairs(reader.root, 0)} if reader.root is not None else set()
    except (YamlError, RecursionError):
        return Unknown("the content of an invalid YAML file")
    return Known(str(name in keys))


def as_bool(run: LaunchRun, value: LaunchObject) -> Value:
    name = value.arguments.get("name") or Unknown("no name is given")
    arms = value.branch_arms
    read = launch_object(
        value.key, LaunchClass.LAUNCH_CONFIGURATION, value.place, {"variable_name": name}, branch_arms=arms
    )
    return each_text(run.perform(read), lambda text: Known(str(text.strip().lower() in ("true", "1", "yes", "on"))))
