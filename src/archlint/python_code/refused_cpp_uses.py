"""What C++ code gives rclcpp that its compiler refuses, by the text of each file that is built."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.place import Place
from archlint.python_code.cpp_members import built_code
from archlint.syntax.cpp_uses import RefusalOfCpp, RefusedUse

if TYPE_CHECKING:
    from archlint.systems.model import WorkspaceIndex


def refused_uses(workspace: WorkspaceIndex) -> Iterator[tuple[Place, RefusedUse]]:
    """Each of them with its place."""
    for path in built_code(workspace):
        code = workspace.code.cpp_facts_at(path)
        for use in () if code is None else code.refused_uses:
            yield Place(path, *use.span), use


__all__ = ["RefusalOfCpp", "RefusedUse", "refused_uses"]
