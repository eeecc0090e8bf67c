"""PRM004: values for parameters that a node does not declare."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import astuple, replace
from typing import TYPE_CHECKING

from archlint.analysis.declared_parameters import always_declared, declared_by, followed, is_judged, names_in_package
from archlint.analysis.kept import once
from archlint.checks.external_parameters import has_unseen_nodes, unknown_to_externals
from archlint.checks.folding import folds
from archlint.checks.misspelt_parameters import MISSPELT, is_told_otherwise, misspelt_for_every_node, misspelt_section
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.settings_by_mistake import declared_dict, joined, joined_key, split_dict
from archlint.finding import Finding, Place, Related
from archlint.launch_files.chosen_names import executable_is_chosen, executable_is_picked, has_another_choice
from archlint.launch_files.files_read_in_code import is_read_in_code, is_taken_out_again
from archlint.launch_files.set_parameters import (
    declared_in,
    files_of,
    files_of_process,
    node_meant,
    others_are_not_run,
    set_nodes,
)
from archlint.suggestions import did_you_mean, hint, listed, listed_for, meant, probable
from archlint.systems.nodes import key_of
from archlint.systems.overrides import Setting, applied, key_matches

if TYPE_CHECKING:
    from archlint.launch.started import Started
    from archlint.model import Blueprint, ParameterDeclaration
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


@rule("PRM004", scope=Scope.SYSTEM)
def unknown_parameter_override(system: System, options: Options) -> Iterator[Finding]:
    """Values for parameters that the node does not declare."""
    yield from misspelt_for_every_node(system)
    yield from unknown_to_externals(system)
    every: dict[tuple[str, str], set[str] | None] = {}
    said: set[tuple[Place, Place, str]] = set()
    shared = _Bundles(system)
    split_dicts: dict[tuple[str | None, str, str, Place | None], tuple[Node, list[Setting]]] = {}
    for node, settings in set_nodes(system):
        declared = declared_by(node)
        assert node.blueprint is not None
        if declared is None or not node.blueprint.just_rclpy:
            continue
        siblings = [other for other in system.entries if other.started is node.started and other is not node]
        if has_unseen_nodes(node) or _is_gone_before(node, siblings):
            continue  # what the launch file sets is for the node that the process is there for
        others, bundles = [_declared_in_sight(other) for other in siblings], _bundles_of(settings)
        for setting in settings:
            if setting.name in declared or always_declared(setting.name) or setting.shared:
                continue
            if has_another_choice(setting.name, declared, settings) or _by_default(system, node, setting.name):
                continue
            if any(names is None or setting.name in names for names in others):
                continue
            if not is_judged(system, node, setting.name) or is_told_otherwise(system, node, setting.name):
                continue
            if node_meant(system, node, setting, siblings) is not node:
                continue
            if setting.written is not None:
                if is_read_in_code(system.workspace, setting.place.file, setting.name.partition(".")[0]):
                    continue
                section = setting.place.file, setting.key
                if section not in every:
                    every[section] = _every_declared(system, *section)
                names_of_all = every[section]
                if names_of_all is None or setting.name in names_of_all:
                    continue
            elif (
                _is_whole_configuration(setting, bundles, declared)
                or shared.is_for_another(setting, bundles)
                or _is_for_another_choice(system, node, setting.name)
            ):
                continue
            line = node.blueprint.place, setting.place, setting.name
            if line in said:
                continue  # a line that starts several nodes of one class is wrong once
            said.add(line)
            whole = declared_dict(setting, declared)
            if whole is None:
                yield _never_used(system, node, node.blueprint, bool(siblings), setting, declared, settings)
            else:
                name, place = whole
                split_dicts.setdefault((node.name, setting.place.file, name, place), (node, []))[1].append(setting)
    for (_, _, name, place), (node, parts) in split_dicts.items():
        yield split_dict(node, name, place or parts[0].place, parts)


def _by_default(system: System, node: Node, name: str) -> bool:
    """Whether a node declares a parameter where all others have their defaults: the launch file has turned off what
    declares it."""
    if system.workspace is None:
        return False
    return any(name in _open_names(system.workspace).get(key_of(blueprint), ()) for blueprint in node.blueprints)


def _is_for_another_choice(system: System, node: Node, name: str) -> bool:
    """Whether a launch argument, or a switch in the launch file, chooses which executable of a package it is, and
    another one of them declares a name."""
    started, launched, workspace = node.started, system.launched, system.workspace
    if started is None or launched is None or workspace is None:
        return False
    if not executable_is_chosen(launched, started) and not executable_is_picked(workspace, started):
        return False
    return name in names_in_package(system.workspace, started.package.text)


@once
def _open_names(workspace: WorkspaceIndex) -> Mapping[object, set[str]]:
    """The names that each node class declares with the defaults of all parameters, by its key."""
    open_names: dict[object, set[str]] = {}
    for node in (node for system in workspace.systems if system.launched is None for node in system.nodes):
        for blueprint in node.blueprints:
            names = (row.name.text for row in blueprint.parameters if row.name.text is not None)
            open_names.setdefault(key_of(blueprint), set()).update(names)
    return open_names


def _is_gone_before(node: Node, siblings: Sequence[Node]) -> bool:
    """Whether a process destroys a node, a helper's that only asks something, before it makes its others."""
    ends = [blueprint.destroyed_at for blueprint in node.blueprints]
    later = [blueprint.number for other in siblings for blueprint in other.blueprints]
    return any(end is not None and number >= end for end in ends for number in later)


def _declared_in_sight(node: Node) -> dict[str, list[ParameterDeclaration]] | None:
    """The declarations of a node by name; None where it may have others, from a base class that is not known, say."""
    complete = all(blueprint.just_rclpy for blueprint in node.blueprints) and followed(node)
    return declared_by(node) if complete else None


_NamesAt = Mapping[Place, set[str]]


class _Bundles:
    """The dicts that a launch file gives to several nodes: each takes of them what it declares."""

    def __init__(self, system: System) -> None:
        self._given: dict[str, list[tuple[Node, Place, bool]]] = {}
        self._workspace = system.workspace
        self._packages = {
            node.package for node in system.nodes if node.package is not None and node.started is not None
        }
        if system.workspace is None:
            return
        for node in system.nodes:
            settings = [] if node.started is None else applied(node.started, node.name, system.workspace.parameters_of)
            bundles = _bundles_of(settings)
            for setting in settings:
                given = self._given.setdefault(setting.name, [])
                given.append((node, setting.place, _is_bundled(setting, bundles)))

    def is_for_another(self, setting: Setting, bundles: _NamesAt) -> bool:
        """Whether another node that gets the same dict declares a name of it, or may; or the launch file itself goes by
        the value."""
        if is_taken_out_again(self._workspace, setting.place.file, setting.name):
            return True
        bundled = _is_bundled(setting, bundles)
        if bundled and any(setting.name in names_in_package(self._workspace, package) for package in self._packages):
            return True  # what is read from a file is for all programs, those of other launch files, too
        for node, place, also in self._given.get(setting.name, ()):
            if place == setting.place or (bundled and also):
                declared = None if node.external else declared_by(node)
                if declared is None or setting.name in declared:
                    return True
        return False


def _bundles_of(settings: Sequence[Setting]) -> _NamesAt:
    """What is set at each place that sets several names."""
    names: dict[Place, set[str]] = {}
    for setting in settings:
        names.setdefault(setting.place, set()).add(setting.name)
    return {place: bundle for place, bundle in names.items() if len(bundle) > 1}


def _is_bundled(setting: Setting, bundles: _NamesAt) -> bool:
    """Whether a dict is not written out in the launch file, one read from a file say: its names have no places of
    their own."""
    return setting.written is None and setting.place in bundles


def _is_whole_configuration(
    setting: Setting, bundles: _NamesAt, declared: Mapping[str, Sequence[ParameterDeclaration]]
) -> bool:
    """Whether a node declares nothing at all of a dict that something else makes, ``config.to_dict()`` say: the dict is
    for a library that the node uses, or handed to every node."""
    return _is_bundled(setting, bundles) and bundles[setting.place].isdisjoint(declared)


def _never_used(
    system: System,
    node: Node,
    blueprint: Blueprint,
    is_one_of_several: bool,
    setting: Setting,
    declared: Mapping[str, Sequence[ParameterDeclaration]],
    settings: Sequence[Setting],
) -> Finding:
    defined = Related(blueprint.place, "the node is defined here")
    key = joined_key(setting.name, declared)
    if key is not None and setting.written is None:
        return joined(node, setting, key, [defined])
    by_program = is_one_of_several and setting.written is None and not declared
    subject = _process(node) if by_program else node.shown
    given = {other.name for other in settings}
    near = probable(setting.name, declared.keys() - given, rivals=given - declared.keys())
    if setting.name.rpartition(".")[2] in declared:
        near = None  # it is the prefix that is wrong, most often of all names beside it
    section = misspelt_section(setting.name, declared.keys() - given) if near else None
    names = listed_for(setting.name, _surely(declared)) if declared else ""
    readers = _readers(system, setting) if setting.written is not None and "*" in setting.key else []
    if len(readers) > 1:
        return _read_by_several(readers, setting, settings)
    return finding(
        "PRM004",
        setting.place,
        f"{subject} declares no parameter '{setting.name}', so this value has no effect{hint(near)}",
        help=f"it declares {names}" if names else "declare it in the node, or remove it",
        related=[] if by_program else [defined],  # one of its nodes, and perhaps a helper's
        node=node.name,
        identity=(subject, setting.name),
        # What names that are misspelt, and those in a misspelt section, have in common is advice of its own.
        group=(f"{section[0]}." if section else MISSPELT if near else _NOTHING_OF_IT, *_cause(setting, blueprint)),
        meant=section[1] if section else near or "",
    )


def _process(node: Node) -> str:
    """What a launch file sets a value on that reaches several nodes, none of which declares anything: their program."""
    executable = None if node.started is None else node.started.executable.text
    return node.shown if executable is None else f"the program '{executable}'"


def _cause(setting: Setting, blueprint: Blueprint) -> tuple[str, ...]:
    """What the values have in common that a node does not declare: the node, as one launch or parameter file is copied
    from the other; or a section that is for several nodes."""
    if setting.written is not None and "*" in setting.key:
        return setting.place.file, setting.key
    return (*map(str, astuple(blueprint.place)), blueprint.class_name)


def _readers(system: System, setting: Setting) -> list[Node]:
    """The nodes, one of each class, that get a section of a parameter file from any launch file."""
    file, by_class = setting.place.file, dict[object, "Node"]()
    for other in system.workspace.systems if system.workspace is not None else ():
        for node in other.nodes:
            reads = node.started is not None and file in files_of_process(node.started)
            if node.blueprint is not None and reads and key_matches(setting.key, node.name):
                by_class.setdefault(key_of(node.blueprint), node)
    return sorted(by_class.values(), key=lambda node: node.shown)


def _read_by_several(readers: Sequence[Node], setting: Setting, settings: Sequence[Setting]) -> Finding:
    """What none of several nodes declares: the same whichever launch file and node shows it."""
    declared = [declared_by(node) or {} for node in readers]
    every = {name for names in declared for name in names}
    section = setting.place.file, setting.key
    given = {other.name for other in settings}
    near = did_you_mean(setting.name, every - given, rivals=given - every)
    places = ((node.blueprint.place, node.shown) for node in readers if node.blueprint is not None)
    return finding(
        "PRM004",
        setting.place,
        f"none of the {len(readers)} nodes that read this section declares a parameter '{setting.name}', so this value "
        f"has no effect{near}",
        help=f"they declare {listed(sorted(every))}",
        related=[Related(place, f"{name} is defined here") for place, name in places],
        identity=("", setting.name),
        group=() if near else (f"none of the {len(readers)} nodes that read this section declares any of", *section),
    )


def _surely(declared: Mapping[str, Sequence[ParameterDeclaration]]) -> list[str]:
    """The names that a node declares, without those of methods that nothing calls, which it may have inherited."""
    called_for = [name for name, rows in declared.items() if not all(row.uncalled for row in rows)]
    return sorted(called_for or declared)


@folds("PRM004", across_systems=True)
def _one_for_a_node(several: Sequence[Finding]) -> Finding:
    """One finding for all that one file, or several launch files, set on a node which declares none of it."""
    first = min(several, key=lambda diagnostic: diagnostic.condition is not None)
    others = {other.place: other for other in several if other.place != first.place}.values()
    names = list(dict.fromkeys(diagnostic.identity[1] for diagnostic in (first, *several)))
    rows = [Related(other.place, _set_here(other, len(names))) for other in list(others)[:SHOWN]]
    if len(names) == 1:
        return replace(first, related=(*rows, *first.related))
    nodes = len({diagnostic.identity[0] for diagnostic in several})
    subject = first.group[0]
    hints = {other.identity[1]: other.meant for other in several if subject == MISSPELT}
    if subject in (_NOTHING_OF_IT, MISSPELT):
        node = first.identity[0] or first.group[-1]
        more = "another node" if nodes == 2 else f"{nodes - 1} more nodes"
        subject = f"{node} declares none of" if nodes == 1 else f"{node} and {more} of its class declare none of"
    under = f" (with {first.condition})" if first.condition else ""
    if subject.endswith("."):
        under += meant(f"'{first.meant}' for '{subject.rstrip('.')}'")
        subject = f"{first.identity[0] or first.group[-1]} declares none of"
    said = listed([_with_hint(name, hints.get(name), name == names[0]) for name in names])
    return replace(
        first,
        message=f"{subject} these {len(names)} parameters, so their values have no effect: {said}{under}",
        related=(*rows, *first.related),
        identity=(first.identity[0], *names),
    )


_NOTHING_OF_IT = "none of"
"""The group of what nodes of one class do not declare."""


def _set_here(other: Finding, names: int) -> str:
    slip = other.group[0] == MISSPELT
    return "it is set here, too" if names == 1 else f"'{other.identity[1]}'{hint(other.meant) if slip else ''}"


def _with_hint(name: str, near: str | None, first: bool) -> str:
    if near is None:
        return name
    return f"{name} (did you mean '{near}'?)" if first else f"{name} ('{near}'?)"


SHOWN = 20
"""How many more places one finding shows."""


def _every_declared(system: System, file: str, key: str) -> set[str] | None:
    """The names that any node declares which a section of a parameter file is for, in all systems that load the
    file; None where some node's source is not here, or others may share what is for all."""
    workspace = system.workspace
    shared = "*" in key
    if workspace is None or (shared and others_are_not_run(workspace)):
        return None
    declared_names: set[str] = set()
    for other in workspace.systems:
        if other is not system and (other.launched is None or file not in files_of(other)):
            continue
        for node in other.nodes:
            if not shared and not key_matches(key, node.name):
                continue
            declared = None if node.external or not followed(node) else declared_by(node)
            if declared is None:
                return None
            declared_names |= set(declared)
        for dormant in _dormant_with(other, file) if shared else ():
            names = declared_in(workspace, dormant)
            if names is None:
                return None
            declared_names |= names
    return declared_names


def _dormant_with(system: System, file: str) -> list[Started]:
    """What a launch file starts under other arguments only, and gives a parameter file."""
    started = [] if system.launched is None else system.launched.started
    return [process for process in started if process.dormant and file in files_of_process(process)]
