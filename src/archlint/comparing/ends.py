"""The ends of topics, services and actions: which came, went and changed, and who is at the other end."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from archlint.comparing import qos
from archlint.comparing.changes import Change, Judgement, Spot, Status, Subject, breaking, risky, safe
from archlint.comparing.graphs import KINDS, End, EndKind, Family, Graph, Node
from archlint.comparing.pairing import Pairs, paired_ends
from archlint.records import dataclass

NOUNS: dict[EndKind, Subject] = {
    "publisher": "publisher",
    "subscriber": "subscriber",
    "service": "service",
    "client": "client",
    "action_server": "action_server",
    "action_client": "action_client",
}
_USES: dict[Family, tuple[str, str]] = {
    "topic": ("subscribes to it", "subscribe to it"),
    "service": ("calls it", "call it"),
    "action": ("uses it", "use it"),
}
_OFFER = ("offers", "offer")
_OFFERS: dict[Family, tuple[str, str]] = {
    "topic": ("publishes it", "publish it"),
    "service": ("offers it", "offer it"),
    "action": ("offers it", "offer it"),
}


@dataclass(frozen=True)
class Placed:
    """An end with its node."""

    node: Node
    kind: EndKind
    end: End


class Ends:
    """The ends of a graph by what they are ends of; those of test code aside."""

    def __init__(self, graph: Graph) -> None:
        self._ends: dict[tuple[Family, str], list[Placed]] = {}
        for node in graph.nodes:
            for kind, end in node.ends():
                if end.is_known and not node.test and end.name is not None:
                    self._ends.setdefault((KINDS[kind].family, end.name), []).append(Placed(node, kind, end))

    def at(self, kind: EndKind, name: str | None) -> list[Placed]:
        """The ends on the side of ``kind``."""
        return [placed for placed in self._all(kind, name) if KINDS[placed.kind].provides == KINDS[kind].provides]

    def opposite(self, kind: EndKind, name: str | None) -> list[Placed]:
        return [placed for placed in self._all(kind, name) if KINDS[placed.kind].provides != KINDS[kind].provides]

    def _all(self, kind: EndKind, name: str | None) -> list[Placed]:
        return [] if name is None else self._ends.get((KINDS[kind].family, name), [])


@dataclass(frozen=True)
class EndChanges:
    """Compares the ends of two systems."""

    before: Ends
    after: Ends

    def of_node(self, old: Node, new: Node) -> Iterator[Change]:
        """Of a node that both sides have."""
        pairs = paired_ends(old, new)
        for (kind, was), (_, now) in pairs.both:
            yield from self._changed(kind, was, now, new)
        for kind, end in pairs.removed:
            if end.is_known:
                yield self.removed(old, kind, end, _doubt(kind, new, pairs))
        for kind, end in pairs.added:
            if end.is_known:
                yield self.added(new, kind, end)

    def removed(self, node: Node, kind: EndKind, end: End, doubt: str = "", with_node: bool = False) -> Change:
        judgement = risky(doubt) if doubt else self._loss(kind, end)
        spot = Spot(end.file, end.line, before=True)
        return _change(Status.REMOVED, kind, end, node, judgement, spot, with_node)

    def added(self, node: Node, kind: EndKind, end: End, with_node: bool = False) -> Change:
        return _change(Status.ADDED, kind, end, node, self._gain(node, kind, end), Spot(end.file, end.line), with_node)

    def _loss(self, kind: EndKind, end: End) -> Judgement:
        """What it does to others that an end is gone."""
        family = KINDS[kind].family
        others, same = self.after.opposite(kind, end.name), self.after.at(kind, end.name)
        if not KINDS[kind].provides:
            if family == "topic" and others and not same:
                return risky(f"{names(others)} {_verb(others, _OFFERS[family])}, and no node here listens any more")
            return safe("nothing depends on it")
        if others and not same:
            return breaking(f"{names(others)} still {_verb(others, _USES[family])}, and no node here offers it")
        if others:
            left = f"{names(same)} still {_verb(same, _OFFER)}"
            return risky(f"{names(others)} {_verb(others, _USES[family])}, which here only {left}")
        if self.before.opposite(kind, end.name):
            return risky("who used it here is gone, too; tools and nodes elsewhere may use it")
        return risky("no node here uses it; tools and nodes elsewhere may")

    def _gain(self, node: Node, kind: EndKind, end: End) -> Judgement:
        family = KINDS[kind].family
        others = self.after.opposite(kind, end.name)
        unlike = [placed for placed in others if _differ(placed.end.type, end.type)]
        if unlike:
            return risky(
                f"{names(unlike)} {_have(unlike)} another type there, {unlike[0].end.type}: they do not connect"
            )
        unmatched = _unmatched(kind, end, others)
        if unmatched:
            return risky(unmatched)
        servers = [placed for placed in self.after.at(kind, end.name) if placed.node is not node]
        if KINDS[kind].provides and family != "topic" and servers:
            return risky(f"{names(servers)} {_verb(servers, _OFFERS[family])}, too: who answers is left to chance")
        if others:
            return safe(f"{names(others)} {_verb(others, _USES[family] if KINDS[kind].provides else _OFFERS[family])}")
        return safe("no node here is at the other end")

    def _changed(self, kind: EndKind, was: End, now: End, node: Node) -> Iterator[Change]:
        if was.name != now.name:
            yield self._renamed(kind, was, now, node)
        if _differ(was.type, now.type):
            yield self._retyped(kind, was, now, node)
        if KINDS[kind].family == "topic" and was.qos != now.qos:
            yield from self._requalified(kind, was, now, node)

    def _renamed(self, kind: EndKind, was: End, now: End, node: Node) -> Change:
        if not now.is_known or not was.is_known:
            judgement = risky("the name is not known any more" if was.is_known else "the name was not known before")
        else:
            judgement = Judgement.worst(self._loss(kind, was), self._gain(node, kind, now))
        return _change(
            Status.RENAMED,
            kind,
            now if now.name is not None else was,
            node,
            judgement,
            Spot(now.file, now.line),
            aspect="name",
            values=(was.name or "not known", now.name or "not known"),
            cause=(was.name, now.name),
        )

    def _retyped(self, kind: EndKind, was: End, now: End, node: Node) -> Change:
        others = self.after.opposite(kind, now.name)
        unlike = [placed for placed in others if _differ(placed.end.type, now.type)]
        if unlike:
            judgement = breaking(f"{names(unlike)} {_have(unlike)} {unlike[0].end.type} there: they do not connect")
        elif others:
            judgement = risky("both ends here have changed; bags, tools and nodes elsewhere have the old type")
        else:
            judgement = breaking("no node here is at the other end: whoever is has the old type")
        return _change(
            Status.CHANGED, kind, now, node, judgement, Spot(now.file, now.line), aspect="type",
            values=(str(was.type), str(now.type)),
        )  # fmt: skip

    def _requalified(self, kind: EndKind, was: End, now: End, node: Node) -> Iterator[Change]:
        before, after = qos.differing(was.qos, now.qos)
        if not before:
            return
        others = self.after.opposite(kind, now.name)
        unmatched = _unmatched(kind, now, others)
        if unmatched:
            served = [placed for placed in others if not qos.mismatch(kind, was.qos, placed.end.qos)]
            judgement = breaking(unmatched) if _unmatched(kind, now, served) else risky(unmatched)
        elif qos.is_weaker(kind, was.qos, now.qos):
            judgement = risky(
                "every end here still connects; nodes elsewhere that count on it may not"
                if others
                else "no node here is at the other end; one elsewhere may no longer connect"
            )
        else:
            judgement = safe("all ends here still connect" if others else "whoever connected still does")
        yield _change(
            Status.CHANGED, kind, now, node, judgement, Spot(now.file, now.line), aspect="qos", values=(before, after)
        )


def names(placed: Iterable[Placed]) -> str:
    """The nodes of some ends, at most three by name."""
    shown = sorted({end.node.shown for end in placed})
    if len(shown) > 3:
        return f"{', '.join(shown[:2])} and {len(shown) - 2} more"
    return " and ".join([", ".join(shown[:-1]), shown[-1]] if len(shown) > 1 else shown)


def _verb(placed: Sequence[Placed], forms: tuple[str, str]) -> str:
    return forms[len({end.node.shown for end in placed}) > 1]


def _have(placed: Sequence[Placed]) -> str:
    return _verb(placed, ("has", "have"))


def _differ(first: str | None, other: str | None) -> bool:
    return first is not None and other is not None and first != other


def _unmatched(kind: EndKind, end: End, others: Sequence[Placed]) -> str:
    """Why quality of service keeps an end from others; empty where it does not."""
    if KINDS[kind].family != "topic":
        return ""
    for placed in others:
        why = qos.mismatch(kind, end.qos, placed.end.qos)
        if why:
            lost = [other for other in others if qos.mismatch(kind, end.qos, other.end.qos)]
            return f"it does not connect to {names(lost)}: {why}"
    return ""


def _doubt(kind: EndKind, now: Node, pairs: Pairs[tuple[EndKind, End]]) -> str:
    """Why an end may still be there that is not seen; empty where it is gone."""
    if any(other == kind and not end.is_known for other, end in pairs.added):
        return f"{now.shown} has a {kind.replace('_', ' ')} now whose name is not known, which may be this one"
    return "" if now.complete else f"not all code of {now.shown} could be followed: it may still be there"


def _change(
    status: Status,
    kind: EndKind,
    end: End,
    node: Node,
    judgement: Judgement,
    spot: Spot,
    with_node: bool = False,
    aspect: str | None = None,
    values: tuple[str, str] | None = None,
    cause: tuple[object, ...] = (),
) -> Change:
    return Change(
        status,
        NOUNS[kind],
        end.name or end.written or "",
        judgement,
        owner=node.shown,
        aspect=aspect,
        values=values,
        type=end.type,
        spot=spot,
        cause=(node.class_name, end.file, end.line, end.column, *(values or ()), *cause),
        with_node=with_node,
    )
