"""Failures that were found, written down so that the tests run them again: one file of JSON for each."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

from benchmarks.fuzz.runs import Files

FOLDER = Path(__file__).parents[2] / "tests" / "fuzz" / "cases"


@dataclass(frozen=True)
class Case:
    """A workspace that broke a property, and how: before and after an edit, where the property is about one."""

    property: str
    said: str
    states: tuple[Files, ...]

    def save(self, folder: Path) -> Path:
        """Write it down; returns where.  Lines are apart, and bytes that are no UTF-8 are lone surrogates."""
        states = [{path: _lines(content) for path, content in sorted(files.items())} for files in self.states]
        document = {"property": self.property, "said": self.said, "states": states}
        content = json.dumps(document, indent=1) + "\n"
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{self.property}-{hashlib.sha256(content.encode()).hexdigest()[:8]}.json"
        path.write_text(content, encoding="utf-8")
        return path


def _lines(content: bytes) -> list[str]:
    return content.decode("utf-8", "surrogateescape").splitlines(keepends=True)


def load(path: Path) -> Case:
    """Read a case again."""
    document = json.loads(path.read_text(encoding="utf-8"))
    states = tuple({name: _content(lines) for name, lines in files.items()} for files in document["states"])
    return Case(document["property"], document["said"], states)


def _content(lines: list[str]) -> bytes:
    return "".join(lines).encode("utf-8", "surrogateescape")
