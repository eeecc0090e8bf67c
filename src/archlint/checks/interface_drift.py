"""ARC004: committed declarations of nodes that their code does not keep."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.analysis.declared_interfaces import drifts
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("ARC004", scope=Scope.CODE)
def interface_drift(system: System, options: Options) -> Iterator[Finding]:
    """Interfaces that ``interface.yaml`` or NoDL declares otherwise than the code creates them."""
    for drift in drifts(system):
        format = "nodl" if drift.file.endswith(".nodl.xml") else "interface-yaml"
        role = "the node is declared here" if drift.in_code else "it is created here"
        yield finding(
            "ARC004",
            drift.place,
            drift.words,
            help=f"make the two agree; `archlint export --format {format}` declares what the code creates",
            related=[] if drift.other is None else [Related(drift.other, role)],
            node=drift.node.name,
        )
