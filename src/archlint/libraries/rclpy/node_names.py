"""What a node says of its own name, and what it makes of others: ``get_name``, ``resolve_topic_name``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from archlint import model
from archlint.interpreter.values import Given, Holed, Known, Unknown, Value, join_texts
from archlint.libraries.rclpy.nodes import known_node
from archlint.model.overrides import SHORT

if TYPE_CHECKING:
    from archlint.libraries.api_use import ApiUse
    from archlint.libraries.run import Run


def _as_value(text: model.Text, look: model.Look) -> Value:
    if text.text is None:
        return Unknown(text.reason or "the name is not known")
    if text.resolution in ("exact", "parameter"):
        names = (text.parameter or "").split(",") if text.resolution == "parameter" else ()
        return Given(text.text, frozenset(names), kind="node_name", look=look, source=look, longest=SHORT)
    parts: list[str | None] = []
    for number, piece in enumerate(text.text.split("*")):
        if number:
            parts.append(None)
        if piece:
            parts.append(piece)
    return Holed(tuple(parts), text.reason or "")


def get_name(run: Run, call: ApiUse) -> Value:
    node = known_node(run, call.receiver)
    if node is None:
        return Unknown("the name of a node that is not known")
    run.program.reads_node_names = True
    return _as_value(*run.overrides.name(node))


def get_namespace(run: Run, call: ApiUse) -> Value:
    node = known_node(run, call.receiver)
    if node is None:
        return Unknown("the namespace of a node that is not known")
    run.program.reads_node_names = True
    value = _as_value(*run.overrides.namespace(node))
    if isinstance(value, Known) and isinstance(value.value, str) and not value.value.startswith("/"):
        return Known("/" + value.value, value.via, kind="node_name")
    return value


def get_fully_qualified_name(run: Run, call: ApiUse) -> Value:
    namespace, name = get_namespace(run, call), get_name(run, call)
    if namespace.text == "/":
        return join_texts((Known("/"), name))
    return join_texts((namespace, Known("/"), name))


def resolve_name(run: Run, call: ApiUse) -> Value:
    """``resolve_topic_name``: without remaps, rcl's expansion."""
    value = call.get("topic") or call.get("service")
    text = None if value is None else value.text
    if value is not None and text is not None and not text.startswith("/"):
        namespace = get_namespace(run, call)
        if text.startswith("~"):
            return _of_the_node(join_texts((get_fully_qualified_name(run, call), Known(text[1:]))))
        if namespace.text == "/":
            return _of_the_node(join_texts((Known("/"), value)))
        return _of_the_node(join_texts((namespace, Known("/"), value)))
    return value if value is not None else Unknown("no name to resolve")


def _of_the_node(value: Value) -> Value:
    """A name that follows the node's: it is absolute, and yet not fixed in the code."""
    return Known(value.value, value.via, kind="node_name") if isinstance(value, Known) else value


__all__ = ["get_fully_qualified_name", "get_name", "get_namespace", "resolve_name"]
