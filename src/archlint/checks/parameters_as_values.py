"""PRM011: a Parameter that is used as if it were the value in it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.checks.uncalled import unless_uncalled
from archlint.finding import Finding
from archlint.python_code.parameters_as_values import Outcome, ParameterUse, parameter_uses

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("PRM011", scope=Scope.CODE)
def parameter_as_value(system: System, options: Options) -> Iterator[Finding]:
    """Parameters without ``.value`` where code calculates, compares or decides."""
    for use in parameter_uses(system):
        diagnostic = finding(
            "PRM011",
            use.place,
            _message(use),
            help="add .value: get_parameter(…).value",
            identity=(use.outcome, use.by),
            group=(use.place.file,),
        )
        yield from unless_uncalled(system, diagnostic)


def _message(use: ParameterUse) -> str:
    match use.outcome:
        case Outcome.FAILS:
            return f"{use.by} fails with a TypeError: this is a Parameter, not the value in it"
        case Outcome.TRUE if not use.by:
            return "this is always true: it asks a Parameter, not the value in it"
    return f"this is always {use.outcome}: {use.by} compares a Parameter, not the value in it"


@folds("PRM011")
def _of_one_file(findings: Sequence[Finding]) -> Finding:
    """One finding for all such uses of a file."""
    return with_places(findings, "here, too")


__all__ = ["parameter_as_value"]
