"""NME002: names that ROS rejects."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_other_places, with_others
from archlint.checks.launched_names import is_given_by_launch, is_renamed, names_given_by_launch
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import NAMED
from archlint.ros import names
from archlint.suggestions import listed
from archlint.systems.overrides import Setting, applied

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model import Creation
    from archlint.systems.model import System
    from archlint.systems.nodes import Endpoint, Node


def _written_elsewhere(endpoints: list[Endpoint]) -> list[Related]:
    """Where the names are written, if not at the create call itself."""
    written: dict[Place, str] = {}
    for endpoint in endpoints:
        origin, at = endpoint.creation.name.origin, endpoint.creation.name_place
        if origin is not None and origin != at and endpoint.written is not None:
            written.setdefault(origin, endpoint.written)
    return [Related(place, f"'{written[place]}' is written here") for place in sorted(written)]


@rule("NME002", scope=Scope.AS_LAUNCHED)
def invalid_name(system: System, options: Options) -> Iterator[Finding]:
    """Names of nodes and endpoints that rcl refuses."""
    yield from names_given_by_launch(system)
    findings: dict[tuple[Place, str], Finding] = {}
    for node in system.entries:
        if node.external:
            continue  # what its remappings say is told where they stand
        own = () if is_renamed(system, node) else _invalid_node(node)
        for diagnostic in (*own, *_invalid_endpoints(system, node)):
            findings.setdefault((diagnostic.place, diagnostic.message), diagnostic)
    yield from (findings[key] for key in sorted(findings))


def _invalid_node(node: Node) -> Iterator[Finding]:
    blueprint = node.blueprint
    if node.error is None or blueprint is None or node.test or node.resolution == "partial":
        return
    if is_given_by_launch(node):
        return
    place = blueprint.name.origin or blueprint.place
    if not blueprint.name.text and place.line != blueprint.place.line:
        return  # a text that is empty at first, and that code fills in as data come
    shown = node.name or blueprint.name.text or ""
    if names.has_placeholder(shown):
        return
    yield finding(
        "NME002",
        place,
        f"ROS rejects the name of the node '{shown}': {node.error}",
        help="use letters, digits and '_' only, with no digit in front; give the namespace separately (namespace=…)",
        related=[] if place == blueprint.place else [Related(blueprint.place, "the node is defined here")],
        node=node.name,
        identity=("node", shown),
    )


def _invalid_endpoints(system: System, node: Node) -> Iterator[Finding]:
    values: dict[Place, tuple[Setting, list[Endpoint]]] = {}
    for endpoint in node.endpoints:
        creation = endpoint.creation
        if endpoint.error is None or not (endpoint.resolved or _must_be_set(endpoint)) or node.test:
            continue
        if names.has_placeholder(endpoint.written or ""):
            continue
        by_parameter = endpoint.resolution == "parameter" or _must_be_set(endpoint)
        value = _set_by_launch(system, endpoint) if by_parameter else None
        if value is not None:
            values.setdefault(value.place, (value, []))[1].append(endpoint)
            continue
        if by_parameter and (creation.conditional or is_renamed(system, node)):
            # The branch may not be taken with that value, or launch files start the node: their systems report it.
            continue
        if _is_one_of_several(endpoint) or (_must_be_set(endpoint) and system.name is None):
            continue  # who starts the node by hand sees what it lacks
        relative = _relative(endpoint)
        if relative is not None and is_renamed(system, node):
            continue  # launch files start it, perhaps in a namespace: their systems report it
        shown, word = endpoint.written or "", NAMED[endpoint.kind]
        if not shown and endpoint.resolution == "exact" and _is_empty_at_first(creation):
            continue
        default = f", the default of the parameter '{endpoint.parameter}'" if by_parameter else ""
        if relative is not None and creation.name.origin_kind == "node_name":
            default = " of a node in no namespace"
        only_complete = names.validate_topic_name(shown) is None and endpoint.name != shown
        complete = f" (full name: '{endpoint.name}')" if only_complete else ""
        yield finding(
            "NME002",
            creation.name_place or creation.place,
            f"ROS rejects the {word} name '{shown}'{default}{complete}: {endpoint.error}",
            help="use letters, digits, '_' and '/' only, with no digit after a '/'; '~/' may only come first"
            if relative is None
            else f"write the relative name '{relative}': ROS adds the node's namespace",
            related=_written_elsewhere([endpoint]),
            node=node.name,
            identity=(creation.function, endpoint.kind, shown),
            group=_cause(endpoint, relative, by_parameter),
        )

    yield from (_bad_value(value, endpoints) for value, endpoints in values.values())


def _cause(endpoint: Endpoint, relative: str | None, by_parameter: bool) -> tuple[str, ...]:
    """What the names of a function have in common: the namespace that is empty, or the default of their parameters; or
    what those of a file may have in common, which :func:`_by_literal` tells."""
    where = (endpoint.creation.place.file, endpoint.creation.function)
    if relative is not None:
        return (*where, _NO_NAMESPACE, "")
    if by_parameter:
        return (*where, _DEFAULT, endpoint.written or "", endpoint.parameter or "")
    origin = endpoint.creation.name.origin or endpoint.creation.name_place
    written = "" if origin is None else f"{origin.file}:{origin.span}"
    return (where[0], "", _LITERAL, endpoint.error or "", _up_to_the_fault(endpoint), written)


_NO_NAMESPACE, _DEFAULT, _LITERAL = "no namespace", "default", "literal"


def _up_to_the_fault(endpoint: Endpoint) -> str:
    """How a name begins, up to what is wrong with it; empty where that is its first character."""
    shown, complete = endpoint.written or "", endpoint.name or ""
    for text, wrong in ((shown, names.validate_topic_name(shown)), (complete, names.validate_full_name(complete))):
        if wrong is not None:
            return text[: wrong.index + 1] if wrong.index else ""
    return ""


def _by_literal(several: Sequence[Finding]) -> Iterable[Sequence[Finding]]:
    """The findings of a file by the text that makes the names wrong: one line makes all of them, or they begin alike up
    to what is wrong."""
    if _LITERAL not in several[0].group[2:3]:
        return (several,)
    rows: list[list[Finding]] = []
    for each in several:
        alike = [row for row in rows if any(_share_literal(each, other) for other in row)]
        rows = [row for row in rows if row not in alike]
        rows.append([*(other for row in alike for other in row), each])
    return rows


def _share_literal(first: Finding, second: Finding) -> bool:
    (*_, start, origin), (*_, other_start, other_origin) = first.group, second.group
    return (start != "" and start == other_start) or (origin != "" and origin == other_origin)


def _is_empty_at_first(creation: Creation) -> bool:
    """Whether an empty name comes from a line above, where code fills it in as data come."""
    origin, given = creation.name.origin, creation.name_place
    return origin is not None and given is not None and origin.line != given.line


def _must_be_set(endpoint: Endpoint) -> bool:
    """Whether a name is the empty default of a parameter: it stands for one that whoever starts the node has to set."""
    return endpoint.written == "" and endpoint.parameter is not None


def _set_by_launch(system: System, endpoint: Endpoint) -> Setting | None:
    """The value that a launch file or a parameter file sets, of the parameter that decides a name."""
    started = endpoint.node.started
    if started is None or system.workspace is None:
        return None
    settings = applied(started, endpoint.node.name, system.workspace.parameters_of)
    return next((setting for setting in settings if setting.name == endpoint.parameter), None)


def _bad_value(value: Setting, endpoints: Sequence[Endpoint]) -> Finding:
    """One finding for the names that are made of one value, where that is set."""
    first, *_ = endpoints
    help_ = f"set '{value.name}' to a value that may be part of a name: letters, digits, '_' and '/'"
    if "start with a number" in (first.error or ""):
        help_ = "put letters in front of the value where the name is built"
    return finding(
        "NME002",
        value.value_place or value.place,
        f"ROS rejects the {NAMED[first.kind]} name '{first.written}', which is built from this value of the parameter "
        f"'{value.name}': {first.error}",
        help=help_,
        related=[
            Related(end.creation.name.origin or end.place, f"'{end.written}' is built from it here")
            for end in endpoints
        ],
        node=first.node.name,
        identity=("value", value.name, first.written or ""),
    )


def _relative(endpoint: Endpoint) -> str | None:
    """The name without the empty namespace that the code puts in front: ``//scan`` of ``f'{namespace}/scan'``."""
    shown = endpoint.written or ""
    rest = shown.lstrip("/")
    return rest if shown.startswith("//") and rest and names.validate_topic_name(rest) is None else None


@folds("NME002", common=4, rows=_by_literal)
def _of_one_cause(several: Sequence[Finding]) -> Finding:
    """One finding for all names that a function begins with an empty namespace, or has of parameters with the same
    default, or that one text of a file makes wrong."""
    first, *others = several
    if _LITERAL in first.group[2:3]:
        told = [replace(each, message=f"'{each.identity[2]}' is used here") for each in others]
        return with_others([first, *told], "another name of the file goes", "more names of the file go", "the same way")
    if _DEFAULT in first.group[2:3]:
        parameters = dict.fromkeys(f"'{other.group[4]}'" for other in others if other.group[4] != first.group[4])
        more = f"; so is the default of {listed([*parameters])}" if parameters else ""
        return replace(with_other_places(several, "it is used here"), message=first.message + more)
    written = list(dict.fromkeys(other.identity[2] for other in others if other.identity[2] != first.identity[2]))
    more = f"; the same applies to {listed([repr(name) for name in written])}" if written else ""
    related = [Related(other.place, f"'{other.identity[2]}' is used here") for other in others]
    return replace(first, message=first.message + more, related=(*first.related, *related))


def _is_one_of_several(endpoint: Endpoint) -> bool:
    """Whether the call has another name, too, that only data decides, or that goes on where this one ends: what ROS
    rejects may then be what stands there until somebody fills it in, or what is left where a file does not say."""
    creation, text = endpoint.creation, endpoint.written or ""
    return bool(creation.branch_arms or creation.conditional) and any(
        other is not endpoint and other.place == endpoint.place and _is_open(other, text)
        for other in endpoint.node.endpoints
    )


def _is_open(other: Endpoint, text: str) -> bool:
    """Whether a name is not wholly known, or begins with ``text`` and goes on."""
    written = other.written
    if written is None or other.resolution in ("partial", "unknown"):
        return True
    return written.startswith(text) and written != text
