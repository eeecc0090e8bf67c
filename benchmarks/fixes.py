"""Every fix applied to copies of checkouts, and whether they hold: ``python -m benchmarks.fixes CHECKOUT…``.

A checkout is copied, all fixes are applied, the unsafe ones too, and then asked: does every changed Python file
compile, is there nothing left to fix, are the findings gone that were fixed, and has the graph the same nodes with the
same names as before?  The originals are only read.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

KINDS = ("publishers", "subscribers", "services", "clients", "action_servers", "action_clients")

COLUMNS = (
    "checkout",
    "fixes offered",
    "files changed",
    "do not compile",
    "findings left",
    "fixes in a second run",
    "names moved",
)


@dataclass
class Row:
    """What became of one checkout."""

    name: str
    offered: Counter[str] = field(default_factory=Counter)
    left: Counter[str] = field(default_factory=Counter)
    changed: int = 0
    broken: list[str] = field(default_factory=list)
    again: int = 0
    moved: list[str] = field(default_factory=list)

    def line(self) -> str:
        fixes = ", ".join(f"{code} {count}" for code, count in sorted(self.offered.items())) or "none"
        return (
            f"| {self.name} | {fixes} | {self.changed} | {len(self.broken)} | {sum(self.left.values())} "
            f"| {self.again} | {len(self.moved)} |"
        )


def archlint(folder: Path, *arguments: str) -> str:
    command = [sys.executable, "-m", "archlint", *arguments, "--no-cache", "--isolated"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)} in {folder}: {done.stderr}")
    return done.stdout


def findings(folder: Path) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = json.loads(archlint(folder, "check", "--format", "json"))["diagnostics"]
    return found


def names(folder: Path) -> Counter[str]:
    """Each endpoint as node, kind, name and type."""
    document = json.loads(archlint(folder, "graph", "--format", "json"))
    return Counter(
        f"{node['name']} {kind} {end['name']} {end['type']}"
        for node in document["nodes"]
        for kind in KINDS
        for end in node[kind]
    )


def texts(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file() and not path.is_symlink()}


def examine(checkout: Path, folder: Path) -> Row:
    shutil.copytree(checkout, folder, symlinks=True, ignore=shutil.ignore_patterns(".git", "__pycache__"))
    row = Row(checkout.name.replace("+", "/"))
    before, found, files = names(folder), findings(folder), texts(folder)
    row.offered.update(one["code"] for one in found if one.get("fix"))
    archlint(folder, "check", "--fix", "--unsafe-fixes", "--quiet")
    for path, text in texts(folder).items():
        if text != files.get(path):
            row.changed += 1
            if path.suffix in (".py", "") and not compiles(text):
                row.broken.append(str(path.relative_to(folder)))
    row.again = archlint(folder, "check", "--diff", "--unsafe-fixes").count("\n@@ ")
    after = Counter(one["code"] for one in findings(folder))
    counted = Counter(one["code"] for one in found)
    row.left = Counter({code: after[code] - (counted[code] - row.offered[code]) for code in row.offered})
    row.left = +row.left
    row.moved = sorted((before - names(folder)) + (names(folder) - before))
    return row


def compiles(text: bytes) -> bool:
    try:
        compile(text, "changed", "exec", dont_inherit=True)
    except (SyntaxError, ValueError):
        return False
    return True


def main() -> None:
    print(f"| {' | '.join(COLUMNS)} |\n{'|---' * len(COLUMNS)}|")
    total = Row("all")
    for checkout in sorted(Path(one) for one in sys.argv[1:] if not one.startswith("-")):
        with tempfile.TemporaryDirectory() as folder:
            row = examine(checkout, Path(folder) / "copy")
        print(row.line(), flush=True)
        if "--misses" in sys.argv:
            for one in (*row.broken, *row.left, *row.moved):
                print(f"  {one}")
        total.offered += row.offered
        total.left += row.left
        total.changed, total.again = total.changed + row.changed, total.again + row.again
        total.broken, total.moved = total.broken + row.broken, total.moved + row.moved
    print(total.line())


if __name__ == "__main__":
    main()
