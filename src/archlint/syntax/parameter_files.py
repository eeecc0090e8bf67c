"""Parameter files: which values they give to which nodes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, Union

from archlint.records import dataclass
from archlint.syntax.facts import FileProblem, Span, Suppression
from archlint.syntax.line_suppressions import suppressions_of_lines
from archlint.syntax.parameter_structure import ROOT, Misplaced, first_misplaced
from archlint.syntax.refused_parameters import RefusedParameter, first_refused
from archlint.syntax.safe_yaml import YamlError, YamlReader, in_python, span_of

if TYPE_CHECKING:
    import yaml


@dataclass(frozen=True)
class NotKnown:
    """Stands for a value that is set from outside and not known here, and why it is not."""

    reason: str


ParameterData = Union[str, int, float, bool, bytes, None, "list[ParameterData]", NotKnown]
"""The value of a parameter, as far as it is known."""


def first_not_known(values: Iterable[object]) -> NotKnown | None:
    """The first of some values that is not known."""
    for value in values:
        match value:
            case NotKnown():
                return value
    return None


@dataclass(frozen=True)
class ParameterEntry:
    """``name`` with ``.`` between the levels of nested maps, which are the ``path``; ``value`` is plain Python data,
    of a text whether it is ``quoted``.  The value of one that is ``changed`` is not that of the file, and one that is
    ``added`` does not stand there at all."""

    name: str
    value: Any
    span: Span
    quoted: bool = False
    path: tuple[str, ...] = ()
    changed: bool = False
    added: bool = False
    in_python: Any = None
    """The value as PyYAML has it, which launch reads the file of a component with."""


@dataclass(frozen=True)
class ParameterSection:
    """What stands below one ``ros__parameters``.  ``key`` is the node key as rclpy matches it: the maps above
    joined with ``/``, with a leading ``/``; ``written`` is the key as the file has it, and ``path`` are these maps."""

    key: str
    written: str
    span: Span
    entries: tuple[ParameterEntry, ...]
    path: tuple[str, ...] = ()


@dataclass(frozen=True)
class ParameterFacts:
    sections: tuple[ParameterSection, ...] = ()
    problems: tuple[FileProblem, ...] = ()
    suppressions: tuple[Suppression, ...] = ()
    plain: tuple[ParameterEntry, ...] = ()
    """What a file without any ``ros__parameters`` gives to a component: launch_ros takes all of it for parameters."""
    misplaced: Misplaced | None = None
    """The first key that is not where rcl wants it."""
    refused: RefusedParameter | None = None
    """The first parameter whose value rcl takes for none."""


def read_parameters(text: str) -> ParameterFacts:
    """The sections of a parameter file; a YAML file of another kind has none.  Never raises."""
    sections: list[ParameterSection] = []
    plain: list[ParameterEntry] = []
    misplaced: Misplaced | None = None
    try:
        reader = YamlReader(text, several=True, rcl=True)  # rcl reads on where another document starts
        for root in reader.roots:
            _sections(reader, root, [], None, sections, 0)
        if len(reader.roots) == 1 and not sections:
            _entries(reader, reader.roots[0], (), plain, 0)
        misplaced = first_misplaced(reader.roots[0]) if reader.roots else None
        refused = first_refused(reader.roots[0]) if reader.roots else None
    except YamlError as error:
        return ParameterFacts(problems=(FileProblem(error.line, error.column, error.message),))
    except RecursionError:
        return ParameterFacts(problems=(FileProblem(1, 1, "nested too deeply"),))
    suppressions = tuple(suppressions_of_lines(text))
    return ParameterFacts(
        tuple(sections), suppressions=suppressions, plain=tuple(plain), misplaced=misplaced, refused=refused
    )


def _sections(
    reader: YamlReader,
    node: yaml.Node,
    path: list[str],
    span: Span | None,
    sections: list[ParameterSection],
    depth: int,
) -> None:
    for key, key_node, value in reader.pairs(node, depth):
        if key == ROOT:
            entries: list[ParameterEntry] = []
            _entries(reader, value, (), entries, depth + 1)
            at = span or span_of(key_node)
            sections.append(ParameterSection(node_key(path), "/".join(path), at, tuple(entries), tuple(path)))
        else:
            _sections(reader, value, [*path, key], span_of(key_node), sections, depth + 1)


def node_key(path: Iterable[str]) -> str:
    """The node key as rclpy matches it, of the maps above ``ros__parameters``."""
    return "/" + "/".join(part.strip("/") for part in path if part.strip("/"))


def _entries(
    reader: YamlReader, node: yaml.Node, above: tuple[str, ...], entries: list[ParameterEntry], depth: int
) -> None:
    import yaml

    for key, key_node, value in reader.pairs(node, depth):
        path = (*above, key)
        if key == ROOT:
            continue  # misplaced: nobody means a parameter of this name
        if isinstance(value, yaml.MappingNode):
            _entries(reader, value, path, entries, depth + 1)
        else:
            quoted = isinstance(value, yaml.ScalarNode) and value.style in ("'", '"')
            data = reader.value(value, depth)
            name, span, there = ".".join(path), span_of(key_node), in_python(value)
            entries.append(ParameterEntry(name, data, span, quoted, path, in_python=there))
