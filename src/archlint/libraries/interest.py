"""Which functions can matter: those that create something, wait, spin, or register a callback."""

from __future__ import annotations

from archlint.libraries import tables
from archlint.syntax.cpp.known_names import IN_PYTHON
from archlint.syntax.parts import Source, names_in

_QUIET = frozenset(
    {"result", "done", "get", "path", "join", "partial", "function", "sleep", "wait", "input", "setup", "Parameter"}
)

_OF_CPP = frozenset(
    path.replace(".", "::")
    for path, python in IN_PYTHON.items()
    if python.endswith((".Node", ".LifecycleNode", ".ActionServer", ".ActionClient", ".Subscriber"))
    or python.startswith("tf2_ros.")
)
"""What makes something without a method of a node, as C++ writes it."""

WORDS = (
    frozenset(
        row.path.rpartition(".")[2]
        for row in tables.ROWS
        if row.effect != "none" or (row.watched and not row.waits_for_io)
    )
    | frozenset(tables.NODE_ROWS)
    | _OF_CPP
    | {"Node", "LifecycleNode", "sleep", "wait", "result", "call"}
) - {"__init__", "join", "get", "path", "set", "exists", "isfile"}
"""Names of the API tables, as they are written in source."""

_LITTLE_IN_CPP = frozenset(
    {"ArgumentParser", "Duration", "as_completed", "call", "done", "get_interface", "get_message", "get_service"}
    | {"getenv", "import_module", "init", "input", "isdir", "map", "partial", "result", "set_exception", "set_result"}
    | {"get_fully_qualified_name", "get_name", "get_namespace", "resolve_service_name", "resolve_topic_name"}
    | {"submit", "sleep", "wait"}
)
"""Words that mean something else in C++ (``std::map``, a field ``result``), and those that add nothing to a node and
use nothing of it."""
_WORDS_OF_CPP = WORDS - _LITTLE_IN_CPP

_MAKING = frozenset(
    {"callbacks", "create_node", "declare_parameter", "declare_parameters", "endpoint", "parameter_client"}
    | {"static_transform_listener", "timer", "transform_buffer", "transform_listener"}
)
MAKERS = frozenset(row.path.rpartition(".")[2] for row in tables.ROWS if row.effect in _MAKING) | _OF_CPP
"""Names of what adds something to a node."""


def interesting(ir: Source, *, in_cpp: bool = False) -> bool:
    """Whether a function or class uses a name of the API tables."""
    return not names_in(ir).isdisjoint(_WORDS_OF_CPP if in_cpp else WORDS)
