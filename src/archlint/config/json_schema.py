"""The JSON Schema of a configuration file, for editors: made from the types that a file is converted into.

It is draft 7, which taplo (Even Better TOML) and SchemaStore use.  It has no ``$id``: archlint has no address yet.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import msgspec

from archlint.checks.registry import registered
from archlint.config.schema import ConfigurationFile, options_of
from archlint.rulebook import rules

if TYPE_CHECKING:
    from archlint.checks.registry import OptionValue
    from archlint.rulebook import Rule

Schema = dict[str, Any]

DESCRIPTIONS: Mapping[str, str] = {
    "baseline": "The file with the findings that are held back, relative to this file.",
    "cache-dir": "The folder in which results are kept, inside of the repository.",
    "closed-world": "Whether nothing outside the workspace takes part: a topic without a publisher is a finding then.",
    "contracts": "What must be connected and what must not be, which types and which QoS a topic has (ARC001, ARC003).",
    "distro": "The ROS distribution to judge for. Without it: all that are supported.",
    "exclude": "Patterns of files and folders that are not checked.",
    "extend": "A configuration file that this one builds on.",
    "extend-select": "Rules that run too, by code, prefix, name or ALL.",
    "external": "Names that other machines or C++ packages provide; globs.",
    "external-nodes": "What nodes offer whose source is elsewhere, beside the well-known ones that archlint knows.",
    "ignore": "Rules that do not run, by code, prefix, name or ALL.",
    "launch": "Patterns of the launch files that are systems of their own. Without it: all of them.",
    "layers": "The nodes of each layer, and the `order` of the layers from top to bottom (ARC002).",
    "owners": "The only nodes that may publish a topic or serve a name (OWN003).",
    "per-file-ignores": "Rules that do not run for the files that match a pattern.",
    "per-package-ignores": "Rules that do not run for a package.",
    "plugins": "Rules of your own: installed plugins by name, and Python files of this repository "
    "(`tools/our_rules.py`), which run only with --plugins.",
    "preset": "Which rules run and which findings fail, to start from: for a course, a team or a safety case.",
    "rules": "The options of a rule, by its code or name.",
    "select": "The only rules that run, by code, prefix, name or ALL.",
    "severity": "How severe the findings of a rule are; the rule by code, prefix or name.",
    "shared-topics": "Topics that several nodes may publish (OWN001).",
    "unused-files": "Whether findings in files and functions that nothing runs and in packages that others maintain "
    "are shown, too.",
}
"""What each key of a configuration says, for people."""


def json_schema() -> Schema:
    """The schema of an ``archlint.toml``, which is that of ``[tool.archlint]``, too."""
    (root,), definitions = msgspec.json.schema_components((ConfigurationFile,), ref_template="#/definitions/{name}")
    tables = {name: _plain(_without_null(table)) for name, table in definitions.items()}
    properties = tables.pop(root["$ref"].rpartition("/")[2])["properties"]
    properties["layers"]["required"] = ["order"]
    properties["rules"] = {"type": "object", "properties": _options_by_rule(), "additionalProperties": False}
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "archlint",
        "description": "The configuration of archlint, the architecture linter for ROS 2.",
        "type": "object",
        "properties": {key: {"description": DESCRIPTIONS[key], **_plain(properties[key])} for key in properties},
        "additionalProperties": False,
        "definitions": tables,
    }


def _without_null(part: Any) -> Any:
    """A schema without null, which TOML does not have, and with which a key that is not there is meant."""
    match part:
        case {"anyOf": [*options]}:
            kept = [_without_null(option) for option in options if option != {"type": "null"}]
            rest = {key: value for key, value in part.items() if key not in ("anyOf", "default")}
            return {**rest, **kept[0]} if len(kept) == 1 else {**rest, "anyOf": kept}
        case dict():
            return {key: _without_null(value) for key, value in part.items()}
        case list():
            return [_without_null(value) for value in part]
    return part


def _plain(part: Schema) -> Schema:
    """A schema without what its type says for error messages or to who reads the code."""
    return {key: value for key, value in part.items() if key != "description"}


def _options_by_rule() -> Schema:
    """The table of each rule that has options, under both of its names."""
    checks = registered()
    known = rules()
    by_rule: Schema = {}
    for code in sorted(checks.keys() & known.keys()):
        if checks[code].defaults:
            table = _options(known[code], checks[code].defaults)
            by_rule |= {code: table, known[code].name: table}
    return by_rule


def _options(rule: Rule, defaults: Mapping[str, OptionValue]) -> Schema:
    _, definitions = msgspec.json.schema_components((options_of(rule.title, defaults),))
    [table] = definitions.values()
    properties = _without_null(table)["properties"]
    return {
        "description": f"{rule.title}: {rule.summary}",
        "type": "object",
        "properties": {key: {**properties[key], "default": default} for key, default in defaults.items()},
        "additionalProperties": False,
    }
