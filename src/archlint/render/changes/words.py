"""A change in words."""

from __future__ import annotations

from collections.abc import Callable

from archlint.comparing.changes import Change, Impact, Spot, Status, Subject
from archlint.render.changes.model import Difference

_NOUNS: dict[Subject, str] = {
    "service": "server of service",
    "client": "client of service",
    "action_server": "server of action",
    "action_client": "client of action",
    "publisher": "publisher of",
    "subscriber": "subscriber to",
    "launch_file": "launch file",
    "launch_argument": "launch argument",
    "remapping": "remapping of",
}


def headline(change: Change, show: Callable[[str], str]) -> str:
    """What changed; ``show`` writes a text of the user's as a format needs it."""
    noun = _NOUNS.get(change.subject, change.subject)
    if change.subject == "service" and change.owner is None:
        noun = "service"
    before, after = (None if text is None else show(text) for text in (change.before, change.after))
    owner = "" if change.owner is None else f"{show(change.owner)}: "
    if change.aspect == "name":
        return f"{owner}{noun} {before} {'renamed' if change.owner is None else 'moved'} to {after}"
    subject = f"{owner}{noun} {show(change.name)}"
    if change.aspect is None:
        return f"{subject} {change.status}"
    if before is None or after is None:
        return f"{subject} {change.status}: {before or after}"
    return f"{subject}, {change.aspect}: {before} → {after}"


def place(spot: Spot) -> str:
    return f"{spot.file}:{spot.line}{' (base)' if spot.before else ''}"


def where(change: Change) -> str:
    """The launch files of the systems in which a change is met, where it is not met among all nodes; other names."""
    parts = []
    if change.systems and None not in change.systems and change.systems[0] not in (change.owner, change.name):
        shown = [system for system in change.systems if system is not None]
        parts.append(f"in {shown[0]}" + (f" and {len(shown) - 1} more" if len(shown) > 1 else ""))
    if change.others:
        more = f" and {len(change.others) - 2} more" if len(change.others) > 2 else ""
        parts.append(f"also as {', '.join(change.others[:2])}{more}")
    return ", ".join(parts)


def counted(difference: Difference) -> str:
    """``2 breaking, 1 risky, 5 safe changes``: those that are told one by one."""
    told, _ = folded(list(difference.changes))
    counts = [(sum(change.impact == impact for change in told), impact) for impact in Impact]
    total = sum(count for count, _ in counts)
    if not total:
        return "no change of the architecture"
    listed = ", ".join(f"{count} {impact}" for count, impact in counts if count)
    return f"{listed} {'change' if total == 1 else 'changes'}"


def findings_counted(difference: Difference) -> str:
    """How many findings appeared and vanished; empty where none did, or that is not known."""
    appeared, vanished = len(difference.appeared or ()), len(difference.vanished or ())
    parts = [f"{appeared} new"] if appeared else []
    parts += [f"{vanished} fixed"] if vanished else []
    return f"{' and '.join(parts)} {'finding' if appeared + vanished == 1 else 'findings'}" if parts else ""


def folded(changes: list[Change]) -> tuple[list[Change], dict[str, list[Change]]]:
    """The changes to tell one by one, and by the name of an added or removed node the ends that go with it."""
    nodes = {change.name for change in changes if change.subject == "node" and change.status != Status.CHANGED}
    inside: dict[str, list[Change]] = {}
    told = []
    for change in changes:
        if change.with_node and change.owner in nodes and change.owner is not None:
            inside.setdefault(change.owner, []).append(change)
        else:
            told.append(change)
    return told, inside


def worth_telling(node: Change, ends: list[Change]) -> list[Change]:
    """Of the ends that came or went with a node those that say more than that."""
    least = Impact.BREAKING if node.status == Status.REMOVED else Impact.RISKY
    return [end for end in ends if end.impact.rank <= least.rank]


def ends_in_short(ends: list[Change]) -> str:
    """``publishes /a, /b; calls /c``."""
    rows: dict[Subject, list[str]] = {}
    for end in ends:
        rows.setdefault(end.subject, []).append(end.name)
    return "; ".join(f"{_VERBS[subject]} {_some(names)}" for subject, names in rows.items())


def _some(names: list[str]) -> str:
    return ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")


_VERBS: dict[Subject, str] = {
    "publisher": "publishes",
    "subscriber": "subscribes to",
    "service": "serves",
    "client": "calls",
    "action_server": "executes",
    "action_client": "requests",
}

__all__ = ["counted", "ends_in_short", "findings_counted", "folded", "headline", "place", "where", "worth_telling"]
