"""What nodes, steps and places of a trace are called."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint.dataflow.builder import IDLE
from archlint.dataflow.model import StepKind
from archlint.render import look

if TYPE_CHECKING:
    from archlint.dataflow.model import Step
    from archlint.place import Place
    from archlint.systems.nodes import Node


def node_words(node: Node | None) -> str:
    """A node's name, or its class."""
    return "" if node is None else look.node_label(node).partition("\n")[0]


def step_name(step: Step) -> str:
    """What a step is called; code that is not known has no name."""
    if step.kind == StepKind.UNKNOWN:
        return "" if step.name == IDLE else "code that is not known"
    if step.kind == StepKind.FRAME and step.reason:
        return "that is not known"
    names = step.name.split(", ")
    return step.name if len(names) <= _NAMES else f"{', '.join(names[:_NAMES])} and {len(names) - _NAMES} more"


_NAMES = 3
"""Attributes that are named where several are one step."""


_TITLES = {
    StepKind.SERVICE: "requests of ",
    StepKind.ANSWER: "answers of ",
    StepKind.ACTION: "goals of ",
    StepKind.RESULT: "feedback and results of ",
    StepKind.FRAME: "frame ",
}


def title(step: Step) -> str:
    """What a step is called where nothing before it says what of a service or action it is."""
    return f"{_TITLES.get(step.kind, '')}{step_name(step)}"


def place_words(place: Place) -> str:
    return f"{place.file}:{place.line}"


__all__ = ["node_words", "place_words", "step_name", "title"]
