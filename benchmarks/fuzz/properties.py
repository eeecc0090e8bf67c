"""What is true of every run, whatever the files say.  A property that does not hold raises ``AssertionError``."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any, NoReturn
from unittest.mock import patch

from archlint.finding import Finding
from archlint.fixes.apply import apply
from archlint.fixes.apply import write as write_fixes
from archlint.fixes.ignores import with_ignores
from archlint.place import Place
from archlint.report.occurrence import Occurrence
from archlint.syntax import compile as compiler
from benchmarks.fuzz.rewriting import renamed, reordered, spaced
from benchmarks.fuzz.runs import Files, Ran, command, findings, laid_out, occurrences, write

CHECK = ("check", ".", "--no-cache", "--jobs", "1", "--format")


def keeps_its_contract(files: Files) -> None:
    """Exit status 0, 1 or 2, no traceback, no failure of a part, and JSON and SARIF that a reader can rely on."""
    with laid_out(files):
        ran = command(*CHECK, "json", "--output", "sarif=../report.sarif")
        _proper(ran)
        if not ran.out:
            return
        report = _strict_json(ran.out)
        _diagnostics(report, ran.status)
        _sarif(_strict_json(Path("../report.sarif").read_text("utf-8")), report)
        for words in (
            ("graph", ".", "--no-cache", "--all", "--format", "json"),
            (*CHECK, "text"),
            (*CHECK[:-1], "--diff"),
        ):
            again = command(*words)
            _proper(again)
            if words[0] == "graph" and again.status == 0:
                _strict_json(again.out)


def _proper(ran: Ran) -> None:
    assert ran.status in (0, 1, 2), f"exit status {ran.status}"
    crash = re.search(r"Traceback \(most recent|internal error", ran.err)
    assert crash is None, _short(ran.err[crash.start() :] if crash else "")
    failed = re.search(r'"LNT003".*?"message": "(.*?)",\n', ran.out, re.DOTALL) or re.search(r"LNT003.*", ran.out)
    assert failed is None, f"LNT003: {_short(failed[failed.lastindex or 0] if failed else '')}"
    if ran.status == 2:
        assert "archlint: error: " in ran.err and not ran.out, f"exit status 2: {_short(ran.err)}"


def _short(text: str) -> str:
    return text.strip()[:600]


def _strict_json(text: str) -> Any:
    text.encode("utf-8")

    def refuse(word: str) -> NoReturn:
        raise AssertionError(f"no JSON: {word}")

    return json.loads(text, parse_constant=refuse)


def _diagnostics(report: Mapping[str, Any], status: int) -> None:
    rows = report["diagnostics"]
    order = [(row["file"], row["line"], row["column"], row["code"]) for row in rows]
    assert order == sorted(order), "the findings are not in order"
    for row in rows:
        assert 1 <= row["line"] <= row["end_line"], f"{row['code']}: a place that ends before it begins"
        assert row["column"] >= 1 and row["message"] and row["severity"] in ("error", "warning", "info")
    summary = report["summary"]
    assert len(rows) == summary["errors"] + summary["warnings"] + summary["infos"], "the summary does not add up"
    assert status == (1 if summary["errors"] + summary["warnings"] else 0), f"exit status {status}: {summary}"


def _sarif(sarif: Mapping[str, Any], report: Mapping[str, Any]) -> None:
    assert sarif["version"] == "2.1.0"
    [run] = sarif["runs"]
    assert len(run["results"]) == len(report["diagnostics"]), "SARIF and JSON differ"
    known = {rule["id"] for rule in run["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in run["results"]} <= known, "SARIF names a rule that it does not describe"


def says_the_same_again(files: Files) -> None:
    """The same findings and the same graph: from several processes, with a new cache and with a full one."""
    with laid_out(files):
        first = _told(command(*CHECK, "json"))
        with patch.object(compiler, "PARALLEL_BYTES", 0):
            assert _told(command("check", ".", "--no-cache", "--jobs", "2", "--format", "json")) == first, (
                "two processes"
            )
        cached = ("check", ".", "--cache-dir", "../cache", "--format", "json")
        assert _told(command(*cached)) == first, "a cache that is filled"
        assert _told(command(*cached)) == first, "a cache that is full"
        drawn = command("graph", ".", "--no-cache", "--format", "json")
        assert command("graph", ".", "--cache-dir", "../cache", "--format", "json") == drawn, (
            "the graph of a full cache"
        )


def _told(ran: Ran) -> tuple[int, Any]:
    if not ran.out:
        return ran.status, ran.err
    report = json.loads(ran.out)
    report["summary"].pop("elapsed_s")
    return ran.status, report


def follows_an_edit(before: Files, after: Files) -> None:
    """With the cache of the files before an edit the run says what one without a cache says."""
    with laid_out(before):
        cached = ("check", ".", "--cache-dir", "../cache", "--format", "json")
        command(*cached)
        write(Path("."), after)
        assert _told(command(*cached)) == _told(command(*CHECK, "json")), "a cache from before the edit"


def is_the_same_reformatted(files: Files) -> None:
    """Blank lines, comments, other names for locals and another order of methods change nothing that is found."""
    with laid_out(files) as folder:
        before = findings(folder)
        for name, rewrite, ordered in (
            ("spaced", _spaced, True),
            ("renamed", _renamed, True),
            ("reordered", reordered, False),
        ):
            texts, lines = _rewritten(files, rewrite)
            write(folder, texts)
            after = findings(folder)
            _assert_same(name, _keys(before, lines if ordered else None), _keys(after, {} if ordered else None))
            write(folder, files)


def _spaced(text: str) -> tuple[str, Mapping[int, int]]:
    return spaced(text, 2)


def _renamed(text: str) -> tuple[str, Mapping[int, int]]:
    return renamed(text), {}


_Rewrite = Callable[[str], "tuple[str, Mapping[int, int]]"]


def _rewritten(files: Files, rewrite: _Rewrite) -> tuple[dict[str, bytes], dict[str, Mapping[int, int]]]:
    """The files of Python that could be rewritten, and where their lines are."""
    texts: dict[str, bytes] = {}
    lines: dict[str, Mapping[int, int]] = {}
    for path, content in files.items():
        if not path.endswith(".py") or b"\r" in content or b"\x0c" in content or b"# archlint" in content:
            continue
        try:
            text = content.decode()
            compile(text, path, "exec", dont_inherit=True)
            made, moved = rewrite(text)
            compile(made, path, "exec", dont_inherit=True)
        except (SyntaxError, ValueError, RecursionError, MemoryError, OverflowError):
            continue
        if len(text.splitlines()) == text.count("\n"):
            texts[path], lines[path] = made.encode(), moved
    return texts, lines


def _keys(found: Iterable[Finding], lines: Mapping[str, Mapping[int, int]] | None) -> Counter[tuple[object, ...]]:
    """What is found where; without lines only in which file: another order shows another one of two ends."""
    if lines is None:
        return Counter((one.code, one.node) for one in found)
    return Counter(
        (one.code, one.place.file, lines.get(one.place.file, {}).get(one.place.line, one.place.line)) for one in found
    )


def _assert_same(name: str, before: Counter[tuple[object, ...]], after: Counter[tuple[object, ...]]) -> None:
    lost, new = sorted(map(str, before - after)), sorted(map(str, after - before))
    assert not lost and not new, f"{name}: lost {lost}, new {new}"


def can_be_suppressed(files: Files) -> None:
    """A comment takes away what it names on its line, and nothing else."""
    with laid_out(files) as folder:
        before = occurrences(folder)
        for file, line, code in sorted({(one.place.file, one.place.line, one.code) for one in before})[:_MOST]:
            outcome = with_ignores({file: {line: [code]}}, "for a test")
            if code.startswith("LNT") or not outcome.texts or file not in files:
                continue
            write_fixes(outcome)
            added = _added_line(files[file].decode("utf-8", "replace"), outcome.texts[file])
            meant = [one for one in before if (one.code, one.place.file, one.place.line) == (code, file, line)]
            after = _kinds(occurrences(folder), file, 0)
            _assert_suppressed(_kinds(before, file, added), after, _kinds(meant, file, added), code)
            write(folder, {file: files[file]})


def _added_line(before: str, after: str) -> int:
    """The line of a comment that has one for itself, as in XML; 0 where there is none."""
    old, new = before.splitlines(), after.splitlines()
    if len(new) == len(old):
        return 0
    return next((number for number, (left, right) in enumerate(zip(old, new, strict=False), 1) if left != right), 0)


_MOST = 4
"""Findings of a workspace that are tried: each is two runs."""
_Kinds = Counter[tuple[str, str, str, int]]


def _kinds(found: Iterable[Occurrence], file: str, added: int) -> _Kinds:
    """What is found where, once a line is added to a file."""

    def line(place: Place) -> int:
        return place.line + (0 < added <= place.line and place.file == file)

    return Counter((one.code, one.what, one.place.file, line(one.place)) for one in found)


def _assert_suppressed(before: _Kinds, after: _Kinds, meant: _Kinds, code: str) -> None:
    gone, new = before - after, after - before
    assert gone, f"{code}: the comment takes away nothing"
    assert not gone - meant, f"{code}: the comment takes away more: {sorted(gone - meant)}"
    # A rule that reports the first of several places now reports the next one.
    said = {key[:2] for key in gone}
    others = [key for key in new if key[:2] not in said]
    assert not others, f"{code}: the comment makes {sorted(others)}"


def can_be_fixed(files: Files) -> None:
    """A fix mends its finding and makes no other one."""
    with laid_out(files) as folder:
        before = occurrences(folder)
        for one in [one for one in findings(folder) if one.fix is not None][:_MOST]:
            outcome = apply([one])
            if not outcome.fixed:
                continue
            write_fixes(outcome)
            after = occurrences(folder)
            made = _counted(after) - _counted(before)
            assert not made, f"the fix of {one.code} makes {sorted(made)}"
            said = Counter((one.code, one.what, one.place.file) for one in before)
            assert said - Counter((one.code, one.what, one.place.file) for one in after), (
                f"the fix of {one.code} leaves it"
            )
            write(folder, {path: files[path] for path in outcome.texts if path in files})


def _counted(found: Iterable[Occurrence]) -> Counter[tuple[str, str]]:
    return Counter((one.code, one.place.file) for one in found)


PROPERTIES: Mapping[str, Callable[..., None]] = {
    one.__name__: one
    for one in (
        keeps_its_contract,
        says_the_same_again,
        follows_an_edit,
        is_the_same_reformatted,
        can_be_suppressed,
        can_be_fixed,
    )
}
"""The properties by name: of one workspace, or of one before and after an edit."""
