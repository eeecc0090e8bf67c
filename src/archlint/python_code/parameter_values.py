"""Values that do not agree with the type beside them: ``Parameter('rate', Parameter.Type.DOUBLE, 10)``.

Source: ``Parameter.__init__`` and ``Parameter.Type.check`` in rclpy/parameter.py of humble, jazzy and rolling.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.libraries.rclpy.names import canonical
from archlint.place import Place
from archlint.python_code.annotations import imported_as
from archlint.python_code.tried_code import tried_for
from archlint.records import dataclass
from archlint.syntax import facts
from archlint.syntax.parts import Itself, everything_in

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex

_PARAMETER = "rclpy.parameter.Parameter"
_AT = 2
"""Where the value stands among the arguments, behind the name and the type."""


@dataclass(frozen=True)
class WrongParameter:
    """Such a value: the type, and the value as Python writes it."""

    place: Place
    type: str
    value: str


_Check = Callable[[object], bool]
_CHECKS: dict[str, _Check] = {
    "BOOL": lambda value: isinstance(value, bool),
    "INTEGER": lambda value: isinstance(value, int),
    "DOUBLE": lambda value: isinstance(value, float),
    "STRING": lambda value: isinstance(value, str),
}


def wrong_parameters(workspace: WorkspaceIndex) -> Iterator[WrongParameter]:
    """Every such call in the files that use rclpy, outside of test code."""
    for path in workspace.python_files(mentioning="Parameter"):
        for type_, value, span in _rows(workspace, path) or ():
            yield WrongParameter(Place(path, *span), type_, value)


@kept_for_each_file
def _rows(code: facts.Facts) -> list[tuple[str, str, facts.Span]]:
    forgiven = tried_for(code.body, {"ValueError"})
    rows: list[tuple[str, str, facts.Span]] = []
    for call in everything_in(code.body, facts.Call):
        if call.func.last_name != "Parameter" or Itself[facts.Base](call) in forgiven:
            continue
        type_, value = _argument(call, 1, "type_"), _argument(call, _AT, "value")
        if type_ is None or value is None or canonical(imported_as(code, call.func.dotted) or "") != _PARAMETER:
            continue
        owner, _, name = type_.dotted.rpartition(".")
        if canonical(imported_as(code, owner) or "") == f"{_PARAMETER}.Type" and _is_wrong(name, value):
            rows.append((name, _written(value), call.span))
    return rows


def _argument(call: facts.Call, at: int, keyword: str) -> facts.Expr | None:
    if any(argument.star for argument in call.args):
        return None
    by_position = [argument.value for argument in call.args if argument.keyword is None]
    named = [argument.value for argument in call.args if argument.keyword == keyword]
    return by_position[at] if at < len(by_position) else named[0] if named else None


def _is_wrong(type_: str, value: facts.Expr) -> bool:
    check = _CHECKS.get(type_.removesuffix("_ARRAY"))
    match value:
        case facts.Literal(value=plain) if check is not None:
            return type_.endswith("_ARRAY") or not check(plain)
        case facts.Sequence(kind="list" | "tuple", elements=elements) if check is not None:
            if not type_.endswith("_ARRAY"):
                return True
            return any(isinstance(each, facts.Literal) and not check(each.value) for each in elements)
    return False


def _written(value: facts.Expr) -> str:
    if isinstance(value, facts.Literal):
        return repr(value.value)
    elements = value.elements if isinstance(value, facts.Sequence) else []
    return f"[{', '.join(map(_written, elements))}]" if elements else "…"


__all__ = ["WrongParameter", "wrong_parameters"]
