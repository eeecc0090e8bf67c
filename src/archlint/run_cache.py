"""The result of a whole run, kept for the next one: where no input changed, nothing is read but their status.

A record holds the findings and, of every input, size, time of change and content hash.  It is plain JSON from
a folder that anybody may have written to: whatever is wrong with it, it is a miss.  Files that changed within
:data:`RACY` of the record being written are compared by content, since a second change may not show in their
time; so are all, where any status differs, which is what a fresh checkout looks like.
"""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from archlint import __version__
from archlint.finding import Finding, Place, Related, Severity
from archlint.report.json import diagnostic
from archlint.report.model import Summary

RACY = 2_000_000_000
"""Nanoseconds: the coarsest clock that a file system in use has."""

Status = tuple[int, int]
"""Time of change in nanoseconds, and size in bytes."""


class RunCache:
    """The one record of a request.  ``folder`` is None where caching is off.

    ``request`` is all that decides the result apart from the content of ``inputs`` and archlint's own code:
    paths, options and configuration.
    """

    def __init__(self, folder: Path | None, request: Sequence[object], inputs: Sequence[str]) -> None:
        text = json.dumps([__version__, own_code(), *request], default=repr, sort_keys=True)
        self.key = hashlib.sha256(text.encode()).hexdigest()
        self.path = None if folder is None else folder / "runs" / f"{self.key[:32]}.json"
        self.inputs = sorted(inputs)
        self.statuses = [_status(path) for path in self.inputs] if folder is not None else []

    def load(self) -> tuple[list[Finding], Summary, list[str]] | None:
        """Findings, summary and notices of the last run if nothing has changed since."""
        if self.path is None:
            return None
        try:
            record = json.loads(self.path.read_bytes())
            if record["key"] != self.key or record["inputs"] != self.inputs:
                return None
            if not self._unchanged(record):
                return None
            result = record["result"]
            findings = [_finding(entry) for entry in result["findings"]]
            return findings, Summary(**result["summary"]), [str(notice) for notice in result["notices"]]
        except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
            return None

    def save(self, findings: Sequence[Finding], summary: Summary, notices: Sequence[str]) -> None:
        """Keep a result.  A folder that cannot be written to is no reason to fail."""
        if self.path is None:
            return
        record = {
            "key": self.key,
            "inputs": self.inputs,
            "statuses": self.statuses,
            "digests": [_digest(path) for path in self.inputs],
            "written": time.time_ns(),
            "result": {
                "findings": [{**diagnostic(finding), "identity": finding.identity} for finding in findings],
                "summary": vars(summary),
                "notices": list(notices),
            },
        }
        if [_status(path) for path in self.inputs] != self.statuses:
            return  # a file was changed while it was being checked
        temporary = self.path.with_suffix(f".{os.getpid()}.tmp")
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            temporary.write_text(json.dumps(record, separators=(",", ":")), "utf-8")
            temporary.replace(self.path)
        except OSError:
            with suppress(OSError):
                temporary.unlink()

    def _unchanged(self, record: dict[str, Any]) -> bool:
        before = [None if status is None else tuple(status) for status in record["statuses"]]
        newest = int(record["written"]) - RACY
        if before != self.statuses:
            suspects = list(range(len(self.inputs)))
        else:
            suspects = [
                at for at, status in enumerate(self.statuses) if status is None or status[0] >= newest
            ]
        return all(_digest(self.inputs[at]) == record["digests"][at] for at in suspects)


def own_code() -> list[tuple[str, int, int]]:
    """Name, time and size of archlint's own modules: an edited rule must not be answered from the cache."""
    from archlint.rulebook import pages_folder

    entries: list[tuple[str, int, int]] = []
    folders = [str(Path(__file__).parent), str(pages_folder())]
    while folders:
        with os.scandir(folders.pop()) as found:
            for entry in found:
                if entry.name.endswith((".py", ".md")):
                    status = entry.stat()
                    entries.append((entry.path, status.st_mtime_ns, status.st_size))
                elif entry.name != "__pycache__" and entry.is_dir():
                    folders.append(entry.path)
    return sorted(entries)


def _status(path: str) -> Status | None:
    try:
        found = os.stat(path)  # noqa: PTH116  a Path for each of thousands of files would take longer
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def _digest(path: str) -> str | None:
    """A hash of a file's content; None for what is no readable regular file."""
    try:
        if not Path(path).is_file():
            return None
        return hashlib.sha256(Path(path).read_bytes()).hexdigest()
    except OSError:
        return None


def _finding(entry: dict[str, Any]) -> Finding:
    """The finding that :func:`~archlint.report.json.diagnostic` wrote."""
    related = tuple(Related(_place(one), str(one["message"])) for one in entry["related"])
    return Finding(
        code=str(entry["code"]),
        name=str(entry["name"]),
        severity=Severity.parse(entry["severity"]),
        message=str(entry["message"]),
        place=_place(entry),
        help=str(entry["help"]),
        node=entry["node"],
        system=entry["system"],
        related=related,
        identity=tuple(str(part) for part in entry["identity"]),
    )


def _place(entry: dict[str, Any]) -> Place:
    keys = ("line", "column", "end_line", "end_column")
    return Place(str(entry["file"]), *(int(entry[key]) for key in keys))
