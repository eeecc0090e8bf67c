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
    if isinstance(expression, facts.Name):
        return expression.id
    if isinstance(expression, facts.Attribute) and isinstance(expression.value, facts.Name):
        return f"{expression.value.id}.{expression.attr}"
    return ""


def proven(conditions: Sequence[tuple[facts.Expr, bool]], followed: frozenset[str]) -> Known:
    """What conditions that have come out so tell."""
    known = NOTHING
    for test, truth in conditions:
        known = within(known, test, truth, followed) or known
    return known


def asked(conditions: Sequence[tuple[facts.Expr, bool]]) -> frozenset[str]:
    """The names that conditions ask for; attributes are left out, for they may change."""
    return frozenset(part.id for test, _ in conditions for part in parts_of(test) if isinstance(part, facts.Name))


def variables(body: Sequence[facts.Stmt]) -> frozenset[str]:
    """The variables on which two places of a function depend together: asked twice, or set and asked."""
    asked: Counter[str] = Counter()
    for statement in statements_of(body):
        if isinstance(statement, facts.If):
            asked.update({dotted(part) for part in parts_of(statement.test)} - {""})
        elif isinstance(statement, facts.Assign) and isinstance(statement.value, facts.Literal):
            asked.update({dotted(target) for target in statement.targets} - {""})
    return frozenset(name for name, times in asked.items() if times > 1)


def after(known: Known, fact: facts.Base, followed: frozenset[str]) -> Known:
    """What is known after a statement."""
    if isinstance(fact, facts.Augmented):
        return _without(known, dotted(fact.target))
    if not isinstance(fact, facts.Assign):
        return known
    for target in fact.targets:
        inside = target.elements if isinstance(target, facts.Sequence) else [target]
        for one in inside:
            known = _without(known, dotted(one))
    names = [dotted(target) for target in fact.targets if dotted(target) in followed]
    if isinstance(fact.value, facts.Literal):
        return known | {(name, fact.value.value) for name in names}
    return known


def _without(known: Known, name: str) -> Known:
    return frozenset(row for row in known if not name or name not in (row[0], row[0].partition(" ")[0]))


def within(known: Known, test: facts.Expr, truth: bool, followed: frozenset[str]) -> Known | None:
    """What is known in an arm of an ``if``; None where what is known keeps out of it."""
    if isinstance(test, facts.Unary) and test.op == "not":
        return within(known, test.operand, not truth, followed)
    if isinstance(test, facts.Boolean):
        return _within_all(known, test, truth, followed)
    if isinstance(test, facts.Compare) and test.ops in (["!="], ["is not"]):
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
        found: Known | None = known
        for value in test.values:
            found = None if found is None else within(found, value, truth, followed)
        return found
    return known if any(within(known, value, truth, followed) is not None for value in test.values) else None


def _question(test: facts.Expr) -> tuple[str, str]:
    """The variable that a condition asks for, and what it is compared with; empty for other conditions."""
    if isinstance(test, facts.Compare) and len(test.comparators) == 1 and test.ops[0] in ("==", "is"):
        other = test.comparators[0]
        return (dotted(test.left), repr(other.value)) if isinstance(other, facts.Literal) else ("", "")
    return dotted(test), ""


def _answer(known: Known, key: str, value: str) -> bool | None:
    for name, constant in known:
        if name == key:
            return repr(constant) == value if value else bool(constant)
        if name == f"{key} {value}":
            return bool(constant)
    return None
