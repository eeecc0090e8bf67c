"""The machine with all of its rooms: statements, expressions and calls."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.call_site import NOTHING_GIVEN, CallSite
from archlint.interpreter.calls import call
from archlint.interpreter.expressions import EXPRESSIONS
from archlint.interpreter.machine import Machine
from archlint.interpreter.statements import STATEMENTS

if TYPE_CHECKING:
    from archlint.interpreter.machine import Status
    from archlint.interpreter.values import Value
    from archlint.syntax import facts


class Interpreter(Machine):
    """A machine that can run."""

    def run_statement(self, statement: facts.Stmt) -> Status:
        return STATEMENTS[statement.__class__](self, statement)

    def evaluate(self, expression: facts.Expr) -> Value:
        return EXPRESSIONS[expression.__class__](self, expression)

    def call(self, function: Value, site: CallSite = NOTHING_GIVEN) -> Value:
        return call(self, function, site)


__all__ = ["Interpreter"]
