"""Parameter files: which values they give to which nodes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from archlint.facts.launch_yaml import suppressions_of_lines
from archlint.facts.model import FileProblem, Span, Suppression
from archlint.facts.safe_yaml import YamlError, YamlReader, span_of

if TYPE_CHECKING:
    import yaml

ROOT = "ros__parameters"


@dataclass(frozen=True)
class ParameterEntry:
    """``name`` with ``.`` between the levels of nested maps; ``value`` is plain Python data, of a text whether it is
    ``quoted``."""

    name: str
    value: Any
    span: Span
    quoted: bool = False


@dataclass(frozen=True)
class ParameterSection:
    """What stands below one ``ros__parameters``.  ``key`` is the node key as rclpy matches it: the maps above
    joined with ``/``, with a leading ``/``; ``written`` is the key as the file has it."""

    key: str
    written: str
    span: Span
    entries: tuple[ParameterEntry, ...]


@dataclass(frozen=True)
class ParameterFacts:
    sections: tuple[ParameterSection, ...] = ()
    problems: tuple[FileProblem, ...] = ()
    suppressions: tuple[Suppression, ...] = ()


def read_parameters(text: str) -> ParameterFacts:
    """The sections of a parameter file; a YAML file of another kind has none.  Never raises."""
    found: list[ParameterSection] = []
    try:
        reader = YamlReader(text, several=True)  # rcl reads on where another document starts
        for root in reader.roots:
            _sections(reader, root, [], None, found, 0)
    except YamlError as error:
        return ParameterFacts(problems=(FileProblem(error.line, error.column, error.message),))
    except RecursionError:
        return ParameterFacts(problems=(FileProblem(1, 1, "nested too deeply"),))
    return ParameterFacts(tuple(found), suppressions=tuple(suppressions_of_lines(text)))


def _sections(
    reader: YamlReader,
    node: yaml.Node,
    path: list[str],
    span: Span | None,
    found: list[ParameterSection],
    depth: int,
) -> None:
    for key, key_node, value in reader.pairs(node, depth):
        if key == ROOT:
            entries: list[ParameterEntry] = []
            _entries(reader, value, "", entries, depth + 1)
            written = "/".join(path)
            joined = "/" + "/".join(part.strip("/") for part in path if part.strip("/"))
            found.append(ParameterSection(joined, written, span or span_of(key_node), tuple(entries)))
        else:
            _sections(reader, value, [*path, key], span_of(key_node), found, depth + 1)


def _entries(reader: YamlReader, node: yaml.Node, prefix: str, found: list[ParameterEntry], depth: int) -> None:
    import yaml

    for key, key_node, value in reader.pairs(node, depth):
        name = f"{prefix}.{key}" if prefix else key
        if isinstance(value, yaml.MappingNode):
            _entries(reader, value, name, found, depth + 1)
        else:
            quoted = isinstance(value, yaml.ScalarNode) and value.style in ("'", '"')
            found.append(ParameterEntry(name, reader.value(value, depth), span_of(key_node), quoted))
