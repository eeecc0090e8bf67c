"""Which parameter values a started node gets: rclpy's matching of node keys, in the order of the command line."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from archlint.finding import Place
from archlint.launch.kinds import FileStatus, StartedKind
from archlint.launch.named_files import FileReference, Replacing, Rewriting, Written
from archlint.launch.parameter_sources import OpenParameters, ParameterFileUse, Parameters, ParameterSetting
from archlint.launch.parameters import from_yaml
from archlint.launch.started import Started
from archlint.name_paths import NamePattern, matches_names
from archlint.records import dataclass
from archlint.ros import names
from archlint.syntax.parameter_files import NotKnown, ParameterFacts, ParameterSection, first_not_known
from archlint.syntax.parts import Itself
from archlint.syntax.safe_yaml import plain_scalar, written_and_read
from archlint.systems.rewritten import rewritten

EVERY_NODE = "/**"


def key_matches(key: str, node: str | None) -> bool:
    """Whether a node key of a parameter file is for a node; one of unknown name is matched by ``/**`` only."""
    if node is None:
        return key.strip("/") == "**"
    return node.startswith("/") and _matches(key, node)


@lru_cache(maxsize=10_000)
def _matches(key: str, node: str) -> bool:
    """Whether ``*`` for one word and ``**`` for any number of them make a node's name of a key."""
    words = [_WILD.get(token, lambda word, token=token: word == token) for token in key.strip("/").split("/")]
    return matches_names(words, node[1:].split("/"))


_WILD: dict[str, NamePattern | None] = {"**": None, "*": bool}


@dataclass(frozen=True)
class Setting:
    """One value for one parameter from outside: for the nodes that ``key`` matches, ``written`` as it stands
    in a parameter file (None for what the launch file itself sets), ``value_place`` where the launch puts another
    value in."""

    key: str
    name: str
    value: object
    place: Place
    written: str | None = None
    shared: bool = False
    within: tuple[tuple[str, Place], ...] = ()
    """The keys of the dicts that launch took apart to come to the name, as in ``ParameterSetting``."""
    value_place: Place | None = None
    unquoted: str | None = None
    """The text that the launch file sets, where launch writes it without quotes and rcl reads something else in it."""


def overrides_of(started: Started, node: str | None, facts_of: Callable[[str], ParameterFacts]) -> dict[str, object]:
    """The parameters that a launch file sets on one node, by name; :class:`NotKnown` where only the value is
    not known."""
    return {setting.name: setting.value for setting in applied(started, node, facts_of)}


def applied(started: Started, node: str | None, facts_of: Callable[[str], ParameterFacts]) -> list[Setting]:
    """The settings that reach one node, each name once, as rclpy applies them."""
    by_key: dict[str, dict[str, Setting]] = {}
    for setting in settings_of(started, facts_of):
        by_key.setdefault(setting.key, {})[setting.name] = setting
    by_name: dict[str, Setting] = {}
    for key, settings in by_key.items():  # in the order in which the keys first appear
        if key_matches(key, node):
            by_name.update(settings)
    return list(by_name.values())


def settings_of(started: Started, facts_of: Callable[[str], ParameterFacts]) -> Iterator[Setting]:
    """Everything that is set on the command line of a process, in its order."""
    words = [*started.arguments, "--ros-args", *started.ros_arguments]
    first, *doubts = _doubts(started.parameters)
    place = started.places.get("arguments", started.place)
    rows = (Setting(EVERY_NODE, name, value, place) for name, value in command_line_parameters(words))
    yield from (_doubted(row, first) for row in rows)
    for parameter, doubt in zip(started.parameters, doubts, strict=True):
        yield from _set_by(started, parameter, doubt, facts_of)


def _set_by(
    started: Started,
    parameter: ParameterSetting | ParameterFileUse | OpenParameters,
    doubt: str | None,
    facts_of: Callable[[str], ParameterFacts],
) -> Iterator[Setting]:
    """What one of the parameters of a process sets, as far as nothing behind it may set it, too."""
    in_process = started.kind == StartedKind.COMPONENT  # a container is sent values, no file
    match parameter:
        case ParameterSetting(name=str(name), value=value):
            read, unquoted = (value, None) if in_process else as_launch_writes(value)
            key = _own_key(started) if parameter.in_dict else EVERY_NODE
            place, shared, within = parameter.place, parameter.shared, parameter.within
            yield _doubted(Setting(key, name, read, place, None, shared, within, None, unquoted), doubt)
        case ParameterFileUse(reference=FileReference(source=str(file))):
            yield from _read_from(parameter, file, Itself(facts_of(file)), in_process, doubt)
        case ParameterFileUse(followed=True):
            rows = _set_in_file(parameter, parameter.place.file, rewritten((), parameter.changes))
            yield from (_doubted(setting, doubt) for setting in rows)


def _doubted(setting: Setting, doubt: str | None) -> Setting:
    return setting if doubt is None else replace(setting, value=NotKnown(doubt), unquoted=None)


def _doubts(parameters: Parameters) -> list[str | None]:
    """For what is set in front of all parameters, and by each of them: why something behind it may set it, too."""
    doubts: list[str | None] = [None]
    for parameter in reversed(parameters):
        doubts.append(_doubt(parameter) or doubts[-1])
    return doubts[::-1]


def _doubt(parameter: ParameterSetting | ParameterFileUse | OpenParameters) -> str | None:
    """Why a parameter may set any other one: it is not known which it sets."""
    match parameter:
        case ParameterFileUse(reference=reference, sets_anything=True):
            if reference.status in (FileStatus.MISSING, FileStatus.NOT_INSTALLED):
                return None  # launch leaves out a file that is not there
            if reference.written is None:
                return f"{WRITTEN_BEHIND}: {reference.reason}"
            return f"'{reference.written}', which is not in this workspace, may set it"
        case OpenParameters(sets_anything=True, reason=reason):
            return f"{WRITTEN_BEHIND}: {reason}"
        case ParameterSetting(name=None):
            return f"{WRITTEN_BEHIND}: a parameter whose name is not known"
    return None


def sets_all_that_is_set(started: Started) -> bool:
    """Whether nothing may set a parameter of a process that :func:`settings_of` does not tell."""
    words = (*started.arguments, *started.ros_arguments)
    return started.knows_all_arguments and None not in words and not any(map(_doubt, started.parameters))


WRITTEN_BEHIND = "what comes behind it may set it"


def as_launch_writes(value: object) -> tuple[object, str | None]:
    """What rcl reads of a value after launch has written it into a file, and the text if it then is none any more:
    PyYAML writes ``y``, ``1e5`` and ``nan`` without quotes."""
    match value:
        case str() if not isinstance(read := written_and_read(value), str):
            return read, value
        case list():
            rows = [as_launch_writes(item) for item in value]
            return [row for row, _ in rows], next((text for _, text in rows if text is not None), None)
    return value, None


@lru_cache(maxsize=256)
def _read_from(
    use: ParameterFileUse, file: str, read: Itself[ParameterFacts], in_process: bool, doubt: str | None
) -> tuple[Setting, ...]:
    """What a parameter file of the workspace sets: asked for each node of a process, and of all launch files that
    include the one which names it."""
    return tuple(_doubted(row, doubt) for row in _set_in_file(use, file, _changed(read, in_process, use.changes)))


@lru_cache(maxsize=64)
def _changed(
    read: Itself[ParameterFacts], in_process: bool, changes: tuple[Rewriting | Replacing | Written, ...]
) -> Sequence[ParameterSection]:
    """The sections of a parameter file after the changes of a launch: many processes are given the same."""
    return rewritten(_sections_for(read.fact, in_process), changes)


def _set_in_file(use: ParameterFileUse, file: str, sections: Sequence[ParameterSection]) -> Iterator[Setting]:
    """What a parameter file sets, as the launch file uses it."""
    for section in sections:
        nodes = substituted(section.key, use)
        for entry in section.entries:
            set_here = substituted(entry.name, use)
            if set_here is None:
                continue  # which parameter it is, nobody can say
            yield Setting(
                section.key if nodes is None else nodes,
                set_here,
                entry.value if entry.changed else file_value(entry.value, use, entry.quoted),
                use.place if entry.added else Place(file, *entry.span),
                None if entry.added else section.written,
                use.shared or (entry.added and "*" in section.key),
                value_place=use.place if entry.changed else None,
            )


def _sections_for(read: ParameterFacts, in_process: bool) -> tuple[ParameterSection, ...]:
    """The sections of a parameter file.  That of a component launch reads itself, with PyYAML, and takes everything of
    one without any (``to_parameters_list`` of launch_ros); a node takes nothing of it."""
    if not in_process:
        return read.sections
    plain = () if read.sections or not read.plain else read.plain
    sections = read.sections or ((ParameterSection(EVERY_NODE, "", plain[0].span, plain, ("**",)),) if plain else ())
    return tuple(
        replace(section, entries=tuple(replace(entry, value=entry.in_python) for entry in section.entries))
        for section in sections
    )


def _own_key(started: Started) -> str:
    """The key under which launch_ros writes the dicts of ``parameters=``: the node's full name, if the launch file
    gives both parts of it."""
    name, namespace = started.name, started.namespace
    if name is None or namespace is None:
        return EVERY_NODE
    known = name.text is not None and namespace.text is not None and "*" not in name.text + namespace.text
    return names.join(namespace.text or "/", name.text or "") if known else EVERY_NODE


def file_value(value: Any, use: ParameterFileUse, quoted: bool = False) -> object:
    """A value of a parameter file; with ``allow_substs`` a ``$(var …)`` in a text is put in where that is known.

    A ``quoted`` text stays one; any other is read again, as what it is then.
    """
    if not use.substitutions or "$(" not in str(value):
        return value
    match value:
        case list():
            return _list_value(value, use)
        case str():
            text = substituted(value, use)
        case _:
            text = None
    if text is None or not _WORDS.fullmatch(text):
        return _not_substituted(value, use)
    if quoted or (text != (path := _SHARE.sub("/share", text)) and _WORD.fullmatch(path)):
        return text  # a path of an installed package is no number
    return plain_scalar(text) if _WORD.fullmatch(text) else NotKnown("a string that YAML may read in several ways")


def _list_value(values: list[Any], use: ParameterFileUse) -> object:
    """In a list, quotes are not kept: a text is known where it is one without them, too."""
    read = [file_value(value, use) for value in values]
    changed = [now for before, now in zip(values, read, strict=True) if now is not before]
    if all(isinstance(now, str) for now in changed):
        return read
    return first_not_known(changed) or _not_substituted(values, use)


def _not_substituted(value: object, use: ParameterFileUse) -> NotKnown:
    """Why what a file has is not known: for the first substitution in it that is not."""
    known = dict(use.configurations)
    for match in _SUBSTITUTION.finditer(str(value)):
        if match[1] == "env":
            return NotKnown(f"the environment variable {match[2]}")
        if match[1] != "var" or match[2] not in known:
            return NotKnown(f"'{match[0]}' in a parameter file")
    return NotKnown("a string that YAML may read in several ways")


_SUBSTITUTION = re.compile(r"\$\(([\w-]+)(?: ([^()\s]+))?[^()]*\)?")
_SHARE = re.compile(r"\$\(find-pkg-share [\w-]+\)")
_WORD = re.compile(r"[\w/.~+-]+")
_WORDS = re.compile(r"""[^'"\\\n]*""")
_VARIABLE = re.compile(r"\$\(var ([^()\s]+)(?: [^()]*)?\)")


def substituted(text: str, use: ParameterFileUse) -> str | None:
    """A text of a parameter file with its launch configurations put in; None where one is not known.

    The share of a package stays as it is written: so do those that launch files ask for.
    """
    if not use.substitutions or "$(" not in text:
        return text
    known = dict(use.configurations)
    filled = _VARIABLE.sub(lambda match: known.get(match[1], match[0]), text)
    return None if "$(" in _SHARE.sub("", filled) else filled


def command_line_parameters(words: Sequence[str | None]) -> Iterator[tuple[str, object]]:
    """``-p name:=value`` between ``--ros-args`` and ``--``; the value is YAML.

    Source: rcl, ``rcl_parse_arguments`` has ``rcl_parse_yaml_value`` read it.
    """
    inside = expect = False
    for word in words:
        if word in ("--ros-args", "--"):
            inside, expect = word == "--ros-args", False
        elif inside and expect and word is not None and ":=" in word:
            name, _, value = word.partition(":=")
            expect = False
            if ":" not in name:
                yield name, from_yaml(value)
        else:
            expect = inside and word in ("-p", "--param")


__all__ = ["NotKnown", "OpenParameters", "key_matches", "overrides_of"]
