"""What code asks the arguments for that a parser of Python's ``argparse`` has made, and that it never sets.

Source: ``argparse`` of Python's library: ``add_argument`` sets ``dest``, or else the first long option without its
dashes in front, those inside made ``_``, or else the first short one.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence

from archlint.analysis.kept import kept_for_each_file
from archlint.python_code.class_chains import targets_of
from archlint.python_code.tried_code import tried_for
from archlint.syntax import facts
from archlint.syntax.bindings import names_bound
from archlint.syntax.parts import Itself, everything_in, parts_of

_PARSES = frozenset({"parse_args", "parse_known_args"})
_HARMLESS = frozenset(
    {"description", "epilog", "error", "exit", "format_help", "format_usage", "print_help", "print_usage", "prog"}
    | {"usage"}
)
"""What leaves the arguments of a parser as they are."""
_PLAIN = frozenset({"add_help", "allow_abbrev", "description", "epilog", "formatter_class", "prog", "usage"})
"""The options of a parser that add no argument."""
_OF_ALL = frozenset(dir(argparse.Namespace()))
_ANY_NAME = frozenset({"setattr", "vars", "__dict__", "locals", "globals"})

Row = tuple[str, list[str], facts.Span]
"""The name that is asked for, those that there are, and where."""


@kept_for_each_file
def absent_arguments(code: facts.Facts) -> list[Row]:
    """The reads of such names in a file."""
    if "ArgumentParser" not in code.names or not _ANY_NAME.isdisjoint(code.names):
        return []
    given = {target.attribute for target in targets_of(code.body)}
    expecting = tried_for(code.body, {"AttributeError"})
    rows: list[Row] = []
    for body in (code.body, *(function.body for function in everything_in(code.body, facts.Function))):
        for name, names in _parsed(body):
            for part in parts_of(body, facts.Attribute):
                known = part.attr in names or part.attr in _OF_ALL or part.attr in given
                if part.value.variable == name and not known and Itself[facts.Base](part) not in expecting:
                    rows.append((part.attr, sorted(names), part.span))
    return rows


def _parsed(body: Sequence[facts.Stmt]) -> Iterator[tuple[str, frozenset[str]]]:
    """The variables of a function that hold the arguments of a parser which it makes, with the names of these."""
    bound = Counter(names_bound(body))
    parsers: dict[str, frozenset[str]] = {}
    for part in parts_of(body, facts.Assign):
        match part:
            case facts.Assign(targets=[facts.Name(id=name)], value=facts.Call() as value):
                if _is_parser(value) and bound[name] == 1 and (names := _names_of(body, name)) is not None:
                    parsers[name] = names
    for part in parts_of(body, facts.Assign):
        match part:
            case facts.Assign(
                targets=[target],
                value=facts.Call(func=facts.Attribute(value=facts.Name(id=parser), attr=method), args=args),
            ) if parser in parsers and method in _PARSES:
                first = target.elements[0] if isinstance(target, facts.Sequence) and target.elements else target
                holds = method == "parse_args" or first is not target
                if holds and bound[first.variable] == 1 and not any(each.keyword == "namespace" for each in args):
                    yield first.variable, parsers[parser]


def _is_parser(call: facts.Call) -> bool:
    plain = all(argument.keyword in _PLAIN or argument.keyword is None for argument in call.args)
    return call.func.last_name == "ArgumentParser" and plain and not any(argument.star for argument in call.args)


def _names_of(body: Sequence[facts.Stmt], parser: str) -> frozenset[str] | None:
    """The names of all arguments of a parser; None where not all are known."""
    names: set[str] = set()
    uses = 0
    for part in everything_in(body):
        match part:
            case facts.Attribute(value=facts.Name(id=name), attr=attr) if name == parser:
                uses += attr in _HARMLESS | _PARSES | {"add_argument"}
            case facts.Call(func=facts.Attribute(value=facts.Name(id=name), attr="add_argument")) if name == parser:
                given = _name_of(part)
                if given is None:
                    return None
                names.add(given)
    mentions = sum(1 for part in everything_in(body, facts.Name) if part.id == parser)
    return frozenset(names) if mentions == uses + 1 else None


def _name_of(call: facts.Call) -> str | None:
    """The name that an argument has in what is parsed; None where that is not known."""
    flags: list[str] = []
    for argument in call.args:
        match argument:
            case facts.Argument(keyword="dest", value=facts.Literal(value=str(name))):
                return name
            case facts.Argument(keyword="dest") | facts.Argument(star="*" | "**"):
                return None
            case facts.Argument(keyword=None, value=facts.Literal(value=str(flag))):
                flags.append(flag)
            case facts.Argument(keyword=None):
                return None
    long = [flag for flag in flags if flag.startswith("--")]
    if not flags or not flags[0].startswith("-"):
        return flags[0] if flags else None
    return (long or flags)[0].lstrip("-").replace("-", "_")


__all__ = ["absent_arguments"]
