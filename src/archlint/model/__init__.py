"""What linking yields: programs, the nodes they make, what those create, and the calls that matter.

Names here are still as the code gives them (relative, ``~``); :mod:`archlint.systems` expands them for a system.
"""

from __future__ import annotations

from archlint.model.absent_reads import AbsentRead
from archlint.model.calls import ApiCall
from archlint.model.executors import ExecutorUse, Spell, SpinDuration
from archlint.model.futures import MistakenFuture
from archlint.model.kinds import (
    ENDPOINT_KINDS,
    NAMED,
    SERVER_OF,
    EntityKind,
    ExecutorKind,
    GroupKind,
    Role,
)
from archlint.model.messages import Access, FieldUse, Passed, UnknownInterface, ValueEffect, WrongValue
from archlint.model.nodes import (
    NEVER_CONSTRUCTED,
    Blueprint,
    Callback,
    ClassKey,
    Creation,
    Frame,
    FunctionRef,
    Group,
    GuardKind,
    NodeClass,
    ParameterDeclaration,
    ParameterDescription,
)
from archlint.model.overrides import Asked, Look, Overrides, node_key
from archlint.model.programs import Program
from archlint.model.refused import Misuse, RefusedCall
from archlint.model.texts import Resolution, Text
from archlint.model.transforms import FramePair

__all__ = [
    "ENDPOINT_KINDS",
    "NAMED",
    "NEVER_CONSTRUCTED",
    "SERVER_OF",
    "AbsentRead",
    "Access",
    "ApiCall",
    "Asked",
    "Blueprint",
    "Callback",
    "ClassKey",
    "Creation",
    "EntityKind",
    "ExecutorKind",
    "ExecutorUse",
    "FieldUse",
    "Frame",
    "FramePair",
    "FunctionRef",
    "Group",
    "GroupKind",
    "GuardKind",
    "Look",
    "MistakenFuture",
    "Misuse",
    "NodeClass",
    "Overrides",
    "ParameterDeclaration",
    "ParameterDescription",
    "Passed",
    "Program",
    "RefusedCall",
    "Resolution",
    "Role",
    "Spell",
    "SpinDuration",
    "Text",
    "UnknownInterface",
    "ValueEffect",
    "WrongValue",
    "node_key",
]
