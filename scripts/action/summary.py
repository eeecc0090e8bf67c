"""What the action writes about a run, in the Markdown that GitHub shows under the job."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

from drawing import Drawing

MOST_FINDINGS = 50
"""Rows of the table; all findings are in the SARIF and the JSON."""
MOST_CHARACTERS, MOST_EDGES = 50_000, 500
"""What GitHub's Mermaid draws at most: ``maxTextSize`` and ``maxEdges`` of its configuration."""

_SEVERITIES = ("error", "warning", "info")


@dataclass(frozen=True)
class SourceLinks:
    """Where a line of a file is shown on GitHub."""

    address: str = ""
    """That of the files of the commit; empty where it is not known."""
    folder: str = "."
    """The working directory, from the root of the repository."""

    @staticmethod
    def of(variables: Mapping[str, str], folder: Path) -> SourceLinks:
        server, repository, commit = (variables.get(f"GITHUB_{name}") for name in ("SERVER_URL", "REPOSITORY", "SHA"))
        root = variables.get("GITHUB_WORKSPACE")
        if not (server and repository and commit and root):
            return SourceLinks()
        return SourceLinks(f"{server}/{repository}/blob/{commit}", os.path.relpath(folder, Path(root).resolve()))

    def place(self, file: str, line: int) -> str:
        """The place as Markdown, with a link if it is in the repository."""
        shown = f"{_text(file)}:{line}"
        path = Path(os.path.normpath(Path(self.folder, file))).as_posix()
        if not self.address or path.startswith(("../", "/")):
            return shown
        return f"[{shown}]({self.address}/{quote(path)}#L{line})"


def markdown(report: Mapping[str, Any], drawing: Drawing, links: SourceLinks, since: str = "") -> str:
    """The summary of ``check --format json``; ``since`` is the revision of ``--new-only``, or empty."""
    findings = report["diagnostics"]
    parts = [f"## archlint: {_counted(report['summary'])}\n", _scope(report["summary"], since)]
    if findings:
        parts.append("\n".join(_table(findings, links)) + "\n")
    if drawing.text:
        parts.append(_graph(drawing))
    return "\n".join(parts) + "\n"


def failure(message: str) -> str:
    """The summary of a run that has no findings to show, because it failed."""
    return "## archlint: the run failed\n\n" + "\n".join(f"    {line}" for line in message.splitlines()) + "\n\n"


def _counted(counts: Mapping[str, Any]) -> str:
    words = [("errors", "error"), ("warnings", "warning"), ("infos", "information")]
    told = [_count(counts[key], word) for key, word in words if counts[key]]
    return ", ".join(told) or "no findings"


def _count(number: int, word: str) -> str:
    return f"{number} {word}" if number == 1 or word == "information" else f"{number} {word}s"


def _scope(counts: Mapping[str, Any], since: str) -> str:
    where = f"{_count(counts['files'], 'file')} with {_count(counts['nodes'], 'node')}"
    said = f"What is new since {_text(since)}, in {where}" if since else f"In {where}"
    quiet = [("suppressed", "suppressed"), ("baselined", "held back by the baseline"), ("older", "not new")]
    told = [f"{counts[key]} {word}" for key, word in quiet if counts.get(key)]
    return f"{said}{''.join(f'; {one}' for one in told)}.\n"


def _table(findings: list[Mapping[str, Any]], links: SourceLinks) -> Iterator[str]:
    yield "| | rule | where | what |"
    yield "|---|---|---|---|"
    for finding in sorted(findings, key=lambda finding: _SEVERITIES.index(finding["severity"]))[:MOST_FINDINGS]:
        where = links.place(finding["file"], finding["line"])
        yield f"| {finding['severity']} | {finding['code']} | {where} | {_text(finding['message'])} |"
    left = len(findings) - MOST_FINDINGS
    if left > 0:
        yield f"\n… and {left} more: the log and the SARIF have all."


def _graph(drawing: Drawing) -> str:
    title, text = drawing.title, drawing.text
    if len(text) > MOST_CHARACTERS or len(re.findall(r"^  \w+ \S*[-=]", text, re.MULTILINE)) > MOST_EDGES:
        return f"{title}: too large for GitHub to draw. `archlint graph -o graph.svg` draws it.\n"
    if "```" in text:
        return ""
    return f"<details open><summary>{title}</summary>\n\n```mermaid\n{text}```\n\n</details>\n"


def _text(text: str) -> str:
    """Text of the user's as Markdown that says the same, and nothing else: no markup, no mention, no row of its own."""
    shown = "".join(char if char.isprintable() else " " for char in text)
    shown = re.sub(r"([\\`*_\[\]|#~$!])", r"\\\1", shown)
    return shown.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("@", "&#64;")
