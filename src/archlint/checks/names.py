"""NME001 and NME002: names that are fixed in the code, and names that ROS rejects."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.checks.registry import Options, finding, rule
from archlint.finding import Finding, Related
from archlint.program.model import (
    ACTION_CLIENT,
    ACTION_SERVER,
    CLIENT,
    PUBLISHER,
    SERVICE,
    SUBSCRIBER,
)
from archlint.system import names

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.system.model import Endpoint, Node, System

ABSOLUTE_BY_CONVENTION = (
    "/tf",
    "/tf_static",
    "/clock",
    "/rosout",
    "/parameter_events",
    "/diagnostics",
    "/robot_description",
)
_WORDS = {
    PUBLISHER: "topic",
    SUBSCRIBER: "topic",
    SERVICE: "service",
    CLIENT: "service",
    ACTION_SERVER: "action",
    ACTION_CLIENT: "action",
}
_BY_CODE = frozenset({"literal", "format"})


@rule("NME001", relative=False, allow=())
def hardcoded_name(system: System, options: Options) -> Iterator[Finding]:
    """Absolute names that only an edit of the code can change, one finding a create call."""
    relative, allowed = options.flag("relative"), options.texts("allow")
    sites: dict[Place, list[Endpoint]] = {}
    varied = {one.place for one in system.endpoints if one.creation.name.resolution != "exact"}
    for endpoint in system.endpoints:
        name = endpoint.written
        if name is None or not _fixed_in_code(endpoint) or _conventional(name, allowed):
            continue
        if endpoint.creation.name.origin_kind == "format" and endpoint.place in varied:
            continue  # only one of the parts that this call puts together is written in the code
        if relative or name.startswith("/"):
            sites.setdefault(endpoint.place, []).append(endpoint)
    for place in sorted(sites):
        yield _hardcoded(sites[place])


def _fixed_in_code(endpoint: Endpoint) -> bool:
    creation = endpoint.creation
    return (
        creation.name_place is not None
        and creation.name.resolution == "exact"
        and creation.name.origin_kind in _BY_CODE
        and not endpoint.node.test
        and endpoint.error is None
    )


def _conventional(name: str, allowed: tuple[str, ...]) -> bool:
    return name in ABSOLUTE_BY_CONVENTION or any(fnmatchcase(name, pattern) for pattern in allowed)


def _hardcoded(endpoints: list[Endpoint]) -> Finding:
    first = endpoints[0]
    several = len({endpoint.written for endpoint in endpoints})
    word, name = _WORDS[first.kind], first.written or ""
    others = f" (one of {several})" if several > 1 else ""
    absolute = name.startswith("/")
    bare = name.lstrip("/") or "…"
    return finding(
        "NME001",
        first.creation.name_place or first.place,
        f"the {word} '{name}'{others} is "
        + ("absolute and fixed in the code: no namespace moves it" if absolute else "fixed in the code"),
        help=f"write '{bare}', which follows the node's namespace, or take the name from a parameter"
        if absolute
        else f"take the name from a parameter: self.declare_parameter('{_parameter(bare)}', '{name}')",
        related=_written_elsewhere(endpoints),
        node=first.node.name,
        identity=(first.creation.function, first.kind, name),
    )


def _parameter(name: str) -> str:
    return name.rpartition("/")[2].lstrip("~") + "_name"


def _written_elsewhere(endpoints: list[Endpoint]) -> list[Related]:
    """Where the names are written, if not at the create call itself."""
    found: dict[Place, str] = {}
    for endpoint in endpoints:
        origin, at = endpoint.creation.name.origin, endpoint.creation.name_place
        if origin is not None and origin != at and endpoint.written is not None:
            found.setdefault(origin, endpoint.written)
    return [Related(place, f"'{found[place]}' is written here") for place in sorted(found)]


@rule("NME002")
def invalid_name(system: System, options: Options) -> Iterator[Finding]:
    """Names of nodes and endpoints that rcl refuses."""
    found: dict[tuple[Place, str], Finding] = {}
    for node in system.nodes:
        for one in (*_invalid_node(node), *_invalid_endpoints(node)):
            found.setdefault((one.place, one.message), one)
    yield from (found[key] for key in sorted(found))


def _invalid_node(node: Node) -> Iterator[Finding]:
    blueprint = node.blueprint
    if node.error is None or blueprint is None or node.test or node.resolution == "partial":
        return
    place = blueprint.name.origin or blueprint.place
    shown = node.name or blueprint.name.text or ""
    yield finding(
        "NME002",
        place,
        f"ROS rejects the name of the node '{shown}': {node.error}",
        help="a node's name is one part of letters, digits and '_' that starts with no digit; its "
        "namespace is given apart (namespace=…)",
        related=[] if place == blueprint.place else [Related(blueprint.place, "the node is defined here")],
        node=node.name,
        identity=("node", shown),
    )


def _invalid_endpoints(node: Node) -> Iterator[Finding]:
    for endpoint in node.endpoints:
        creation = endpoint.creation
        if endpoint.error is None or not endpoint.resolved or node.test:
            continue
        if endpoint.resolution == "parameter" and creation.conditional:
            continue  # with that value of the parameter the branch may not be taken
        shown, word = endpoint.written or "", _WORDS[endpoint.kind]
        default = f", the default of the parameter '{endpoint.parameter}'" if endpoint.resolution == "parameter" else ""
        only_complete = names.validate_topic_name(shown) is None
        complete = f" (complete: '{endpoint.name}')" if only_complete else ""
        yield finding(
            "NME002",
            creation.name_place or creation.place,
            f"ROS rejects the {word} name '{shown}'{default}{complete}: {endpoint.error}",
            help="a name is made of parts of letters, digits and '_' with '/' between them; no part starts "
            "with a digit, and '~/' stands only in front",
            related=_written_elsewhere([endpoint]),
            node=node.name,
            identity=(creation.function, endpoint.kind, shown),
        )
