"""``archlint config``: the effective configuration, and the origin of each value; or what one may hold."""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, cast

from archlint import cells
from archlint.cli import console
from archlint.cli.exits import CLEAN
from archlint.cli.options import add_configuration, add_paths, paths_of, plugins_of, settings_of
from archlint.cli.parser import Parser
from archlint.finding import Severity
from archlint.globs import Glob
from archlint.visible import visible

if TYPE_CHECKING:
    from archlint.config.settings import Settings
    from archlint.ros.external_nodes import ExternalNode


def parser() -> Parser:
    parser = Parser("config", "Print the effective configuration as TOML, with the origin of each value.")
    add_paths(parser)
    add_configuration(parser, with_plugins=True)
    parser.add_argument("--schema", action="store_true", help="print the JSON Schema of a configuration file instead")
    return parser


def run(arguments: argparse.Namespace) -> int:
    if arguments.schema:
        from archlint.config.json_schema import json_schema  # with all rules, which this command does without

        if plugins_of(arguments):
            settings_of(arguments, paths_of(arguments)[0], plugins=True)
        console.say(json.dumps(json_schema(), indent=2) + "\n")
        return CLEAN
    settings = settings_of(arguments, paths_of(arguments)[0], plugins_of(arguments) or False)
    origins = settings.origins
    rows = [(visible(f"{key} = {_toml(value)}"), origins.get(key, "default")) for key, value in _values(settings)]
    width = min(max(cells.width(text) for text, _ in rows), 60)
    console.say("".join(f"{cells.padded(text, width)}  # {visible(origin)}\n" for text, origin in rows))
    console.say(f"# rules that run: {', '.join(_running(settings))}\n")
    return CLEAN


def _values(settings: Settings) -> Iterator[tuple[str, object]]:
    """Keys with their effective values; those that are unset and have no default are left out."""
    layers = settings.layers
    selects = [layer.select for layer in layers if layer.select is not None]
    if selects:
        yield "select", selects[-1]
    if settings.preset is not None:
        yield "preset", settings.preset
    yield "extend-select", [code for layer in layers for code in layer.extend_select]
    yield "ignore", [code for layer in layers for code in layer.ignore]
    yield "severity", settings.severity
    yield "exclude", settings.exclude
    yield "per-file-ignores", settings.per_file_ignores
    yield "per-package-ignores", settings.per_package_ignores
    if settings.distro is not None:
        yield "distro", settings.distro
    yield "closed-world", settings.closed_world
    yield "launch", settings.launch
    yield "external", settings.external
    if settings.external_nodes:
        yield "external-nodes", [_external(node) for node in settings.external_nodes]
    yield "shared-topics", settings.shared_topics
    yield "unused-files", settings.unused_files
    yield from _architecture(settings)
    if settings.baseline is not None:
        yield "baseline", settings.baseline
    if settings.cache_dir is not None:
        yield "cache-dir", settings.cache_dir
    if settings.plugins:
        yield "plugins", settings.plugins
    yield "rules", settings.rules


def _architecture(settings: Settings) -> Iterator[tuple[str, object]]:
    if settings.owners:
        yield "owners", settings.owners
    if settings.contracts:
        yield "contracts", [contract.as_table() for contract in settings.contracts]
    if settings.node_layers is not None:
        yield "layers", {"order": settings.node_layers.order, **settings.node_layers.members}


def _external(node: ExternalNode) -> dict[str, object]:
    """An external node by the keys of the configuration."""
    row: dict[str, object] = {"package": node.package, "executable": node.executables, "name": node.name}
    row["complete"] = not node.open
    for end in node.ends:
        key = f"{end.kind.replace('_', '-')}s"
        row[key] = {**cast("dict[str, str]", row.get(key, {})), end.name: end.type}
    return row | ({"parameters": {p.name: p.type for p in node.parameters}} if node.parameters else {})


def _toml(value: object) -> str:
    match value:
        case Mapping():
            inner = ", ".join(f"{_toml(key)} = {_toml(item)}" for key, item in value.items())
            return f"{{ {inner} }}" if inner else "{}"
        case Severity():
            return json.dumps(value.label)
        case Glob():
            return json.dumps(value.pattern)
        case list() | tuple():
            return f"[{', '.join(_toml(item) for item in value)}]"
    return json.dumps(value)


def _running(settings: Settings) -> list[str]:
    selection = settings.selection
    return [code for code in selection.codes if selection.runs(code, settings.closed_world)]
