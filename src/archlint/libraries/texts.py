"""From a value to the text that the floors above see."""

from __future__ import annotations

from archlint.interpreter.values import Holed, Known, OneOf, Unknown, Value, reason
from archlint.model import Text


def text_of_value(value: Value | None, missing: str) -> Text:
    """What is known of a name; several alternatives are one unknown here."""
    if value is None:
        return Text(None, "unknown", reason=missing)
    if isinstance(value, Known):
        if not isinstance(value.value, str):
            return Text(None, "unknown", reason=f"{value.value!r} is not a string")
        if value.via:
            return Text(value.value, "parameter", ",".join(sorted(value.via)), None, value.origin, value.kind)
        return Text(value.value, "exact", None, None, value.origin, value.kind)
    if isinstance(value, Holed):
        parameter = ",".join(sorted(value.via)) or None
        return Text(value.pattern, "partial", parameter, value.reason, value.origin, "format")
    if isinstance(value, Unknown):
        return Text(None, "unknown", value.parameter, value.reason)
    if isinstance(value, OneOf):
        known = [option for option in value.values if isinstance(option, (Known, Holed))]
        if len(known) == 1:
            return text_of_value(known[0], missing)
        return Text(None, "unknown", reason="one of several values, chosen at run time")
    return Text(None, "unknown", reason=reason(value))
