"""NME001: absolute names that only an edit of the code can change."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.completeness import enclosing_class
from archlint.analysis.fixed_names import is_of_a_model, must_be_absolute, passed_from
from archlint.analysis.kept import once
from archlint.analysis.name_sites import sites_of_name
from archlint.branches import exclusive
from archlint.checks.folding import all_sites, folds
from archlint.checks.name_conventions import CONVENTION, FixedName, Home, home_of, one_of_package, with_convention
from archlint.checks.name_reasons import (
    DEMANDED,
    FIXED,
    NOT_INSTALLED,
    OF_ANOTHER,
    PARAMETERS,
    PRIVATE,
    RELATIVE,
    REMAPPED,
    WITHOUT_PACKAGE,
    Reason,
    of_others,
    shared_by,
)
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import NAMED
from archlint.ros.well_known import ABSOLUTE, BY_CLICK
from archlint.systems.nodes import key_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint, Node

FIXED_BY_OTHERS = {
    "/fmu/": "PX4",
    "/ap/": "ArduPilot",
    "/mavros/": "MAVROS",
    "/world/": "Gazebo",
    "/gazebo/": "Gazebo",
    "/pause_physics": "Gazebo",
    "/unpause_physics": "Gazebo",
    "/reset_simulation": "Gazebo",
    "/reset_world": "Gazebo",
    "/carla/": "CARLA",
    "/api/sport/": "Unitree",
    "/lf/lowstate": "Unitree",
    "/lf/sportmodestate": "Unitree",
    "/lowcmd": "Unitree",
    "/lowstate": "Unitree",
    "/sportmodestate": "Unitree",
    "/utlidar/": "Unitree",
}
"""Systems outside of ROS that one robot or one simulation has one of, and whose bridges choose these names."""
_OF_A_JOINT = re.compile(r"/model/[^/]+/joint/[^/]+/")
"""How Gazebo's joint plugins (JointController, JointPositionController, Thruster) begin the topics that nobody names.

Source: gz-sim, ``src/systems``: ``/model/<model>/joint/<joint>/cmd_vel`` and the like.
"""
_OF_AUTOWARE = (
    "/api/",
    "/awapi/",
    "/control/",
    "/localization/",
    "/perception/",
    "/planning/",
    "/sensing/",
    "/vehicle/",
)
"""How the names begin that Autoware's components have in its own launch files."""
_TYPES_OF_OTHERS = {
    "carla_msgs/": "CARLA",
    "gazebo_msgs/srv/": "Gazebo",
    "linkattacher_msgs/": "Gazebo",
    "rmf_": "Open-RMF",
    "ros_gz_interfaces/srv/": "Gazebo",
    "unitree_api/": "Unitree",
    "unitree_go/": "Unitree",
    "unitree_hg/": "Unitree",
}
"""Interfaces that only such a system speaks: ``/spawn_entity`` of gazebo_ros is one for all robots, and Open-RMF's
``/robot_path_requests`` (of ``rmf_fleet_msgs``) one for the whole site.  MAVROS and PX4 are not among them: each
vehicle has a namespace, which the workspace chooses, unless the name begins as theirs do by default."""

_BY_CODE = frozenset({"literal", "format"})
_NAMES_SHOWN = 3
"""How many names of one place a message lists."""


@rule("NME001", scope=Scope.CODE, taste=True, says_if_installed=True, relative=False, allow=())
def hardcoded_name(system: System, options: Options) -> Iterator[Finding]:
    """Absolute names that only an edit of the code can change, one finding a create call and literal; those of one
    class become one, and those of a package whose convention they are."""
    relative, allowed = options.flag("relative"), options.texts("allow")
    varied = {end.place for end in system.endpoints if end.creation.name.resolution != "exact"}
    fixed: list[Endpoint] = []
    for endpoint in (end for node in system.nodes if not node.external for end in node.endpoints):
        name = endpoint.written
        if name is None or not _fixed_in_code(endpoint) or _conventional(endpoint, name, allowed):
            continue
        if endpoint.creation.name.origin_kind == "format" and endpoint.place in varied:
            continue  # only one of the parts that this call puts together is written in the code
        fixed.append(endpoint)
    wanted = [endpoint for endpoint in fixed if relative or (endpoint.written or "").startswith("/")]
    users = _files_that_use(wanted)
    reasons = [(end, _reason(system.workspace, end, len(users.get(_literal(end).file, ())))) for end in fixed]
    uses = [_use(system, end, reason) for end, reason in reasons if reason is not None and reason.severity is None]
    packages = with_convention(system.workspace, uses)
    findings: dict[tuple[Place, Place, str], Finding] = {}
    for endpoint, reason in reasons:
        if reason is not None and (relative or (endpoint.written or "").startswith("/")):
            diagnostic = _hardcoded(system, endpoint, reason, packages)
            findings.setdefault((diagnostic.place, endpoint.place, endpoint.written or ""), diagnostic)
    yield from (findings[key] for key in sorted(findings))


def _literal(endpoint: Endpoint) -> Place:
    """Where the name of an endpoint is written."""
    return endpoint.creation.name.origin or endpoint.creation.name_place or endpoint.place


def _use(system: System, endpoint: Endpoint, reason: Reason) -> FixedName:
    """A name with the class that fixes it, to see what the convention of a package is."""
    place = passed_from(system.workspace, endpoint) or _literal(endpoint)
    home = _home(system, place, endpoint.place)
    has_namespace = any(_namespaces_of(system.workspace, endpoint.node) or ())
    return FixedName(home, place, endpoint.written or "", follows=reason == FIXED and not has_namespace)


def _files_that_use(fixed: Sequence[Endpoint]) -> dict[str, set[str]]:
    """The files that create something under names that are written in another file, by that one.  A helper does not
    take its names from the file of the node that it works for: that one passes them."""
    users: dict[str, set[str]] = {}
    for endpoint in fixed:
        literal, node = endpoint.creation.name.origin, endpoint.node.blueprint
        if literal is None or literal.file == endpoint.place.file:
            continue
        if node is None or node.place.file != literal.file:
            users.setdefault(literal.file, set()).add(endpoint.place.file)
    return users


def _fixed_in_code(endpoint: Endpoint) -> bool:
    creation = endpoint.creation
    return (
        creation.name_place is not None
        and creation.name.resolution == "exact"
        and creation.name.origin_kind in _BY_CODE
        and not endpoint.node.test
        and endpoint.error is None
    )


def _conventional(endpoint: Endpoint, name: str, allowed: tuple[str, ...]) -> bool:
    """Whether a name is meant to be the same for all robots, or what RViz's tools send to: the copies that a player of
    bags makes of ``/tf`` are as the topic itself."""
    is_copy = endpoint.type == "tf2_msgs/msg/TFMessage" and name.startswith(("/tf_", "/tf_static_"))
    return name in ABSOLUTE | BY_CLICK or is_copy or any(fnmatchcase(name, pattern) for pattern in allowed)


def _hardcoded(system: System, endpoint: Endpoint, reason: Reason, packages: Mapping[Home, tuple[str, str]]) -> Finding:
    """``packages`` has that of each class which fixes absolute names as all its package does."""
    name, word = endpoint.written or "", NAMED[endpoint.kind]
    given = endpoint.creation.name_place or endpoint.place
    place = passed_from(system.workspace, endpoint) or _literal(endpoint)
    home = _home(system, place, endpoint.place)
    owner = _package(system.workspace, place.file) if reason.by_package else home
    key = reason.key
    if home in packages and reason == FIXED:
        owner, key = packages[home], CONVENTION
    diagnostic = finding(
        "NME001",
        place,
        reason.message(f"the {word} '{name}'", "", plural=False),
        help=_help(name, reason),
        related=[] if given == place else [Related(given, f"the {word} is created under this name here")],
        node=endpoint.node.name,
        identity=(home[1], word, name),
        group=(*owner, key, reason.state, reason.effect, reason.cure),
        sites=sites_of_name(system.workspace, given, name, stays=reason.key != FIXED.key),
    )
    return diagnostic if reason.severity is None else replace(diagnostic, severity=reason.severity)


def _reason(workspace: WorkspaceIndex | None, endpoint: Endpoint, users: int) -> Reason | None:
    """Why a name is as it is; ``users`` is the number of other files that take names from the file it is in.  None
    where whoever starts the node can choose another form of it."""
    node, name = endpoint.node, endpoint.written or ""
    if not name.startswith("/"):
        return RELATIVE
    owner = _owner(workspace, endpoint)
    if owner is not None:
        return of_others(owner)
    if is_of_a_model(workspace, name):
        return of_others("Gazebo")
    if must_be_absolute(workspace, endpoint):
        return DEMANDED
    if _private_to_foreign_node(workspace, name):
        return PRIVATE
    if _is_chosen(node, endpoint):
        return None
    if users > 1:
        return shared_by(users)
    if _is_remapped(workspace, endpoint):
        return REMAPPED
    if is_not_installed(workspace, endpoint.place.file):
        return NOT_INSTALLED if workspace is not None and workspace.manifests else WITHOUT_PACKAGE
    return _by_namespace(workspace, node)


def _owner(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> str | None:
    """The system outside of ROS that fixes a name, if one does: by the name, or by its type where no other node of the
    workspace is at the other end, so that it is that system which is spoken with.  A name below a namespace such as
    ``/robot_1`` is the workspace's own choice."""
    name, type_ = endpoint.written or "", endpoint.type or ""
    types = (other.type or "" for other in (endpoint, *endpoint.node.endpoints))
    if name.startswith(_OF_AUTOWARE) and any(other.startswith(("autoware_", "tier4_")) for other in types):
        return "Autoware"
    for prefix, owner in FIXED_BY_OTHERS.items():
        if name.startswith(prefix):
            return owner
    if _OF_A_JOINT.match(name):
        return "Gazebo"
    speaker = next((owner for prefix, owner in _TYPES_OF_OTHERS.items() if type_.startswith(prefix)), None)
    if speaker is None or name.rfind("/") > 0 or (workspace is not None and name in _spoken_here(workspace)):
        return None
    return speaker


@once
def _spoken_here(workspace: WorkspaceIndex) -> frozenset[str]:
    """The names that a node of the workspace provides and another uses."""
    return frozenset(
        connection.name
        for system in workspace.systems
        for connection in (*system.topics.values(), *system.services.values(), *system.actions.values())
        if any(
            user.node is not provider.node and not (user.external or provider.external)
            for user in connection.users
            for provider in connection.providers
        )
    )


def _private_to_foreign_node(workspace: WorkspaceIndex | None, name: str) -> bool:
    """Whether a name lies below that of a node (``/lidar_node/scan`` is its ``~/scan``) which no code of the workspace
    makes and no launch file starts."""
    owner, _, rest = name[1:].partition("/")
    if not owner.endswith("_node") or not rest or workspace is None:
        return False
    return not any(owner in (node.name or "").split("/") for system in workspace.systems for node in system.nodes)


def _is_remapped(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether launch files start the node, and each gives the name another form; no namespace does that."""
    blueprint = endpoint.node.blueprint
    if workspace is None or blueprint is None:
        return False
    names = workspace.launched_names(blueprint, endpoint.kind, endpoint.place)
    return bool(names) and endpoint.written not in names


def _namespaces_of(workspace: WorkspaceIndex | None, node: Node) -> frozenset[str] | None:
    """The namespaces that launch files start a node in; None where none starts it."""
    return None if workspace is None or node.blueprint is None else workspace.namespaces.get(key_of(node.blueprint))


def _by_namespace(workspace: WorkspaceIndex | None, node: Node) -> Reason:
    """What to do about absolute names: where launch files start the node in a namespace that one of them begins with,
    they would have it twice without their '/'."""
    given = _namespaces_of(workspace, node)
    written = [endpoint.written or "" for endpoint in node.endpoints]
    repeated = [
        namespace
        for namespace in given or ()
        if namespace and any(name.startswith(f"{namespace}/") for name in written)
    ]
    if not repeated:
        own = any(not name.startswith(("/", "~")) for name in written if name)
        return OF_ANOTHER if own and given and "" not in given else FIXED
    if given != frozenset(repeated[:1]):
        return PARAMETERS
    start = repeated[0]
    cure = f"remove '{start}/', the namespace in which the launch file starts the node"
    if not all(name.startswith(f"{start}/") for name in written if name.startswith("/")):
        cure += ", and take the other names from parameters"
    return replace(FIXED, cure=cure, namespace=start)


def _is_chosen(node: Node, endpoint: Endpoint) -> bool:
    """Whether another arm of the branch that takes this name makes the same endpoint under a name that something
    outside of the code decides, or that follows the namespace."""
    arms = endpoint.creation.branch_arms
    return bool(arms) and any(
        other.kind == endpoint.kind
        and other.type == endpoint.type
        and exclusive(arms, other.creation.branch_arms)
        and _may_be_meant(endpoint.written or "", other)
        for other in node.endpoints
    )


def _may_be_meant(name: str, other: Endpoint) -> bool:
    """Whether an endpoint of another arm has another form of a name: what is absolute, too, and ends in another word
    is another topic."""
    form = other.creation.name
    if form.resolution == "exact":
        return not (other.written or "/").startswith("/")
    text = form.text or ""
    last = text.rpartition("/")[2]
    return form.resolution != "partial" or not text.startswith("/") or "*" in last or name.endswith(f"/{last}")


def _help(name: str, reason: Reason) -> str:
    if reason.cure == FIXED.cure:
        bare = name.lstrip("/") or "…"
        return f"write '{bare}', so that the node's namespace applies, or take the name from a parameter"
    if reason.key != FIXED.key:
        return reason.cure
    start = f"{reason.namespace}/"
    if reason.namespace and name.startswith(start):
        return f"write '{name.removeprefix(start)}': the launch file starts the node in '{reason.namespace}'"
    parameter = name.rpartition("/")[2].lstrip("~") + "_name"
    return f"take the name from a parameter: self.declare_parameter('{parameter}', '{name}')"


def _package(workspace: WorkspaceIndex | None, file: str) -> tuple[str, str]:
    """The package of a file, or the folder of one beside the packages."""
    package = None if workspace is None else workspace.package_of(file)
    return ("", posixpath.dirname(file)) if package is None else (package, "")


def _home(system: System, literal: Place, call: Place) -> tuple[str, str]:
    """The file and the class that fix a name: those that the literal is in.  A constant of the module belongs to the
    class that uses it, if that is in the same file; the class is empty where there is none."""
    home = enclosing_class(system.workspace, literal)
    if home is None and literal.file == call.file:
        home = enclosing_class(system.workspace, call)
    return literal.file, home or ""


@folds("NME001")
def of_one_cause(findings: Sequence[Finding]) -> Finding:
    """The finding for all names that one class fixes, or the files of a package that nobody installs: at the first
    literal, the others related."""
    first = findings[0]
    if first.group[2] == CONVENTION and len(set(map(home_of, findings))) > 1:
        return one_of_package(findings)
    at: dict[Place, dict[str, None]] = {}
    for diagnostic in findings:
        at.setdefault(diagnostic.place, {})[_shown(diagnostic)] = None
    names = sorted({diagnostic.identity[-1] for diagnostic in findings})
    sites = all_sites(findings)
    here = ", ".join(list(at.pop(first.place))[:_NAMES_SHOWN])
    related = tuple(Related(place, ", ".join(at[place])) for place in sorted(at))
    if len(names) == 1:
        return replace(first, related=(*first.related, *related), sites=sites)
    _, _, key, state, effect, cure = first.group
    reason = Reason(key, state, effect, cure)
    return replace(
        first,
        message=reason.message(f"{len(names)} names {_owner_words(findings)}", f", such as {here}", plural=True),
        help=reason.cure,
        related=related,
        sites=sites,
        identity=(first.identity[0], *names),
    )


def _owner_words(findings: Sequence[Finding]) -> str:
    """Where the names of several findings are: in several files, a class or a file."""
    files = {diagnostic.place.file for diagnostic in findings}
    classes = {diagnostic.identity[0] for diagnostic in findings}
    if len(files) > 1:
        return f"in {len(files)} files"
    return "in this file" if len(classes) > 1 or "" in classes else f"of {findings[0].identity[0]}"


def _shown(diagnostic: Finding) -> str:
    _, word, name = diagnostic.identity
    return f"the {word} '{name}'"
