"""How namespaces of a launch are put together, as launch_ros does it."""

from __future__ import annotations

from archlint.interpreter.values import Holed, Known, Unknown, Value, alternatives, join_texts, one_of
from archlint.launch.objects import known_text


def prefix_namespace(base: Value | None, namespace: Value | None) -> Value | None:
    """launch_ros' ``prefix_namespace``: an absolute one replaces, a relative one is joined below ``base``.

    The root as ``base`` adds nothing in front of the slash: ``/`` and ``robot`` make ``/robot``.
    """
    if namespace is None or base is None or known_text(base) == "":
        value = namespace if namespace is not None else base
        return None if value is None else _stripped(value)
    if known_text(namespace) == "":
        return _stripped(base)
    rows = [_below(alternative, other) for alternative in alternatives(base) for other in alternatives(namespace)]
    return _stripped(one_of(rows))


def _below(base: Value, namespace: Value) -> Value:
    start = _start(namespace)
    if start is None:
        return Unknown(_why(namespace))
    if start.startswith("/") or known_text(base) == "":
        return namespace
    if known_text(namespace) == "":
        return base
    return join_texts((Known("") if known_text(base) == "/" else base, Known("/"), namespace))


def absolute(namespace: Value | None) -> Value | None:
    """launch_ros' ``make_namespace_absolute``."""
    if namespace is None:
        return None
    rows: list[Value] = []
    for option in alternatives(namespace):
        start = _start(option)
        if start is None:
            rows.append(Unknown(_why(option)))
        else:
            rows.append(option if start.startswith("/") else join_texts((Known("/"), option)))
    return one_of(rows)


def _start(value: Value) -> str | None:
    """What a text starts with; None where that is not known."""
    match value:
        case Known(value=text):
            return str(text)
        case Holed(parts=parts):
            return parts[0]
    return None


def _why(value: Value) -> str:
    match value:
        case Unknown(reason=reason) | Holed(reason=reason):
            return reason
    return "the namespace is not known"


def _stripped(value: Value) -> Value:
    rows: list[Value] = []
    for option in alternatives(value):
        match option:
            case Known(value=text) if text != "/":
                rows.append(Known(str(text).rstrip("/"), option.via, option.origin, option.kind))
            case _:
                rows.append(option)
    return one_of(rows)
