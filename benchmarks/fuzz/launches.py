"""Launch files in XML and YAML, which are two spellings of the same elements."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from xml.sax.saxutils import quoteattr

from archlint.launch.frontends.tables import ATTRIBUTES
from benchmarks.fuzz.pick import Pick


@dataclass
class Element:
    """An element of a launch file."""

    tag: str
    attributes: dict[str, str]
    children: list[Element] = field(default_factory=list)


_TAGS = (
    "node",
    "node",
    "node",
    "group",
    "include",
    "arg",
    "let",
    *ATTRIBUTES,
    "param",
    "remap",
    "executable",
    "set_parameter",
    "odd",
)
_VALUES = (
    *(
        "$(var scan)",
        "$(var scan 1)",
        "$(find-pkg-share robot)/launch/robot.launch.xml",
        "$(env HOME)",
        "$(eval '1 + 1')",
        "$(eval \"'$(var a)' == 'b'\")",
    ),
    *(
        "$(if $(var a) b c)",
        "$(not $(var a))",
        "$(dirname)/robot.launch.yaml",
        "$(anon x)",
        "$(command 'rm -rf /')",
        "$(var $(var a))",
    ),
    *(
        "robot",
        "robot",
        "talker",
        "true",
        "false",
        "1",
        "0.1",
        "[1, 2",
        "{a: b}",
        "$(odd)",
        "$(var scan) $(var",
        "$$(var)",
        "\\$(var x)",
    ),
)


def element(pick: Pick, depth: int = 0) -> Element:
    """An element with attributes that it may have, and others; nested ones get no children in the end."""
    tag = pick.among(_TAGS)
    known = ATTRIBUTES.get(tag, ["name", "from", "to", "value", "cmd"])
    names = [name for name in known[:6] if not pick.rarely(3)] + [
        pick.one("if", "unless", "odd", "type", "ns", "sep")
    ] * pick.rarely(4)
    attributes = {name: value(pick) for name in names}
    children = [element(pick, depth + 1) for _ in range(pick.number(0, 3 - depth))] if depth < 3 else []
    return Element(tag, attributes, children)


def value(pick: Pick) -> str:
    return pick.name() if pick.rarely(3) else pick.among(_VALUES)


def xml_launch(pick: Pick) -> str:
    """A launch file in XML."""
    comment = pick.one(
        "", "", "<!-- archlint: ignore[LCH001] x -->", "<!-- -- -->", "<![CDATA[<x>]]>", "&undefined;", "<?php ?>"
    )
    head = pick.one(
        "",
        "",
        '<?xml version="1.0"?>\n',
        '<?xml version="1.0" encoding="utf-16"?>\n',
        '<!DOCTYPE a [<!ENTITY b "c">]>\n',
    )
    inside = "\n".join(_as_xml(element(pick), 1) for _ in range(pick.number(0, 4)))
    return f"{head}<launch>\n{comment}\n{inside}\n</{pick.one('launch', 'launch', 'launch', 'launch', 'lunch')}>\n"


def _as_xml(element: Element, indent: int) -> str:
    space = "  " * indent
    attributes = "".join(f" {name}={quoteattr(value)}" for name, value in element.attributes.items())
    if not element.children:
        return f"{space}<{element.tag}{attributes}/>"
    inside = "\n".join(_as_xml(child, indent + 1) for child in element.children)
    return f"{space}<{element.tag}{attributes}>\n{inside}\n{space}</{element.tag}>"


def yaml_launch(pick: Pick) -> str:
    """A launch file in YAML."""
    root = pick.one("launch", "launch", "launch", "launch", "lunch")
    rows = "\n".join(_as_yaml(pick, element(pick), 0) for _ in range(pick.number(0, 4)))
    head = pick.one("\n---", "\n", "%YAML 1.1\n---", "# note\n")
    end = pick.one("", "", "...", "---", "- x", "&a [*a]")
    return f"{head}\n{root}:\n{rows}\n{end}\n"


def _as_yaml(pick: Pick, element: Element, indent: int) -> str:
    space = "  " * indent
    lines = [f"{space}- {element.tag}:"]
    lines += [f"{space}    {name}: {_scalar(pick, value)}" for name, value in element.attributes.items()]
    if element.children:
        lines.append(f"{space}    {pick.one('children', 'param', 'remap', 'arg', 'composable_node')}:")
        lines += [_as_yaml(pick, child, indent + 3) for child in element.children]
    return "\n".join(lines)


def _scalar(pick: Pick, value: str) -> str:
    return pick.one(
        json.dumps(value),
        json.dumps(value),
        "'" + value.replace("'", "''") + "'",
        value,
        "!!python/name:os.system " + value,
        f"|\n            {value}",
    )
