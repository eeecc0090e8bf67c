"""Score what archlint reads against what the oracle saw: `python -m benchmarks.accuracy.compare ORACLE
CHECKOUTS`.

An entity is a distinct (file, line, kind, name, type, QoS) in the oracle's record, outside test code.
It is

- found, when the tool has an endpoint of that kind at that file and line, resolved or not;
- right in name, when one of the tool's resolved names there is the name that the run gave (counted
  where the run knows the name: not where it depends on what only a robot, a network or a command line
  decides);
- right in type and in QoS, likewise, at the endpoint of that name where there is one;
- right in owner, when the tool lists it under the node whose create call ran, and a phantom is an entry that counts as
  a node and is none: see `owners.py`;
- wrong in name, when the tool gives resolved names there, and none is one that any run gave at that
  place. An answer of `partial` or `unknown` is a miss, not wrong.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import owners, peer
from .oracle.workspace import is_test

LISTS = {
    "publisher": "publishers",
    "subscriber": "subscribers",
    "service": "services",
    "client": "clients",
    "action_server": "action_servers",
    "action_client": "action_clients",
    "timer": "timers",
}
_WITH_QOS = ("publisher", "subscriber", "service", "client")

Entity = dict[str, Any]
Site = tuple[str, int, str]


@dataclass
class Score:
    """Counts for one kind: how many were asked, how many were right."""

    entities: int = 0
    found: int = 0
    named: int = 0
    right_name: int = 0
    typed: int = 0
    right_type: int = 0
    profiled: int = 0
    right_qos: int = 0
    sites: int = 0
    wrong_sites: int = 0
    owned: int = 0
    right_owner: int = 0
    nodes: int = 0
    phantoms: int = 0

    def __add__(self, other: Score) -> Score:
        return Score(**{name: getattr(self, name) + getattr(other, name) for name in vars(self)})


@dataclass
class Comparison:
    """The scores of one repository by kind, and what was missed."""

    scores: dict[str, Score] = field(default_factory=lambda: defaultdict(Score))
    misses: list[str] = field(default_factory=list)
    wrong: list[str] = field(default_factory=list)
    unseen: list[str] = field(default_factory=list)
    astray: list[str] = field(default_factory=list)
    phantoms: list[str] = field(default_factory=list)
    nodes: int = 0

    @property
    def total(self) -> Score:
        """All kinds together."""
        return sum(self.scores.values(), Score(nodes=self.nodes, phantoms=len(self.phantoms)))


def compare(
    oracle: dict[str, Any],
    graph: dict[str, Any],
    *,
    kinds: Iterable[str] = tuple(LISTS),
    qos_kinds: Iterable[str] = _WITH_QOS,
) -> Comparison:
    """Score one graph against one oracle record."""
    result = Comparison()
    seen = _by_site(oracle_entities(oracle, kinds))
    ours = _by_site(_graph_endpoints(graph, kinds))
    for site in sorted(seen):
        _score_site(result, site, seen[site], ours.get(site, []), tuple(qos_kinds))
    executed = {(site[0], site[1]) for site in seen}
    files = {site[0] for site in seen}
    for site in sorted(set(ours) - set(seen)):
        if site[0] in files and not is_test(site[0]):
            known = ", ".join(sorted({str(each.get("name")) for each in ours[site]}))
            other = " (seen there as another kind)" if site[:2] in executed else ""
            result.unseen.append(f"{site[0]}:{site[1]} {site[2]} {known}{other}")
    return result


def compare_owners(oracle: dict[str, Any], graph: dict[str, Any], checkout: Path, result: Comparison) -> None:
    """Add to a comparison whose the endpoints are, and what is no node."""
    for site, entity, right in owners.owned(oracle, graph, LISTS):
        score = result.scores[site[2]]
        score.owned += 1
        score.right_owner += right
        if not right:
            given = ", ".join(owners.owners(graph, site, LISTS)) or "nothing"
            result.astray.append(f"{_place(site)}: {entity['class']} {entity['node']} is {given}")
    counted = [entry for entry in graph["nodes"] if entry.get("is_node", True) and not entry.get("test")]
    result.nodes = len(counted)
    result.phantoms = owners.phantoms(oracle, graph, checkout)


def oracle_entities(oracle: dict[str, Any], kinds: Iterable[str]) -> list[Entity]:
    """The distinct entities of a record, outside test code."""
    distinct: dict[str, Entity] = {}
    for entity in oracle["entities"]:
        if entity["kind"] in kinds and not is_test(entity["file"]):
            key = json.dumps([entity[name] for name in ("file", "line", "kind", "name", "type", "qos")])
            distinct.setdefault(key, entity)
    return list(distinct.values())


def _graph_endpoints(graph: dict[str, Any], kinds: Iterable[str]) -> list[Entity]:
    found: list[Entity] = []
    for node in graph["nodes"]:
        for kind in kinds:
            found.extend({**endpoint, "kind": kind} for endpoint in node.get(LISTS[kind], []))
    for each in graph.get("unresolved", []):
        if each.get("kind") in kinds:
            found.append({"name": None, "type": None, "qos": None, "resolution": "unknown", **each})
    return found


def _by_site(entities: Iterable[Entity]) -> dict[Site, list[Entity]]:
    sites: dict[Site, list[Entity]] = defaultdict(list)
    for entity in entities:
        sites[(entity["file"], entity["line"], entity["kind"])].append(entity)
    return dict(sites)


def _score_site(
    result: Comparison, site: Site, seen: list[Entity], ours: list[Entity], qos_kinds: tuple[str, ...]
) -> None:
    score = result.scores[site[2]]
    score.sites += 1
    resolved = {
        each["name"]: each for each in ours if each.get("name") and each.get("resolution") in ("exact", "parameter")
    }
    plain = [each for each in seen if each["phase"] != "forced" and not each.get("other_way")]
    true_names = {each["name"] for each in plain if each["name"]}
    if resolved and true_names and not true_names & set(resolved):
        score.wrong_sites += 1
        result.wrong.append(f"{_place(site)}: the run gives {_words(true_names)}, read as {_words(resolved)}")
    for entity in seen:
        problems = list(_score_entity(score, entity, ours, resolved, qos_kinds))
        if problems:
            result.misses.append(
                f"{_place(site)} {entity['name'] or entity.get('pattern') or ''}: {'; '.join(problems)}"
            )


def _score_entity(
    score: Score, entity: Entity, ours: list[Entity], resolved: dict[str, Entity], qos_kinds: tuple[str, ...]
) -> Iterable[str]:
    score.entities += 1
    score.found += bool(ours)
    if not ours:
        yield "not found"
    name = entity["name"] if entity["phase"] != "forced" else None
    same = [each for each in ours if each.get("name") == entity["name"]] or ours
    if name:
        score.named += 1
        score.right_name += name in resolved
        if ours and name not in resolved:
            answers = sorted({f"{each.get('name')} ({each.get('resolution')})" for each in ours})
            yield f"name is {', '.join(answers)[:200]}"
    if entity["type"]:
        score.typed += 1
        types = {each.get("type") for each in same}
        score.right_type += entity["type"] in types
        if ours and entity["type"] not in types:
            yield f"type {entity['type']} is {_words(types)}"
    if entity["kind"] in qos_kinds and entity["qos"] and None not in entity["qos"].values():
        score.profiled += 1
        right = any(same_qos(entity["qos"], each.get("qos")) for each in same)
        score.right_qos += right
        if ours and not right:
            yield f"QoS {entity['qos']} is {[each.get('qos') for each in same][:2]}"


def same_qos(seen: dict[str, Any], ours: dict[str, Any] | None) -> bool:
    """Whether two profiles agree; the depth says nothing under keep_all and system_default."""
    if not ours:
        return False
    names = ["history", "reliability", "durability"] + (["depth"] if seen["history"] == "keep_last" else [])
    return all(seen[name] == ours.get(name) for name in names)


def _place(site: Site) -> str:
    return f"{site[0]}:{site[1]} {site[2]}"


def _words(values: Iterable[Any]) -> str:
    return ", ".join(sorted(str(value) for value in values))[:200]


# Tables -----------------------------------------------------------------------------------------
def table(rows: dict[str, Score]) -> str:
    """The scores as a Markdown table."""
    lines = [
        "| | entities | found | right name | right type | right QoS | wrong names (of sites) "
        "| right owner | phantom nodes |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for title, score in rows.items():
        cells = [
            _share(score.found, score.entities),
            _share(score.right_name, score.named),
            _share(score.right_type, score.typed),
            _share(score.right_qos, score.profiled),
            _share(score.wrong_sites, score.sites),
            _share(score.right_owner, score.owned),
            f"{score.phantoms} of {score.nodes}" if score.nodes else "-",
        ]
        lines.append(f"| {title} | {score.entities} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.1f} % ({part}/{whole})" if whole else "-"


def main() -> None:
    """Compare each repository that has an oracle record, then all of them together."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("oracle", type=Path, help="the folder that benchmarks.accuracy.run wrote")
    parser.add_argument("checkouts", type=Path, help="the folder of repositories that it ran")
    parser.add_argument("names", nargs="*", help="only these repositories (default: all)")
    parser.add_argument("--peer", metavar="COMMAND", help="score this ros2inspector instead")
    parser.add_argument("--graphs", type=Path, help="read <repository>.json here instead of running archlint")
    parser.add_argument("--misses", action="store_true", help="list what was missed, and what no run came to")
    parser.add_argument("--without-forced", action="store_true", help="leave out what only a direct call reached")
    options = parser.parse_args()
    everything: dict[str, Comparison] = {}
    for record in sorted(options.oracle.glob("*.json")):
        checkout = options.checkouts / record.stem
        if (options.names and record.stem not in options.names) or not checkout.is_dir():
            continue
        oracle = json.loads(record.read_text(encoding="utf-8"))
        if options.without_forced:
            oracle["entities"] = [each for each in oracle["entities"] if each["phase"] != "forced"]
        started = time.monotonic()
        graph, asked = _answer(options, checkout)
        elapsed = time.monotonic() - started
        everything[record.stem] = comparison = compare(oracle, graph, **asked)
        if not options.peer:
            compare_owners(oracle, graph, checkout, comparison)
        print(f"\n## {record.stem} ({elapsed:.1f} s)\n\n{table({**comparison.scores, 'all': comparison.total})}")
        for title, lines in (
            ("wrong", comparison.wrong),
            ("no nodes", comparison.phantoms),
            ("under another node", comparison.astray),
            *((("missed", comparison.misses), ("not seen by a run", comparison.unseen)) if options.misses else ()),
        ):
            if lines:
                print(f"\n{title}:\n" + "\n".join(f"  {line}" for line in lines))
    _print_all(everything)


def _answer(options: argparse.Namespace, checkout: Path) -> tuple[dict[str, Any], dict[str, Any]]:
    if options.graphs:
        return json.loads((options.graphs / f"{checkout.name}.json").read_text(encoding="utf-8")), {}
    if not options.peer:
        return _archlint(checkout), {}
    asked = {"kinds": [kind for kind in LISTS if kind != "timer"], "qos_kinds": ("publisher", "subscriber")}
    with tempfile.TemporaryDirectory() as copy:
        target = Path(copy, checkout.name)
        shutil.copytree(checkout, target, symlinks=True, ignore=shutil.ignore_patterns(".git"))
        return peer.read(options.peer, target, Path(copy)), asked


def _archlint(checkout: Path) -> dict[str, Any]:
    command = [sys.executable, "-m", "archlint", "graph", ".", "--format", "json"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).resolve().parents[2] / "src")}
    done = subprocess.run(command, cwd=checkout, env=environment, capture_output=True, text=True, check=False)
    if not done.stdout.strip():
        raise RuntimeError(f"archlint gave nothing for {checkout}: {done.stderr.strip()[-600:]}")
    graph: dict[str, Any] = json.loads(done.stdout)
    return graph


def _print_all(everything: dict[str, Comparison]) -> None:
    kinds: dict[str, Score] = defaultdict(Score)
    for comparison in everything.values():
        for kind, score in comparison.scores.items():
            kinds[kind] += score
    rows = {name: comparison.total for name, comparison in everything.items()}
    total = sum(rows.values(), Score())
    print(f"\n# By repository\n\n{table({**rows, 'all': total})}")
    print(f"\n# By kind\n\n{table({**kinds, 'all': total})}")


if __name__ == "__main__":
    main()
