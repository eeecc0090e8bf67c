"""Each rule's share of a run, over made-up workspaces: what grows faster than they do compares all with all."""

from __future__ import annotations

import contextlib
import gc
import io
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from archlint.cli import main
from archlint.engine import findings, judging
from benchmarks.speed.workspaces import make_workspace

_Rule = Callable[..., Iterable[object]]


def shares(sizes: Sequence[int]) -> dict[str, list[float]]:
    """Seconds of CPU of each rule, and of link and load, for each size."""
    rows: dict[str, list[float]] = {}
    for number, packages in enumerate(sizes):
        with tempfile.TemporaryDirectory() as temporary:
            make_workspace(Path(temporary), packages)
            for name, seconds in _seconds(Path(temporary)).items():
                rows.setdefault(name, [0.0] * len(sizes))[number] = seconds
    return rows


def _seconds(folder: Path) -> Counter[str]:
    seconds: Counter[str] = Counter()
    with _watched(seconds), contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        gc.disable()
        main(["check", str(folder), "--exit-zero", "--no-cache", "--jobs", "1"])
        gc.enable()
        gc.collect()
    return seconds


@contextlib.contextmanager
def _watched(seconds: Counter[str]) -> Iterator[None]:
    """While each rule, and what makes systems, notes how long it takes."""
    registered, systems_of = judging.registered, findings.systems_of
    checks = {
        code: replace(check, function=_timed(check.function, code, seconds)) for code, check in registered().items()
    }
    judging.registered = lambda: checks
    findings.systems_of = _timed(systems_of, "link and load", seconds)
    try:
        yield
    finally:
        judging.registered, findings.systems_of = registered, systems_of


def _timed(function: _Rule, name: str, seconds: Counter[str]) -> _Rule:
    def timed(*arguments: object) -> list[object]:
        started = time.process_time()
        try:
            return list(function(*arguments))
        finally:
            seconds[name] += time.process_time() - started

    return timed
