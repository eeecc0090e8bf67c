"""LCH015: descriptions of robots that no reader takes."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from archlint.checks.folding import folds, with_places
from archlint.checks.registry import Options, finding, rule
from archlint.checks.scope import Scope
from archlint.finding import Finding, Related
from archlint.launch_files.robot_trees import Flaw, RefusedTree, refused_trees
from archlint.suggestions import meant

if TYPE_CHECKING:
    from archlint.systems.model import System


@rule("LCH015", scope=Scope.LAUNCH_FILE, in_use=True)
def refused_description(system: System, options: Options) -> Iterator[Finding]:
    """Links and joints that are no tree, in a description that a launch file names."""
    for row in refused_trees(system):
        message, help = _said(row)
        ends = f"whatever reads '{posixpath.basename(row.robot)}' refuses it, and the robot has no description"
        same = row.there is not None and row.there != row.place
        yield finding(
            "LCH015",
            row.place,
            f"{message}: {ends}",
            help=help,
            related=[Related(row.there, "the other one is here")] if same and row.there is not None else [],
            identity=(row.flaw.value, row.name),
            group=(row.robot, row.flaw.value),
        )


def _said(row: RefusedTree) -> tuple[str, str]:
    name = f"'{row.name}'"
    match row.flaw:
        case Flaw.TWICE if row.there == row.place:
            return (
                f"this makes more than one {row.kind} {name}, as the macro around it is called more than once",
                "make the name of a parameter that is another one in each call",
            )
        case Flaw.TWICE:
            return f"a second {row.kind} is called {name}", "give it a name of its own, or remove one of the two"
        case Flaw.NO_LINK:
            near = row.other and f"'{row.other}'"
            message = f"the joint '{row.joint}' has {name} as its {row.kind}, and no link is called so{meant(near)}"
            return message, f"write {near}" if near else f'add <link name="{row.name}"/>, or remove the joint'
        case Flaw.ROOTS:
            return (
                f"no joint has '{row.other}' or {name} as its child, and a robot has one link alone without",
                "add a joint between the two, or remove the one that is not needed",
            )


@folds("LCH015")
def _of_one_description(findings: Sequence[Finding]) -> Finding:
    """One finding for what is wrong in one way: the reader stops at the first."""
    return with_places(findings)


__all__ = ["refused_description"]
