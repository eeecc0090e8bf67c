"""Where a parameter file departs from ``node: ros__parameters: …``, so that rcl refuses it or reads other names.

Source: ``parse_file_events`` and ``parse_key`` of rcl_yaml_param_parser.  The process that is given such a file ends in
``rclpy.init()``: "Cannot have a value before ros__parameters", "There are no node names before ros__parameters".
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.records import dataclass
from archlint.string_enum import StringEnum
from archlint.syntax.facts import Span
from archlint.syntax.safe_yaml import span_of

if TYPE_CHECKING:
    import yaml

ROOT = "ros__parameters"
_MEANT = re.compile(r"[ _-]*(?:ros?)?[ _-]*param(?:eter)?s?[ _-]*", re.IGNORECASE)
"""What people write for it: ``ros_parameters``, ``ros__parameter``, ``parameters``."""


class Misplacement(StringEnum):
    """What is wrong with a key of a parameter file."""

    MISSPELT = "misspelt"
    """It was meant to be ``ros__parameters``."""
    NO_NODE = "no node"
    """``ros__parameters`` at the top."""
    NOTHING_BELOW = "nothing below"
    """``ros__parameters`` without keys below it."""
    BESIDE = "beside"
    """A value beside ``ros__parameters``."""
    MISSING = "missing"
    """A value with no ``ros__parameters`` above it."""
    LIST = "list"
    """A list at the top, where the names of nodes have to be."""
    TWICE = "twice"
    """``ros__parameters`` below itself: rcl takes it for a part of the parameters' names."""


@dataclass(frozen=True)
class Misplaced:
    """The first key of a file that is not where it has to be; ``above`` are the keys around it.  ``other`` is the empty
    key beside a ``ros__parameters`` at the top, a key beside one without content, and one below one too many."""

    kind: Misplacement
    key: str
    span: Span
    above: tuple[str, ...] = ()
    other: str = ""

    @property
    def is_refused(self) -> bool:
        """Whether rcl refuses the file."""
        return self.kind != Misplacement.TWICE


def first_misplaced(root: yaml.Node) -> Misplaced | None:
    """The first key of a document that is not where it has to be.  Its maps must be known not to be without end."""
    import yaml

    if isinstance(root, yaml.SequenceNode):
        line = root.start_mark.line + 1
        column = root.start_mark.column + 1
        return Misplaced(Misplacement.LIST, "", (line, column, line, column + 1))
    return next(_misplaced(root, ()), None)


def _misplaced(node: yaml.Node, above: tuple[str, ...]) -> Iterator[Misplaced]:
    pairs = list(_pairs(node))
    root = next((key for key in pairs if key.value == ROOT), None)
    for key in pairs:
        match key:
            case _Pair(value="<<"):
                return  # an alias: rcl has none
            case _Pair(value=name, is_map=True, node=inner) if name.startswith(ROOT):
                yield from _below(inner, above) if above else [key.misplaced(Misplacement.NO_NODE, above)]
            case _Pair(value=name) if name.startswith(ROOT):
                yield key.misplaced(Misplacement.NOTHING_BELOW, above, next((k.value for k in pairs if k != key), ""))
            case _Pair(value=name, is_map=True, node=inner):
                wrong = next(_misplaced(inner, (*above, name)), None)
                if wrong is not None:
                    yield _of_map(key, wrong, above, is_beside=root is not None)
            case _ if root is None:
                yield key.misplaced(Misplacement.MISSING, above)
            case _ if above:
                yield key.misplaced(Misplacement.BESIDE, above)
            case _:
                yield root.misplaced(Misplacement.NO_NODE, above, key.value)


def _of_map(key: _Pair, wrong: Misplaced, above: tuple[str, ...], is_beside: bool) -> Misplaced:
    """What is wrong with a key of which something is ``wrong`` below it, perhaps beside a ``ros__parameters``."""
    if wrong.kind != Misplacement.MISSING:
        return wrong
    if _MEANT.fullmatch(key.value):
        return key.misplaced(Misplacement.MISSPELT, above)
    return key.misplaced(Misplacement.BESIDE, above) if is_beside and above else wrong


def _below(node: yaml.Node, above: tuple[str, ...]) -> Iterator[Misplaced]:
    """What stands below ``ros__parameters`` and may not."""
    for key in _pairs(node):
        if key.value == ROOT and key.is_map:
            first = next((inner.value for inner in _pairs(key.node)), "")
            yield key.misplaced(Misplacement.TWICE, above, first)
        elif key.is_map:
            yield from _below(key.node, (*above, key.value))


@dataclass(frozen=True, eq=False)
class _Pair:
    value: str
    span: Span
    node: yaml.Node
    is_map: bool

    def misplaced(self, kind: Misplacement, above: tuple[str, ...], other: str = "") -> Misplaced:
        return Misplaced(kind, self.value, self.span, above, other)


def _pairs(node: yaml.Node) -> Iterator[_Pair]:
    import yaml

    match node:
        case yaml.MappingNode(value=pairs):
            for key, value in pairs:
                yield _Pair(str(key.value), span_of(key), value, isinstance(value, yaml.MappingNode))


__all__ = ["ROOT", "Misplaced", "Misplacement", "first_misplaced"]
