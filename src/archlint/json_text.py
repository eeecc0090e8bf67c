"""Documents as JSON that every reader takes."""

from __future__ import annotations

import json
import math
import re

_LONE_SURROGATE = re.compile("[\ud800-\udfff]")


def json_text(document: object, *, indent: int | None = None, separators: tuple[str, str] | None = None) -> str:
    """A document as JSON, without a newline at the end.

    A number that JSON has no word for (nan, infinity) is null, and a byte of a file name that is no UTF-8 is shown as
    U+FFFD: strict readers refuse the whole document otherwise.
    """
    try:
        text = json.dumps(document, indent=indent, separators=separators, allow_nan=False)
    except ValueError:
        text = json.dumps(_finite(document), indent=indent, separators=separators, allow_nan=False)
    return text if "\\ud" not in text else json.dumps(_valid(json.loads(text)), indent=indent, separators=separators)


def _finite(value: object) -> object:
    match value:
        case float():
            return value if math.isfinite(value) else None
        case dict():
            return {key: _finite(item) for key, item in value.items()}
        case list() | tuple():
            return [_finite(item) for item in value]
    return value


def _valid(value: object) -> object:
    match value:
        case str():
            return _LONE_SURROGATE.sub("\ufffd", value)
        case dict():
            return {_valid(key): _valid(item) for key, item in value.items()}
        case list():
            return [_valid(item) for item in value]
    return value
