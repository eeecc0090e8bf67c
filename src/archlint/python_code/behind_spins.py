"""Code to which a program hardly ever comes: it stands behind a bare ``rclpy.spin()``, which Ctrl-C ends with a
KeyboardInterrupt that nothing catches, or behind a constructor that never returns.

Source: as of skipped_endings.py.  Such a spin returns only where a line of the program shuts rclpy down.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.analysis.kept import kept_for_each_file
from archlint.python_code.endless_constructors import comes_back, endless_classes
from archlint.python_code.second_shutdowns import OF_SIGNALS, targets_of_threads
from archlint.python_code.skipped_endings import shuts_down_elsewhere, spin_in
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.place import Place
    from archlint.systems.model import WorkspaceIndex


def is_behind_a_spin(workspace: WorkspaceIndex, place: Place) -> bool:
    """Whether a place stands behind such a spin or constructor in its block, or in one inside."""
    return any(start <= place.span[:2] and place.span[2:] <= end for start, end in _behind(workspace, place.file) or ())


@kept_for_each_file
def _behind(code: facts.Facts) -> list[tuple[tuple[int, int], tuple[int, int]]]:
    """The parts of a file that stand behind such a line: where each begins and ends."""
    if not OF_SIGNALS.isdisjoint(code.names) or shuts_down_elsewhere(code):
        return []
    threads, endless = targets_of_threads(code), endless_classes(code)
    blocks = [code.body, *(f.body for f in everything_in(code.body, facts.Function) if f.name not in threads)]
    return [part for block in blocks for part in _in_block(block, endless)]


def _in_block(
    block: Sequence[facts.Stmt], endless: frozenset[str]
) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    """Such parts of a block: what stands behind a ``try`` with a spin in it, and in its ``except``, is reached."""
    for at, statement in enumerate(block):
        if isinstance(statement, (facts.Function, facts.Class, facts.Global)):
            continue
        stays = not statement.blocks and not comes_back([statement], endless)
        if (spin_in(statement) is not None or stays) and block[at + 1 :]:
            last = block[-1]
            if not isinstance(last, facts.Global):
                yield statement.span[2:], last.span[2:]
            return
        for inner in statement.blocks:
            yield from _in_block(inner, endless)


__all__ = ["is_behind_a_spin"]
