"""Attributes of a node that get their first value in a callback, and that another callback reads without asking.

Until a message has come the read is an AttributeError.  So it is where a callback reads what only its own last lines
assign, and where nothing calls the method that would assign it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from archlint.analysis.uncalled_methods import is_asked_of_others, is_called_elsewhere
from archlint.place import Place
from archlint.python_code.class_chains import (
    ClassInFile,
    chain_of,
    classes_asked_for,
    derived_from,
    kept_for_each_class,
    methods_of,
    targets_of,
)
from archlint.python_code.early_attribute_reads import gives, is_of_class
from archlint.python_code.empty_attributes import empty_at_first, failing_uses
from archlint.python_code.methods_at_work import INIT, Called, MethodsAtWork, methods_at_work, never_returns, of_self
from archlint.python_code.sure_reads import SureRead, sure_reads
from archlint.python_code.unassigned_attributes import (
    attributes_of_self,
    has_self,
    may_be_set,
    members_of,
    names_of_body,
)
from archlint.python_code.unshared_objects import asked_in, is_unshared
from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in, names_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_RUNS_CALLBACKS = ("spin", "spin_once", "spin_until_future_complete", "wait_for_message")
_STARTS_LATER = frozenset({"reset", "autostart"})
"""What makes a timer begin after the constructor."""


class Late(StringEnum):
    """When an attribute gets its first value."""

    NEVER = "never"
    """Nothing calls the method that assigns it."""
    AFTERWARDS = "afterwards"
    """The callback that reads it assigns it further down, and nothing else does."""
    CALLED = "called"
    """Another callback assigns it."""


@dataclass(frozen=True)
class LateRead:
    """A read of an attribute that may have no value yet, in a ``method`` that runs as part of the callback ``reader``,
    registered for something; ``setter`` is a method that assigns it."""

    place: Place
    cls: str
    name: str
    late: Late
    reader: str
    role: Called | None
    setter: str
    assigned: Place
    is_sure: bool
    is_unshared: bool
    """Whether no other code has the object, so that none calls its methods."""
    error: str = ""
    """What is raised where the constructor assigns None; empty where it assigns nothing."""


@dataclass(frozen=True)
class _Row:
    """The same by the text of the class; nobody else may call ``alone``."""

    name: str
    span: facts.Span
    late: Late
    reader: str
    role: Called | None
    setter: str
    assigned: facts.Span
    is_sure: bool
    alone: frozenset[str]
    error: str = ""


def late_attributes(workspace: WorkspaceIndex) -> Iterator[LateRead]:
    """Every such read in the files that were asked for: the first of each attribute."""
    for cls in classes_asked_for(workspace):
        for row in _late(workspace, cls):
            if _is_certain(workspace, cls, row):
                at = partial(Place, cls.file)
                yield LateRead(
                    at(*row.span),
                    cls.code.name,
                    row.name,
                    row.late,
                    row.reader,
                    row.role,
                    row.setter,
                    at(*row.assigned),
                    row.is_sure,
                    is_unshared(workspace, cls),
                    row.error,
                )


def _is_certain(workspace: WorkspaceIndex, cls: ClassInFile, row: _Row) -> bool:
    """Whether nothing else gives the object the attribute, and nobody else calls the methods that do."""
    chain = chain_of(workspace, cls)
    if members_of(workspace, chain) is None or is_of_class(workspace, chain, row.name):
        return False
    names = row.alone | {row.name}
    bases = [base.code for base in chain.own if base.code is not cls.code]
    if any(not names.isdisjoint(gives(base) | names_in(base.body)) for base in bases):
        return False
    for other in derived_from(workspace, cls):
        is_known = members_of(workspace, chain_of(workspace, other)) is not None
        if not is_known or not names.isdisjoint(gives(other.code)):
            return False
    if any(is_of_class(workspace, chain, name, own=False) for name in row.alone):
        return False  # rclpy calls it
    file_facts = workspace.facts_at(cls.file)
    if file_facts is None or _calls_from_outside(file_facts, row.alone):
        return False
    if any(is_called_elsewhere(workspace, cls.file, name) for name in row.alone):
        return False
    if any(is_asked_of_others(workspace, cls.file, name) for name in row.alone):
        return False
    return not may_be_set(workspace, cls, row.name)


def gets_it_nowhere_else(workspace: WorkspaceIndex, cls: ClassInFile, name: str) -> bool:
    """Whether nothing but the methods of a class gives an object of it an attribute."""
    chain = chain_of(workspace, cls)
    if members_of(workspace, chain) is None or is_of_class(workspace, chain, name):
        return False
    bases = [base.code for base in chain.own if base.code is not cls.code]
    return not any(name in gives(base) for base in bases) and not may_be_set(workspace, cls, name)


def _calls_from_outside(file_facts: facts.Facts, methods: frozenset[str]) -> bool:
    """Whether a file asks any object but ``self`` for one of some methods."""
    return any(
        part.attr in methods and of_self(part) is None for part in everything_in(file_facts.body, facts.Attribute)
    )


# ---------------------------------------------------------------------------------------- by the text of the class


@kept_for_each_class
def _late(code: facts.Class) -> list[_Row]:
    count = Counter(function.name for function in methods_of(code))
    work = methods_at_work(code)
    if INIT not in work.methods or any(number > 1 for number in count.values()):
        return []
    if not work.registered or any(name in names_in(code.body) for name in _RUNS_CALLBACKS):
        return []
    setters = _setters(work)
    early = work.after([INIT])
    others = {*names_of_body(code), *asked_in(code)}
    late = {name: where for name, where in setters.items() if name not in others and early.isdisjoint(where) and where}
    rows = {row.name: row for row in _never(work, late)}
    empty = _empty(code, {name: where for name, where in setters.items() if name not in others}, early)
    failing = failing_uses(code, frozenset(empty)) if empty else {}
    setters.update(empty)
    for reader, role in _readers(code, work, early) if late or empty else ():
        for read in sure_reads(work, reader, frozenset((*late, *empty))):
            use = failing.get(read.span)
            row = None if read.name in empty and use is None else _row(work, reader, role, read, setters)
            if row is not None:
                rows.setdefault(row.name, row if use is None else replace(row, error=use.error))
    return [*rows.values()]


def _empty(
    code: facts.Class, setters: Mapping[str, dict[str, facts.Span]], early: set[str]
) -> dict[str, dict[str, facts.Span]]:
    """The methods that assign each attribute which is None as long as the constructor alone has run."""
    later: dict[str, dict[str, facts.Span]] = {}
    for name in empty_at_first(code):
        where = {method: span for method, span in setters.get(name, {}).items() if method != INIT}
        if where and early.isdisjoint(where):
            later[name] = where
    return later


@dataclass(frozen=True)
class LateSetter:
    """The first ``method`` that assigns an attribute, where it does so, and all ``methods`` that do."""

    method: str
    span: facts.Span
    methods: frozenset[str]


def set_by_callbacks(code: facts.Class) -> dict[str, LateSetter]:
    """The attributes of a class that only methods assign to which its constructor does not lead, and a callback does;
    nothing where the class spins itself or starts threads."""
    count = Counter(function.name for function in methods_of(code))
    work = methods_at_work(code)
    if INIT not in work.methods or any(number > 1 for number in count.values()):
        return {}
    if any(name in names_in(code.body) for name in (*_RUNS_CALLBACKS, "Thread")):
        return {}
    early, others = work.after([INIT]), {*names_of_body(code), *asked_in(code)}
    rows: dict[str, LateSetter] = {}
    for name, where in _setters(work).items():
        if (
            name not in others
            and where
            and early.isdisjoint(where)
            and any(map(work.called_for, work.leading_to(where)))
        ):
            method, span = next(iter(where.items()))
            rows[name] = LateSetter(method, span, frozenset(where))
    return rows


def _never(work: MethodsAtWork, late: Mapping[str, dict[str, facts.Span]]) -> Iterator[_Row]:
    """The first read of each attribute that only methods assign which nothing calls."""
    seen: set[str] = set()
    idle = {name: work.leading_to(setters) for name, setters in late.items()}
    idle = {name: methods for name, methods in idle.items() if not any(map(work.called_for, methods))}
    for method, function in work.methods.items() if idle else ():
        written = {Itself(target) for target in targets_of(function.body)}
        for part in attributes_of_self(function.body) if has_self(function) else ():
            methods = idle.get(part.attr)
            if methods is None or method in methods or part.attr in seen or Itself[facts.Base](part) in written:
                continue
            seen.add(part.attr)
            setter, assigned = next(iter(late[part.attr].items()))
            yield _Row(part.attr, part.span, Late.NEVER, method, None, setter, assigned, True, frozenset(methods))


def _setters(work: MethodsAtWork) -> dict[str, dict[str, facts.Span]]:
    """The methods that assign each attribute of ``self``, with the first place of each."""
    setters: dict[str, dict[str, facts.Span]] = {}
    for method, function in work.methods.items():
        for target in targets_of(function.body):
            name = of_self(target)
            if name is not None and isinstance(target, facts.Attribute) and not name.startswith("__"):
                setters.setdefault(name, {}).setdefault(method, target.span)
    return setters


def _readers(code: facts.Class, work: MethodsAtWork, early: set[str]) -> Iterator[tuple[str, Called | None]]:
    """The callbacks that may run once the constructor is done, those of timers first."""
    yield INIT, None
    if never_returns(work):
        return
    later = not _STARTS_LATER.isdisjoint(names_in(code.body) | _keywords(code))
    rows = [(name, role) for method, name, role in work.registered if method in early]
    rows = [(name, role) for name, role in rows if not (role is Called.TIMER and later)]
    for wanted in (Called.TIMER, Called.MESSAGE, Called.REQUEST):
        yield from dict.fromkeys((name, role) for name, role in rows if role is wanted)


def _keywords(code: facts.Class) -> set[str]:
    calls = everything_in(code.body, facts.Call)
    return {argument.keyword for call in calls for argument in call.args if argument.keyword}


def _row(
    work: MethodsAtWork,
    reader: str,
    role: Called | None,
    read: SureRead,
    setters: Mapping[str, dict[str, facts.Span]],
) -> _Row | None:
    """What is said of a read in a callback; None where what assigns the attribute may have run by then."""
    own = setters[read.name]
    before = work.after(read.before)
    if not before.isdisjoint(own) or read.name in _tested_in(work, before):
        return None
    leading = work.leading_to(own)
    called = {name: work.called_for(name) for name in leading}
    tops = {name for name in leading if called[name]}
    if not tops or (reader in tops and not read.is_sure):
        return None
    late = Late.AFTERWARDS if tops == {reader} else Late.CALLED
    if late is Late.CALLED and not _comes_later(role, set().union(*called.values())):
        return None
    asked = {*read.asks, *_attributes_in(work, work.after([name for name in read.asks if name in work.methods]))}
    changing = {name: {*setters.get(name, ()), *_changed_in(work).get(name, ())} for name in asked}
    if not all(_is_of_others(work, changing[name], tops | {reader}, read.name) for name in asked):
        return None
    setter, assigned = next(iter(own.items()))
    return _Row(read.name, read.span, late, reader, role, setter, assigned, read.is_sure, frozenset(leading))


def _tested_in(work: MethodsAtWork, methods: Collection[str]) -> set[str]:
    """The attributes of ``self`` for which a condition of some methods asks: one may wait, or raise, where there is no
    value yet."""
    parts = (part for name in methods for part in everything_in(work.methods[name].body, facts.Statement))
    tests = [part.test for part in parts if isinstance(part, facts.If | facts.While | facts.Assert)]
    return {name for test in tests for part in everything_in([test]) if (name := of_self(part)) is not None}


def _attributes_in(work: MethodsAtWork, methods: Collection[str]) -> set[str]:
    """The attributes of ``self`` that some methods name."""
    parts = (part for name in methods for part in everything_in(work.methods[name].body, facts.Attribute))
    return {name for part in parts if (name := of_self(part)) is not None}


def _changed_in(work: MethodsAtWork) -> dict[str, set[str]]:
    """The methods, but for the constructor, that may change what an attribute holds: ``self.queue.append(…)``,
    ``self.table[0] = …``."""
    changed: dict[str, set[str]] = {}
    for method, function in work.methods.items():
        calls = (call.func for call in everything_in(function.body, facts.Call))
        changes = [func.value for func in calls if isinstance(func, facts.Attribute)]
        changes += [target.value for target in targets_of(function.body) if isinstance(target, facts.Subscript)]
        for part in changes if method != INIT else ():
            name = of_self(part)
            if name is not None:
                changed.setdefault(name, set()).add(method)
    return changed


def _is_of_others(work: MethodsAtWork, setters: Collection[str], callbacks: set[str], wanted: str) -> bool:
    """Whether an attribute for which a condition asks says nothing of what some callbacks have done: only the
    constructor and other messages give it a value, and these do not ask for the attribute that is ``wanted``."""
    later = work.leading_to([method for method in setters if method not in work.after([INIT])])
    others = {method for method in later if work.called_for(method)}
    if not later.isdisjoint(work.after(callbacks)) or wanted in _attributes_in(work, work.after(later)):
        return False
    return all(work.called_for(method) <= {Called.MESSAGE} for method in others) and later <= work.after(others)


def _comes_later(role: Called | None, setters: set[Called]) -> bool:
    """Whether a callback may well run before those that assign something."""
    if role is None:
        return True
    if role is Called.TIMER:
        return Called.TIMER not in setters
    return setters <= {Called.MESSAGE, Called.PARAMETERS}


__all__ = ["Late", "LateRead", "LateSetter", "gets_it_nowhere_else", "late_attributes", "set_by_callbacks"]
