"""A workspace to ask: what is wrong in it, which nodes it has, who talks to whom."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from archlint.api.errors import ArchlintError, typed_errors
from archlint.api.graph import Graph, graph_of
from archlint.config.seen_from import seen_from
from archlint.config.settings import Settings
from archlint.config.settings import load as load_settings
from archlint.engine import pipeline
from archlint.engine.request import Request
from archlint.finding import Finding, Severity
from archlint.report.model import Summary
from archlint.systems.graph import to_networkx
from archlint.systems.model import System

if TYPE_CHECKING:
    import networkx

_RUNNING = threading.Lock()
"""Deeply nested code needs a higher recursion limit, which is one of the process: runs come one after another."""

Answer = TypeVar("Answer")
PathLike = str | os.PathLike[str]


@dataclass(frozen=True)
class CheckResult:
    """What a check has to say: ``findings`` in the order of file, line, column and code, the figures of the run, and
    ``notices``, sentences that the command line prints as warnings."""

    findings: tuple[Finding, ...]
    summary: Summary
    notices: tuple[str, ...]

    def fails(self, severity: Severity = Severity.WARNING) -> bool:
        """Whether something is at or above a severity: where the command line ends with exit status 1, or with 2 for
        a finding LNT003 (a rule that raised)."""
        return any(finding.code == "LNT003" or finding.severity >= severity for finding in self.findings)


@dataclass(frozen=True)
class Workspace:
    """A workspace, a package, a folder or a file, with its configuration; made by :func:`load`.

    Each method reads the files as they are when it is called.  In findings and graphs a file is a path from
    ``folder``, with ``/``, whatever the working directory is.
    """

    folder: Path
    """The folder that was loaded, or that the file is in."""
    _request: Request = field(repr=False)

    def check(self) -> CheckResult:
        """What the rules of the configuration find, with a fix where one is possible (``finding.fix``).

        Raises :class:`ArchlintError` where nothing here is for ROS 2.
        """
        report = _run(lambda: pipeline.check(self._request))
        return CheckResult(tuple(report.findings), report.summary, tuple(report.notices))

    def systems(self) -> tuple[System, ...]:
        """What rules judge: first the open system, which is all code of the workspace, then what each launch file
        starts (with ``launch`` that one only).  Raises :class:`ArchlintError`."""
        return tuple(_run(lambda: pipeline.systems(self._request)))

    def graph(self) -> Graph:
        """All nodes and connections, or those of the launch file that was loaded; as ``archlint graph`` shows them.

        Raises :class:`ArchlintError`.
        """
        return _run(lambda: graph_of(pipeline.graph(self._request)))

    def networkx(self) -> networkx.MultiDiGraph:
        """The same as a graph of networkx: a vertex ``(kind, name)`` for each node, topic, service and action, and
        edges that run with the data or the request.  Raises :class:`ArchlintError`."""
        return _run(lambda: to_networkx(pipeline.graph(self._request)))


def load(
    path: PathLike = ".",
    *,
    config: PathLike | None = None,
    isolated: bool = False,
    launch: PathLike | None = None,
    arguments: Mapping[str, str] | None = None,
    plugins: bool | None = None,
    jobs: int | None = 1,
) -> Workspace:
    """A workspace to ask.  Nothing of it is executed, and nothing is written or printed; no cache is kept.

    ``path`` is a workspace, a package, a folder or a file.  The configuration is the nearest one upwards, that of
    ``config``, or none (``isolated``).  ``launch`` is a launch file, from the working directory: the only system then,
    started with these ``arguments``.  ``plugins`` says whether the plugins that the configuration names run (True) or
    are left out (False); with None, one that is code of the repository is an error.  ``jobs`` is the most processes,
    None for as many as there are processors and memory for.
    Raises :class:`ArchlintError`.
    """
    if config is not None and isolated:
        raise ArchlintError("config and isolated exclude each other")
    asked = Path(os.path.abspath(path))
    if not asked.exists():
        raise ArchlintError(f"no such file or directory: {os.fspath(path)}")
    folder = asked if asked.is_dir() else asked.parent
    with typed_errors():
        settings = (
            Settings() if isolated else load_settings(asked, None if config is None else Path(config), plugins=plugins)
        )
    request = Request(
        (str(asked),),
        seen_from(str(folder), settings),
        cached=False,
        jobs=jobs,
        folder=str(folder),
        launch=None if launch is None else _launch_file(launch, folder),
        launch_arguments=tuple((arguments or {}).items()),
    )
    return Workspace(folder, request)


def _launch_file(launch: PathLike, folder: Path) -> str:
    if not os.path.isfile(launch):
        raise ArchlintError(f"no such launch file: {os.fspath(launch)}")
    return Path(os.path.relpath(launch, folder)).as_posix()


def _run(work: Callable[[], Answer]) -> Answer:
    with _RUNNING, typed_errors():
        return work()
