"""API003: nodes that are used before they are initialised, and bases of theirs that never are."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds
from archlint.checks.refused_calls import judged_refusals, name_of_call
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.model import Misuse
from archlint.python_code.skipped_constructors import SkippedConstructor, skipped_constructors
from archlint.python_code.uninitialised_programs import uninitialised_programs

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("API003", scope=Scope.CODE)
def node_not_initialised(system: System, options: Options) -> Iterator[Finding]:
    """Constructors that use the node before they initialise it, and nodes of programs that initialise rclpy later, or
    never."""
    for call in judged_refusals(system):
        if call.misuse is Misuse.BEFORE_INIT:
            yield finding(
                "API003",
                call.place,
                f"{call.given}() fails: rclpy.init() is called after it",
                help="call rclpy.init() first",
                identity=(call.given, "init"),
            )
        if call.misuse is Misuse.EARLY:
            yield finding(
                "API003",
                call.place,
                f"{name_of_call(call.api)}() fails: {call.given} has not called super().__init__() yet",
                help="call super().__init__('node_name') first",
                identity=(call.given,),
                group=(call.place.file, call.given),
            )

    for program in uninitialised_programs(system):
        yield finding(
            "API003",
            program.place,
            f"{program.node}() fails: the program never calls rclpy.init()",
            help="call rclpy.init() first",
            identity=(program.node, "no init"),
            group=(program.place.file, program.node, "no init"),
        )
    yield from map(_skipped, () if system.workspace is None else skipped_constructors(system.workspace))


def _skipped(row: SkippedConstructor) -> Finding:
    return finding(
        "API003",
        row.place,
        f"{row.base}.__init__() never runs: Node stands before it and calls no other constructor, so that a {row.cls} "
        f"has no '{row.attribute}'",
        help=f"call {row.base}.__init__(self) after super().__init__(…)",
        related=[Related(row.read, f"this reads '{row.attribute}'")],
        identity=(row.cls, row.base),
        group=(row.place.file, row.cls, row.base),
    )


@folds("API003")
def of_one_class(findings: Sequence[Finding]) -> Finding:
    """The first call of a constructor, with which it ends."""
    return findings[0]
