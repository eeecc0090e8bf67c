"""What the whole program promises: imports run downwards, variables are named for what they hold, and the same input
gives the same bytes."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
FIXTURES = ROOT / "fixtures"
CHECK = ("check", "--format", "json")
REPORTS = ("text", "concise", "sarif", "github", "gitlab", "junit")
FORMATS = tuple(f"--output={name}={{folder}}/{name}" for name in REPORTS)
GRAPHS = [("graph", "--format", name) for name in ("json", "text", "dot", "mermaid")]
OUTPUTS = {"broken_system": [(*CHECK, *FORMATS), *GRAPHS], "forms": [CHECK, GRAPHS[0]]}
"""What is compared of each workspace; the larger one in the formats that tell most."""
TIMED = re.compile(r'("elapsed_s": |\btime=")[0-9.]+')
"""The only thing that a clock decides: how long the run took."""

OF_ANOTHER_FOLDER = {
    "action": "scripts/action",
    "adoption": "benchmarks/adoption",
    "fixtures": "fixtures",
    "fuzz": "benchmarks/fuzz",
    "histories": "benchmarks/histories",
    "mutations": "benchmarks/mutations",
    "oracle": "benchmarks/accuracy/oracle",
    "structure": "benchmarks/structure",
    "website": "website",
}
"""Folders of tests that belong to no package of src, and what they are for."""

VAGUE = {"one", "found", "made"}
"""They say how a variable got its value, and not what that is."""

VAGUE_NAME = re.compile(rf"(?<![.\w])(?:{'|'.join(sorted(VAGUE))})\b")
NO_NAMES = re.compile(r'"""[\s\S]*?"""|#.*')
"""Docstrings and comments, in which these words may stand."""

BINDS = """
def f(a, *b, c=0, **d):
    e, (g, *h) = a
    for i in [j for j in b]:
        k += (m := i)
    return lambda n: n

match x:
    case [*p, q]:
        pass
    case int() as r:
        pass
try:
    pass
except OSError as s:
    pass
"""

RUNS = """
import contextlib, io, json, sys
from archlint.cli import main
said = []
for words in json.load(sys.stdin):
    with contextlib.redirect_stdout(io.StringIO()) as out:
        main(words)
    said.append(out.getvalue())
json.dump(said, sys.stdout)
"""


def said(folder: Path, commands: list[tuple[str, ...]], hash_seed: str, *options: str) -> list[str]:
    """Standard output of each command in a folder, one process for all, and the files that they write; the running time
    is blanked."""
    environment = {
        "PATH": os.environ["PATH"],
        "PYTHONPATH": str(ROOT / "src"),
        "PYTHONHASHSEED": hash_seed,
        "SYSTEMROOT": os.environ.get("SYSTEMROOT", ""),
        "GITHUB_WORKSPACE": str(folder),  # the root of the repository, wherever the copy is
    }
    with tempfile.TemporaryDirectory() as written:
        words = [[*(word.format(folder=written) for word in command), "--isolated", *options] for command in commands]
        done = subprocess.run(
            [sys.executable, "-c", RUNS],
            cwd=folder,
            env=environment,
            input=json.dumps(words),
            capture_output=True,
            text=True,
            check=True,
        )
        reports = [path.read_text("utf-8") for path in sorted(Path(written).iterdir())]
    assert len(reports) == sum(word in FORMATS for command in commands for word in command)
    return [TIMED.sub(r"\1", text) for text in (*json.loads(done.stdout), *reports)]


def test_imports_run_downwards():
    lint_imports = Path(sys.executable).with_name("lint-imports")
    done = subprocess.run([lint_imports, "--no-cache"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_each_folder_of_tests_is_named_like_the_package_that_it_tests():
    folders = {path.parent.relative_to(ROOT / "tests").as_posix() for path in (ROOT / "tests").rglob("test_*.py")}
    for folder in sorted(folders - {"."}):
        tested = ROOT / OF_ANOTHER_FOLDER.get(folder, f"src/archlint/{folder}")
        assert tested.is_dir(), f"tests/{folder}: there is no {tested.relative_to(ROOT)}"


def modules_of(package: Path) -> set[str]:
    return {path.stem for path in package.glob("*.py")} - {"__init__"}


def test_each_package_has_a_folder_of_tests_and_each_module_its_tests_there():
    source, tests = ROOT / "src" / "archlint", ROOT / "tests"
    nested = sorted(
        path.parent for path in source.rglob("__init__.py") if path.parent.parent not in (source, source.parent)
    )
    for package in nested:
        above, folder = package.parent, tests / package.relative_to(source)
        assert list(folder.glob("test_*.py")), f"{package.relative_to(ROOT)} has no tests in {folder.relative_to(ROOT)}"
        for module in sorted(modules_of(package) - modules_of(above)):
            aside = tests / above.relative_to(source) / f"test_{module}.py"
            assert not aside.exists(), f"{aside.relative_to(ROOT)} belongs in {folder.relative_to(ROOT)}"


def variables(source: str) -> set[tuple[str, int]]:
    """The variables and parameters that a file binds, with the line of each."""
    bound = set()
    for node in ast.walk(ast.parse(source)):
        match node:
            case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name):
                bound.add((name, node.lineno))
            case ast.MatchAs(name=str(name)) | ast.MatchStar(name=str(name)) | ast.ExceptHandler(name=str(name)):
                bound.add((name, node.lineno))
    return bound


def test_every_way_to_bind_a_variable_counts():
    assert {name for name, _ in variables(BINDS)} == set("abcdeghijkmnpqrs")


def test_a_variable_is_named_for_what_it_holds():
    vague = [
        f"{path.relative_to(ROOT).as_posix()}:{line}: {name}"
        for path in sorted((ROOT / "src" / "archlint").rglob("*.py"))
        for text in [path.read_text(encoding="utf-8")]
        if VAGUE_NAME.search(NO_NAMES.sub("", text))  # most modules need not be parsed
        for name, line in sorted(variables(text), key=lambda row: row[1])
        if name in VAGUE
    ]
    assert vague == [], "name them for what they hold"


@pytest.mark.parametrize("name", OUTPUTS)
def test_the_same_input_gives_the_same_bytes(name, tmp_path):
    """Whatever the hashes, the processes, the folder and the cache are; in the order of places, without a word of the
    machine.  In one test, since each of its runs takes seconds."""
    folder, commands = FIXTURES / name, OUTPUTS[name]
    expected = said(folder, commands, "0", "--jobs", "1", "--no-cache")
    tell_nothing_of_the_machine(folder, expected)
    are_in_the_order_of_their_places(expected[0])
    moved = tmp_path / "somewhere" / "else"
    shutil.copytree(folder, moved, ignore=shutil.ignore_patterns(".archlint_cache"))
    kept = ("--cache-dir", str(tmp_path / "cache"))
    assert said(moved, commands, "2", "--jobs", "2", *kept) == expected, "a cache that is empty"
    assert said(moved, commands, "1", "--jobs", "1", *kept) == expected, "a cache that knows the workspace"


def tell_nothing_of_the_machine(folder: Path, texts: list[str]) -> None:
    for text in texts:
        assert text
        for place in (str(ROOT), str(folder), sys.executable):
            assert place not in text
        assert not re.search(r"\b20\d\d-\d\d-\d\d[T ]\d\d:\d\d", text)


def are_in_the_order_of_their_places(findings: str) -> None:
    diagnostics = json.loads(findings.replace('"elapsed_s": ', '"elapsed_s": 0'))["diagnostics"]
    places = [(one["file"], one["line"], one["column"], one["code"]) for one in diagnostics]
    assert places
    assert places == sorted(places)


def test_dataclasses_are_quick_to_make():
    """All but what users of the API, rules and renderers share, which refuses to be changed, and the recorder, which is
    printed."""
    source = ROOT / "src" / "archlint"
    others = {"records.py", "observed/recorder.py", "systems/model.py", "systems/nodes.py"}
    slow = [
        path.relative_to(source).as_posix()
        for path in sorted(source.rglob("*.py"))
        if path.relative_to(source).parts[0] != "api" and path.relative_to(source).as_posix() not in others
        if re.search(r"^from dataclasses import (.*, )?dataclass\b", path.read_text(encoding="utf-8"), re.MULTILINE)
    ]
    assert slow == [], "import dataclass from archlint.records"


def test_no_rule_reads_the_files_of_the_workspace():
    """A rule asks the ``WorkspaceIndex`` what it knows; the tree behind it is for launch and for analysis."""
    reads = [
        f"{file.name}:{item.lineno}"
        for file in sorted((ROOT / "src" / "archlint" / "checks").glob("*.py"))
        for item in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if (isinstance(item, ast.Attribute) and item.attr == "tree")
        or (isinstance(item, ast.ImportFrom) and item.module == "archlint.workspace.tree")
    ]
    assert reads == []
