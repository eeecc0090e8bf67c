"""Which names the workspace gives to methods and attributes itself."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import System


def is_defined_somewhere(system: System, file: str, name: str) -> bool:
    """Whether any file of the workspace defines a function of a name, assigns an attribute of it or names it in a text
    (``setattr``): an object may have got it from there.  True where a file cannot be read."""
    workspace = system.workspace
    if workspace is None:
        return True
    files = dict.fromkeys((file, *workspace.code.files_that_mention(name)))
    return any(_defines(workspace.facts_at(path), name) for path in files)


def _defines(code: facts.Facts | None, name: str) -> bool:
    if code is None:
        return True
    for part in everything_in(code.body):
        match part:
            case facts.Function(name=defined) if defined == name:
                return True
            case facts.Assign(targets=targets) if any(target.attribute == name for target in targets):
                return True
            case facts.Literal(text=text) if text == name:
                return True
    return False


__all__ = ["is_defined_somewhere"]
