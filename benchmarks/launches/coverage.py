"""How far launch files load, and whether every node action in them is accounted for: ``python -m
benchmarks.launches.coverage CHECKOUT… [--misses | --nodes]``.

All launch files of a checkout (test code and ROS 1 left out) are loaded with their default arguments.  A file is
loaded *fully* where everything on its way was followed, *partly* where something was not (an include of a package
that is not in the checkout, a list that only data decides …; the graph says so under ``unresolved``), and *not at
all* where nothing of it could be read.

The text search takes, in each launch file, what looks like a node action: ``Node(``, ``LifecycleNode(``,
``ComposableNode(``, ``ComposableNodeContainer(`` and ``ExecuteProcess(`` of ``ros2 run`` in Python, ``<node``,
``<lifecycle_node``, ``<composable_node`` and ``<node_container`` in XML, ``node:`` and its relatives in YAML, comments
left out.  An action is accounted for where a launch starts a node at its place: as one whose code is in the checkout
(*here*), one whose code is elsewhere and that archlint knows all the same, whole or in part (*known*), another whose
code is elsewhere (*external*), or one under a condition that the defaults do not meet (*not
taken*).  *Not reached* are those in code that the launch files do not run with their defaults, *unresolved* those in
a file with something that was not followed, *put nowhere* those that a run came past and that no description holds.

``--nodes`` counts the nodes that launch files start, each once for its place, program and name, and lists the programs
of which nothing is known, those of most checkouts first.  An *open* node is known and may have more than that.
"""

from __future__ import annotations

import io
import os
import re
import sys
import tokenize
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from archlint.config.settings import Settings
from archlint.engine.compiling import compiled
from archlint.engine.inputs import Inputs, find_files, tree_of
from archlint.engine.loading import systems_of as systems_of_workspace
from archlint.engine.pipeline import store_of
from archlint.engine.request import Request
from archlint.finding import Place
from archlint.launch.files import LaunchFiles
from archlint.launch.model import Launched
from archlint.systems.model import System
from archlint.systems.nodes import Node

KINDS = ("here", "known", "external", "not taken", "unresolved", "not reached", "put nowhere")
PYTHON = re.compile(r"(?<![\w])(?:Lifecycle)?(?:Node|ComposableNode|ComposableNodeContainer)\s*\(")
NO_ACTION = re.compile(r"^\s*(?:class|def|from|import)\b")
XML = re.compile(r"<(?:node|lifecycle_node|composable_node|node_container)\b")
XML_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
YAML = re.compile(r"^\s*-?\s*(?:node|lifecycle_node|composable_node|node_container)\s*:", re.MULTILINE)


def systems_of(root: Path) -> list[System]:
    os.chdir(root)
    request = Request((".",), Settings(), cached=False, jobs=1)
    workspace, store = find_files(request), store_of(request)
    inputs = Inputs(request, workspace, tree_of(request, workspace), store)
    return systems_of_workspace(inputs, compiled(request, workspace, store))


def actions_in(path: str) -> list[int]:
    """The lines of a launch file with something that looks like a node action."""
    text = Path(path).read_text("utf-8", "replace")
    if path.endswith((".yaml", ".yml")):
        text = re.sub(r"(?m)^\s*#.*$", "", text)
        return _lines(YAML, text)
    if text.lstrip().startswith("<"):
        return _lines(XML, XML_COMMENT.sub(lambda comment: re.sub(r"[^\n]", " ", comment[0]), text))
    return [
        number
        for number, line in enumerate(_code(text).splitlines(), start=1)
        if PYTHON.search(line) and not NO_ACTION.match(line)
        for _ in PYTHON.findall(line)
    ]


def _lines(pattern: re.Pattern[str], text: str) -> list[int]:
    return [text.count("\n", 0, match.end()) + 1 for match in pattern.finditer(text)]


def _code(text: str) -> str:
    """Python without its comments and texts."""
    lines = text.splitlines(keepends=True)
    try:
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type in (tokenize.COMMENT, tokenize.STRING):
                for row in range(token.start[0] - 1, token.end[0]):
                    start = token.start[1] if row == token.start[0] - 1 else 0
                    end = token.end[1] if row == token.end[0] - 1 else len(lines[row])
                    kept = lines[row]
                    lines[row] = kept[:start] + re.sub(r"[^\n]", " ", kept[start:end]) + kept[end:]
    except (tokenize.TokenError, SyntaxError, IndentationError):
        pass
    return "".join(lines)


def accounted(systems: list[System]) -> dict[tuple[str, int], str]:
    """What became of the node action at each place, the best of all launches that meet it."""
    found: dict[tuple[str, int], str] = {}

    def note(place: Place | None, kind: str) -> None:
        for line in range(place.line, place.end_line + 1) if place is not None else ():
            assert place is not None
            known = found.get((place.file, line), KINDS[-1])
            found[place.file, line] = min(kind, known, key=KINDS.index)

    for system in systems:
        for node in system.nodes:
            note(node.launch_place, _kind(node))
        for started in system.launched.started if system.launched is not None else ():
            note(started.place, "not taken" if started.dormant else "external")
    return found


def _kind(node: Node) -> str:
    """Whether the code of a node is here, or what it has is known all the same, from the table of well-known nodes."""
    if not node.external or node.unfollowed is not None:
        return "here"
    known = node.known is not None and (node.known.complete or bool(node.endpoints))
    return "known" if known else "external"


def level(launched: Launched) -> tuple[str, list[str]]:
    """How far a launch file was loaded, with the reasons where that is not fully."""
    reasons = [gap.reason for gap in launched.not_followed()]
    if not reasons:
        return "fully", []
    whole = launched.started or launched.included or launched.declared
    return "partly" if whole else "not at all", reasons


def measure(root: Path) -> tuple[Counter[str], Counter[str], list[str]]:
    systems = [system for system in systems_of(root) if system.launched is not None]
    files: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    told: list[str] = []
    unfollowed: set[str] = set()
    index = systems[0].workspace if systems else None
    if index is None:
        return files, kinds, told
    launch_files = index.launch_files
    for system in systems:
        assert system.launched is not None
        how, reasons = level(system.launched)
        files[how] += 1
        unfollowed.update(gap.place.file for gap in system.launched.not_followed())
        if how != "fully":
            told.append(f"{how}: {system.launched.file}: {'; '.join(sorted(set(reasons)))[:200]}")
    files["ROS 1"] = sum(launch_files.frontend(path).ros1 for path in frontends(launch_files))
    places = accounted(systems)
    made = {
        (place.file, line)
        for system in systems
        for place in (system.launched.node_actions if system.launched is not None else ())
        for line in range(place.line, place.end_line + 1)
    }
    for path in launch_files.all():
        if path.endswith((".launch", ".xml")) and launch_files.frontend(path).ros1:
            continue
        for line in actions_in(path):
            kind = places.get((path, line))
            if kind is None:
                came_past = (path, line) in made or not path.endswith(".py")
                kind = "unresolved" if path in unfollowed else "put nowhere" if came_past else "not reached"
            kinds[kind] += 1
            if kind in KINDS[4:]:
                told.append(f"{kind}: {path}:{line}")
    return files, kinds, told


@dataclass
class StartedNodes:
    """What launch files start."""

    kinds: Counter[str] = field(default_factory=Counter)
    unknown: Counter[str] = field(default_factory=Counter)
    """The programs of which nothing is known, with the number of checkouts."""

    def add(self, systems: list[System]) -> Counter[str]:
        """Count the nodes of one checkout."""
        nodes = {
            (node.launch_place, node.package, node.executable, node.name): node
            for system in systems
            if system.launched is not None
            for node in system.nodes
            if node.started is not None
        }
        kinds = Counter(_kind(node) for node in nodes.values())
        kinds["open"] = sum(_kind(node) == "known" and node.is_stranger for node in nodes.values())
        self.kinds += kinds
        self.unknown.update(
            {f"{node.package}/{node.executable}" for node in nodes.values() if _kind(node) == "external"}
        )
        return kinds


def list_nodes(roots: list[Path]) -> None:
    started = StartedNodes()
    print("| checkout | nodes | here | known | open | unknown |\n|---|---|---|---|---|---|")
    for root in roots:
        print(_row_of_nodes(root.name.replace("+", "/"), started.add(systems_of(root))), flush=True)
    print(_row_of_nodes("all", started.kinds))
    print(*(f"{count} {program}" for program, count in started.unknown.most_common()), sep="\n")


def _row_of_nodes(name: str, kinds: Counter[str]) -> str:
    nodes = sum(kinds[kind] for kind in KINDS[:3])
    return f"| {name} | {nodes} | " + " | ".join(str(kinds[k]) for k in ("here", "known", "open", "external")) + " |"


def frontends(launch_files: LaunchFiles) -> list[str]:
    return [path for path in launch_files.all() if path.endswith((".launch", ".xml"))]


def main() -> None:
    roots = [Path(argument).resolve() for argument in sys.argv[1:] if not argument.startswith("-")]
    if "--nodes" in sys.argv:
        list_nodes(roots)
        return
    print("| checkout | fully | partly | not at all | ROS 1 | node actions | " + " | ".join(KINDS) + " |")
    print("|---|" + "---|" * (5 + len(KINDS)))
    all_files: Counter[str] = Counter()
    all_kinds: Counter[str] = Counter()
    for root in roots:
        files, kinds, told = measure(root)
        all_files += files
        all_kinds += kinds
        print(_row(root.name.replace("+", "/"), files, kinds), flush=True)
        if "--misses" in sys.argv:
            print("".join(f"    {line}\n" for line in told), end="", flush=True)
    print(_row("all", all_files, all_kinds))


def _row(name: str, files: Counter[str], kinds: Counter[str]) -> str:
    cells = [files[how] for how in ("fully", "partly", "not at all", "ROS 1")]
    cells += [kinds.total(), *(kinds[kind] for kind in KINDS)]
    return f"| {name} | " + " | ".join(map(str, cells)) + " |"


if __name__ == "__main__":
    main()
