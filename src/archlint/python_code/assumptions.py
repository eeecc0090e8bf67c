"""What is known of variables on a path: the constant that one was given, and what an earlier ``if`` has found.

``success = False`` in one branch and ``if success:`` further down belong together, and so do ``if ok:`` and a later
``if not ok:``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from archlint.syntax import facts
from archlint.syntax.walk import parts_of, statements_of

Known = frozenset[tuple[str, object]]
"""Names with their constants, and conditions as written with their truth."""

NOTHING: Known = frozenset()
MOST = 6
"""So many variables are followed at most: each may double the number of states."""


def dotted(expression: facts.Base) -> str:
    """``goal_handle`` and ``self.goal`` as written; empty for anything else."""
    written = expression.dotted
    return written if written.count(".") < 2 else ""


def proven(conditions: Sequence[tuple[facts.Expr, bool]], followed: frozenset[str]) -> Known:
    """What conditions that have come out so say."""
    known = NOTHING
    for test, truth in conditions:
        known = within(known, test, truth, followed) or known
    return known


def asked(conditions: Sequence[tuple[facts.Expr, bool]]) -> frozenset[str]:
    """The names that conditions ask for; attributes are left out, for they may change."""
    return frozenset(part.id for test, _ in conditions for part in parts_of(test, facts.Name))


def variables(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """The variables on which two places of a function depend together: asked twice, or set and asked."""
    asked: Counter[str] = Counter()
    for statement in statements_of(body):
        match statement:
            case facts.If(test=test):
                asked.update({dotted(part) for part in parts_of(test)} - {""})
            case facts.Assign(targets=targets, value=facts.Literal()):
                asked.update({dotted(target) for target in targets} - {""})
    return frozenset(name for name, times in asked.items() if times > 1)


def chained(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """The variables for which an ``if`` asks, and its ``elif`` again."""
    names: set[str] = set()
    for statement in statements_of(body):
        match statement:
            case facts.If(test=test, orelse=[facts.If(test=other)]):
                names |= {dotted(part) for part in parts_of(test)} & {dotted(part) for part in parts_of(other)}
    return frozenset(names - {""})


def after(known: Known, fact: facts.Base, followed: frozenset[str]) -> Known:
    """What is known after a statement."""
    match fact:
        case facts.Augmented(target=target):
            return _without(known, dotted(target))
        case facts.Assign(targets=targets, value=value):
            for stored in (part for target in targets for part in target.unpacked):
                known = _without(known, dotted(stored))
            if isinstance(value, facts.Literal):
                known |= {(dotted(target), value.value) for target in targets if dotted(target) in followed}
    return known


def _without(known: Known, name: str) -> Known:
    return frozenset(row for row in known if not name or name not in (row[0], row[0].partition(" ")[0]))


def within(known: Known, test: facts.Expr, truth: bool, followed: frozenset[str]) -> Known | None:
    """What is known in an arm of an ``if``; None where what is known keeps out of it."""
    match test:
        case facts.Unary(op="not"):
            return within(known, test.operand, not truth, followed)
        case facts.Boolean():
            return _within_all(known, test, truth, followed)
        case facts.Compare(ops=["!="] | ["is not"]):
            test, truth = facts.Compare(test.left, ["is"], test.comparators, test.span), not truth
    key, value = _question(test)
    if key not in followed:
        return known
    answer = _answer(known, key, value)
    if answer is not None:
        return known if answer is truth else None
    return known | {(f"{key} {value}", truth)}


def _within_all(known: Known, test: facts.Boolean, truth: bool, followed: frozenset[str]) -> Known | None:
    """``and`` holds where all of it does, ``or`` fails where all of it does; the other way one of them is enough."""
    if truth is (test.op == "and"):
        narrowed: Known | None = known
        for value in test.values:
            narrowed = None if narrowed is None else within(narrowed, value, truth, followed)
        return narrowed
    return known if any(within(known, value, truth, followed) is not None for value in test.values) else None


def _question(test: facts.Expr) -> tuple[str, str]:
    """The variable that a condition asks for, and what it is compared with; empty for other conditions."""
    match test:
        case facts.Compare(left=left, ops=["==" | "is"], comparators=[facts.Literal(value=constant)]):
            return dotted(left), repr(constant)
    return dotted(test), ""


def _answer(known: Known, key: str, value: str) -> bool | None:
    for name, constant in known:
        if name == key:
            return repr(constant) == value if value else bool(constant)
        if name == f"{key} {value}":
            return bool(constant)
    return None
