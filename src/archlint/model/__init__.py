"""What linking yields: programs, the nodes they make, what those create, and the calls that matter.

Names here are still as the code gives them (relative, ``~``); :mod:`archlint.systems` expands them for a system.
"""

from __future__ import annotations

from archlint.model.calls import ApiCall
from archlint.model.executors import FOR_A_MOMENT, FOR_A_WHILE, TO_THE_END, ExecutorUse, Spell
from archlint.model.messages import FieldUse, Passed, UnknownInterface
from archlint.model.nodes import (
    ACTION_CLIENT,
    ACTION_SERVER,
    CLIENT,
    ENDPOINT_KINDS,
    GUARD,
    NAMED,
    NEVER_CONSTRUCTED,
    PUBLISHER,
    SERVICE,
    SUBSCRIBER,
    TIMER,
    Blueprint,
    Callback,
    ClassKey,
    Creation,
    Frame,
    Group,
    ParameterDeclaration,
)
from archlint.model.overrides import Overrides, node_key
from archlint.model.programs import Program
from archlint.model.texts import Resolution, Text

__all__ = [
    "ACTION_CLIENT",
    "ACTION_SERVER",
    "CLIENT",
    "ENDPOINT_KINDS",
    "FOR_A_MOMENT",
    "FOR_A_WHILE",
    "GUARD",
    "NAMED",
    "NEVER_CONSTRUCTED",
    "PUBLISHER",
    "SERVICE",
    "SUBSCRIBER",
    "TIMER",
    "TO_THE_END",
    "ApiCall",
    "Blueprint",
    "Callback",
    "ClassKey",
    "Creation",
    "ExecutorUse",
    "FieldUse",
    "Frame",
    "Group",
    "Overrides",
    "ParameterDeclaration",
    "Passed",
    "Program",
    "Resolution",
    "Spell",
    "Text",
    "UnknownInterface",
    "node_key",
]
