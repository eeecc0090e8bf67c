"""Namespaces, remappings and parameters: once as a launch file's action, once as the command line that it makes."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import yaml

from tests_ros.comparing import Entity


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

    def of(self, nodes: list[Entity], folder: Path, kinds: tuple[str, ...]) -> Settings:
        """The settings for a process with these nodes, as archlint knows them under their defaults.

        ``folder`` is the launch file's; ``kinds`` are those of the endpoints that get rules.
        """
        name = f"{self.rename}_{nodes[0]['name'].rpartition('/')[2]}" if self.rename and len(nodes) == 1 else None
        key = self.parameters
        if key == "node":
            key = f"{self.namespace or ''}/{name or nodes[0]['name'].rpartition('/')[2]}"
        return Settings(self.namespace, name, tuple(self._rules(nodes, kinds)), self._file(nodes, key, folder))

    def _rules(self, nodes: list[Entity], kinds: tuple[str, ...]) -> list[tuple[str, str]]:
        """A rule for every other name that the code writes, as it writes it."""
        written = sorted({end["written"] for node in nodes for kind in kinds for end in node[kind] if is_plain(end)})[
            ::2
        ]
        if self.remap == "relative":
            return [(one, f"moved/{one.lstrip('~/')}") for one in written]
        if self.remap == "absolute":
            return [(one, f"/far/away/{one.lstrip('~/')}") for one in written]
        return []

    def _file(self, nodes: list[Entity], key: str | None, folder: Path) -> Path | None:
        values = {one["name"]: other(one["default"]) for node in nodes for one in node["parameters"] if one["name"]}
        if key is None or not values:
            return None
        path = folder / f"{nodes[0]['name'].rpartition('/')[2]}.yaml"
        path.write_text(yaml.safe_dump({key: {"ros__parameters": values}}))
        return path


def is_plain(end: Entity) -> bool:
    """Whether an endpoint's name is written out in the code, and is not rclpy's own."""
    own = end["name"] in ("/rosout", "/parameter_events") or "_parameter" in (end["name"] or "")
    return bool(end["written"]) and end["resolution"] == "exact" and not own and "type_description" not in end["name"]


def other(value: Any) -> Any:
    """Another value of the same type."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, (int, float)):
        return value + 2
    return f"{value}_given" if isinstance(value, str) else value


VARIATIONS = (
    Variation("namespace", namespace="/fleet/one", remap="relative", parameters="/**"),
    Variation("renamed", namespace="/two", rename="other", remap="absolute", parameters="node"),
)
