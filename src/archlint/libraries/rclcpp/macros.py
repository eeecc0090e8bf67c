"""Macros of C++ headers, which are functions whose names are those of the place where they are used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.interpreter.values import NONE, Value
from archlint.syntax.cpp.known_names import CALLER

if TYPE_CHECKING:
    from archlint.interpreter.call_site import CallSite
    from archlint.libraries.api_use import Plain
    from archlint.libraries.run import Run


def _caller(run: Run, site: CallSite) -> Value:
    """The object of the method that uses a macro."""
    if len(run.activations) < 2:
        return NONE
    own = run.activations.pop()
    try:
        return run.lookup("self") or NONE
    finally:
        run.activations.append(own)


PLAIN: dict[str, Plain] = {CALLER: _caller}

__all__ = ["PLAIN"]
