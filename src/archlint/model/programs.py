"""A program: one executable, or a class or function that no executable reaches, as it was run."""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from archlint.model.executors import (
    ExecutorUse,
    SpinDuration,
)
from archlint.model.given import Process
from archlint.records import dataclass

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.model.absent_reads import AbsentRead
    from archlint.model.calls import ApiCall
    from archlint.model.futures import MistakenFuture
    from archlint.model.messages import FieldUse, UnknownInterface, WrongValue
    from archlint.model.nodes import Blueprint, Callback
    from archlint.model.refused import RefusedCall


@dataclass(eq=False)
class Program:
    """One executable (or a class or function that no executable reaches), run symbolically."""

    name: str
    """Executable name, or the qualified name of the class or function that was run."""
    package: str | None
    file: str
    nodes: list[Blueprint] = field(default_factory=list)
    calls: list[ApiCall] = field(default_factory=list)
    callbacks: list[Callback] = field(default_factory=list)
    executors: list[ExecutorUse] = field(default_factory=list)
    field_uses: list[FieldUse] = field(default_factory=list)
    callers: dict[Place, set[Place | None]] = field(default_factory=dict)
    """Where the functions that use fields of their parameters are called; None for code that is not here."""
    unknown_interfaces: list[UnknownInterface] = field(default_factory=list)
    wrong_values: list[WrongValue] = field(default_factory=list)
    refused_calls: list[RefusedCall] = field(default_factory=list)
    mistaken_futures: list[MistakenFuture] = field(default_factory=list)
    absent_reads: list[AbsentRead] = field(default_factory=list)
    refused: set[Place] = field(default_factory=set)
    """The calls that Python refuses: the arguments do not fit."""
    reads_command_line: bool = False
    parses_command_line: bool = False
    """Whether it looks at ``sys.argv``, and whether argparse divides that up for it."""
    strict_parsers: list[Place] = field(default_factory=list)
    """Where argparse is given that command line as it is, on each way, and ends the program at an option that it does
    not know."""
    reads_node_names: bool = False
    """Whether it asks a node for its name, which may be another than that in the code."""
    exhausted: bool = False
    """True where a bound on depth or steps cut the run short."""
    late: bool = False
    """True where it was cut short since other programs of the workspace had run so much."""
    executable: bool = True
    process: Process = field(default_factory=Process)
    """What sets its objects apart from those of other programs."""

    def executors_of(self, node: Blueprint) -> list[ExecutorUse]:
        """The executors that spin a node; of several those that do so longest.

        Where the program is not all there is (nothing starts it, or the node comes from outside), a spin for a
        moment says nothing of who spins the node later.
        """
        uses = [use for use in self.executors if use.spun and node in use.nodes]
        least = SpinDuration.A_WHILE if node.caller_unknown or not self.executable else SpinDuration.A_MOMENT
        longest = max((use.lasts_for(node) for use in uses), default=least)
        return [use for use in uses if use.lasts_for(node) == longest >= least]
