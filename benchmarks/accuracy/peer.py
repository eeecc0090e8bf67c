"""What `ros2inspector` (0.1.5) reads in the same tree, brought into the form of `archlint graph
--format json`.

It gives a file and a line for each endpoint, so it is scored at the same sites by the same rules. Where
its answer is less than was asked, the benefit is its own: names are expanded here as rcl would; a type
without its middle part (`std_msgs/String`) is taken for the full one; it has no QoS of services and
actions and no timers, and is not asked.
"""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

_KINDS = {
    "publishers": "publishers",
    "subscriptions": "subscribers",
    "services": "services",
    "clients": "clients",
    "action_servers": "action_servers",
    "action_clients": "action_clients",
}
_MIDDLE = {"publishers": "msg", "subscriptions": "msg", "services": "srv", "clients": "srv"}


def read(command: str, checkout: Path, cache: Path, language: str = "python") -> dict[str, Any]:
    """Run the peer on a copy of the checkout (it writes a cache into the tree) and translate its answer."""
    nodes = [node for node in _nodes(command, checkout, cache) if node["language"] == language]
    return {"version": 1, "nodes": [_node(node, checkout) for node in nodes], "unresolved": []}


def _nodes(command: str, folder: Path, cache: Path) -> list[dict[str, Any]]:
    """What it finds in a folder; where two packages of one name make it refuse, what it finds below."""
    arguments = [command, "nodes", "-C", str(folder), "--format", "json", "--no-cache"]
    done = subprocess.run(arguments, capture_output=True, text=True, cwd=cache, check=False)
    if done.stdout.strip():
        found: list[dict[str, Any]] = json.loads(done.stdout)
        return found
    inner = [path for path in sorted(folder.iterdir()) if path.is_dir() and not path.name.startswith(".")]
    return [node for path in inner for node in _nodes(command, path, cache)]


def _node(node: dict[str, Any], checkout: Path) -> dict[str, Any]:
    name = node.get("declared_ros_name") or node["name"]
    translated: dict[str, Any] = {"name": f"/{name}", "file": node["file_path"], "line": node["line"]}
    for theirs, ours in _KINDS.items():
        translated[ours] = [_endpoint(each, theirs, name, checkout) for each in node[theirs]]
    return translated


def _endpoint(endpoint: dict[str, Any], kind: str, node: str, checkout: Path) -> dict[str, Any]:
    name, type_ = endpoint["name"], endpoint["msg_type"]
    known = not name.startswith("<")
    package, _, short = type_.partition("/")
    qos = endpoint.get("qos")
    return {
        "file": Path(endpoint["file_path"]).resolve().relative_to(checkout.resolve()).as_posix(),
        "line": endpoint["line"],
        "name": _expanded(name, node) if known else None,
        "resolution": "exact" if known else "unknown",
        "type": f"{package}/{_MIDDLE.get(kind, 'action')}/{short}" if short else None,
        "qos": {key: qos[key] for key in ("history", "depth", "reliability", "durability")} if qos else None,
    }


def _expanded(name: str, node: str) -> str:
    if name.startswith("/"):
        return name
    return f"/{node}{name[1:]}" if name.startswith("~") else f"/{name}"
