"""Create calls that a plain text search finds, and how many of them the graph has: ``python -m benchmarks.coverage
CHECKOUT…``.

A call is a line of a Python file outside test code on which ``create_publisher(`` and the like stand after a dot, or
``ActionServer(``/``ActionClient(`` without ``class`` or ``import``.  The graph has it when an endpoint or timer starts
on that line; it is resolved when one of those has a known name (timers: a known period).
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

CALL = re.compile(
    r"\.(?:create_(?:lifecycle_)?publisher|create_subscription|create_service|create_client|create_timer)\s*\("
    r"|(?<![\w.])(?:rclpy\.action\.)?Action(?:Server|Client)\s*\("
)
KINDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")


def is_test(path: Path) -> bool:
    return any(part in ("test", "tests") for part in path.parts) or path.stem.startswith("test_")


def text_search(root: Path) -> list[tuple[str, int]]:
    found = []
    for path in sorted(root.rglob("*.py")):
        relative = path.relative_to(root)
        if is_test(relative) or any(part.startswith(".") for part in relative.parts):
            continue
        for number, line in enumerate(path.read_text("utf-8", "replace").splitlines(), start=1):
            code = line.partition("#")[0]
            if CALL.search(code) and not re.match(r"\s*(class|def|from|import)\b", code):
                found.append((relative.as_posix(), number))
    return found


def graph(root: Path) -> tuple[dict[tuple[str, int], bool], list[str]]:
    command = [sys.executable, "-m", "archlint", "graph", ".", "--format", "json", "--no-cache"]
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True)
    sites: dict[tuple[str, int], bool] = {}
    document = json.loads(done.stdout)
    for node in document["nodes"]:
        for kind in KINDS:
            for endpoint in node[kind]:
                for line in range(endpoint["line"], endpoint["end_line"] + 1):
                    key = (endpoint["file"], line)
                    sites[key] = sites.get(key, False) or endpoint["name"] is not None
        for timer in node["timers"]:
            for line in range(timer["line"], timer.get("end_line", timer["line"]) + 1):
                key = (timer["file"], line)
                sites[key] = sites.get(key, False) or timer["period_s"] is not None
    return sites, [entry["file"] for entry in document["unresolved"]]


def main() -> None:
    misses = "--misses" in sys.argv
    print("| checkout | text search | in the graph | resolved |")
    print("|---|---|---|---|")
    total = [0, 0, 0]
    for name in (argument for argument in sys.argv[1:] if not argument.startswith("-")):
        root = Path(name).resolve()
        calls = text_search(root)
        sites, _ = graph(root)
        found = [call for call in calls if call in sites]
        resolved = [call for call in found if sites[call]]
        for index, rows in enumerate((calls, found, resolved)):
            total[index] += len(rows)
        print(f"| {root.name} | {len(calls)} | {len(found)} | {len(resolved)} |", flush=True)
        if misses:
            for file, line in calls:
                if (file, line) not in sites:
                    print(f"    not in the graph: {file}:{line}")
    print(f"| all | {total[0]} | {total[1]} | {total[2]} |")


if __name__ == "__main__":
    main()
