"""YAML launch files, as the same tree of elements that XML gives."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax.launch_elements import DEPTH, ELEMENTS, Attribute, Element, LaunchFacts, Scalar, failed
from archlint.syntax.line_suppressions import suppressions_of_lines
from archlint.syntax.safe_yaml import YamlError, YamlReader, scalar, span_of

if TYPE_CHECKING:
    import yaml


def read_launch_yaml(text: str) -> LaunchFacts:
    """The facts of a YAML launch file; never raises for what is in the text."""
    try:
        reader = YamlReader(text)
        if reader.root is None:
            return LaunchFacts()
        reader.left = ELEMENTS
        root = _root(reader, reader.root)
    except YamlError as error:
        return failed(error.line, error.column, error.message)
    except RecursionError:
        return failed(1, 1, "nested too deeply")
    return LaunchFacts(root, suppressions=tuple(suppressions_of_lines(text)))


def _root(reader: YamlReader, node: yaml.Node) -> Element | None:
    """The content of the single key ``launch``; None for a file about something else."""
    pairs = list(reader.pairs(node, 0))
    if len(pairs) != 1 or pairs[0][0] != "launch":
        return None
    _, key, value = pairs[0]
    return Element("launch", {}, tuple(_children(reader, value, 1)), span_of(key))


def _children(reader: YamlReader, node: yaml.Node, depth: int) -> list[Element]:
    """A list of maps with one key each: the elements below a parent."""
    import yaml

    children: list[Element] = []
    if depth > DEPTH:
        reader.left = -1
    reader.spend(node, min(depth, 50))
    for item in node.value if isinstance(node, yaml.SequenceNode) else [node]:
        for tag, key, value in reader.pairs(item, min(depth, 50)):
            children.append(_element(reader, tag, key, value, depth))
    return children


def _element(reader: YamlReader, tag: str, key: yaml.Node, node: yaml.Node, depth: int) -> Element:
    """``tag: {attribute: value, child: [{…}, …]}``; of containers the value may be the list of children."""
    import yaml

    if isinstance(node, yaml.SequenceNode):
        return Element(tag, {}, tuple(_children(reader, node, depth + 1)), span_of(key))
    attributes: dict[str, Attribute] = {}
    children: list[Element] = []
    for name, name_node, value in reader.pairs(node, min(depth, 50)):
        match value:
            case yaml.ScalarNode():
                span = (*span_of(name_node)[:2], *span_of(value)[2:])
                attributes[name] = Attribute(_scalar(value), span)
            case yaml.SequenceNode(value=items) if items and all(isinstance(item, yaml.ScalarNode) for item in items):
                attributes[name] = Attribute([_scalar(item) for item in items], span_of(name_node))
            case yaml.SequenceNode() if name == "children":
                children.extend(_children(reader, value, depth + 1))
            case yaml.SequenceNode(value=items):
                for item in items:
                    children.append(_element(reader, name, _first_key(item) or name_node, item, depth + 1))
            case _:
                children.append(_element(reader, name, name_node, value, depth + 1))
    return Element(tag, attributes, tuple(children), span_of(key))


def _first_key(item: yaml.Node) -> yaml.Node | None:
    """Where one entry of a list starts: at its first key."""
    import yaml

    return item.value[0][0] if isinstance(item, yaml.MappingNode) and item.value else None


def _scalar(node: yaml.ScalarNode) -> Scalar:
    """launch reads YAML 1.1 as PyYAML does: ``y`` is a text, not a bool as for rcl."""
    return node.value if node.tag == "tag:yaml.org,2002:str" else scalar(node)
