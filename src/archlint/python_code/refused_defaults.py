"""Defaults of parameters that no parameter of ROS can have: ``declare_parameter('gains', {'p': 1.0})``.

Source: ``Parameter.Type.from_parameter_value`` in rclpy/parameter.py of humble, jazzy and kilted, which raises a
TypeError; tried with rclpy of jazzy.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.place import Place
from archlint.python_code.class_chains import files_with
from archlint.python_code.plain_kinds import Kind, kind_of
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in
from archlint.syntax.walk import given_to

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_DECLARES = "declare_parameter"
_NUMBERS = ("a bool", "an int")
"""What one list may have both of: a bool is an int."""


@dataclass(frozen=True)
class RefusedDefault:
    """A declaration of a parameter with such a default, in words."""

    place: Place
    value: str
    mixed: bool
    """Whether it is a list of values of several types."""
    describes: str = ""
    """Where it is no default, but stands in the place of the descriptor: what that is given instead."""


def refused_defaults(workspace: WorkspaceIndex) -> Iterator[RefusedDefault]:
    """Every such call in the files that use rclpy, outside of test code; none where the workspace has a method of that
    name itself."""
    read = [workspace.facts_at(path) for path in files_with(workspace, _DECLARES)]
    if any(code is None or _defines(code) for code in read):
        return
    for path in workspace.python_files(mentioning=_DECLARES):
        for span, value, mixed, describes in _rows(workspace, path) or ():
            yield RefusedDefault(Place(path, *span), value, mixed, describes)


def _defines(code: facts.Facts) -> bool:
    return any(function.name == _DECLARES for function in everything_in(code.body, facts.Function))


@kept_for_each_file
def _rows(code: facts.Facts) -> list[tuple[facts.Span, str, bool, str]]:
    forgiven = tried_for(code.body, {"TypeError", "Exception"})
    rows: list[tuple[facts.Span, str, bool, str]] = []
    for call in everything_in(code.body, facts.Call):
        if call.func.attribute != _DECLARES or Itself[facts.Base](call) in forgiven:
            continue
        if any(argument.star for argument in call.args):
            continue
        default, descriptor = given_to(call, "value", 1), given_to(call, "descriptor", 2)
        refused = None if default is None else _refused(default)
        if refused is not None:
            rows.append((call.span, *refused, ""))
        elif descriptor is not None and (described := _no_descriptor(descriptor)) is not None:
            rows.append((call.span, described[0], False, described[1]))
    return rows


def _no_descriptor(given: facts.Expr) -> tuple[str, str] | None:
    """What stands in the place of a descriptor and is none, in words, and what a descriptor would be given instead;
    rclpy looks at its class in each distribution."""
    match given:
        case facts.Mapping(keys=keys):
            names = [key.text if isinstance(key, facts.Literal) else None for key in keys]
            return "a dict", ", ".join(
                f"{name}=…" for name in names
            ) if None not in names and names else "description=…"
        case facts.Literal(value=str()) | facts.FormatString():
            return "a text", "description=…"
    return None


def _refused(default: facts.Expr) -> tuple[str, bool] | None:
    """What is refused, in words, and whether it is for the types in it."""
    match default:
        case facts.Mapping() | facts.Comprehension(kind="dict"):
            return "a dict", False
        case facts.Sequence(kind="set"):
            return "a set", False
        case facts.Sequence(kind="list" | "tuple", elements=elements):
            return _of_items(elements)
    return ("an array of numpy", False) if kind_of(default, {}) is Kind.ARRAY else None


def _of_items(elements: Sequence[facts.Base]) -> tuple[str, bool] | None:
    if any(isinstance(each, (facts.Sequence, facts.Mapping)) for each in elements):
        return "a list of lists or dicts", False
    types = {_type_of(each) for each in elements}
    if None in types or len(types) < 2 or types <= {*_NUMBERS}:
        return None
    return f"a list with {' and '.join(sorted(str(each) for each in types))}", True


def _type_of(element: facts.Base) -> str | None:
    match element:
        case facts.Unary(op="-", operand=operand):
            return _type_of(operand)
        case facts.Literal(value=bool()):
            return "a bool"
        case facts.Literal(value=int()):
            return "an int"
        case facts.Literal(value=float()):
            return "a float"
        case facts.Literal(value=str()):
            return "a text"
    return None


__all__ = ["RefusedDefault", "refused_defaults"]
