"""What methods of texts give, whatever the text is."""

from __future__ import annotations

from collections.abc import Mapping

from archlint.interpreter.values import EachValue, Unknown, Value
from archlint.syntax import facts

_GIVE: Mapping[str, frozenset[str]] = {
    "str": frozenset(
        {"lower", "upper", "title", "capitalize", "casefold", "swapcase", "strip", "lstrip", "rstrip", "replace"}
        | {"removeprefix", "removesuffix", "zfill", "ljust", "rjust", "center", "expandtabs", "join", "format"}
    ),
    "bytes": frozenset({"encode"}),
    "int": frozenset({"find", "rfind", "count", "index", "rindex"}),
    "bool": frozenset({"startswith", "endswith", "isdigit", "isalpha", "isalnum", "isnumeric", "isdecimal", "isspace"}),
}
"""What methods of a text give, whatever is in it."""
_GIVE_TEXTS = frozenset({"split", "rsplit", "splitlines"})
METHODS = frozenset().union(*_GIVE.values(), _GIVE_TEXTS)
"""The methods of texts of which it is known what they give."""


def result_of(name: str, why: str) -> Value:
    """What a method of a text gives whose content is not known."""
    if name in _GIVE_TEXTS:
        return EachValue(Unknown(why, of_class="str"))
    return Unknown(why, of_class=next((cls for cls, names in _GIVE.items() if name in names), None))


_ENCODINGS = frozenset({"ascii", "cp1252", "iso-8859-1", "latin-1", "latin1", "utf-16", "utf-8", "utf8"})


def decodes(e: facts.Call) -> bool:
    """Whether a call is certainly ``data.decode('utf-8')``, which makes a text of whatever bytes."""
    match e.func, e.args:
        case facts.Attribute(attr="decode"), [facts.Argument(value=facts.Literal(value=str(name))), *_]:
            return name.lower() in _ENCODINGS
    return False


__all__ = ["METHODS", "decodes", "result_of"]
