"""The graph of a summary: of what the findings are in, or, where a change brings none, of what it touches."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

MOST_FILES = 40
"""The files whose nodes a graph shows: more make a picture that nobody reads."""
OF_FINDINGS = "The nodes where these findings are, and what they talk to"
OF_CHANGES = "The nodes in the files that have changed, and what they talk to"
_CHANGED = (
    *("-c", "core.fsmonitor=false", "diff", "--no-ext-diff", "--no-textconv"),
    *("--name-only", "--relative", "-z", "--diff-filter=d", "--end-of-options"),
)


@dataclass(frozen=True)
class Drawing:
    """Mermaid, and what it shows; both are empty where there is nothing to draw."""

    title: str = ""
    text: str = ""


@dataclass(frozen=True)
class Draughtsman:
    """Who draws: ``command`` is what draws Mermaid of the paths that follow it."""

    command: Sequence[str]
    folder: Path
    environment: Mapping[str, str]

    def of(self, report: Mapping[str, Any], since: str) -> Drawing:
        """Of ``check --format json``; ``since`` is the revision of ``--new-only``, or empty."""
        files = list(dict.fromkeys(finding["file"] for finding in report["diagnostics"]))
        if files:
            return self._drawn(OF_FINDINGS, files)
        return self._drawn(OF_CHANGES, self._changed(since)) if since else Drawing()

    def _drawn(self, title: str, files: Sequence[str]) -> Drawing:
        python = [file for file in files if file.endswith(".py")][:MOST_FILES]
        packages = dict.fromkeys(package for file in files if (package := self._package_of(file)))
        for paths in (python, [*packages]):  # a launch file alone, say, has no nodes
            if paths and "n0" in (text := self._mermaid(paths)):
                return Drawing(title, text)
        return Drawing()

    def _mermaid(self, paths: Sequence[str]) -> str:
        """Empty where archlint cannot draw them."""
        named = [path if os.path.isabs(path) else f"./{path}" for path in paths]
        done = self._run([*self.command, *named])
        return done.stdout.decode("utf-8", "replace") if done.returncode == 0 else ""

    def _changed(self, since: str) -> list[str]:
        """The files that differ from where this branch left the revision."""
        done = self._run(["git", *_CHANGED, f"{since}...HEAD", "--", "."])
        return [os.fsdecode(name) for name in done.stdout.split(b"\0") if name]

    def _run(self, command: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
        return subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, check=False)

    def _package_of(self, file: str) -> str:
        """The folder of the package that a file belongs to; empty where it is in none."""
        parents = Path(file).parents
        return next((path.as_posix() for path in parents if (self.folder / path / "package.xml").is_file()), "")
