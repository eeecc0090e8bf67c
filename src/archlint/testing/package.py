"""The check of one package, as its own tests run it."""

from __future__ import annotations

import contextlib
import io
import json
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from archlint.cli import check, main
from archlint.cli.exits import CLEAN
from archlint.finding import Severity


def main_with_errors(argv: Sequence[str] = ()) -> tuple[int, list[str]]:
    """Run ``archlint check`` with these arguments, in the current folder.

    The report is printed, which pytest shows where a test fails.  Returns the exit status (0 nothing fails, 1 there are
    findings, 2 the run failed), and what is wrong, one line each: ``file:line:column: CODE message`` for a finding that
    fails the run, or the error that ended it.  Raises nothing.
    """
    with tempfile.TemporaryDirectory(prefix="archlint-") as folder, io.StringIO() as messages:
        results = Path(folder, "archlint.json")
        with contextlib.redirect_stderr(messages):
            status = main(["check", *argv, "--output", f"json={results}"])
        sys.stderr.write(messages.getvalue())
        if status == CLEAN:
            return status, []
        errors = _failing(results, argv) if results.is_file() else []
        return status, errors or messages.getvalue().splitlines()


def _failing(results: Path, argv: Sequence[str]) -> list[str]:
    lowest = Severity.parse(check.parser().parse_words([*argv]).severity)
    return [
        f"{finding['file']}:{finding['line']}:{finding['column']}: {finding['code']} {finding['message']}"
        for finding in json.loads(results.read_text("utf-8"))["diagnostics"]
        if Severity.parse(finding["severity"]) >= lowest
    ]
