"""Parameter files as rcl's parser reads them: which node key sets which parameter to which value."""

from __future__ import annotations

import re
from collections.abc import Iterator

import yaml

Row = tuple[str, str, object]
"""Node key, parameter, value."""

_TRUE = ("y", "Y", "yes", "Yes", "YES", "true", "True", "TRUE", "on", "On", "ON")
_FALSE = ("n", "N", "no", "No", "NO", "false", "False", "FALSE", "off", "Off", "OFF")
_FLOAT = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")
_INTEGER = re.compile(r"[-+]?(0[xX][0-9a-fA-F]+|\d+)$")


def scalar(node: yaml.ScalarNode) -> object:
    """``get_value`` of rcl_yaml_param_parser: quotes make a string, otherwise boolean, integer, double, string."""
    text = node.value
    if node.style in ("'", '"') or (node.tag == "tag:yaml.org,2002:str" and node.style is not None):
        return text
    if text in _TRUE or text in _FALSE:
        return text in _TRUE
    if _INTEGER.match(text):
        return int(text, 16) if "x" in text.lower() else int(text, 8) if re.match(r"[-+]?0\d", text) else int(text)
    if _FLOAT.match(text):
        return float(text)
    if text.lower() in (".nan", ".inf", "+.inf", "-.inf"):
        return float(text.replace(".", ""))
    return text


def value_of(text: str) -> object:
    """The value in ``-p name:=value``."""
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.YAMLError:
        return text
    return text if node is None else _value(node)


def _value(node: yaml.Node) -> object:
    if isinstance(node, yaml.SequenceNode):
        return [_value(item) for item in node.value]
    return scalar(node) if isinstance(node, yaml.ScalarNode) else None


def rows_of_file(path: str) -> list[Row]:
    with open(path, encoding="utf-8") as file:
        root = yaml.compose(file.read(), Loader=yaml.SafeLoader)
    return list(_nodes(root, "")) if root is not None else []


def _nodes(node: yaml.Node, key: str) -> Iterator[Row]:
    for name, below in node.value if isinstance(node, yaml.MappingNode) else ():
        if name.value == "ros__parameters":
            yield from _entries(below, key, "")
        else:
            yield from _nodes(below, f"{key.rstrip('/')}/{name.value.lstrip('/')}" if key else name.value)


def _entries(node: yaml.Node, key: str, prefix: str) -> Iterator[Row]:
    for name, below in node.value if isinstance(node, yaml.MappingNode) else ():
        full = f"{prefix}.{name.value}" if prefix else name.value
        if isinstance(below, yaml.MappingNode):
            yield from _entries(below, key, full)
        else:
            yield key, full, _value(below)
