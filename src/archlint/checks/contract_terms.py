"""ARC001: the types and QoS that a contract allows."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase
from typing import TYPE_CHECKING

from archlint.analysis.coexistence import in_source_order
from archlint.architecture import Contract, Policy
from archlint.checks.registry import finding
from archlint.connections.links import counts, is_meant, named
from archlint.finding import Finding, Related
from archlint.model import (
    EntityKind,
)
from archlint.ros.qos import FieldName, allowed

if TYPE_CHECKING:
    from archlint.systems.model import System
    from archlint.systems.nodes import Connection, Endpoint


def other_types(system: System, contract: Contract) -> Iterator[Finding]:
    for connection in named(system, contract):
        for end in in_source_order((*connection.providers, *connection.users)):
            if end.type is None or not counts(end) or any(fnmatchcase(end.type, glob) for glob in contract.types):
                continue
            yield _differs(
                contract,
                connection,
                end,
                f"uses '{connection.name}' as {end.type}",
                " or ".join(contract.types),
                "use a type that the contract allows, or change the contract",
            )


def other_qos(system: System, contract: Contract) -> Iterator[Finding]:
    for topic in named(system, contract):
        for end in in_source_order((*topic.providers, *topic.users)):
            if end.qos is None or not counts(end) or not _is_an_end_of(contract, end):
                continue
            if end.qos.overridable or end.qos.parameter is not None:
                continue
            for policy, values in contract.policies:
                if allowed(end.qos, _field(policy), values) is False:
                    yield _wrong_policy(contract, topic, end, policy, values)


def _is_an_end_of(contract: Contract, end: Endpoint) -> bool:
    """Whether a contract about QoS asks for this end: for all of them where it names no node."""
    if not contract.provider and not contract.user:
        return True
    return is_meant(contract.provider if end.kind == EntityKind.PUBLISHER else contract.user, end.node)


def _field(policy: Policy) -> FieldName:
    """The field of a profile that holds a policy."""
    return "liveliness_lease" if policy == "liveliness-lease" else policy


def _wrong_policy(
    contract: Contract, topic: Connection, end: Endpoint, policy: Policy, values: tuple[str | float, ...]
) -> Finding:
    does = "publishes" if end.kind == EntityKind.PUBLISHER else "subscribes to"
    given = getattr(end.qos, _field(policy))
    unit = "" if isinstance(given, str) or policy == "depth" else " s"
    words = f"no {policy}" if given is None else f"{policy} {given}{unit}"
    return _differs(
        contract,
        topic,
        end,
        f"{does} '{topic.name}' with {words}",
        " or ".join(str(value) + unit for value in values) if given is not None else f"{policy} {values[0]} s",
        f"set the {policy} that the contract allows, or change the contract",
        (policy,),
    )


def _differs(
    contract: Contract,
    connection: Connection,
    end: Endpoint,
    does: str,
    wanted: str,
    help: str,
    more: tuple[str, ...] = (),
) -> Finding:
    return finding(
        "ARC001",
        end.place,
        f"{end.node.shown} {does}; the contract '{contract.name}' allows {wanted}",
        help=help,
        related=[Related(contract.place, "the contract is here")],
        node=end.node.name,
        identity=(contract.name, connection.name, end.node.name or "", *more),
    )
