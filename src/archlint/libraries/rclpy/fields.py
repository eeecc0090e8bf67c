"""What a run keeps of nodes and executors beside their attributes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.fields import Field, Fields
from archlint.interpreter.values import Value, one_of

if TYPE_CHECKING:
    from archlint.model import ExecutorUse

EXECUTOR: Field[ExecutorUse] = Field("executor")
"""How the program uses an executor."""
OVERRIDES: Fields[Value] = Fields("override", one_of)
"""The parameters that a constructor is given values for."""
PARAMETERS: Fields[Value] = Fields("parameter", one_of)
"""The values of declared parameters."""

__all__ = ["EXECUTOR", "OVERRIDES", "PARAMETERS"]
