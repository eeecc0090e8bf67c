"""LCH001 to LCH005 and GRF002: what a launch file gets wrong about what it starts."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.completeness import is_whole, walk
from archlint.analysis.generated_files import is_generated
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related, Severity
from archlint.launch.model import MISSING, NOT_INSTALLED
from archlint.model import (
    EntityKind,
)
from archlint.ros import names
from archlint.ros.well_known import OF_EVERY_NODE
from archlint.suggestions import did_you_mean, distance, have_same_words, listed
from archlint.syntax import facts
from archlint.systems.instances import instantiate

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.launch.model import FileReference, Remap, Started, UnknownAttribute
    from archlint.systems.model import Node, System, WorkspaceIndex
    from archlint.workspace.installed import Executable, Installs


# ------------------------------------------------------------------------------------------------- LCH001


@rule("LCH001", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_executable(system: System, options: Options) -> Iterator[Finding]:
    """Started executables that their package does not install."""
    if system.launched is None or system.workspace is None:
        return
    for started in system.launched.started:
        installs = system.workspace.installs.get(started.package.text or "")
        name = started.executable.text
        if installs is None or name is None or started.kind not in ("node", "container"):
            continue
        if started.executable.resolution != "exact" or name in installs.executables:
            continue
        package = system.workspace.packages.get(installs.package)
        unread = package is None or package.build_type not in ("ament_python", "ament_cmake")
        if unread or installs.open_executables or not installs.build_files or name in installs.mentioned:
            continue
        hint, help = _instead(installs, name, system.workspace)
        yield finding(
            "LCH001",
            started.places.get("executable", started.place),
            f"package '{installs.package}' installs no executable '{name}'{hint}",
            help=help,
            identity=(installs.package, name),
        )


def _instead(installs: Installs, name: str, workspace: WorkspaceIndex) -> tuple[str, str]:
    """What to start or to install instead of an executable that is not there: a hint and a line of help."""
    known = sorted(installs.executables)
    same = [one for one in known if _stem(installs.executables[one]) == name.removesuffix(".py")]
    if len(same) == 1:
        source = installs.executables[same[0]]
        return f"; {source.script or source.module} is installed as '{same[0]}'", f"start '{same[0]}'"
    if name in installs.too_deep:
        where = installs.too_deep[name]
        return f": it comes to {where}", "launch looks in the folder itself: install(DIRECTORY …/ …), with a slash"
    owners = [one.package for one in workspace.installs.values() if name in one.executables]
    if len(owners) == 1:
        return f"; package '{owners[0]}' installs it", f"start it from package '{owners[0]}'"
    build = _build_file(installs, workspace)
    files = [] if workspace.loader is None else workspace.loader.python_files_of(installs.package)
    there = [file for file in files if posixpath.basename(file) == name]
    if len(there) == 1:
        return did_you_mean(name, known), f"{there[0]} is there: install it in {build}"
    stems = {name, name.removesuffix("_node")} - {_stem(one) for one in installs.executables.values()}
    meant = [file for file in files if posixpath.basename(file).removesuffix(".py") in stems]
    if len(meant) == 1:  # nearer than another node of a similar name
        return f"; {meant[0]} is there, and not installed", f"install it in {build} under the name '{name}'"
    return did_you_mean(name, known), f"it installs {listed(known)}; add it to {build}, or start one of these"


def _stem(executable: Executable) -> str:
    """The file that an executable runs, by its name alone."""
    if executable.script is not None:
        return posixpath.basename(executable.script).removesuffix(".py")
    return (executable.module or "").rpartition(".")[2]


def _build_file(installs: Installs, workspace: WorkspaceIndex) -> str:
    """The file in which a package names its executables."""
    package = workspace.packages.get(installs.package)
    wanted = "setup.py" if package is not None and package.build_type == "ament_python" else "CMakeLists.txt"
    names = [posixpath.basename(file) for file in installs.build_files]
    return wanted if wanted in names else names[0]


# ------------------------------------------------------------------------------------------------- LCH002


@rule("LCH002", scope=Scope.AS_LAUNCHED)
def dead_remapping(system: System, options: Options) -> Iterator[Finding]:
    """Remappings whose source is no name of any node of the process."""
    if system.launched is None:
        return
    for started, nodes in _by_started(system):
        if all(is_whole(system.workspace, node) for node in nodes):
            for remap in started.remaps:
                found = [] if remap.group else list(_dead(remap, nodes, started))
                if found and not _live_elsewhere(system, remap):
                    yield from found


def _by_started(system: System) -> list[tuple[Started, list[Node]]]:
    """What a launch file starts of code that is here, each with its nodes, and what they may have in it."""
    found: dict[int, tuple[Started, list[Node]]] = {}
    for node in system.entries:
        if node.started is not None and not node.external:
            found.setdefault(id(node.started), (node.started, []))[1].append(node)
    return list(found.values())


def _live_elsewhere(system: System, remap: Remap) -> bool:
    """Whether the same line may do something where another launch file includes this one, say in a namespace."""
    others = system.workspace.systems if system.workspace is not None else []
    for other in others:
        if other is system or other.launched is None:
            continue
        for started, nodes in _by_started(other):
            same = [one for one in started.remaps if one.place == remap.place]
            if not all(is_whole(system.workspace, node) for node in nodes) and same:
                return True
            if any(not list(_dead(one, nodes, started)) for one in same):
                return True
    return False


_PLAIN_SOURCE = re.compile(r"~?/?[A-Za-z_][\w/]*")


def _dead(remap: Remap, nodes: list[Node], started: Started) -> Iterator[Finding]:
    source = remap.source.text
    if source is None or remap.source.resolution != "exact" or not _PLAIN_SOURCE.fullmatch(source):
        return
    if source.startswith("__"):
        return
    known: set[str] = set()
    expanded = ""
    for node in nodes:
        own = _before_remapping(node, started)
        if own is None:
            return
        names_of_node, name, namespace = own
        full = names.expand(source, name, namespace)
        if not isinstance(full, str) or full in names_of_node or _implicit(full, name, namespace):
            return
        expanded = full
        known |= names_of_node
    shown = [n.rpartition("/")[2] if "/" not in source.strip("/") and not source.startswith("/") else n for n in known]
    node_name = nodes[0].name
    yield finding(
        "LCH002",
        remap.place,
        f"nothing in {node_name} is called '{expanded}', so this remapping does nothing" + did_you_mean(source, shown),
        help=f"names in it: {listed(sorted(known))}; only whole names match, with their namespace",
        node=node_name,
        identity=(node_name or "", expanded),
    )


def _before_remapping(node: Node, started: Started) -> tuple[set[str], str, str] | None:
    """The names of a node without the launch file's remappings, its own name and its namespace."""
    if node.blueprint is None or node.name is None:
        return None
    plain = instantiate(node.blueprint, node.program, name=started.name, namespace=started.namespace)
    if plain.name is None or any(endpoint.name is None for endpoint in plain.endpoints):
        return None
    namespace, _, name = plain.name.rpartition("/")
    found: set[str] = set()
    for endpoint in plain.endpoints:
        assert endpoint.name is not None
        found.add(endpoint.name)
        if endpoint.kind in (EntityKind.ACTION_SERVER, EntityKind.ACTION_CLIENT):
            found.update(names.action_entities(endpoint.name).values())
    return found, name, namespace or "/"


_SERVICES = frozenset(
    {
        "describe_parameters",
        "get_parameters",
        "get_parameter_types",
        "list_parameters",
        "set_parameters",
        "set_parameters_atomically",
        "get_logger_levels",
        "set_logger_levels",
        "get_type_description",
        "transition_event",
        "change_state",
        "get_state",
        "get_available_states",
        "get_available_transitions",
        "get_transition_graph",
    }
)


def _implicit(full: str, name: str, namespace: str) -> bool:
    """Names that rclpy gives every node.  Remapping /tf is a habit that harms nobody."""
    if full in OF_EVERY_NODE or full.rpartition("/")[2] in ("tf", "tf_static"):
        return True
    below = names.join(namespace, name) + "/"
    return full.startswith(below) and full[len(below) :] in _SERVICES


# ------------------------------------------------------------------------------------------ LCH004, LCH005

_WHAT = {"launch": "launch file", "parameters": "parameter file", "rviz": "RViz configuration"}


@rule("LCH004", scope=Scope.LAUNCH_FILE, in_use=True)
def missing_launch_file(system: System, options: Options) -> Iterator[Finding]:
    """Included files, parameter files and RViz configurations that are not where the launch file looks."""
    uses: dict[tuple[Place, str | None], list[FileReference]] = {}
    for reference in system.launched.references if system.launched is not None else ():
        if reference.status in (MISSING, NOT_INSTALLED) and not reference.optional:
            uses.setdefault((_decided_at(reference), reference.written), []).append(reference)
    for (place, written), [reference, *others] in uses.items():
        files = {place.file, reference.place.file, *(other.place.file for other in others)}
        if reference.status == MISSING and any(_writes_files(system.workspace, file) for file in files):
            continue
        what = _WHAT.get(reference.kind, "file")
        shown = re.sub(r"^\$\((?:find-pkg-share [\w.-]+|workspace)\)/?", "", written or "")
        if reference.status == MISSING and is_generated(system.workspace, reference.package or "", shown):
            continue
        if reference.status == MISSING:
            message = f"package '{reference.package}' has no {what} '{_in_package(system, reference, shown)}'"
            message += _did_you_mean_file(system.workspace, reference.package or "", shown)
            beside = (written or "").startswith("$(workspace)")
            start = "folder that this launch file is in" if beside else "package's share folder"
            help = f"check the path; it starts at the {start}, where the build installs it"
        else:
            message = f"package '{reference.package}' does not install the {what} '{shown}'"
            help = f"{reference.source} is there: install it (data_files in setup.py, install(DIRECTORY …) in CMake)"
        read = dict.fromkeys(one.place for one in (reference, *others) if one.place != place)
        yield finding(
            "LCH004",
            place,
            message,
            help=help,
            related=[Related(one, "it is used here") for one in read],
            identity=(reference.package or "", written or ""),
        )


def _in_package(system: System, reference: FileReference, shown: str) -> str:
    """The path of a file below its package: ``ThisLaunchFileDir()`` gives it below the workspace."""
    installs = None if system.workspace is None else system.workspace.installs.get(reference.package or "")
    return shown if installs is None else shown.removeprefix(f"{installs.folder}/")


def _decided_at(reference: FileReference) -> Place:
    """Where the name of a file is written, an argument's default say, unless that is inside of what uses it."""
    use, given = reference.place, reference.given
    if given is None or given.file != use.file:
        return given or use
    starts = (use.line, use.column) <= (given.line, given.column)
    ends = (given.end_line, given.end_column) <= (use.end_line, use.end_column)
    return use if starts and ends else given


_WRITERS = frozenset({"write_text", "write_bytes", "copy", "copy2", "copyfile"})


def _writes_files(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a launch file may make the files that it names: it opens one to write, or copies one."""
    found = None if workspace is None or workspace.loader is None else workspace.loader.facts_at(file)
    for item in walk([] if found is None else found.body):
        if not isinstance(item, facts.Call):
            continue
        name = item.func.id if isinstance(item.func, facts.Name) else getattr(item.func, "attr", "")
        modes = [argument.value for argument in item.args[1:] if isinstance(argument.value, facts.Literal)]
        if name in _WRITERS or (name == "open" and any(str(mode.value)[:1] in ("w", "a", "x") for mode in modes)):
            return True
    return False


def _did_you_mean_file(workspace: WorkspaceIndex | None, package: str, shown: str) -> str:
    """The file beside a missing one whose name is nearest to its name."""
    loader = None if workspace is None else workspace.loader
    installs = None if loader is None else loader.installs.get(package)
    if loader is None or installs is None:
        return ""
    inside = shown if shown.startswith(f"{installs.folder}/") else posixpath.join(installs.folder, shown)
    folder, name = posixpath.split(posixpath.normpath(inside))
    limit = max(1, len(name.partition(".")[0]) // 3)  # endings are alike without saying much
    beside = [path for path in loader.tree.files_below(folder) if posixpath.dirname(path) == folder]
    names_beside = [posixpath.basename(path) for path in beside]
    same = [other for other in names_beside if have_same_words(name, other)]
    if len(same) == 1:
        return f"; did you mean '{same[0]}'?"
    return did_you_mean(name, [other for other in names_beside if distance(name, other, limit) <= limit])


_RENAMED = {
    "node_name": "name",
    "node_executable": "executable",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
    "type": "exec",
    "ns": "namespace",
    "launch_description_sources": "launch_description_source",
}


@rule("LCH005", scope=Scope.LAUNCH_FILE, in_use=True)
def unknown_launch_attribute(system: System, options: Options) -> Iterator[Finding]:
    """Keywords and attributes that an action does not have."""
    loader = None if system.workspace is None else system.workspace.loader
    for wrong in system.launched.unknown_attributes if system.launched is not None else ():
        if loader is not None and loader.mentions(wrong.place.file, "ROS_DISTRO"):
            continue  # what one distribution of ROS refuses, another wants
        renamed = _RENAMED.get(wrong.name)
        hint = f"; it is called '{renamed}'" if renamed in wrong.known else did_you_mean(wrong.name, wrong.known)
        in_xml = wrong.action.startswith("<")
        kind = "attribute" if in_xml else "argument"
        why = "launch refuses this file as it reads it" if in_xml else "this call raises TypeError"
        found = finding(
            "LCH005",
            wrong.place,
            f"{wrong.action} has no {kind} '{wrong.name}'{hint}",
            help=f"{why}, before anything that it describes is started",
            identity=(wrong.action, wrong.name),
            group=(wrong.place.file,),
        )
        is_old = (
            wrong.name.startswith("node_") and _OLD_RELEASE.search(posixpath.basename(wrong.place.file)) is not None
        )
        yield replace(found, severity=Severity.INFO) if is_old else found


_OLD_RELEASE = re.compile(r"(?<![a-z])(?:dashing|eloquent|foxy)(?![a-z])")
"""The releases whose ``Node`` took ``node_name`` and the like, in the name of a file that is for one of them."""


@folds("LCH005")
def _of_one_file(several: Sequence[Finding]) -> Finding:
    """One finding for a file, whatever its actions are given that they do not have: launch stops at the first."""
    others = tuple(Related(one.place, one.message) for one in several[1:])
    return replace(several[0], related=others)


# -------------------------------------------------------------------------------------------------- GRF002


@rule("GRF002", scope=Scope.CODE)
def node_not_launched(system: System, options: Options) -> Iterator[Finding]:
    """Nodes that an executable starts and no launch file does."""
    workspace = system.workspace
    if system.launched is not None or workspace is None or not workspace.launched:
        return
    started = {(s.package.text, s.executable.text) for one in workspace.launched for s in one.started}
    spoken = _words_of_launch_code(workspace)
    for node in system.nodes:
        blueprint = node.blueprint
        if blueprint is None or node.test or not node.executables:
            continue
        runs = {(run_package(node), name) for name in node.executables}
        installed = workspace.installs.get(run_package(node) or "")
        runs = {run for run in runs if installed is not None and run[1] in installed.executables}
        if not runs or not runs.isdisjoint(started):
            continue
        if any(_spoken_of(words, *run) for run in runs for words in spoken) or any(
            _offered(workspace, *run) for run in runs
        ):
            continue
        shown = node.name or blueprint.class_name
        yield finding(
            "GRF002",
            blueprint.place,
            f"no launch file of this workspace starts {shown}",
            help=f"it runs with `ros2 run {run_package(node)} {min(name for _, name in runs)}` only",
            node=node.name,
            identity=(blueprint.class_name,),
        )


def _words_of_launch_code(workspace: WorkspaceIndex) -> list[frozenset[str]]:
    """The texts in each launch file in Python: other arguments, or an event, may start what its defaults do not."""
    files = workspace.loader.python_facts() if workspace.loader is not None else []
    return [
        frozenset(str(item.value) for item in walk(found.body) if isinstance(item, facts.Literal))
        for file, found in files
        if file.kind == "launch_python"
    ]


def _spoken_of(words: frozenset[str], package: str | None, executable: str) -> bool:
    """Whether a file names an executable and its package, or the command that runs it."""
    if executable in words:
        return package in words
    return any(f"ros2 run {package} {executable}" in word for word in words)


def _offered(workspace: WorkspaceIndex, package: str | None, executable: str) -> bool:
    """Whether a module of the package has an action for it that launch files can use."""
    loader = workspace.loader
    return loader is None or any(
        loader.mentions(path, executable) and loader.mentions(path, "launch_ros")
        for path in loader.python_files_of(package or "")
    )


def run_package(node: Node) -> str | None:
    return node.program.package if node.program is not None else node.package


__all__ = ["UnknownAttribute"]
