"""Defects between the two ends of a topic, service or action, and in the names of endpoints."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from .defect import Defect, Sites, plants
from .python_source import Edit, Lines, PythonSource, argument, called, literal, misspelt_literal

_SIGNATURES = {
    "create_publisher": ("publisher", 0, ("msg_type",), 1, ("topic",)),
    "create_subscription": ("subscription", 0, ("msg_type",), 1, ("topic",)),
    "create_service": ("service", 0, ("srv_type",), 1, ("srv_name",)),
    "create_client": ("client", 0, ("srv_type",), 1, ("srv_name",)),
    "ActionServer": ("action server", 1, ("action_type",), 2, ("action_name",)),
    "ActionClient": ("action client", 1, ("action_type",), 2, ("action_name",)),
}


@dataclass(eq=False)
class End:
    """A create call whose name is a plain literal."""

    kind: str
    source: PythonSource
    call: ast.Call
    type: ast.expr
    name: ast.expr

    @property
    def qos(self) -> ast.expr | None:
        return argument(self.call, 2 if self.kind == "publisher" else 3, "qos_profile")

    @property
    def owner(self) -> tuple[str, str]:
        cls = self.source.class_of(self.call)
        return self.source.file, cls.name if cls is not None else ""

    @property
    def key(self) -> tuple[str, str]:
        """Name and type, as far as one file tells it."""
        written = self.source.text(self.type).decode().split(".")[-1]
        return (literal(self.name) or "").lstrip("/"), self.source.imported.get(written, ("", written))[1]


def ends(sites: Sites, kind: str) -> list[End]:
    found = []
    for source in sites.home.code:
        for call in source.calls:
            signature = _SIGNATURES.get(called(call))
            if signature is None or signature[0] != kind:
                continue
            type_, name = argument(call, *_flat(signature[1:3])), argument(call, *_flat(signature[3:5]))
            if type_ is not None and name is not None and literal(name):
                found.append(End(kind, source, call, type_, name))
    return found


def _flat(pair: tuple[int, tuple[str, ...]]) -> tuple[int, str]:
    return pair[0], pair[1][0]


def pairs(sites: Sites, provider: str, user: str, alone: bool = False) -> Iterator[tuple[End, End]]:
    """Ends of two classes with one literal name and one type; ``alone``: nobody else has the name."""
    providers, users = ends(sites, provider), ends(sites, user)
    every = [end.key[0] for end in (*providers, *users)]
    for one, other in product(providers, users):
        if one.key == other.key and one.owner != other.owner and (not alone or every.count(one.key[0]) == 2):
            yield one, other


def _places(*several: End) -> tuple[Lines, ...]:
    return tuple(end.source.lines(end.call) for end in several)


# --------------------------------------------------------------------------------------------- one name or type


@plants("one letter of a subscription's topic changed")
def topic_misspelt(sites: Sites) -> Iterator[Defect]:
    for one, other in pairs(sites, "publisher", "subscription", alone=True):
        edit = misspelt_literal(other.source, other.name)
        if edit is not None:
            yield Defect((edit,), ("TOP004",), _places(one, other), also=("NME001", "OWN001"))


def _other_type(end: End, module: str, name: str) -> tuple[Edit, ...] | None:
    if end.key[1] == name:
        return None
    first = end.source.with_import(f"from {module} import {name} as PlantedType")
    return None if first is None else (first, end.source.replaced(end.type, "PlantedType"))


def _typed(sites: Sites, provider: str, user: str, rule: str, module: str, name: str) -> Iterator[Defect]:
    for one, other in pairs(sites, provider, user):
        edits = _other_type(other, module, name)
        if edits is not None:
            # The code that goes with the old type is wrong now, and the package of the new one undeclared.
            yield Defect(edits, (rule,), _places(one, other), also=("MSG001", "MSG003", "PKG001", "TOP005"))


@plants("another message type at one end")
def topic_type(sites: Sites) -> Iterator[Defect]:
    yield from _typed(sites, "publisher", "subscription", "TOP001", "std_msgs.msg", "UInt64")


@plants("another service type at one end")
def service_type(sites: Sites) -> Iterator[Defect]:
    yield from _typed(sites, "service", "client", "SRV002", "std_srvs.srv", "SetBool")


@plants("another action type at one end")
def action_type(sites: Sites) -> Iterator[Defect]:
    yield from _typed(
        sites, "action server", "action client", "ACT002", "action_tutorials_interfaces.action", "Fibonacci"
    )


@plants("a name that ROS rejects")
def invalid_name(sites: Sites) -> Iterator[Defect]:
    for kind in ("publisher", "subscription", "service", "client", "action server", "action client"):
        for end in ends(sites, kind):
            name = literal(end.name) or ""
            start, stop = end.source.offsets(end.name)
            edit = Edit(end.source.file, stop - 1, stop - 1, b"-1")
            if stop - start > len(name):
                yield Defect((edit,), ("NME002",), (end.source.lines(end.name),), also=_ONE_END_LESS)


_ONE_END_LESS = ("TOP004", "OWN001", "OWN002", "TMO003", "TMO004", "EXE005")
"""What was said of the name is said of another one now, or of the others that have it."""


@plants("a second server under the name of another")
def second_server(sites: Sites) -> Iterator[Defect]:
    for kind in ("service", "action server"):
        for one, other in product(ends(sites, kind), ends(sites, kind)):
            if one.owner < other.owner and one.key[0] != other.key[0]:
                edit = other.source.replaced(other.name, repr(literal(one.name)))
                yield Defect((edit,), ("OWN002",), _places(one, other), also=("SRV002", "ACT002", "NME001"))


# ------------------------------------------------------------------------------------------------------------ QoS

_PROFILES = "from rclpy.qos import QoSProfile as PlantedProfile, ReliabilityPolicy as R, DurabilityPolicy as D"


def _depth(node: ast.expr | None) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, int)


def _with_profile(end: End, profile: str, imports: str = _PROFILES) -> tuple[Edit, ...] | None:
    first, qos = end.source.with_import(imports), end.qos
    return None if first is None or qos is None else (first, end.source.replaced(qos, profile))


@plants("best effort offered to a reliable subscription")
def best_effort(sites: Sites) -> Iterator[Defect]:
    for one, other in pairs(sites, "publisher", "subscription"):
        edits = _with_profile(one, "PlantedProfile(depth=1, reliability=R.BEST_EFFORT)")
        if edits is not None and _depth(other.qos):
            yield Defect(edits, ("QOS001",), _places(one, other), also=("PKG001",))


@plants("transient local requested of a volatile publisher")
def transient_local(sites: Sites) -> Iterator[Defect]:
    for one, other in pairs(sites, "publisher", "subscription"):
        edits = _with_profile(other, "PlantedProfile(depth=1, durability=D.TRANSIENT_LOCAL)")
        if edits is not None and _depth(one.qos):
            yield Defect(edits, ("QOS002",), _places(one, other), also=("PKG001",))


@plants("a deadline requested that nobody offers")
def deadline(sites: Sites) -> Iterator[Defect]:
    imports = f"{_PROFILES}; from rclpy.duration import Duration as PlantedDuration"
    for one, other in pairs(sites, "publisher", "subscription"):
        edits = _with_profile(other, "PlantedProfile(depth=1, deadline=PlantedDuration(seconds=0.5))", imports)
        if edits is not None and _depth(one.qos):
            yield Defect(edits, ("QOS003",), _places(one, other), also=("PKG001",))


@plants("a depth of 0")
def no_depth(sites: Sites) -> Iterator[Defect]:
    for kind in ("publisher", "subscription"):
        for end in ends(sites, kind):
            if end.qos is not None and _depth(end.qos):
                yield Defect((end.source.replaced(end.qos, "0"),), ("QOS004",), _places(end))
