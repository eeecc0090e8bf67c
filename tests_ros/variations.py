"""Namespaces, remappings and parameters: once as a launch file's action, once as the command line that it makes."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import yaml

from tests_ros.reading import Entity


@dataclass(frozen=True)
class Settings:
    """What one process is started with; ``file`` is a parameter file."""

    namespace: str | None = None
    name: str | None = None
    remappings: tuple[tuple[str, str], ...] = ()
    file: Path | None = None

    def action(self, package: str, executable: str) -> str:
        """As an action of an XML launch file."""
        inner = "".join(f"<remap from={quoteattr(old)} to={quoteattr(new)}/>" for old, new in self.remappings)
        inner += f"<param from={quoteattr(f'$(dirname)/{self.file.name}')}/>" if self.file else ""
        given = {"pkg": package, "exec": executable, "name": self.name, "namespace": self.namespace}
        words = " ".join(f"{key}={quoteattr(value)}" for key, value in given.items() if value is not None)
        return f"<node {words}>{inner}</node>\n"

    def arguments(self) -> tuple[str, ...]:
        """As the command line of the process, in the order in which launch_ros gives them."""
        words = ["--ros-args"]
        words += ["-r", f"__node:={self.name}"] if self.name else []
        words += ["-r", f"__ns:={self.namespace}"] if self.namespace else []
        words += ["--params-file", str(self.file)] if self.file else []
        words += [word for old, new in self.remappings for word in ("-r", f"{old}:={new}")]
        return tuple(words)


@dataclass(frozen=True)
class Variation:
    """A way of starting a node otherwise than by its defaults."""

    name: str
    namespace: str | None = None
    rename: str | None = None
    remap: str | None = None
    """``relative`` or ``absolute``: how the rules for its endpoints are written; None: no rules."""
    parameters: str | None = None
    """The key that the parameter file has for the node: ``/**``, or ``node`` for its full name; None: no file."""

    def of(self, nodes: list[Entity], file: Path, names: list[str]) -> Settings:
        """The settings for a process with these nodes, as archlint knows them under their defaults.

        ``file`` is the parameter file that is written if there is anything for it; ``names`` are those that get rules,
        as they are written in the code.
        """
        if not nodes:
            return Settings(self.namespace)
        name = f"{self.rename}_{own_name(nodes[0])}" if self.rename and len(nodes) == 1 else None
        key = self.parameters
        if key == "node":
            key = f"{self.namespace or ''}/{name or own_name(nodes[0])}"
        written = self._write(nodes, key, file)
        return Settings(self.namespace, name, tuple(self._rules(names)), written)

    def _rules(self, names: list[str]) -> list[tuple[str, str]]:
        if self.remap == "relative":
            return [(one, f"moved/{one.lstrip('~/')}") for one in names]
        if self.remap == "absolute":
            return [(one, f"/far/away/{one.lstrip('~/')}") for one in names]
        return []

    def _write(self, nodes: list[Entity], key: str | None, file: Path) -> Path | None:
        values = {one["name"]: other(one["default"]) for node in nodes for one in node["parameters"] if is_set(one)}
        if key is None or not values:
            return None
        file.write_text(yaml.safe_dump({key: {"ros__parameters": values}}))
        return file


def every_other_name(nodes: list[Entity], kinds: tuple[str, ...]) -> list[str]:
    """Half of the names that the code of some nodes writes for ends of these ``kinds``, as it writes them: what is
    remapped for one of the nodes is remapped for all."""
    return sorted({end["written"] for node in nodes for kind in kinds for end in node[kind] if is_plain(end)})[::2]


def own_name(node: Entity) -> str:
    """Without its namespace."""
    return str(node["name"]).rpartition("/")[2]


def is_plain(end: Entity) -> bool:
    """Whether an endpoint's name is written out in the code, so that a rule can name it, and is not rclpy's own."""
    name, written = end["name"] or "", end["written"] or ""
    own = name in ("/rosout", "/parameter_events") or any(word in name for word in RCLPY_S_OWN)
    in_a_rule = re.fullmatch(r"(~/|/)?[A-Za-z][A-Za-z0-9/]*(_[A-Za-z0-9/]+)*", written)
    return bool(in_a_rule) and end["resolution"] == "exact" and not own


RCLPY_S_OWN = ("_parameter", "type_description", "/_action/")
"""In names that rclpy makes for a node or an action."""


def is_set(parameter: Entity) -> bool:
    """Whether a parameter file can set it to another value of its type."""
    return parameter["name"] is not None and parameter["default"] not in (None, [])


def other(value: Any) -> Any:
    """Another value of the same type."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return value + 2
    if isinstance(value, list):
        return [other(one) for one in value]
    return f"{value}_given"


VARIATIONS = (
    Variation("namespace", namespace="/fleet/one", remap="relative", parameters="/**"),
    Variation("renamed", namespace="/two", rename="other", remap="absolute", parameters="node"),
)
