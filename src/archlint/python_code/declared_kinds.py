"""What the values of parameters are for certain: the type of the default that the node declares is theirs for good.

Source: rclpy's ``Node`` refuses a value of another type than the declared one, wherever it comes from, unless the
descriptor says ``dynamic_typing``.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from archlint.python_code.plain_kinds import Kind, kind_of, kind_of_all
from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for
from archlint.syntax.walk import given_to

_OPEN = frozenset(
    {"allow_undeclared_parameters", "automatically_declare_parameters_from_overrides", "dynamic_typing"}
    | {"has_parameter", "undeclare_parameter"}
)
"""Words of a file in which a parameter may be declared otherwise, or not at all."""
_FIELDS = {
    "bool_value": Kind.BOOL,
    "double_value": Kind.NUMBER,
    "integer_value": Kind.NUMBER,
}


def kind_of_parameter(code: facts.Facts, cls: facts.Class | None, value: facts.Expr) -> Kind | None:
    """What ``self.get_parameter('rate').value`` is in the methods of a class that declares it, or
    ``self.declare_parameter('rate', 1.0).value``, or a field of ``get_parameter_value()``; None for anything else."""
    match value:
        case facts.Attribute(attr=field, value=facts.Call(func=facts.Attribute(attr="get_parameter_value"))):
            return _FIELDS.get(field)
        case facts.Attribute(attr="value", value=facts.Call(func=function) as call) if _OPEN.isdisjoint(code.names):
            name = given_to(call, "name", 0)
            if function.dotted == "self.declare_parameter":
                return _of_default(call)
            if function.dotted == "self.get_parameter" and cls is not None and name is not None:
                return _declared(cls).get(name.text or "")
    return None


def kind_with_parameters(
    code: facts.Facts, cls: facts.Class | None, values: Sequence[facts.Expr | None]
) -> Kind | None:
    """What all of some values are, where some are those of parameters; None where none is."""
    kinds = [None if value is None else kind_of_parameter(code, cls, value) for value in values]
    if not any(kinds):
        return None
    others = (kind or kind_of_all([value], {}) for kind, value in zip(kinds, values, strict=True))
    known = set(others) - {Kind.NONE}
    return known.pop() if len(known) == 1 else None


@once_for
def _declared(cls: facts.Class) -> dict[str, Kind]:
    """The parameters that a class declares, with defaults of one kind; none where some of the names are not written
    out."""
    kinds: dict[str, set[Kind | None]] = {}
    for name, kind in _declarations(cls):
        kinds.setdefault(name, set()).add(kind)
    known = {name: kind for name, given in kinds.items() for kind in given if kind is not None and len(given) == 1}
    return {} if "" in kinds else known


def _declarations(cls: facts.Class) -> Iterator[tuple[str, Kind | None]]:
    """Each declaration: the name, empty where it is not written out, and the kind of the default."""
    for call in everything_in(cls.body, facts.Call):
        match call.func.last_name:
            case "declare_parameter":
                name = given_to(call, "name", 0)
                yield (name.text or "") if name is not None else "", _of_default(call)
            case "declare_parameters":
                rows = given_to(call, "parameters", 1)
                for row in rows.elements if isinstance(rows, facts.Sequence) else ():
                    match row:
                        case facts.Sequence(elements=[facts.Literal(value=str(written)), default]):
                            yield written, _kind(default)
                        case facts.Sequence(elements=[facts.Literal(value=str(written)), *_]):
                            yield written, None
                        case _:
                            yield "", None
                if not isinstance(rows, facts.Sequence):
                    yield "", None


def _of_default(call: facts.Call) -> Kind | None:
    default = given_to(call, "value", 1)
    others = [argument for argument in call.args if argument.star or argument.keyword not in (None, "name", "value")]
    return None if default is None or others or len(call.args) > 2 else _kind(default)


def _kind(default: facts.Expr) -> Kind | None:
    kind = kind_of(default, {})
    return kind if kind in (Kind.BOOL, Kind.NUMBER, Kind.LIST) else None


__all__ = ["kind_of_parameter", "kind_with_parameters"]
