"""What the node actions of a launch file would start that nothing adds: launch looks for it once they are added."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from archlint.launch.kinds import StartedKind
from archlint.launch.started import Started
from archlint.launch_files.launch_descriptions import wrong_descriptions
from archlint.launch_files.wrong_launch_descriptions import Wrong
from archlint.model import Text
from archlint.place import Place
from archlint.syntax import facts
from archlint.syntax.parts import everything_in

if TYPE_CHECKING:
    from archlint.systems.model import System

_NODES = frozenset({"Node", "LifecycleNode"})


def unadded_programs(system: System) -> Iterator[Started]:
    """The programs of node actions that nothing adds, where package and executable are written out."""
    for file, wrong in wrong_descriptions(system):
        if wrong.kind == Wrong.NOT_ADDED and wrong.of in _NODES and system.workspace is not None:
            code = system.workspace.facts_at(file)
            for assign in everything_in([] if code is None else code.body, facts.Assign):
                match assign.targets:
                    case [facts.Name(span=span)] if span == wrong.span:
                        yield from _started(file, assign.value)


def _started(file: str, action: facts.Expr) -> Iterator[Started]:
    if not isinstance(action, facts.Call):
        return
    values = {argument.keyword: argument.value for argument in action.args if argument.keyword}
    match values.get("package"), values.get("executable"):
        case facts.Literal(value=str(package), span=first), facts.Literal(value=str(name), span=second):
            places = {"package": Place.of(file, first), "executable": Place.of(file, second)}
            texts = Text(package, "exact"), Text(name, "exact")
            yield Started(StartedKind.NODE, *texts, Place.of(file, action.span), file, places=places)


__all__ = ["unadded_programs"]
