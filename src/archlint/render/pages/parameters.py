"""The table of a node's parameters."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.render.markdown import code, table, text
from archlint.syntax.parameter_files import NotKnown

if TYPE_CHECKING:
    from archlint.model import ParameterDeclaration, ParameterDescription
    from archlint.render.pages.site import Site
    from archlint.systems.nodes import Node

_LONGEST = 120
"""Characters of a value that is shown."""


def section(node: Node, site: Site, page: str) -> Iterator[str]:
    """The parameters that the node declares."""
    if node.parameters:
        rows = [_row(parameter, site, page) for parameter in sorted(node.parameters, key=_order)]
        yield "## Parameters"
        yield "\n".join(table(("Name", "Type", "Default", "Range", "What for", "Source"), rows))


def _order(parameter: ParameterDeclaration) -> tuple[bool, str, object]:
    name = parameter.name.text
    return (name is None, name or "", parameter.place)


def _row(parameter: ParameterDeclaration, site: Site, page: str) -> Sequence[str]:
    described = parameter.description
    notes = ["read-only"] if described is not None and described.read_only else []
    notes += ["only under a condition"] if parameter.conditional else []
    name = "not known" if parameter.name.text is None else code(parameter.name.text)
    return (
        "; ".join([name, *notes]),
        _type(parameter),
        _default(parameter),
        "" if described is None else _range(described),
        "" if described is None else text(" ".join(f"{described.text} {_braced(described.constraints)}".split())),
        site.source_link(parameter.place, page),
    )


def _type(parameter: ParameterDeclaration) -> str:
    return "any" if parameter.dynamic else parameter.type or "not known"


def _default(parameter: ParameterDeclaration) -> str:
    if parameter.given:
        return f"{value_words(parameter.given[0])} (set by the code)"
    if parameter.known:
        return value_words(parameter.default)
    return "none" if parameter.without_default else "not known"


def value_words(value: object) -> str:
    """A value as a parameter file has it."""
    match value:
        case NotKnown(reason=reason):
            return f"not known: {text(reason)}"
        case bool():
            return code(str(value).lower())
        case float() if math.isfinite(value):
            return code(repr(value))
        case str() if not value:
            return '`""`'
    shown = str(value)
    return code(shown if len(shown) <= _LONGEST else f"{shown[:_LONGEST]}…")


def _range(described: ParameterDescription) -> str:
    if described.lowest is None and described.highest is None:
        return ""
    ends = " to ".join("?" if end is None else f"{end:g}" for end in (described.lowest, described.highest))
    return ends if described.step is None else f"{ends}, step {described.step:g}"


def _braced(constraints: str) -> str:
    return f"({constraints})" if constraints else ""


__all__ = ["section", "value_words"]
