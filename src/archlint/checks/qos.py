"""QOS001 to QOS003: offers that do not serve a request."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.analysis.aside import is_disused, is_not_installed
from archlint.analysis.coexistence import has_launch_files, known_to_coexist
from archlint.checks.folding import folds
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.connections.delivery import Undelivered, fits_any, fitting, policy_words, undelivered
from archlint.connections.outside_publishers import undelivered_from_outside
from archlint.finding import Finding, Related, Severity

if TYPE_CHECKING:
    from archlint.connections.outside_publishers import FromOutside
    from archlint.ros.qos import DurationPolicy, StrengthPolicy, Verdict
    from archlint.systems.model import System


@rule("QOS001", scope=Scope.SYSTEM)
def qos_reliability_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Best-effort publishers and reliable subscriptions of one topic."""
    yield from _mismatches("QOS001", system, {"reliability"})


@rule("QOS002", scope=Scope.SYSTEM)
def qos_durability_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Volatile publishers and transient-local subscriptions of one topic."""
    yield from _mismatches("QOS002", system, {"durability"})


@rule("QOS003", scope=Scope.SYSTEM)
def qos_deadline_mismatch(system: System, options: Options) -> Iterator[Finding]:
    """Deadlines, liveliness and leases that are requested tighter than offered."""
    yield from _mismatches("QOS003", system, {"deadline", "liveliness", "liveliness_lease"})


def _mismatches(code: str, system: System, policies: set[DurationPolicy | StrengthPolicy]) -> Iterator[Finding]:
    """One finding for each subscription (one create call) and policy, with all publishers that do not fit."""
    against: dict[tuple[int, str], list[tuple[Undelivered, Verdict]]] = {}
    served: dict[int, bool] = {}
    for pair in undelivered(system):
        request = pair.request
        if id(request) not in served:
            served[id(request)] = fits_any(system, request)
        if served[id(request)] and (not _is_proven(system, pair) or _is_of_loose_scripts(system, pair)):
            continue  # it was made for the publisher that fits
        if _is_put_aside(system, pair):
            continue
        for verdict in pair.verdicts:
            if verdict.policy in policies:
                against.setdefault((id(pair.request), verdict.policy), []).append((pair, verdict))
    for pairs in against.values():
        yield _mismatch(code, system, pairs)
    for row in undelivered_from_outside(system):
        for verdict in row.verdicts:
            if verdict.policy in policies:
                yield _from_outside(code, row, verdict)


def _from_outside(code: str, row: FromOutside, verdict: Verdict) -> Finding:
    user = row.request
    offered, requested = policy_words(verdict, verdict.offered), policy_words(verdict, verdict.requested)
    diagnostic = finding(
        code,
        user.place,
        f"{user.node.shown} requests {requested} on '{user.name}', but {row.publisher} offers {offered}: no message "
        "arrives",
        help=_AT_SUBSCRIPTION[verdict.policy],
        node=user.node.name,
        identity=(user.name or "", verdict.policy, row.publisher),
        group=(row.publisher, verdict.policy, user.place.file, offered, requested, _OUTSIDE),
    )
    return replace(diagnostic, severity=min(diagnostic.severity, Severity.WARNING))


def _mismatch(code: str, system: System, pairs: list[tuple[Undelivered, Verdict]]) -> Finding:
    """The finding, a warning where there are launch files and none of them starts both nodes."""
    pairs = sorted(pairs, key=lambda pair: not _is_proven(system, pair[0]))  # the others stay in their order
    first, verdict = pairs[0]
    user, offer = first.request, first.offer
    offered, requested = policy_words(verdict, verdict.offered), policy_words(verdict, verdict.requested)
    served = fitting(system, user)
    lost = "no message arrives"
    if served:
        lost = f"its messages do not arrive, those of {served[0].node.shown} do"
    proven = _is_proven(system, first)
    loose = all(_is_of_loose_scripts(system, pair) for pair, _ in pairs)
    if loose:
        lost += ", in scripts that no installed program uses"
    elif not proven:
        lost += ", if they run together: no launch file here starts both by default"
    cause = (str(offer.place), verdict.policy, user.name or "", offer.node.name or "", offered, requested, lost)
    at = offer if user.external else user
    diagnostic = finding(
        code,
        at.place,
        f"{user.node.shown} requests {requested} on '{user.name}', but {offer.node.shown} offers {offered}: {lost}",
        help=_AT_PUBLISHER[verdict.policy] if user.external else _ADVICE[verdict.policy],
        related=[Related(user.place, f"{user.node.shown} requests {requested}")]
        if user.external
        else [
            Related(pair.offer.place, f"{pair.offer.node.shown} offers {policy_words(mismatch, mismatch.offered)}")
            for pair, mismatch in pairs
        ],
        node=at.node.name,
        identity=(user.name or "", verdict.policy, *(pair.offer.node.name or "" for pair, _ in pairs)),
        group=cause if len(pairs) == 1 else (),
    )
    most = Severity.INFO if loose else diagnostic.severity if proven else Severity.WARNING
    return replace(diagnostic, severity=min(diagnostic.severity, most))


def _at_the_publisher(findings: Sequence[Finding]) -> Finding:
    """The finding for a publisher that does not fit several subscriptions: one line of its own mends them all."""
    first, *others = findings
    if first.group[-1] == _OUTSIDE:
        return _at_the_subscriptions(findings)
    _, policy, topic, publisher, offered, requested, lost = first.group
    several = f"{len(findings)} subscriptions request {requested}"
    return replace(
        first,
        message=f"{publisher} offers {offered} on '{topic}', but {several}: {lost}",
        help=_AT_PUBLISHER[policy],
        related=(*first.related, *(Related(other.place, f"{other.node} requests {requested}") for other in others)),
        identity=(topic, policy, publisher),
    )


def _at_the_subscriptions(findings: Sequence[Finding]) -> Finding:
    """The finding for several subscriptions of a file to what one publishes outside."""
    first = findings[0]
    publisher, _, _, offered, requested, _ = first.group
    others = {told.place: told for told in findings if told.place != first.place}.values()
    if not others:
        return first
    topics = f"'{first.identity[0]}' and {len(others)} more topic{'s' if len(others) > 1 else ''}"
    return replace(
        first,
        message=f"{first.node} requests {requested} on {topics}, but {publisher} offers {offered}: no message arrives",
        related=(*first.related, *(Related(other.place, f"'{other.identity[0]}' is one of them") for other in others)),
        identity=(*first.identity, *(other.identity[0] for other in others)),
    )


_OUTSIDE = "from outside"
RELIABILITY = folds("QOS001", across_systems=True)(_at_the_publisher)
DURABILITY = folds("QOS002", across_systems=True)(_at_the_publisher)
DEADLINE = folds("QOS003", across_systems=True)(_at_the_publisher)


def _is_of_loose_scripts(system: System, pair: Undelivered) -> bool:
    """Whether both nodes are in scripts that no package installs, where there are packages that install programs, and
    no program starts both."""
    workspace, ends = system.workspace, (pair.offer, pair.request)
    if workspace is None or not workspace.manifests or known_to_coexist(system, pair.offer.node, pair.request.node):
        return False
    return all(is_not_installed(workspace, end.place.file) for end in ends)


def _is_put_aside(system: System, pair: Undelivered) -> bool:
    """Whether one of two nodes is in a file that is no longer in use, and nothing starts both: who changes the other
    for its sake cuts that off from those which are in use."""
    if known_to_coexist(system, pair.offer.node, pair.request.node):
        return False
    return any(is_disused(system.workspace, end.place.file) for end in (pair.offer, pair.request))


def _is_proven(system: System, pair: Undelivered) -> bool:
    """Whether something is seen to start both nodes, or there is no launch file that could: then nobody can say that
    one is left out."""
    if system.closed or not has_launch_files(system):
        return True
    return pair.offer.node is pair.request.node or known_to_coexist(system, pair.offer.node, pair.request.node)


_ADVICE = {
    "reliability": "subscribe with best effort, or publish with reliable",
    "durability": "publish with transient local durability, or subscribe with volatile and do without earlier messages",
    "deadline": "let the publisher offer the requested deadline, or request none",
    "liveliness": "let the publisher assert its liveliness by topic, or request automatic liveliness",
    "liveliness_lease": "let the publisher offer a lease no longer than the requested one, or request none",
}
_AT_SUBSCRIPTION = {
    "reliability": "subscribe with best effort, as qos_profile_sensor_data does",
    "durability": "subscribe with volatile durability",
    "deadline": "request no deadline",
    "liveliness": "request automatic liveliness",
    "liveliness_lease": "request no lease",
}
"""What to write where the publisher is outside of the workspace."""
_AT_PUBLISHER = {
    "reliability": "publish with reliable",
    "durability": "publish with transient local durability",
    "deadline": "offer the requested deadline",
    "liveliness": "assert liveliness by topic",
    "liveliness_lease": "offer a lease no longer than the requested one",
}
"""What to write where one publisher does not fit several subscriptions."""
