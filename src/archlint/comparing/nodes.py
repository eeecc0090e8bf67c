"""Nodes: which came, went, have another name, or run otherwise."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.comparing.changes import Change, Judgement, Spot, Status, breaking, risky, safe
from archlint.comparing.graphs import Node


def node_removed(node: Node, ends: Sequence[Change]) -> Change:
    """``ends`` are the changes of what went with it."""
    losses = [end for end in ends if end.judgement.impact.rank == 0]
    judgement = (
        breaking(f"others still use {_listed(losses)}")
        if losses
        else risky("no node here misses it; launch files and tools elsewhere may start it")
    )
    return _node(Status.REMOVED, node, judgement, is_before=True)


def node_added(node: Node, ends: Sequence[Change]) -> Change:
    """``ends`` are the changes of what came with it."""
    doubtful = [end for end in ends if end.judgement.impact.rank < 2]
    judgement = risky(f"see {_listed(doubtful)}") if doubtful else safe("nothing that was there is touched")
    return _node(Status.ADDED, node, judgement)


def _listed(ends: Sequence[Change]) -> str:
    shown = sorted({end.name for end in ends})
    return ", ".join(shown[:3]) + (f" and {len(shown) - 3} more" if len(shown) > 3 else "")


def node_changes(old: Node, new: Node) -> Iterator[Change]:
    """What has changed of a node that both sides have, its ends and parameters aside."""
    if old.name != new.name and old.name is not None and new.name is not None:
        reason = "parameter files, remappings and tools name it; its private names and parameter services move with it"
        yield _node(Status.RENAMED, new, risky(reason), aspect="name", values=(old.name, new.name))
    if _both(old.executable, new.executable) and old.executable != new.executable:
        reason = "launch files and commands elsewhere start it by the old one"
        yield _node(Status.CHANGED, new, risky(reason), aspect="executable",
                    values=(str(old.executable), str(new.executable)))  # fmt: skip
    if _both(old.package, new.package) and old.package != new.package:
        reason = "launch files and commands elsewhere start it from the old one"
        yield _node(Status.CHANGED, new, risky(reason), aspect="package",
                    values=(str(old.package), str(new.package)))  # fmt: skip
    if old.lifecycle != new.lifecycle and not (old.external or new.external):
        judgement = (
            risky("it does nothing until something activates it")
            if new.lifecycle
            else risky("whoever manages its states does not find their services any more")
        )
        yield _node(Status.CHANGED, new, judgement, aspect="lifecycle", values=_yes_no(old.lifecycle, new.lifecycle))
    threads = ("single_threaded", "multi_threaded")
    if old.executor != new.executor and old.executor in threads and new.executor in threads:
        reason = "callbacks run in an order of their own, some at the same time" if new.executor == threads[1] else (
            "a callback that waits keeps all others waiting"
        )  # fmt: skip
        yield _node(Status.CHANGED, new, risky(reason), aspect="executor", values=(old.executor, new.executor))
    if old.condition != new.condition:
        reason = "it is started under other arguments than before"
        yield _node(Status.CHANGED, new, risky(reason), aspect="condition",
                    values=(old.condition or "always", new.condition or "always"))  # fmt: skip


def _both(first: str | None, other: str | None) -> bool:
    return first is not None and other is not None


def _yes_no(before: bool, after: bool) -> tuple[str, str]:
    return ("yes" if before else "no"), ("yes" if after else "no")


def _node(
    status: Status,
    node: Node,
    judgement: Judgement,
    is_before: bool = False,
    aspect: str | None = None,
    values: tuple[str, str] | None = None,
) -> Change:
    return Change(
        status,
        "node",
        node.shown,
        judgement,
        aspect=aspect,
        values=values,
        spot=None if node.file is None or node.line is None else Spot(node.file, node.line, is_before),
        cause=() if values is None or aspect == "name" else (node.class_name, node.file, *values),
    )
