"""From a value to the text that the floors above see."""

from __future__ import annotations

from dataclasses import replace

from archlint.interpreter.values import Holed, Known, OneOf, Unknown, Value, reason
from archlint.model import Text

_WRITTEN = frozenset({"literal", "format"})
_AT_RUN_TIME = "one of several values, chosen at run time"


def text_of_value(value: Value | None, missing: str) -> Text:
    """What is known of a name; several alternatives are one unknown here."""
    if value is None:
        return Text(None, "unknown", reason=missing)
    match value:
        case Known(value=str(text), via=parameters, origin=origin, kind=kind):
            if parameters:
                return Text(text, "parameter", ",".join(sorted(parameters)), None, origin, kind)
            return Text(text, "exact", None, None, origin, kind)
        case Known(value=constant):
            return Text(None, "unknown", reason=f"{constant!r} is not a string")
        case Holed(reason=why, via=parameters, origin=origin):
            return Text(value.pattern, "partial", ",".join(sorted(parameters)) or None, why, origin, "format")
        case Unknown(parameter=parameter, reason=why):
            return Text(None, "unknown", parameter, why)
        case OneOf(values=options, why=why):
            known = [option for option in options if isinstance(option, (Known, Holed))]
            if len(known) == 1:
                name = text_of_value(known[0], missing)
                return replace(name, origin_kind="fallback") if name.origin_kind in _WRITTEN else name
            return Text(None, "unknown", reason=f"one of several values: {why}" if why else _AT_RUN_TIME)
    return Text(None, "unknown", reason=reason(value))
