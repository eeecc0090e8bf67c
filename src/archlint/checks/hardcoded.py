"""NME001: absolute names that only an edit of the code can change."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_not_installed
from archlint.analysis.completeness import enclosing_class
from archlint.analysis.fixed_names import must_be_absolute, passed_from
from archlint.analysis.name_sites import sites_of_name
from archlint.branches import exclusive
from archlint.checks.folding import all_sites, folds
from archlint.checks.foreign_names import is_foreign
from archlint.checks.name_conventions import CONVENTION, home_of, one_of_several_nodes
from archlint.checks.name_evidence import FixedName, is_needed_outside, namespaces_of, told
from archlint.checks.name_reasons import FIXED, PARAMETERS, RELATIVE, WITHOUT_PACKAGE, Reason, repeating, shared_by
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.names_in_data import is_in_data
from archlint.model import NAMED
from archlint.packaging.manifests import package_around
from archlint.ros.well_known import ABSOLUTE, BY_CLICK

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import System, WorkspaceIndex
    from archlint.systems.nodes import Endpoint, Node

_BY_CODE = frozenset({"literal", "format"})
_NAMES_SHOWN = 3
"""How many names of one place a message lists."""


@rule("NME001", scope=Scope.CODE, taste=True, says_if_installed=True, relative=False, everywhere=False, allow=())
def hardcoded_name(system: System, options: Options) -> Iterator[Finding]:
    """Absolute names that only an edit of the code can change, one finding a create call and literal; those of a
    class that launch files speak against become one, and so do those of all other classes."""
    relative, allowed = options.flag("relative"), options.texts("allow")
    names = _fixed_names(system, allowed, relative)
    findings: dict[tuple[Place, Place, str], Finding] = {}
    for name, evidence in told(system, names, options.flag("everywhere")):
        if relative or name.text.startswith("/"):
            diagnostic = _hardcoded(system, name, evidence)
            findings.setdefault((diagnostic.place, name.endpoint.place, name.text), diagnostic)
    yield from (findings[key] for key in sorted(findings))


def _fixed_names(system: System, allowed: tuple[str, ...], relative: bool) -> list[FixedName]:
    """The names that only an edit of the code can change, without those that are absolute for a reason."""
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
    return [
        FixedName(_home(system, _begin(system.workspace, end), end.place), end, reason)
        for end, reason in reasons
        if reason is not None
    ]


def _begin(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> Place:
    """Where the name of an endpoint begins."""
    return passed_from(workspace, endpoint) or _literal(endpoint)


def _literal(endpoint: Endpoint) -> Place:
    """Where the name of an endpoint is written."""
    return endpoint.creation.name.origin or endpoint.creation.name_place or endpoint.place


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


def _hardcoded(system: System, fixed: FixedName, evidence: Reason | None) -> Finding:
    """``evidence`` is what speaks against the form of the name, where something does."""
    endpoint, reason = fixed.endpoint, evidence or fixed.reason
    name, word = fixed.text, NAMED[endpoint.kind]
    given = endpoint.creation.name_place or endpoint.place
    place = _begin(system.workspace, endpoint)
    owner = (*fixed.home, reason.key) if reason.is_of_class else ("", "", CONVENTION)
    related = [] if given == place else [Related(given, f"the {word} is created under this name here")]
    if reason.place is not None:
        related.append(Related(reason.place, f"'{reason.other}' is relative here"))
    diagnostic = finding(
        "NME001",
        place,
        reason.message(f"the {word} '{name}'", "", plural=False),
        help=_help(name, reason),
        related=related,
        node=endpoint.node.name,
        identity=(fixed.home[1], word, name),
        group=(
            *owner,
            *(_package(system.workspace, place.file), reason.other, reason.state, reason.effect, reason.cure),
        ),
        sites=sites_of_name(system.workspace, given, name, stays=not reason.has_fix),
    )
    return diagnostic if reason.severity is None else replace(diagnostic, severity=reason.severity)


def _reason(workspace: WorkspaceIndex | None, endpoint: Endpoint, users: int) -> Reason | None:
    """Why a name is reported; ``users`` is the number of other files that take names from the file it is in.  None
    where it has to be absolute, where whoever starts the node can choose another form of it, and where nobody starts
    the file but who works on it."""
    node, name = endpoint.node, endpoint.written or ""
    if not name.startswith("/"):
        return RELATIVE
    if is_foreign(workspace, endpoint) or must_be_absolute(workspace, endpoint):
        return None
    if (
        _is_chosen(node, endpoint)
        or _is_beside_its_relative_form(endpoint)
        or _is_remapped(workspace, endpoint)
        or _is_beside(workspace, _literal(endpoint).file)
        or is_in_data(workspace, name)
        or is_needed_outside(workspace, endpoint)
        or _is_looked_up(workspace, endpoint)
    ):
        return None
    if users > 1:
        return shared_by(users)
    if _is_run_by_hand(workspace, endpoint.place.file):
        return None
    if is_not_installed(workspace, endpoint.place.file):
        return None if workspace is not None and workspace.manifests else WITHOUT_PACKAGE
    return _by_namespace(workspace, node)


def _is_beside_its_relative_form(endpoint: Endpoint) -> bool:
    """Whether a node has both ``/heading`` and ``heading``, of two types: it tells them apart, and one form for both
    would put two types on one topic."""
    name = (endpoint.written or "").removeprefix("/")
    return any(end.written == name and end.type != endpoint.type for end in endpoint.node.endpoints)


_SHOWN_OR_TOOL = frozenset({"example", "examples", "sample", "samples", "tool", "tools"})


def _is_beside(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a file is an example or a tool of its package, or lies beside the packages of its workspace."""
    if workspace is None or not workspace.manifests:
        return False
    package = package_around(workspace, posixpath.dirname(file))
    if package is None:
        return workspace.package_of(file) is None
    folder = posixpath.dirname(package.manifest.relative)
    inside = posixpath.dirname(file).removeprefix(folder).strip("/").split("/")
    return not (_SHOWN_OR_TOOL - {package.name}).isdisjoint(inside)


_NAMES_OF_THE_GRAPH = ("get_topic_names_and_types", "get_service_names_and_types")


def _is_looked_up(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether code beside a name asks ROS which names there are: those are absolute, and are compared with it."""
    files = (endpoint.place.file, _literal(endpoint).file)
    return workspace is not None and any(
        workspace.code.mentions(file, word) for file in files for word in _NAMES_OF_THE_GRAPH
    )


def _is_run_by_hand(workspace: WorkspaceIndex | None, file: str) -> bool:
    """Whether a script is in a package whose CMake files install no program at all."""
    package = None if workspace is None or not file.endswith(".py") else workspace.package_of(file)
    installs = None if workspace is None or package is None else workspace.installs.get(package)
    if installs is None or installs.open_executables or installs.executables:
        return False
    return any(path.endswith("CMakeLists.txt") for path in installs.build_files)


def _is_remapped(workspace: WorkspaceIndex | None, endpoint: Endpoint) -> bool:
    """Whether launch files start the node, and each gives the name another form; no namespace does that."""
    blueprint = endpoint.node.blueprint
    if workspace is None or blueprint is None:
        return False
    names = workspace.launched_names(blueprint, endpoint.kind, endpoint.place)
    return bool(names) and endpoint.written not in names


def _by_namespace(workspace: WorkspaceIndex | None, node: Node) -> Reason | None:
    """What to do about absolute names: where launch files start the node in a namespace that one of them begins with,
    they would have it twice without their '/'.  Beside relative names, and in a namespace, an absolute one belongs to
    somebody else."""
    given = namespaces_of(workspace, node.blueprint)
    written = [endpoint.written or "" for endpoint in node.endpoints]
    repeated = [
        namespace for namespace in given if namespace and any(name.startswith(f"{namespace}/") for name in written)
    ]
    if not repeated:
        own = any(not name.startswith(("/", "~")) for name in written if name)
        return None if own and "" not in given else FIXED
    if given != frozenset(repeated[:1]):
        return PARAMETERS
    start = repeated[0]
    cure = f"remove '{start}/', the namespace in which the launch file starts the node"
    if not all(name.startswith(f"{start}/") for name in written if name.startswith("/")):
        cure += ", and take the other names from parameters"
    return repeating(start, cure)


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
    if not reason.has_fix:
        return reason.cure
    start = f"{reason.namespace}/"
    if reason.namespace and name.startswith(start):
        return f"write '{name.removeprefix(start)}': the launch file starts the node in '{reason.namespace}'"
    parameter = name.rpartition("/")[2].lstrip("~") + "_name"
    return f"take the name from a parameter: self.declare_parameter('{parameter}', '{name}')"


def _package(workspace: WorkspaceIndex | None, file: str) -> str:
    """The package of a file; empty where it is in none."""
    package = None if workspace is None else workspace.package_of(file)
    return package or ""


def _home(system: System, literal: Place, call: Place) -> tuple[str, str]:
    """The file and the class that fix a name: those that the literal is in.  A constant of the module belongs to the
    class that uses it, if that is in the same file; the class is empty where there is none."""
    home = enclosing_class(system.workspace, literal)
    if home is None and literal.file == call.file:
        home = enclosing_class(system.workspace, call)
    return literal.file, home or ""


_DECISIVE = 3
"""How much of a group says what becomes one finding; what comes after tells of each name."""


@folds("NME001", common=_DECISIVE, across_severities=True)
def of_one_cause(findings: Sequence[Finding]) -> Finding:
    """The finding for all names that one class fixes, or several classes of a workspace, where something speaks against
    the form or else at the first literal, the others related."""
    findings = sorted(findings, key=lambda diagnostic: not diagnostic.group[_DECISIVE + 1])  # evidence comes first
    first = findings[0]
    if len(set(map(home_of, findings))) > 1:
        packages = [diagnostic.group[_DECISIVE] for diagnostic in findings]
        return one_of_several_nodes(findings, packages, first.group[_DECISIVE + 1])
    at: dict[Place, dict[str, None]] = {}
    for diagnostic in findings:
        at.setdefault(diagnostic.place, {})[_shown(diagnostic)] = None
    names = sorted({diagnostic.identity[-1] for diagnostic in findings})
    sites = all_sites(findings)
    here = ", ".join(list(at.pop(first.place))[:_NAMES_SHOWN])
    related = tuple(Related(place, ", ".join(at[place])) for place in sorted(at))
    if len(names) == 1 or first.group[_DECISIVE + 1]:  # what is at the other end belongs to it
        related = (*first.related, *related)
    if len(names) == 1:
        return replace(first, related=related, sites=sites)
    state, effect, cure = first.group[_DECISIVE + 2 :]
    reason = Reason(first.group[2], state, effect, cure)
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
