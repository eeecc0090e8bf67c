"""Whether code says itself where Python looks for modules."""

from __future__ import annotations

from archlint.syntax import facts
from archlint.syntax.parts import everything_in, once_for

_CHANGES = frozenset({"sys.path.append", "sys.path.extend", "sys.path.insert"})
_SEARCH_PATH = "sys.path"


@once_for
def changes_search_path(code: facts.Facts) -> bool:
    """Whether a file puts folders on ``sys.path``: which ones is not asked."""
    if "sys" not in code.names or "path" not in code.names:
        return False
    calls = (call.func.dotted in _CHANGES for call in everything_in(code.body, facts.Call))
    statements = everything_in(code.body, facts.Statement)
    return any(calls) or any(
        target.dotted == _SEARCH_PATH for statement in statements for target in getattr(statement, "assigned", ())
    )


__all__ = ["changes_search_path"]
