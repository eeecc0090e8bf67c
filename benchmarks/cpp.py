"""How much of the C++ that a text search finds is in the graph.

    python -m benchmarks.cpp CHECKOUT… [--peer PATH] [--missed] [--sample N]

Each create call that a text search finds in the C++ of a checkout, outside of comments and test code, is looked for in
the graph by its file and line.  ``--peer`` names ros2inspector, which is asked for the same lines; ``--missed`` lists
the calls that are not in the graph; ``--sample`` prints so many of the others, chosen by a hash, to be held against the
source.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from benchmarks.accuracy import peer
from benchmarks.coverage import is_test

_CALL = re.compile(
    r"\bcreate_(?:publisher|subscription|service|client|server|lifecycle_publisher)\s*<"
    r"|message_filters::Subscriber\s*<[^;\n]*\("
)
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".hh", ".hxx", ".h")
_NOT_BUILT = ("COLCON_IGNORE", "AMENT_IGNORE")
_KINDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")
Site = tuple[str, int]
"""A file, relative to the checkout, and a line."""


def calls(checkout: Path) -> Iterator[Site]:
    """The create calls that a text search finds."""
    for path in sorted(checkout.rglob("*")):
        folders = [folder for folder in path.parents if folder.is_relative_to(checkout)]
        inside = path.relative_to(checkout)
        left_out = is_test(inside) or any(part.startswith(".") for part in inside.parts)
        if path.suffix not in _SUFFIXES or left_out or any((f / mark).exists() for f in folders for mark in _NOT_BUILT):
            continue
        text = path.read_text(encoding="utf-8", errors="replace")
        code = _COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
        if "ros/ros.h" in code and "rclcpp" not in code:
            continue
        for match in _CALL.finditer(code):
            yield path.relative_to(checkout).as_posix(), code.count("\n", 0, match.start()) + 1


def archlint_graph(checkout: Path) -> dict[str, Any]:
    """The graph as ``archlint graph`` writes it."""
    command = [sys.executable, "-m", "archlint", "graph", ".", "--format", "json", "--no-cache"]
    done = subprocess.run(command, cwd=checkout, capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.stdout.strip() else {"nodes": []}


def peer_graph(command: str, checkout: Path) -> dict[str, Any]:
    """What the peer says of a copy of the checkout, in the form of archlint's graph."""
    with tempfile.TemporaryDirectory() as copy:
        target = Path(copy, checkout.name)
        shutil.copytree(checkout, target, symlinks=True, ignore=shutil.ignore_patterns(".git"))
        return peer.read(command, target, Path(copy), "cpp")


def by_line(graph: Mapping[str, Any]) -> dict[Site, list[dict[str, Any]]]:
    """The endpoints of a graph by where they are created."""
    rows: dict[Site, list[dict[str, Any]]] = {}
    for node in graph["nodes"]:
        for kind in _KINDS:
            for end in node[kind]:
                for line in range(end["line"], end.get("end_line", end["line"]) + 1):
                    rows.setdefault((end["file"], line), []).append(end)
    return rows


def score(sites: Sequence[Site], ends: Mapping[Site, Sequence[Mapping[str, Any]]]) -> Counter[str]:
    """How many calls are found, and of how many the name, the type and the QoS are known.

    A name that lacks nothing but that of its node (``~/state`` of a plug-in) is counted apart.
    """
    count: Counter[str] = Counter(calls=len(sites))
    for site in sites:
        here = ends.get(site, ())
        count["found"] += bool(here)
        whole = any(end["resolution"] in ("exact", "parameter") for end in here)
        count["name"] += whole
        count["name but its node"] += not whole and any(_is_written(end) for end in here)
        count["type"] += any(end["type"] for end in here)
        count["qos"] += any((end.get("qos") or {}).get("reliability") for end in here)
    return count


def _is_written(end: Mapping[str, Any]) -> bool:
    written = end.get("written") or ""
    return bool(written) and "*" not in written


def row(title: str, count: Counter[str]) -> str:
    """One row of the table."""
    found, every = count["found"], count["calls"]
    name = f"{_share(count['name'], found)} + {_share(count['name but its node'], found)}"
    return (
        f"| {title} | {every} | {_share(found, every)} | {name} | {_share(count['type'], found)} "
        f"| {_share(count['qos'], found)} |"
    )


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} %" if whole else "-"


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkouts", nargs="+", type=Path)
    parser.add_argument("--peer", metavar="PATH")
    parser.add_argument("--missed", action="store_true")
    parser.add_argument("--sample", type=int, default=0, metavar="N")
    options = parser.parse_args()
    total: Counter[str] = Counter()
    of_peer: Counter[str] = Counter()
    samples: list[str] = []
    missed: list[str] = []
    print("| checkout | calls | found | name + but for its node's | type | QoS |\n|---|---|---|---|---|---|")
    for checkout in options.checkouts:
        sites = list(calls(checkout))
        ends = by_line(archlint_graph(checkout))
        count = score(sites, ends)
        total += count
        print(row(checkout.name, count), flush=True)
        for site in sites:
            here = ends.get(site, [])
            place = f"{checkout.name}/{site[0]}:{site[1]}"
            if not here:
                missed.append(place)
            samples += [f"{place}  {end['name'] or end.get('written')}  {end['type']}  {end['qos']}" for end in here]
        if options.peer:
            theirs = score(sites, by_line(peer_graph(options.peer, checkout)))
            of_peer += theirs
            print(row(f"{checkout.name}, the peer", theirs), flush=True)
    print(row("all", total))
    if options.peer:
        print(row("all, the peer", of_peer))
    for place in missed if options.missed else ():
        print(f"missed: {place}")
    for sample in sorted(samples, key=lambda text: hashlib.sha256(text.encode()).digest())[: options.sample]:
        print(sample)


if __name__ == "__main__":
    main()
