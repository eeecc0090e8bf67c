"""archlint for Python programs: a test of your own, a dashboard, a script that looks at the architecture.

All that is public is here, and the same names are in ``archlint`` itself.  Nothing of it prints, ends the process,
changes the working directory or keeps anything from one workspace to the next.  docs/api.md has examples.
"""

from __future__ import annotations

from archlint.api.errors import ArchlintError
from archlint.api.graph import (
    Endpoint,
    Graph,
    Interface,
    InterfaceConstant,
    InterfaceField,
    LaunchArgument,
    Node,
    Parameter,
    QosProfile,
    Remapping,
    Service,
    Timer,
    Topic,
    Undelivered,
    Unresolved,
    graph_of,
)
from archlint.api.workspace import CheckResult, Workspace, load
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Edit, Finding, Fix, Place, Related, Severity
from archlint.report.model import Summary
from archlint.systems.graph import to_networkx
from archlint.systems.model import System

__all__ = [
    "ArchlintError",
    "CheckResult",
    "Edit",
    "Endpoint",
    "Finding",
    "Fix",
    "Graph",
    "Interface",
    "InterfaceConstant",
    "InterfaceField",
    "LaunchArgument",
    "Node",
    "Options",
    "Parameter",
    "Place",
    "QosProfile",
    "Related",
    "Remapping",
    "Scope",
    "Service",
    "Severity",
    "Summary",
    "System",
    "Timer",
    "Topic",
    "Undelivered",
    "Unresolved",
    "Workspace",
    "finding",
    "graph_of",
    "load",
    "rule",
    "to_networkx",
]
