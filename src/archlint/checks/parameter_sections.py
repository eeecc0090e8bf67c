"""PRM005: sections of parameter files for nodes that nothing starts."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.cpp_nodes import makes_costmap, names_cpp_node
from archlint.analysis.declared_parameters import followed
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Place, Related, Severity
from archlint.launch.kinds import FileStatus
from archlint.launch_files.chosen_names import may_get_any_file, name_is_chosen, namespace_is_chosen
from archlint.launch_files.files_of_commands import may_be_given_by_command
from archlint.launch_files.files_read_in_code import is_for_a_test, is_read_in_code
from archlint.launch_files.managed_nodes import managed_nodes
from archlint.launch_files.plugin_parameters import controllers_of, costmaps_without_namespace
from archlint.launch_files.set_parameters import (
    files_of,
    files_of_process,
    others_are_not_run,
    rewritten_files,
    systems_that_load,
)
from archlint.launch_files.unloaded_parameter_files import has_no_reader, is_left_out
from archlint.records import dataclass
from archlint.ros.external_nodes import well_known
from archlint.suggestions import listed, meant, nearest
from archlint.systems.nodes import key_of
from archlint.systems.overrides import key_matches

if TYPE_CHECKING:
    from archlint.launch.model import Included, Launched
    from archlint.launch.started import Started
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Node


@dataclass(frozen=True)
class _Loader:
    """A node of a launch file that loads the parameter file, under the name that it has with the default arguments;
    whether the launch arguments may give it another name, or another namespace."""

    name: str
    node: Node
    other_name: bool
    other_namespace: bool
    managed: bool = False
    """Whether a lifecycle manager of the launch knows it by that name."""

    @property
    def last(self) -> str:
        return self.name.rpartition("/")[2]


@rule("PRM005", scope=Scope.SYSTEM)
def parameters_for_unknown_node(system: System, options: Options) -> Iterator[Finding]:
    """Sections of parameter files for nodes that no launch file which loads them starts."""
    workspace = system.workspace
    if workspace is None:
        return
    if system.launched is None:
        yield from _of_costmaps(workspace)
        return
    for file in files_of(system):
        started = _nodes_beside(workspace, file)
        if not started or file in rewritten_files(workspace):
            continue  # in the file that a launch makes of this one the keys may be others
        if may_be_given_by_command(workspace, file):
            continue
        keys = [section.key for section in workspace.parameters_of(file).sections if "*" not in section.key]
        of_others = _named_for_others(workspace, file)
        unmet = [node for node in started if not any(key_matches(key, node.name) for key in keys)]
        for section in workspace.parameters_of(file).sections:
            if section.key == "/" or "*" in section.key or "$(" in section.key or _any_matches(section.key, started):
                continue
            if section.key.rpartition("/")[2] in of_others:
                continue
            finding_ = _judged(workspace, Place(file, *section.span), section.key, started, unmet)
            if finding_ is not None:
                yield finding_


def _of_costmaps(workspace: WorkspaceIndex) -> Iterator[Finding]:
    """One finding for the costmaps of a file; less certain to matter where nothing here loads it."""
    by_file: dict[str, list[tuple[Place, str]]] = {}
    for place, name in costmaps_without_namespace(workspace):
        by_file.setdefault(place.file, []).append((place, name))
    for file, [(place, name), *others] in by_file.items():
        told = finding(
            "PRM005",
            place,
            f"these parameters are for /{name}, and the costmap of Nav2 is /{name}/{name}, which gets none of them",
            help=f"write the key twice, one below the other: {name}: {name}: ros__parameters:",
            related=[Related(other, f"so it is with '/{named}'") for other, named in others],
            identity=(file, "costmaps"),
        )
        if not is_left_out(workspace, file):
            yield replace(told, severity=Severity.INFO) if has_no_reader(workspace, file) else told


def _any_matches(key: str, started: Sequence[_Loader]) -> bool:
    return any(key_matches(key, node.name) for node in started)


def _judged(
    workspace: WorkspaceIndex,
    place: Place,
    key: str,
    started: Sequence[_Loader],
    unmet: Sequence[_Loader],
) -> Finding | None:
    """What is said of a section that no node beside it is started for; ``unmet`` are those without a section."""
    file = place.file
    if is_read_in_code(workspace, file, key.strip("/")):
        return None
    namespace, _, last = key.rpartition("/")
    if last in controllers_of(workspace.parameters_of(file)) and _may_hold_more_nodes(workspace, file):
        return None  # the controller manager, which gets the file, makes a node of that name
    namesakes = [node for node in started if node.last == last]
    right = sorted({node.name for node in unmet if node.last == last})
    if _may_come_otherwise(workspace, key):
        return None
    if namesakes:
        # With a section of its own for each namesake, or a namespace from an argument, it is for another start.
        if not right or (namespace and any(node.other_namespace for node in namesakes)):
            return None
        help = f"the key must be the full name: write '{right[0]}:', or '/**/{last}:' for any namespace"
        return _finding(place, key, right[0], help)
    if others_are_not_run(workspace):
        return None
    renamed = _renamed_loader(key, unmet, file)
    if _is_another_program(workspace, file, last, started):
        return None
    if renamed is None and names_cpp_node(workspace, file, last):
        return None
    if is_for_a_test(workspace, file, last) or _holds_costmap(workspace, file, last, started):
        return None
    near = nearest(key, [node.name for node in unmet if not node.other_name])
    if near and _are_of_two_programs(key, near):
        near = ""
    near = near or _with_node(key, unmet, file)
    if not near and any(node.other_name for node in started):
        return None
    if not near and renamed is None and _may_hold_more_nodes(workspace, file):
        return None
    loaders = {node.name for node in started if _loads(node, file)}
    if renamed is not None:
        return _renamed(_finding(place, key, near, ""), renamed)
    help = f"nodes that load this file: {listed(sorted(loaders or {node.name for node in started}))}"
    return _finding(place, key, near, help)


def _are_of_two_programs(key: str, other: str) -> bool:
    """Whether well-known programs give their nodes both names: ``map_saver`` is no slip for ``map_server``, but what
    is left of Nav2's own file."""
    last, other_last = key.rpartition("/")[2], other.rpartition("/")[2]
    names = {node.name for nodes in well_known().values() for node in nodes}
    return last != other_last and {last, other_last} <= names


def _renamed_loader(key: str, unmet: Sequence[_Loader], file: str) -> _Loader | None:
    """The node that gets a file, and no section of it, which a key would be for if the launch file gave it no name."""
    namespace, _, last = key.rpartition("/")
    if namespace.strip("/"):
        return None
    return next((node for node in unmet if _loads(node, file) and last in _own_names(node.node)), None)


def _own_names(node: Node) -> set[str | None]:
    """The name that the code of a node gives it.  Where the code is not here, and the launch file gives the process a
    name, no node in it has that of the program or of its package any more, which most programs give their node."""
    if node.blueprint is not None:
        return {node.blueprint.name.text}
    if node.known is not None:
        return {node.known.name}
    return {node.executable, node.package}


def _renamed(told: Finding, loader: _Loader) -> Finding:
    """The key is right for a node that is started without launch: what is to be changed may be the launch file."""
    help = (
        f"write '{loader.name}:', since the lifecycle manager knows the node by that name"
        if loader.managed
        else f"take the name off the node in the launch file, or write '{loader.name}:' if nothing else starts it"
    )
    at = loader.node.launch_place
    related = () if at is None else (Related(at, f"this calls it '{loader.name}'"),)
    return replace(told, help=help, related=related)


def _with_node(key: str, unmet: Sequence[_Loader], file: str) -> str:
    """The node that a key is for but for the word ``node`` at its end, if it gets the file and no section of it;
    empty for none, and for several."""
    plain = key.removesuffix(_NODE)
    same = {row.name for row in unmet if row.name.removesuffix(_NODE) == plain and _loads(row, file)}
    return same.pop() if len(same) == 1 and not any(row.other_name for row in unmet) else ""


_NODE = "_node"


def _holds_costmap(workspace: WorkspaceIndex, file: str, name: str, started: Sequence[_Loader]) -> bool:
    """Whether a program of the workspace that gets a file makes a costmap of Nav2 of that name in its process."""
    packages = {node.node.started.package.text for node in started if node.node.started and _loads(node, file)}
    return any(package is not None and makes_costmap(workspace, package, name) for package in packages)


def _loads(loader: _Loader, file: str) -> bool:
    """Whether the launch gives a file to the process of a node, not only to another one beside it."""
    return loader.node.started is not None and file in files_of_process(loader.node.started)


def _finding(place: Place, key: str, right: str, help: str) -> Finding:
    return finding(
        "PRM005",
        place,
        f"no launch file that loads this file starts a node '{key}'{_hint(right)}",
        help=help,
        identity=(place.file, key),
        group=(place.file,),
        meant=right,
    )


def _hint(right: str) -> str:
    return meant(right and f"'{right}'")


@folds("PRM005")
def _one_for_a_file(several: Sequence[Finding]) -> Finding:
    """One finding for all sections of a file that lack their nodes."""
    first, *others = several
    keys = [reported.identity[1] for reported in several]
    instead = meant(" and ".join(f"'{reported.meant}'" for reported in several if reported.meant))
    return replace(
        first,
        message=f"no launch file that loads this file starts any of these {len(keys)} nodes: {listed(keys)}{instead}",
        related=(
            *first.related,
            *(Related(other.place, f"'{other.identity[1]}'{_hint(other.meant)}") for other in others),
        ),
        identity=(first.identity[0], *keys),
    )


def _may_come_otherwise(workspace: WorkspaceIndex, key: str) -> bool:
    """Whether some launch file starts a node with this name and lets an argument choose its parameter file."""
    return any(
        system.launched is not None and node.started is not None and may_get_any_file(system.launched, node.started)
        for system in workspace.systems
        for node in system.nodes
        if key_matches(key, node.name)
    )


def _is_another_program(workspace: WorkspaceIndex, file: str, name: str, started: Sequence[_Loader]) -> bool:
    """Whether a Python node of the package that a file lies in has a name, and no launch file that loads the file
    starts it: the file is for a run by hand, too."""
    package = workspace.package_of(file)
    running = {key_of(node.node.blueprint) for node in started if node.node.blueprint is not None}
    return package is not None and any(
        node.package == package
        and (node.name or "").rpartition("/")[2] == name
        and node.blueprint is not None
        and key_of(node.blueprint) not in running
        for system in workspace.systems
        if system.launched is None
        for node in system.nodes
    )


def _may_hold_more_nodes(workspace: WorkspaceIndex, file: str) -> bool:
    """Whether a process gets the file whose source is not here, or whose nodes are in other hands: nav2's servers
    make the nodes of their costmaps."""
    return any(
        (node.external or not followed(node)) and node.started is not None and file in files_of_process(node.started)
        for system in workspace.systems
        for node in system.nodes
    )


def _may_read(include: Included, file: str) -> bool:
    """Whether a launch file that is not here may load a parameter file of this workspace: it is of another package,
    so that it knows the file, or the folder that it lies in, from whoever includes it."""
    if include.visible is None or include.reference.status != FileStatus.EXTERNAL:
        return True
    name = posixpath.basename(file)
    return any(name in text or _is_folder(text) for text in include.visible)


def _is_folder(text: str) -> bool:
    return text.startswith("$(") and "." not in posixpath.basename(text)


def _are_others_known(launched: Launched, file: str) -> bool:
    """Whether of each process that a launch starts under other arguments alone the name is known, and that it does
    not get a parameter file."""
    return all(
        process.name is not None
        and process.name.resolution == "exact"
        and not may_get_any_file(launched, process)
        and file not in files_of_process(process)
        for process in launched.started
        if process.dormant
    )


def _may_get(launched: Launched, process: Started, file: str) -> bool:
    """Whether a process gets a parameter file, or may get one that is not known: in a parameter, or as an argument."""
    known = file in files_of_process(process) or may_get_any_file(launched, process)
    return known or process.may_read_arguments_for_ros


def _named_for_others(workspace: WorkspaceIndex, file: str) -> set[str]:
    """The names of what the launches that load a file start under other arguments alone."""
    return {
        process.name.text.rpartition("/")[2]
        for system in systems_that_load(workspace).get(file, ())
        for process in (system.launched.started if system.launched is not None else ())
        if process.dormant and process.name is not None and process.name.text is not None
    }


def _nodes_beside(workspace: WorkspaceIndex, file: str) -> list[_Loader]:
    """All nodes of the launches that load a file; none where the name of one is not known."""
    loaders: list[_Loader] = []
    for system in systems_that_load(workspace).get(file, ()):
        launched = system.launched
        assert launched is not None
        if launched.gaps or not _are_others_known(launched, file):
            return []
        if any(i.reference.source is None and _may_read(i, file) for i in launched.included):
            return []
        managed = managed_nodes(workspace, launched)
        for node in system.nodes:
            process = node.started
            if node.name is None or node.resolution not in ("exact", "parameter"):
                if process is None or _may_get(launched, process, file):
                    return []
                continue  # whatever it is called, nothing of the file is for it
            other_name = process is not None and name_is_chosen(launched, process)
            other_namespace = process is not None and namespace_is_chosen(launched, process)
            is_managed = node.name.rpartition("/")[2] in managed
            loaders.append(_Loader(node.name, node, other_name, other_namespace, is_managed))
    return loaders
