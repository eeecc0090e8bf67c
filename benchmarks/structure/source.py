"""What can be counted in the source of archlint, file by file."""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_COMPLEXITY = re.compile(r"\((\d+) > 0\)")
_CLOCKS = frozenset({"monotonic", "monotonic_ns", "perf_counter", "perf_counter_ns", "process_time", "process_time_ns"})

Function = ast.FunctionDef | ast.AsyncFunctionDef


@dataclass(frozen=True)
class File:
    """A file of a package: its folder directly below the package ("" for the package's own), and counts."""

    path: Path
    folder: str
    lines: int
    instance_checks: int
    """Calls of ``isinstance``."""
    late_imports: tuple[int, ...]
    """Lines inside functions that import something of the package itself."""
    functions: tuple[tuple[str, int, int], ...]
    """Name, first line and number of lines of each function and method."""


def files_of(package: Path) -> list[File]:
    """Every Python file of a package, by path."""
    return [_read(path, package) for path in sorted(package.rglob("*.py"))]


def _read(path: Path, package: Path) -> File:
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    functions = [node for node in ast.walk(tree) if isinstance(node, Function)]
    late = {node.lineno for function in functions for node in ast.walk(function) if _is_own_import(node, package.name)}
    relative = path.relative_to(package)
    return File(
        path,
        relative.parts[0] if len(relative.parts) > 1 else "",
        len(text.splitlines()),
        sum(_name(node.func) == "isinstance" for node in ast.walk(tree) if isinstance(node, ast.Call)),
        tuple(sorted(late)),
        tuple((node.name, node.lineno, (node.end_lineno or node.lineno) - node.lineno + 1) for node in functions),
    )


def _is_own_import(node: ast.AST, package: str) -> bool:
    match node:
        case ast.ImportFrom(module=module, level=level):
            return level > 0 or (module or "").partition(".")[0] == package
        case ast.Import(names=names):
            return any(alias.name.partition(".")[0] == package for alias in names)
    return False


def _name(expression: ast.expr) -> str:
    """The last word of a name or an attribute."""
    match expression:
        case ast.Name(id=name) | ast.Attribute(attr=name):
            return name
    return ""


def complexities(package: Path) -> list[int]:
    """The cyclomatic complexity of each function, as ruff counts it (C901); smallest first."""
    words = ["check", "--isolated", "--no-cache", "--exit-zero", "--select", "C901", "--output-format", "json"]
    ruff = Path(sys.executable).with_name("ruff")
    done = subprocess.run(
        [ruff, *words, "--config", "lint.mccabe.max-complexity = 0", package],
        capture_output=True,
        text=True,
        check=True,
    )
    counts = [_COMPLEXITY.search(finding["message"]) for finding in json.loads(done.stdout)]
    return sorted(int(count[1]) for count in counts if count is not None)


# -------------------------------------------------------------------------------------------------- tests


def timed_asserts(tests: Path) -> list[str]:
    """The ``assert`` statements of tests that a clock decides, as ``file:line``."""
    return [
        f"{path.relative_to(tests).as_posix()}:{line}"
        for path in sorted(tests.rglob("*.py"))
        for line in sorted(_timed(path.read_text(encoding="utf-8")))
    ]


def _timed(text: str) -> Iterator[int]:
    """The lines of these in a file."""
    tree = ast.parse(text) if any(name in text for name in _CLOCKS) else ast.Module([], [])
    for function in (node for node in ast.walk(tree) if isinstance(node, Function)):
        names: set[str] = set()
        for _ in range(3):  # start = clock(); taken = clock() - start; slow = taken > 5
            names |= {
                target.id
                for node in ast.walk(function)
                if isinstance(node, ast.Assign) and _asks_clock(node.value, names)
                for target in node.targets
                if isinstance(target, ast.Name)
            }
        asserts = (node for node in ast.walk(function) if isinstance(node, ast.Assert))
        yield from {node.lineno for node in asserts if _asks_clock(node.test, names)}


def _asks_clock(expression: ast.expr, names: set[str]) -> bool:
    return any(
        (isinstance(node, ast.Call) and _name(node.func) in _CLOCKS)
        or (isinstance(node, ast.Name) and node.id in names)
        for node in ast.walk(expression)
    )
