"""Runs one rule over small files: a line that ends in ``# here`` is where a finding must be."""

from __future__ import annotations

from pathlib import Path
from textwrap import dedent

from archlint.config.settings import load
from archlint.engine.pipeline import Request, check
from archlint.finding import Finding
from archlint.report import concise

MARK = "# here"
EVERYWHERE = {
    "LCH003": "[rules.LCH003]\ncommand-line = true\n",
    "NME001": "[rules.NME001]\neverywhere = true\n",
    "OWN001": "closed-world = true\n",
    "OWN002": "closed-world = true\n",
}
"""Options with which a rule tells of single names and classes what it tells by itself where more speaks for it."""


class Judge:
    """``judge("TMO001", source)`` checks that exactly the marked lines carry the rule, and gives the findings.

    Several sources are several files; ``config`` is TOML that follows the ``select`` key.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __call__(self, code: str, *sources: str, config: str = "") -> list[Finding]:
        marked = []
        for number, source in enumerate(sources):
            name = f"node{number or ''}.py"
            lines = dedent(source).lstrip("\n").splitlines()
            (self.folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
            marked += [(name, line) for line, text in enumerate(lines, 1) if text.endswith(MARK)]
        settings = f'select = ["{code}"]\n' + (dedent(config) or EVERYWHERE.get(code, ""))
        (self.folder / "archlint.toml").write_text(settings, encoding="utf-8")
        report = check(Request((".",), load(self.folder), cached=False, jobs=1))
        found = sorted((one.place.file, one.place.line) for one in report.findings)
        assert found == sorted(marked), concise.render(report)
        return report.findings
