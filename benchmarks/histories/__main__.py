"""Which faults archlint tells of that teams fixed: ``python -m benchmarks.histories CLONES``.

CLONES is a folder with the clones of the repositories in ``bugs.tsv``, with their history; nothing is fetched.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.histories.parents import clone_of, export_parent
from benchmarks.histories.table import PATH, Bug, Verdict, read

Finding = dict[str, Any]
NEAR = 12
"""Lines around a fault whose findings --misses shows to the reader."""


def main() -> None:
    """Print how many faults of each group are told, and with --misses the others with what is said near them."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.histories", description=main.__doc__)
    parser.add_argument("clones", type=Path)
    parser.add_argument("--table", type=Path, default=PATH, help="another table of faults (default: bugs.tsv)")
    parser.add_argument("--only", default="", help="faults whose repository, group or file contains this")
    parser.add_argument("--misses", action="store_true")
    options = parser.parse_args()
    bugs = [bug for bug in read(options.table) if options.only in f"{bug.repository} {bug.group} {bug.file}"]
    default = _default_rules()
    counts: dict[str, Counter[Verdict]] = defaultdict(Counter)
    for bug, findings in _checked(bugs, options.clones.resolve()):
        verdict = judged(bug, findings, default)
        counts[bug.group][verdict] += 1
        if verdict is not bug.verdict:
            print(f"{bug.place}: {bug.verdict.value} in the table, {verdict.value} now", flush=True)
        if options.misses and verdict in (Verdict.SILENT, Verdict.PART):
            _show(bug, findings)
    _print_table(counts)


def judged(bug: Bug, findings: list[Finding], default: set[str]) -> Verdict:
    """What is said of a fault now: one of its rules must name its file.

    A rule that is not in the fault's row cannot be judged without reading: such a fault stays as the table has it.
    """
    telling = {finding["code"] for finding in findings if finding["code"] in bug.rules and bug.file in files(finding)}
    if bug.verdict is Verdict.PART:
        return Verdict.PART if telling else Verdict.SILENT
    if telling & default:
        return Verdict.DEFAULT
    return Verdict.OPT_IN if telling else Verdict.SILENT


def files(finding: Finding) -> set[str]:
    """The files that a finding names, those in the fix that it offers among them."""
    edits = (finding["fix"] or {}).get("edits", [])
    return {place["file"] for place in (finding, *finding["related"], *edits)}


def _checked(bugs: list[Bug], clones: Path) -> Iterator[tuple[Bug, list[Finding]]]:
    """Each fault with the findings before its fix; a commit that several faults share is checked once."""
    commits: dict[tuple[str, str], list[Bug]] = defaultdict(list)
    for bug in bugs:
        commits[bug.repository, bug.fix].append(bug)
    for (repository, fix), group in commits.items():
        clone = clone_of(repository, clones)
        with tempfile.TemporaryDirectory() as folder:
            parent = Path(folder) / repository.partition("/")[2]
            if clone is None or not export_parent(clone, fix, parent):
                print(f"{repository} {fix[:10]}: not in {clones}", file=sys.stderr)
                continue
            findings = archlint(parent)
        for bug in group:
            yield bug, findings


def archlint(folder: Path) -> list[Finding]:
    """All findings of a workspace, of every rule."""
    command = ["check", ".", "--select", "ALL", "--format", "json", "--no-cache", "--isolated", "--exit-zero"]
    findings: list[Finding] = json.loads(_run(command, folder))["diagnostics"]
    return findings


def _default_rules() -> set[str]:
    rules = json.loads(_run(["rules", "--format", "json"], Path.cwd()))["rules"]
    return {rule["code"] for rule in rules if rule["default"] == "on"}


def _run(arguments: list[str], folder: Path) -> str:
    command = [sys.executable, "-m", "archlint", *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if not done.stdout:  # a rule that fails leaves the findings of the others, and exit code 2
        raise RuntimeError(f"{' '.join(command)} in {folder}: {done.stderr}")
    return done.stdout


def _show(bug: Bug, findings: list[Finding]) -> None:
    print(f"{bug.place} [{bug.group}] {bug.description}")
    for finding in findings:
        if finding["file"] == bug.file and abs(finding["line"] - bug.line) <= NEAR:
            print(f"    {finding['line']}: {finding['code']} {finding['message']}")


def _print_table(counts: dict[str, Counter[Verdict]]) -> None:
    print("| group | faults | told by default | with all rules | in part |")
    print("|---|---|---|---|---|")
    for group, count in [*sorted(counts.items()), ("all", sum(counts.values(), Counter()))]:
        told = count[Verdict.DEFAULT]
        print(f"| {group} | {count.total()} | {told} | {told + count[Verdict.OPT_IN]} | {count[Verdict.PART]} |")


if __name__ == "__main__":
    main()
