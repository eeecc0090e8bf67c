"""Methods that nothing calls: left over from a tutorial, or waiting for a caller."""

from __future__ import annotations

import posixpath
from typing import TYPE_CHECKING

from archlint.analysis.left_over import idle_methods
from archlint.analysis.source_code import code_of

if TYPE_CHECKING:
    from archlint.finding import Place
    from archlint.systems.model import WorkspaceIndex


def uncalled_method(workspace: WorkspaceIndex | None, place: Place) -> str | None:
    """The name of the method that holds a place, where its own file does not name it again, and no other Python file
    has a word for both the method and its module; None for any other place."""
    if workspace is None:
        return None
    function = code_of(workspace).function_at(place)
    if function is None or function.name not in idle_methods(workspace, place.file):
        return None
    module = posixpath.basename(place.file).removesuffix(".py")
    others = (other for other in workspace.code.files_that_mention(function.name) if other != place.file)
    return None if any(workspace.code.mentions(other, module) for other in others) else function.name


__all__ = ["uncalled_method"]
