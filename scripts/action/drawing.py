"""The graph of a summary: of what a change does to the architecture, or else of what the findings are in."""

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
OF_CHANGES = "What has changed between the nodes: new in green, gone in red"


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
    difference: Sequence[str] = ()
    """What draws Mermaid of the changes since the revision of ``new-only``; empty without one."""

    def of(self, report: Mapping[str, Any]) -> Drawing:
        """Of ``check --format json``."""
        if self.difference:
            done = self._run(self.difference)
            if done.returncode == 0:  # a release of archlint before `diff` cannot
                text = done.stdout.decode("utf-8", "replace")
                return Drawing(OF_CHANGES, text) if text else Drawing()
        return self._drawn(OF_FINDINGS, list(dict.fromkeys(finding["file"] for finding in report["diagnostics"])))

    def _drawn(self, title: str, files: Sequence[str]) -> Drawing:
        python = [file for file in files if file.endswith(".py")][:MOST_FILES]
        packages = dict.fromkeys(package for file in files if (package := self._package_of(file)))
        for paths in (python, [*packages]):  # a launch file alone, say, has no nodes
            if paths and '["' in (text := self._mermaid(paths)):
                return Drawing(title, text)
        return Drawing()

    def _mermaid(self, paths: Sequence[str]) -> str:
        """Empty where archlint cannot draw them."""
        named = [path if os.path.isabs(path) else f"./{path}" for path in paths]
        done = self._run([*self.command, *named])
        return done.stdout.decode("utf-8", "replace") if done.returncode == 0 else ""

    def _run(self, command: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
        return subprocess.run(command, cwd=self.folder, env=self.environment, capture_output=True, check=False)

    def _package_of(self, file: str) -> str:
        """The folder of the package that a file belongs to; empty where it is in none."""
        parents = Path(file).parents
        return next((path.as_posix() for path in parents if (self.folder / path / "package.xml").is_file()), "")
