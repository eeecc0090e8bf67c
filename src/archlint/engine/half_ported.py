"""Files that are half ported: they use rclpy, and import what only ROS 1 has before anything else runs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from archlint.finding import Finding, Severity
from archlint.syntax import facts
from archlint.syntax.python.gate import ROS1_MODULES

if TYPE_CHECKING:
    from archlint.syntax.files import FactsOfFiles
    from archlint.workspace.model import SourceFile, Workspace


def half_ported(workspace: Workspace, files: Sequence[SourceFile], facts_of: FactsOfFiles) -> dict[str, str]:
    """The files whose import of a module of ROS 1 fails, whatever runs them, with that module."""
    own = {package.name for package in workspace.packages}
    modules_by_file: dict[str, str] = {}
    for file in files:
        read = facts_of.facts_of(file)
        modules = [] if read is None else [top for statement in read.body for top in _imported(statement)]
        first = next((module for module in modules if module in ROS1_MODULES and module not in own), None)
        if first is not None:
            modules_by_file[file.relative] = first
    return modules_by_file


def _imported(statement: facts.Stmt) -> tuple[str, ...]:
    """The top-level module that a statement imports; none in a ``try``, which may do without."""
    match statement:
        case facts.Import(module=module) | facts.ImportFrom(module=module, level=0):
            return (module.partition(".")[0],)
    return ()


def as_information(findings: Iterable[Finding], modules: Mapping[str, str]) -> list[Finding]:
    """The findings, those in files that cannot run for a module of ROS 1 as no more than information."""
    return [
        replace(finding, severity=min(finding.severity, Severity.INFO)) if finding.place.file in modules else finding
        for finding in findings
    ]


def with_reason(findings: Iterable[Finding], modules: Mapping[str, str]) -> list[Finding]:
    """The findings, with the reason why some are only information in their message."""
    return [
        replace(finding, message=f"{finding.message}; this file imports '{module}' of ROS 1, so it does not run")
        if (module := modules.get(finding.place.file)) is not None and finding.severity is Severity.INFO
        else finding
        for finding in findings
    ]
