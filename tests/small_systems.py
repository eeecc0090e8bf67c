"""Small systems in the form of the JSON of a graph."""

from __future__ import annotations

from typing import Any

from archlint.comparing.changes import Change
from archlint.comparing.compare import compare
from archlint.comparing.graphs import Graph, graph_of

RELIABLE = {"history": "keep_last", "depth": 10, "reliability": "reliable", "durability": "volatile"}
BEST_EFFORT = {**RELIABLE, "reliability": "best_effort"}


def end(name: str | None, type: str = "std_msgs/msg/String", **more: Any) -> dict[str, Any]:
    """An end of a topic, service or action."""
    return {
        "name": name,
        "type": type,
        "qos": RELIABLE,
        "file": "robot/node.py",
        "line": 10,
        "column": 9,
        "written": name and name[1:],
        "resolution": "unknown" if name is None else "exact",
        **more,
    }


def parameter(name: str, default: Any, type: str = "double", **more: Any) -> dict[str, Any]:
    return {"name": name, "type": type, "default": default, "file": "robot/node.py", "line": 5, **more}


def node(name: str, **more: Any) -> dict[str, Any]:
    """A node of a package ``robot``, whose class has its name."""
    return {
        "name": name,
        "class": name[1:].title(),
        "package": "robot",
        "executable": name[1:],
        "file": f"robot{name}.py",
        "line": 3,
        "is_node": True,
        "lifecycle": False,
        "executor": "single_threaded",
        "launched_by": None,
        "external": False,
        "condition": None,
        "remappings": [],
        "test": False,
        "complete": True,
        "publishers": [],
        "subscribers": [],
        "services": [],
        "clients": [],
        "action_servers": [],
        "action_clients": [],
        "parameters": [],
        "overrides": [],
        **more,
    }


def system(*nodes: dict[str, Any], name: str | None = None, **more: Any) -> Graph:
    """All nodes of a workspace, or with a name what that launch file starts."""
    rest = {"launch_arguments": [], "interfaces": [], **more}
    return graph_of({"version": 1, "system": name, "nodes": list(nodes), **rest})


def changes(before: Graph, after: Graph) -> list[Change]:
    return list(compare([before], [after]).changes)


def told(before: Graph, after: Graph) -> list[str]:
    """Each change as ``impact status subject name: reason``."""
    return [f"{c.impact} {c.status} {c.subject} {c.name}: {c.reason}" for c in changes(before, after)]
