"""Python's own functions, as far as names need them, a module a theme."""

from archlint.interpreter.builtins.table import BUILTINS, call_builtin

__all__ = ["BUILTINS", "call_builtin"]
